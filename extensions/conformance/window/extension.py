"""Window command of the conformance check."""

from __future__ import annotations

from app.panels.command_kind import CommandContext, WindowCommand
from app.window import theme
from app.words import mark


def _can_run(on: CommandContext) -> bool:
    """Whether a tracked hand can be recorded."""
    setup = on.host.setup
    return on.host.running and setup is not None and setup.live is not None


def _run(on: CommandContext) -> None:
    """Open the dialog."""
    from extensions.conformance.window.dialog import ConformanceDialog

    setup = on.host.setup
    if setup is None or not _can_run(on):
        return
    scene = theme.colours(on.store.value.theme).scene
    on.show_dialog(
        "conformance",
        lambda: ConformanceDialog(on.host, setup, on.store, on.tasks, scene, on.window),
    )


COMMAND = WindowCommand(
    "conformance", mark("C&onformance…"), _run, after="save_wearer", enabled=_can_run
)
