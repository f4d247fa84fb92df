"""Jobs of the dialogs: what takes long runs in subprocesses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import NamedTuple

from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress
from extensions.reference.accuracy import headline, worst_of
from extensions.reference.importing import ReferenceImportOptions, import_reference
from extensions.reference.recognition import RecognisedPoints, mapping_template, recognise
from extensions.reference.remarks import remarks
from extensions.reference.report import write_report
from extensions.reference.session import Described
from tracker.base.errors import GlovetrackError, notice_of
from tracker.base.files import free_path, write_whole
from tracker.base.notices import Notice

Watch = Callable[..., None]


@dataclass(frozen=True)
class ReferenceFile:
    """A file to be recognised: of a hand with these keypoints."""

    path: Path
    mapping: Path | None
    pulse: str
    keypoints: tuple[str, ...]
    side: str


class Answer(NamedTuple):
    """What is in the file that request ``number`` named, or why it cannot be read."""

    number: int
    found: RecognisedPoints | None
    problem: Notice | None


def recognise_job(number: int, file: ReferenceFile) -> Job:
    """A job that returns an `Answer`."""

    def run(progress: JobProgress) -> Answer:
        progress(-1.0, file.path.name)
        try:
            found = recognise(file.path, file.keypoints, file.side, file.mapping, file.pulse)
        except GlovetrackError as error:
            return Answer(number, None, notice_of(error))
        return Answer(number, found, None)

    return run


def template_job(file: ReferenceFile, out: Path) -> Job:
    """A job that writes a mapping file to begin with, and returns its path."""

    def run(progress: JobProgress) -> Path:
        progress(-1.0, out.name)
        text = mapping_template(file.path, file.keypoints, file.side)
        write_whole(out, text, force=True, inputs=[file.path])
        return out

    return run


class ImportedSession(NamedTuple):
    """The new session, its reference, and what to know about it."""

    path: Path
    about: Described
    remarks: list[Notice]


def import_job(reference: Path, session: Path, options: ReferenceImportOptions) -> Job:
    """A job that returns an `ImportedSession`: ``…_reference.mcap`` next to ``session``."""

    def run(progress: JobProgress) -> ImportedSession:
        work = partial(_import, reference, session, options)
        out: ImportedSession = run_in_subprocess("import-reference", work, progress)
        return out

    return run


def _import(
    reference: Path, session: Path, options: ReferenceImportOptions, watch: Watch
) -> ImportedSession:
    out = free_path(session.with_name(f"{session.stem}_reference{session.suffix}"))
    about = import_reference(reference, session, out, options, watch=watch)
    return ImportedSession(out, about, remarks(about, options.with_drift))


class WorstInstant(NamedTuple):
    """A large error: of a hand of ``session`` at t s; ``error`` and ``sd`` in m."""

    session: Path
    side: str
    t: float
    keypoint: str
    error: float
    state: str
    sd: float


class AccuracyReport(NamedTuple):
    """The page, the line to quote, and the largest errors."""

    page: Path
    line: str
    worst: tuple[WorstInstant, ...]


def accuracy_job(sessions: Sequence[Path], offsets: bool, anonymous: bool) -> Job:
    """A job that returns an `AccuracyReport`; its page is next to the first session."""

    def run(progress: JobProgress) -> AccuracyReport:
        work = partial(_report, tuple(sessions), offsets, anonymous)
        out: AccuracyReport = run_in_subprocess("accuracy", work, progress)
        return out

    return run


def _report(
    sessions: Sequence[Path], offsets: bool, anonymous: bool, watch: Watch
) -> AccuracyReport:
    first = sessions[0]
    alone = len(sessions) == 1 and not anonymous
    page = free_path(first.with_name(f"{first.stem}_accuracy.html" if alone else "accuracy.html"))
    measured = write_report(sessions, page, offsets, anonymous, watch=watch)
    worst = tuple(
        WorstInstant(m.pairs.path, m.pairs.side, w.t, w.keypoint, w.error, w.state, w.sd)
        for m, w in worst_of(measured)
    )
    return AccuracyReport(page, headline(measured), worst)
