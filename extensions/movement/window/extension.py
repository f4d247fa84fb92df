"""Window commands of the movement report."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from app.panels.command_kind import CommandContext, WindowCommand
from app.panels.library.session_files import open_folder
from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress
from app.words import mark, tr


def report_job(sessions: Sequence[Path]) -> Job:
    """A job that returns the path of the page: ``report.html``, or with a number if it exists."""
    takes = sorted(sessions)

    def run(progress: JobProgress) -> Path:
        out: Path = run_in_subprocess("report", partial(_write, takes), progress)
        return out

    return run


def _write(takes: Sequence[Path], progress: Callable[..., None]) -> Path:
    from extensions.movement.report.write import write_report  # deferred: loads SciPy

    out = free_page(takes[0].parent)
    write_report(takes, out, watch=progress)
    return out


def free_page(folder: Path) -> Path:
    """A path at which neither a page nor its table or figures exist."""

    out, n = folder / "report.html", 1
    while any(folder.glob(f"{out.stem}.*")) or any(folder.glob(f"{out.stem}_ranges.*")):
        n += 1
        out = folder / f"report-{n}.html"
    return out


def _report(on: CommandContext) -> None:
    """Write one page about all recordings next to the first, and open it in the browser."""
    paths = on.recordings
    title = tr("Report of {}").format(paths[0].stem)
    if len(paths) > 1:
        title = tr("Report of {} recordings").format(len(paths))
    on.tasks.run(title, report_job(paths), open_folder)


REPORT = WindowCommand("report", mark("Report"), _report, on_recordings=True)
