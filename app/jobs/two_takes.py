"""Reads two takes to be seen side by side."""

from __future__ import annotations

from pathlib import Path

from app.platform.tasks import Job, JobProgress
from app.viewmodels.two_takes import TwoTakes, read_take
from app.words import tr
from tracker.base.errors import FileError


def two_takes_job(first: Path, second: Path) -> Job:
    """A job whose result is a `TwoTakes`; it fails in words where one was never tracked."""

    def run(progress: JobProgress) -> TwoTakes:
        takes = []
        for i, path in enumerate((first, second)):
            progress(i / 2, path.name)
            takes.append(read_take(path))
            if not len(takes[-1].t):
                raise FileError(tr("{} is not tracked: track it again first.").format(path.name))
        return TwoTakes(*takes)

    return run
