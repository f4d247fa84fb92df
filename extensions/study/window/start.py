"""Opens the window with a study's dialog; imported without Qt."""

from __future__ import annotations

from extensions.study.folder import Study


def open_study_window(study: Study, participant: str, simulated: bool) -> int:
    """Open the window with the devices, or simulated ones, and the dialog above it; returns the
    exit status."""
    from app.panels.command_kind import CommandContext
    from app.window.start import open_window
    from app.window.window_options import WindowOptions
    from extensions.study.window.extension import show_study

    def then(context: CommandContext) -> None:
        show_study(context, study, participant)

    return open_window(WindowOptions(demo=simulated, devices=not simulated), then)
