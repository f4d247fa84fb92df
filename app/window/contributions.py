"""Makes the panels and commands that packages have declared."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TypeVar

from app.panels.command_kind import CommandContext, RecordingAction, WindowCommand
from app.panels.kind import PanelKind, PanelServices
from app.panels.panel import Panel
from app.words import tr
from tracker.base.registry import Registry

PANELS = Registry("panels", "panel", PanelKind)
COMMANDS = Registry("window_commands", "window command", WindowCommand)
P = TypeVar("P", bound=Panel)
_log = logging.getLogger(__name__)


def panel_kinds() -> dict[str, PanelKind]:
    """All kinds that can be loaded, by name, in the order of the View menu."""
    kinds = PANELS.all()
    return dict(sorted(kinds.items(), key=lambda item: item[1].number or len(kinds) + 100))


def make_panels(
    kinds: Mapping[str, PanelKind], services: PanelServices, failed: Callable[[str], None]
) -> dict[str, Panel]:
    """A panel of each kind, by name. ``failed`` gets a sentence for each that cannot be made."""
    panels = {}
    for name, kind in kinds.items():
        try:
            panel = kind.make(services)
        except Exception as error:  # noqa: BLE001  one panel's fault must not stop the window
            _log.exception("The panel %s cannot be made.", name)
            failed(_why_not(kind, error))
            continue
        panel.name = name
        panel.setObjectName(f"panel_{name}")
        panel.setWindowTitle(tr(kind.title))
        panels[name] = panel
    return panels


def _why_not(kind: PanelKind, error: Exception) -> str:
    title = tr(kind.title).replace("&&", "&")
    if isinstance(error, ImportError) and kind.extra:
        text = tr("The panel {} cannot be shown: {}. Install it with pip install '{}'.")
        return text.format(title, error, kind.extra)
    return tr("The panel {} cannot be shown: {}.").format(title, error)


@dataclass(frozen=True, eq=False)
class AddedCommand:
    """A command of a window's menu, in the user's language; see `WindowCommand`."""

    title: str
    run: Callable[[], None]
    after: str
    enabled: Callable[[], bool]
    shortcut: str


def recording_actions(context: CommandContext) -> dict[str, RecordingAction]:
    """Commands on recordings, by name."""

    def run(command: WindowCommand, recordings: Sequence[Path]) -> None:
        _run(command, replace(context, recordings=tuple(recordings)))

    return {
        name: RecordingAction(tr(command.title), partial(run, command))
        for name, command in COMMANDS.all().items()
        if command.on_recordings
    }


def added_commands(context: CommandContext) -> dict[str, AddedCommand]:
    """Commands of the window's menus, by name."""
    return {
        name: AddedCommand(
            tr(command.title),
            partial(_run, command, context),
            command.after,
            partial(_is_enabled, command, context),
            command.shortcut,
        )
        for name, command in COMMANDS.all().items()
        if not command.on_recordings
    }


def _run(command: WindowCommand, context: CommandContext) -> None:
    try:
        command.run(context)
    except Exception as error:  # noqa: BLE001  one command's fault must not stop the window
        _log.exception("The command %s failed.", command.name)
        title = tr(command.title).replace("&", "").rstrip("…")
        context.host.error.emit(tr("{} failed: {}.").format(title, error))


def _is_enabled(command: WindowCommand, context: CommandContext) -> bool:
    try:
        return command.enabled(context)
    except Exception:  # noqa: BLE001  one command's fault must not stop the window
        _log.exception("Whether the command %s can run is not known.", command.name)
        return False


def panel_of(panels: Mapping[str, Panel], kind: type[P]) -> P:
    """The panel of this class. Raises LookupError if there is none."""
    for panel in panels.values():
        if isinstance(panel, kind):
            return panel
    raise LookupError(kind.__name__)
