"""Window command of studies."""

from __future__ import annotations

from pathlib import Path

from app.panels.command_kind import CommandContext, WindowCommand
from app.words import error_text, mark, tr
from extensions.study.folder import Study
from tracker.base.errors import GlovetrackError


def show_study(context: CommandContext, study: Study, participant: str = "") -> None:
    """Show the dialog of a study, or bring it to the front."""
    from extensions.study.window.dialog import StudyDialog

    context.show_dialog("study", lambda: StudyDialog(context, study, participant))


def _open(context: CommandContext) -> None:
    """Ask for a protocol file; the study's folder is next to it."""
    from PySide6.QtWidgets import QFileDialog

    from extensions.study.folder import start_study
    from extensions.study.protocol import load_protocol

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


COMMAND = WindowCommand("study", mark("St&udy…"), _open)
