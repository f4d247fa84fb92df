"""A job that tracks a recorded session again and compares both trackings."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from app.platform.tasks import Job, JobProgress
from app.viewmodels.compare import Comparison
from app.viewmodels.names import engine_name
from app.words import tr
from tracker.base.errors import FileError
from tracker.base.files import free_path
from tracker.base.notices import notice
from tracker.offline.options import TrackOptions
from tracker.session.compare import compare, truth_error_mm
from tracker.session.reader import SessionReader

TRACKING_SHARE = 0.9  # of the progress bar; the rest is the comparison


def track_job(source: Path, out: Path, wanted: TrackOptions) -> Job:
    """A job that tracks ``source`` into the new file ``out``; leaves no file if cancelled.

    Its result is a `Comparison`, or None if ``source`` was never tracked before.
    """

    def run(progress: JobProgress) -> Comparison | None:
        from tracker.offline.track import track  # deferred: loads every engine

        progress(0.0, engine_name(wanted.engine))

        def forward(share: float) -> None:
            progress(TRACKING_SHARE * share, engine_name(wanted.engine))

        report = track(source, out, wanted, forward)
        with SessionReader(source) as reader:
            tracked = any(n.startswith("/hand/") for n in reader.topic_names)
        if not tracked:
            return None
        progress(TRACKING_SHARE, tr("comparing"))
        return replace(compared(source, out), unused=report.unused)

    return run


def compare_job(first: Path, second: Path) -> Job:
    """A job whose result is the `Comparison` of two sessions."""

    def run(progress: JobProgress) -> Comparison:
        progress(-1.0, tr("comparing"))
        return compared(first, second)

    return run


def compared(first: Path, second: Path) -> Comparison:
    """Raises FileError if the two have no instant in common, or if one was never tracked."""

    figures = compare(first, second)
    errors: list[dict[str, float]] = []
    truth = _with_truth(first, second)
    for path, other in ((first, second), (second, first)):
        errors.append(truth_error_mm(path, truth, other) if truth is not None else {})
    engines = _engine_of(first), _engine_of(second)
    return Comparison(first, second, figures, (errors[0], errors[1]), engines)


def _engine_of(path: Path) -> str:

    with SessionReader(path) as reader:
        return reader.info.engine


def _with_truth(*paths: Path) -> Path | None:
    """The first of the files that contains the simulated truth."""

    for path in paths:
        with SessionReader(path) as reader:
            if any(n.startswith("/truth/") for n in reader.topic_names):
                return path
    return None


def free_name(source: Path, engine: str) -> Path:
    """``session_vist.mcap`` next to ``session.mcap``, or with a number if that exists.

    Raises FileError if the folder does not exist.
    """

    if not source.parent.is_dir():
        raise FileError(notice("window.no_folder", folder=source.parent))
    return free_path(source.with_name(f"{source.stem}_{engine or 'again'}{source.suffix}"))
