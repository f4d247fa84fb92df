"""Window command of the touch test."""

from __future__ import annotations

from app.panels.command_kind import CommandContext, WindowCommand
from app.words import mark
from tracker.base.registry import deferred


def can_run(on: CommandContext) -> bool:
    """Whether a tracked hand can be recorded before a camera."""
    setup = on.host.setup
    live = on.host.running and setup is not None and setup.live is not None
    return live and setup is not None and setup.camera.present


COMMAND = WindowCommand(
    "touch_test",
    mark("&Touch test…"),
    deferred("extensions.touch.window.dialog:open_dialog"),
    after="save_wearer",
    enabled=can_run,
)
