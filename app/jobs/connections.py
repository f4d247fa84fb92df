"""Connections that are switched on by name, at an address and a port each, and remembered."""

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
    """The connections of ``kinds``. ``wanted`` names one to close and to open again as set now."""

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
        """``settings_key``: under which ``store`` has the settings."""
        super().__init__(parent)
        self.kinds, self.settings = kinds, settings
        self._store, self._key = store, settings_key

    def switch(self, name: str, on: bool) -> None:
        """Turn one on or off, now and after the next start."""
        self._change([name], **{name: on})

    def move(self, host: str) -> None:
        """To or at another address; what is on is opened again there."""
        self._change(self._on(), host=host)

    def set_port(self, name: str, port: int) -> None:
        self.set_option(name, "port", port)

    def set_option(self, name: str, option: str, value: object) -> None:
        """Change an option; what is on is opened again with it."""
        self._change([name] if self.is_on(name) else [], **{key_of(name, option): value})

    def port(self, name: str) -> int | None:
        """The port that is set; None for a connection without one."""
        kind = self.kinds[name]
        return int(self.settings.options(kind).port) if kind.has("port") else None

    def is_on(self, name: str) -> bool:
        return self.settings.is_on(name)

    def _on(self) -> list[str]:
        return [name for name in self.kinds if self.is_on(name)]

    def _change(self, names: Iterable[str], **changes: object) -> None:
        """Remember other settings, and open ``names`` again with them."""
        self.settings = self.settings.changed(**changes)
        self._store.update(**{self._key: dict(self.settings.table)})
        for name in names:
            self.wanted.emit(name)


def remembered(kind: type[P], data: dict[str, Any]) -> P:
    """Params from what was remembered; what is unknown or of a wrong type keeps its default."""
    return from_dict(kind, data, lambda key, why: _log.info("%s %s", key, why))
