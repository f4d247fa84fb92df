"""Jobs that read recordings for curves: all signals, the motion, or two recordings to compare."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Collection, Sequence
from pathlib import Path

import numpy as np

from app.engines.engine import EngineSetup
from app.engines.replay.marker_matches import MarkerMatcher
from app.platform.tasks import Job, JobProgress
from app.viewmodels.signal_curves import RecordingCurves
from app.viewmodels.signal_rows import (
    GestureRows,
    Rows,
    hand_rows,
    image_rows,
    imu_rows,
    status_rows,
)
from app.viewmodels.signals import SignalSource
from app.viewmodels.two_recordings import TwoRecordings, read_angles
from tracker.base.errors import FileError
from tracker.base.files import disk_error
from tracker.base.notices import notice
from tracker.live.history import SearchedImage
from tracker.messages import BlobFrame, Estimate, FrameResult, ImuSample, Status, Tracking
from tracker.session.motion import Take, read_take
from tracker.session.reader import SessionReader

KINDS = (ImuSample, Estimate, BlobFrame, Status)
AT_ONCE = 500  # estimates or images between two checks for cancellation


def read_motion(path: Path, side: str = "") -> Callable[[JobProgress], Take | None]:
    """A job; its result is None without estimates. ``side``: the hand, if there are two."""

    def job(progress: JobProgress) -> Take | None:
        with SessionReader(path, watch=progress, side=side) as reader:
            try:
                return read_take(reader)
            except FileError:
                return None

    return job


def csv_of(text: str, path: Path) -> None:
    """Write a table. Raises FileError."""
    try:
        path.write_text(text, "utf-8", newline="")
    except OSError as error:
        raise disk_error(path, error) from error


def read_signals(path: Path, setup: EngineSetup) -> Callable[[JobProgress], RecordingCurves]:
    """A job that reads the recording of ``setup`` for the curves of all its hands."""

    def job(progress: JobProgress) -> RecordingCurves:
        rows: dict[tuple[str, SignalSource], Rows] = {}
        for hand in setup.hands:
            with SessionReader(path, side=hand.side, watch=progress) as reader:
                for source, found in _rows_of(reader, hand, progress).items():
                    rows[hand.side, source] = found
        return RecordingCurves(rows)

    return job


def _rows_of(
    reader: SessionReader, setup: EngineSetup, progress: JobProgress
) -> dict[SignalSource, Rows]:
    """Rows of one hand by source; times are s from the recording's start."""
    found: dict[type, list[object]] = {kind: [] for kind in KINDS}
    for message in reader.messages(KINDS):
        found[type(message)].append(message)
    samples = [m for m in found[ImuSample] if isinstance(m, ImuSample)]
    estimates = [m for m in found[Estimate] if isinstance(m, Estimate)]
    estimates.sort(key=lambda e: e.t)
    blobs = [m for m in found[BlobFrame] if isinstance(m, BlobFrame)]
    statuses = [m for m in found[Status] if isinstance(m, Status)]
    start = reader.anchor.monotonic(reader.span_ns[0])
    rows = {
        SignalSource.IMU: imu_rows(samples),
        SignalSource.HAND: hand_rows(estimates),
        SignalSource.GESTURES: _gestures(setup, estimates, progress),
        SignalSource.IMAGES: _images(setup, blobs, estimates, progress),
        SignalSource.STATUS: status_rows(statuses),
    }
    return {source: Rows(each.t - start, each.columns) for source, each in rows.items()}


def _gestures(setup: EngineSetup, estimates: Sequence[Estimate], progress: JobProgress) -> Rows:
    source, parts = GestureRows(setup), []
    for begin in range(0, len(estimates), AT_ONCE):
        progress(-1.0, "")
        parts.append(source.rows(estimates[begin : begin + AT_ONCE]))
    return _joined(parts)


def _images(
    setup: EngineSetup,
    blobs: Sequence[BlobFrame],
    estimates: Sequence[Estimate],
    progress: JobProgress,
) -> Rows:
    """The recording does not contain the matching of blobs and markers: it is computed from the
    recorded estimates."""
    matcher = (
        MarkerMatcher(setup.hand, setup.glove, setup.camera.rig)
        if setup.camera.calibrated
        else None
    )
    images = []
    for i, frame in enumerate(blobs):
        if i % AT_ONCE == 0:
            progress(-1.0, "")
        at = bisect_left(estimates, frame.t, key=lambda e: e.t)
        around = estimates[max(0, at - 1) : at + 1]
        result = _result(setup, matcher, frame, around)
        images.append(SearchedImage(frame.t, len(frame.left or ()), len(frame.right or ()), result))
    return image_rows(images)


def _result(
    setup: EngineSetup,
    matcher: MarkerMatcher | None,
    frame: BlobFrame,
    around: Sequence[Estimate],
) -> FrameResult:
    if matcher is not None:
        return matcher.match(frame, around)
    return FrameResult.nothing(frame.t, Tracking.SEARCHING, len(setup.glove.markers))


def _joined(parts: Sequence[Rows]) -> Rows:
    if not parts:
        return Rows(np.zeros(0), {})
    names: Collection[str] = parts[0].columns
    columns = {name: np.concatenate([part.columns[name] for part in parts]) for name in names}
    return Rows(np.concatenate([part.t for part in parts]), columns)


def two_recordings_job(first: Path, second: Path) -> Job:
    """A job whose result is a `TwoRecordings`; fails with a message if one was never tracked."""

    def run(progress: JobProgress) -> TwoRecordings:
        recordings = []
        for i, path in enumerate((first, second)):
            progress(i / 2, path.name)
            recordings.append(read_angles(path))
            if not len(recordings[-1].t):
                raise FileError(notice("window.not_tracked", file=path.name))
        return TwoRecordings(*recordings)

    return run
