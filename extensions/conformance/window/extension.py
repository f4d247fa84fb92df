"""Window command of the conformance check."""

from __future__ import annotations

from app.panels.command_kind import CommandContext, WindowCommand
from app.words import mark
from tracker.base.registry import deferred


def can_run(on: CommandContext) -> bool:
    """Whether a tracked hand can be recorded."""
    setup = on.host.setup
    return on.host.running and setup is not None and setup.live is not None


COMMAND = WindowCommand(
    "conformance",
    mark("C&onformance…"),
    deferred("extensions.conformance.window.dialog:open_dialog"),
    after="save_wearer",
    enabled=can_run,
)
