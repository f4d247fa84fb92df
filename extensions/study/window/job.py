"""Background jobs of a study: the verdict on a trial, and the report."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress
from extensions.study.folder import open_study
from extensions.study.protocol import TrialLimits
from extensions.study.results import write_report
from extensions.study.schedule import ScheduleStep
from extensions.study.verdict import TrialVerdict, judge, stored


def verdict_job(path: Path, step: ScheduleStep, limits: TrialLimits) -> Job:
    """A job that returns the `TrialVerdict` on a recording."""

    def run(progress: JobProgress) -> TrialVerdict:
        work = partial(_judge, path, step, limits)
        return stored(run_in_subprocess("verdict", work, progress))

    return run


def _judge(
    path: Path, step: ScheduleStep, limits: TrialLimits, _: Callable[..., None]
) -> dict[str, Any]:
    return judge(path, step, limits).as_json()


def report_job(folder: Path) -> Job:
    """A job that writes the report of a study, and returns its path."""

    def run(progress: JobProgress) -> Path:
        out: Path = run_in_subprocess("study-report", partial(_report, folder), progress)
        return out

    return run


def _report(folder: Path, _: Callable[..., None]) -> Path:
    return write_report(open_study(folder), folder / "report")
