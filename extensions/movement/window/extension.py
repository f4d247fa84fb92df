"""Window commands of the movement report."""

from __future__ import annotations

from app.panels.command_kind import CommandContext, WindowCommand
from app.panels.library.session_files import open_folder
from app.words import mark, tr
from extensions.movement.window.report_job import report_job


def _report(on: CommandContext) -> None:
    """Write one page about all recordings next to the first, and open it in the browser."""
    paths = on.recordings
    title = tr("Report of {}").format(paths[0].stem)
    if len(paths) > 1:
        title = tr("Report of {} recordings").format(len(paths))
    on.tasks.run(title, report_job(paths), open_folder)


REPORT = WindowCommand("report", mark("Report"), _report, on_recordings=True)
