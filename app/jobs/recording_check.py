"""Checks a finished recording: whether it is complete, and how well it was tracked."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress
from app.viewmodels.recording_report import HandReport, RecordingReport
from app.words import error_text, notice_text
from tracker.base.errors import GlovetrackError
from tracker.session.overview import HandShare, quality
from tracker.session.reader import SessionReader
from tracker.session.recover import needs_recovery
from tracker.session.verify import verify


def check_job(path: Path) -> Job:
    """A job that reads the whole file and returns its `RecordingReport`; in a subprocess, since the
    hand is tracked at the same time."""

    def run(progress: JobProgress) -> RecordingReport:
        try:
            report: RecordingReport = run_in_subprocess("check", partial(_report, path), progress)
        except GlovetrackError as error:
            return RecordingReport(path, error_text(error))
        return report

    return run


def _report(path: Path, progress: Callable[..., None]) -> RecordingReport:
    """Raises FileError if it cannot be read."""

    findings = verify(path, progress)
    errors = [f"{f.where}: {notice_text(f.what)}" for f in findings if f.severity == "error"]
    with SessionReader(path) as reader:
        q, duration = quality(reader), reader.duration
        shares = q.hands or (HandShare(reader.info.side, q.tracked),)
    problem = errors[0] if errors else ""
    silent = {f.where: f.silence for f in findings}
    camera = silent.get("/camera", 0.0)
    hands = tuple(
        HandReport(hand.side, hand.tracked, silent.get(f"/glove/{hand.side}", 0.0))
        for hand in shares
    )
    cut_off = needs_recovery(path)
    return RecordingReport(
        path, problem, duration, q.packets_lost, q.by_imus, camera, hands, cut_off
    )
