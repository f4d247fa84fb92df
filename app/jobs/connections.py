"""Connections that are switched on by name, each with an address and a port, stored in the
settings."""

from __future__ import annotations

import logging
from collections.abc import Iterable, Mapping
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from app.storage.settings import SettingsStore
from tracker.base.config import from_dict
from tracker.streaming.connection import ConnectionKind, ConnectionSettings, key_of

_log = logging.getLogger(__name__)
P = TypeVar("P")
K = TypeVar("K", bound=ConnectionKind[Any])
S = TypeVar("S", bound=ConnectionSettings)


class Connections(QObject, Generic[K, S]):
    """The connections of ``kinds``. ``wanted``: name of a connection to be reopened with the
    current settings."""

    changed = Signal()
    wanted = Signal(str)

    def __init__(
        self,
        kinds: Mapping[str, K],
        settings: S,
        store: SettingsStore,
        settings_key: str,
        parent: QObject | None = None,
    ) -> None:
        """``settings_key``: key of the settings in ``store``."""
        super().__init__(parent)
        self.kinds, self.settings = kinds, settings
        self._store, self._key = store, settings_key

    def switch(self, name: str, on: bool) -> None:
        """Switch a connection on or off, and store that."""
        self._change([name], **{name: on})

    def move(self, host: str) -> None:
        """Change the address; open connections are reopened."""
        self._change(self._on(), host=host)

    def set_port(self, name: str, port: int) -> None:
        self.set_option(name, "port", port)

    def set_option(self, name: str, option: str, value: object) -> None:
        """Change an option; an open connection is reopened."""
        self._change([name] if self.is_on(name) else [], **{key_of(name, option): value})

    def port(self, name: str) -> int | None:
        """The port; None for a connection without one."""
        kind = self.kinds[name]
        return int(self.settings.options(kind).port) if kind.has("port") else None

    def is_on(self, name: str) -> bool:
        return self.settings.is_on(name)

    def _on(self) -> list[str]:
        return [name for name in self.kinds if self.is_on(name)]

    def _change(self, names: Iterable[str], **changes: object) -> None:
        """Store the settings and reopen ``names``."""
        self.settings = self.settings.changed(**changes)
        self._store.update(**{self._key: dict(self.settings.table)})
        for name in names:
            self.wanted.emit(name)


def remembered(kind: type[P], data: dict[str, Any]) -> P:
    """Params from stored data; unknown or invalid entries are replaced by defaults."""
    return from_dict(kind, data, lambda key, why: _log.info("%s %s", key, why))
