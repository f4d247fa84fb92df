"""Jobs that create a new session file from another one: crop, fill gaps, recover."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress
from app.viewmodels.gaps import FilledSession, Gap, SessionGaps
from tracker.base.errors import FileError
from tracker.base.files import free_path
from tracker.session.gaps.find import KINDS, session_gaps
from tracker.session.reader import SessionReader
from tracker.session.recover import recover


def recover_job(path: Path) -> Job:
    """A job that copies all readable data to ``…_recovered.mcap``."""

    def run(progress: JobProgress) -> Path:

        progress(-1.0, path.name)
        return recover(path).path

    return run


def crop_job(source: Path, part: tuple[float, float]) -> Job:
    """A job that copies ``part`` (s of the replay) to ``…_crop.mcap``; leaves no file if
    cancelled."""

    def run(progress: JobProgress) -> Path:
        out: Path = run_in_subprocess("crop", partial(_crop, source, part), progress)
        return out

    return run


def _crop(source: Path, part: tuple[float, float], progress: Callable[..., None]) -> Path:
    from tracker.offline.crop import crop  # deferred: loads SciPy

    out = free_path(source.with_name(f"{source.stem}_crop{source.suffix}"))
    crop(source, out, *part, progress)
    return out


def list_gaps_job(path: Path, limit: float) -> Job:
    """A job whose result is `SessionGaps`, empty for a session that was never tracked. ``limit``: s
    of *inferred* that are not listed."""

    def run(progress: JobProgress) -> SessionGaps:

        with SessionReader(path) as reader:
            edits, start = reader.edits, reader.span_ns[0]
            tracked = any(n.startswith("/hand/") for n in reader.topic_names)
        try:
            gaps = session_gaps(path, limit, progress) if tracked else []
        except FileError:  # damaged, or without estimates: `verify` and the replay report it
            gaps = []
        filled = tuple(f for edit in edits for f in edit.filled)
        return SessionGaps(path, tuple(gaps), filled, start)

    return run


def fill_job(source: Path, gaps: Sequence[Gap], method: str, max_gap: float, limit: float) -> Job:
    """A job that fills these gaps in ``…_filled.mcap``; its result is a `FilledSession`."""

    def run(progress: JobProgress) -> FilledSession:
        work = partial(_fill, source, tuple(gaps), method, max_gap, limit)
        made: FilledSession = run_in_subprocess("fill", work, progress)
        return made

    return run


def _fill(
    source: Path,
    gaps: Sequence[Gap],
    method: str,
    max_gap: float,
    limit: float,
    progress: Callable[..., None],
) -> FilledSession:
    from tracker.offline.fill import fill  # deferred: loads SciPy
    from tracker.session.gaps.fill import FillOptions  # deferred: loads SciPy

    out = free_path(source.with_name(f"{source.stem}_filled{source.suffix}"))
    options = FillOptions(method, max_gap, KINDS)
    report = fill(source, out, options, wanted=gaps, limit=limit, watch=progress)
    return FilledSession(out, len(report.filled), len(report.left))
