"""Connections that are switched on by name, at an address and a port each, and remembered."""

from __future__ import annotations

import logging
from collections.abc import Iterable
from dataclasses import asdict, replace
from typing import Any, TypeVar

from PySide6.QtCore import QObject, Signal

from app.storage.settings import SettingsStore
from tracker.base.config import from_dict

_log = logging.getLogger(__name__)
P = TypeVar("P")


class Connections(QObject):
    """``params`` has a field NAME for each connection's switch, NAME_port for its port, and
    ``host``. ``wanted`` names one that is to be closed and opened as it is wanted now."""

    changed = Signal()
    wanted = Signal(str)
    names: tuple[str, ...] = ()
    settings_key = ""  # under which the parameters are remembered
    params: Any

    def __init__(self, store: SettingsStore, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._store = store

    def switch(self, name: str, on: bool) -> None:
        """Turn one on or off, now and after the next start."""
        self._change([name], **{name: on})

    def move(self, host: str) -> None:
        """To or at another address; what is on is opened again there."""
        self._change(self._on(), host=host)

    def set_port(self, name: str, port: int) -> None:
        self._change([name] if self.is_on(name) else [], **{f"{name}_port": port})

    def is_on(self, name: str) -> bool:
        return bool(getattr(self.params, name))

    def _on(self) -> list[str]:
        return [name for name in self.names if self.is_on(name)]

    def _change(self, names: Iterable[str], **changes: Any) -> None:
        """Remember other parameters, and open ``names`` anew with them."""
        self.params = replace(self.params, **changes)
        self._store.update(**{self.settings_key: asdict(self.params)})
        for name in names:
            self.wanted.emit(name)


def remembered(kind: type[P], data: dict[str, Any]) -> P:
    """Params from what was remembered; what is unknown or of a wrong type keeps its default."""
    return from_dict(kind, data, lambda key, why: _log.info("%s %s", key, why))
