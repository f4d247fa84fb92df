"""Window commands of the reference extension."""

from __future__ import annotations

from app.panels.command_kind import CommandContext, WindowCommand
from app.words import mark
from tracker.base.registry import deferred


def is_replayed(on: CommandContext) -> bool:
    """Whether a tracked session is open in replay."""
    setup = on.host.setup
    return setup is not None and setup.player is not None and setup.player.tracked


IMPORT = WindowCommand(
    "reference_import",
    mark("Import re&ference…"),
    deferred("extensions.reference.window.import_dialog:open_dialog"),
    after="beside",
    enabled=is_replayed,
)
ACCURACY = WindowCommand(
    "reference_accuracy",
    mark("Accurac&y report…"),
    deferred("extensions.reference.window.accuracy_dialog:open_dialog"),
    after="beside",
    enabled=is_replayed,
)
ACCURACY_OF = WindowCommand(
    "reference_accuracy_of",
    mark("Accuracy report…"),
    deferred("extensions.reference.window.accuracy_dialog:open_dialog"),
    on_recordings=True,
)
