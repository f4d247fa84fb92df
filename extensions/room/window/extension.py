"""Window command of the trackers in the room."""

from __future__ import annotations

from app.panels.command_kind import WindowCommand
from app.words import mark
from tracker.base.registry import deferred

COMMAND = WindowCommand(
    "room_tracker",
    mark("&Room tracker…"),
    deferred("extensions.room.window.dialog:open_dialog"),
    after="save_wearer",
)
