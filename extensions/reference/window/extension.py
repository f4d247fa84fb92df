"""Window commands of the reference extension."""

from __future__ import annotations

from app.panels.command_kind import CommandContext, WindowCommand
from app.words import mark


def _is_replayed(on: CommandContext) -> bool:
    """Whether a tracked session is open in replay."""
    setup = on.host.setup
    return setup is not None and setup.player is not None and setup.player.tracked


def _import(on: CommandContext) -> None:
    """Open the dialog for the open session."""
    from extensions.reference.window.import_dialog import ImportDialog

    setup = on.host.setup
    if setup is not None and setup.player is not None and _is_replayed(on):
        on.show_dialog("reference_import", lambda: ImportDialog(on, setup))


def _report(on: CommandContext) -> None:
    """Open the dialog for the open session, or for the selected recordings."""
    from extensions.reference.window.accuracy_dialog import AccuracyDialog

    setup = on.host.setup
    paths = list(on.recordings)
    if not paths and setup is not None and setup.player is not None:
        paths = [setup.player.path]
    on.show_dialog("reference_accuracy", lambda: AccuracyDialog(on, paths))


IMPORT = WindowCommand(
    "reference_import", mark("Import re&ference…"), _import, after="beside", enabled=_is_replayed
)
ACCURACY = WindowCommand(
    "reference_accuracy", mark("Accurac&y report…"), _report, after="beside", enabled=_is_replayed
)
ACCURACY_OF = WindowCommand(
    "reference_accuracy_of", mark("Accuracy report…"), _report, on_recordings=True
)
