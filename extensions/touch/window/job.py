"""Writes the report of a touch test in a background job."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import NamedTuple

from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress
from extensions.touch.analyse import analyse
from extensions.touch.report import write_report


class Written(NamedTuple):
    """The page, and the line to quote."""

    page: Path
    line: str


def touch_job(session: Path) -> Job:
    """A job that returns the report `Written` next to ``session``."""

    def run(progress: JobProgress) -> Written:
        out: Written = run_in_subprocess("touch-test", partial(_write, session), progress)
        return out

    return run


def _write(session: Path, progress: Callable[..., None]) -> Written:

    result = analyse(session, watch=progress)
    page, n = session.with_name(f"{session.stem}-touch-test.html"), 1
    while page.exists() or page.with_suffix(".pdf").exists():
        n += 1
        page = session.with_name(f"{session.stem}-touch-test-{n}.html")
    write_report(result, page)
    return Written(page, result.line)
