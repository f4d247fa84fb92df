"""Opens a study in the window: by the window's menu, or by the command line with the window."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import QFileDialog

from app.panels.command_kind import CommandContext
from app.window.start import open_another
from app.window.window_options import WindowOptions
from app.words import error_text, tr
from extensions.study.folder import Study, start_study
from extensions.study.protocol import load_protocol
from extensions.study.window.dialog import StudyDialog
from tracker.base.errors import GlovetrackError


def open_study_window(study: Study, participant: str, simulated: bool) -> int:
    """Open the window with the devices, or simulated ones, and the dialog above it; returns the
    exit status."""

    def then(context: CommandContext) -> None:
        show_study(context, study, participant)

    return open_another(WindowOptions(demo=simulated, devices=not simulated), then)


def show_study(context: CommandContext, study: Study, participant: str = "") -> None:
    """Show the dialog of a study, or bring it to the front."""
    context.show_dialog("study", lambda: StudyDialog(context, study, participant))


def open_protocol(context: CommandContext) -> None:
    """Ask for a protocol file; the study's folder is next to it."""
    name, _ = QFileDialog.getOpenFileName(
        context.window, tr("Protocol of a study"), "", tr("Protocols (*.toml)")
    )
    if not name:
        return
    path = Path(name)
    try:
        protocol, _text = load_protocol(path)
        inside = path.parent.name == "protocol"  # the copy in a study that has begun
        folder = path.parent.parent if inside else path.parent / protocol.name
        study = start_study(path, folder)
    except GlovetrackError as error:
        context.host.error.emit(error_text(error))
        return
    show_study(context, study)
