"""Descriptor with which a package adds a command: a `WindowCommand` of the group
``glovetrack.window_commands``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from PySide6.QtWidgets import QDialog, QWidget

    from app.engines.engine_host import EngineHost
    from app.jobs.remote import RemoteControl
    from app.platform.tasks import TaskOwner
    from app.storage.settings import SettingsStore


@dataclass(frozen=True, eq=False)
class CommandContext:
    """What a command can use.

    ``show_dialog(name, make)`` shows a dialog, or brings an open one of that name to the front.
    ``remote``: remote control, with its settings.
    ``open_session(path, at)`` replays a recording, paused at ``at`` s unless that is None.
    ``recordings``: the selected recordings, for a command on recordings.
    """

    host: EngineHost
    store: SettingsStore
    tasks: TaskOwner
    window: QWidget
    show_dialog: Callable[[str, Callable[[], QDialog]], None]
    remote: RemoteControl
    open_session: Callable[[Path, float | None], None]
    recordings: Sequence[Path] = ()


def always(_context: CommandContext) -> bool:
    return True


@dataclass(frozen=True, eq=False)
class WindowCommand:
    """A command in a menu of the window, or on the recordings in the library.

    ``name`` is the name of its entry point. ``title``: in English, translated if the catalogue
    contains it; ``&`` precedes the mnemonic. ``on_recordings``: listed in the library, for one or
    more recordings; otherwise in a menu of the window, after the command ``after``, or in the menu
    *Extensions* if that is empty or unknown. ``enabled`` is called when an engine is opened,
    started, stopped or closed. ``shortcut`` is a Qt key sequence.
    """

    name: str
    title: str
    run: Callable[[CommandContext], None]
    on_recordings: bool = False
    after: str = ""
    enabled: Callable[[CommandContext], bool] = always
    shortcut: str = ""


@dataclass(frozen=True, eq=False)
class RecordingAction:
    """A command on recordings as listed in the library: title and callback."""

    title: str
    run: Callable[[Sequence[Path]], None]
