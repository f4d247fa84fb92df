"""Window command of the touch test."""

from __future__ import annotations

from app.panels.command_kind import CommandContext, WindowCommand
from app.words import mark


def _can_run(on: CommandContext) -> bool:
    """Whether a tracked hand can be recorded before a camera."""
    setup = on.host.setup
    live = on.host.running and setup is not None and setup.live is not None
    return live and setup is not None and setup.camera.present


def _run(on: CommandContext) -> None:
    """Open the dialog."""
    from extensions.touch.window.dialog import TouchDialog

    setup = on.host.setup
    if setup is None or not _can_run(on):
        return
    on.show_dialog("touch_test", lambda: TouchDialog(on.host, setup, on.store, on.tasks, on.window))


COMMAND = WindowCommand(
    "touch_test", mark("&Touch test…"), _run, after="save_wearer", enabled=_can_run
)
