"""What the conformance check adds to the window."""

from __future__ import annotations

from app.panels.command_kind import CommandContext, WindowCommand
from app.window import theme
from app.words import mark


def _can_run(on: CommandContext) -> bool:
    """Whether there is a hand that is tracked and can be recorded."""
    setup = on.host.setup
    return on.host.running and setup is not None and setup.live is not None


def _run(on: CommandContext) -> None:
    """Scripted gestures, recorded and judged."""
    from extensions.conformance.window.guide.dialog import ConformanceDialog

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
