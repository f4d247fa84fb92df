"""Window command of the trackers in the room."""

from __future__ import annotations

from app.panels.command_kind import CommandContext, WindowCommand
from app.words import mark


def _run(on: CommandContext) -> None:
    """Open the dialog."""
    from extensions.room.window.dialog import RoomDialog

    on.show_dialog(
        "room_tracker", lambda: RoomDialog(on.host, on.remote, on.store, on.tasks, on.window)
    )


COMMAND = WindowCommand("room_tracker", mark("&Room tracker…"), _run, after="save_wearer")
