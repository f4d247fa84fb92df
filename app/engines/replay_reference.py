"""The second hand of a replay: another tracking of the same movement, or the truth."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from app.engines.engine import ReferenceHand
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Estimate
from tracker.session.reader import SessionReader

LEAD = 0.2  # s; an estimate may have been fed this long after its instant
CLOSE = 0.05  # s between two instants that still are the same one


class ReferenceTrack:
    """Goes along with a replay through the estimates of a file, or through its truth."""

    def __init__(self, path: Path, truth: bool = False) -> None:
        self._reader = SessionReader(path)
        self._truth = truth
        info = self._reader.info
        self._rows = origin_rows(info.hand, info.glove)
        self._coming: Iterator[Estimate] = iter(())
        self._last: Estimate | None = None
        self._next: Estimate | None = None

    def seek(self, t: float) -> None:
        """Begin anew at ``t`` s of the monotonic clock."""
        self._coming = self._messages(t - LEAD)
        self._last = self._next = None

    def _messages(self, start: float) -> Iterator[Estimate]:
        if self._truth:
            yield from self._reader.truth(start)
            return
        for message in self._reader.messages((Estimate,), start=start):
            assert isinstance(message, Estimate)
            yield message

    def advance(self, t: float) -> None:
        """Go on to the last estimate that is not later than ``t``."""
        while self._next is None or self._next.t <= t + 1e-6:
            self._last = self._next if self._next is not None else self._last
            self._next = next(self._coming, None)
            if self._next is None:
                return

    def pose(self, t: float) -> ReferenceHand | None:
        """The hand there at ``t``; None where it was lost or nothing is known."""
        found = self._last
        if found is None or abs(found.t - t) > CLOSE:
            return None
        p, q = found.keypoints[self._rows], found.keypoint_q[self._rows]
        if not (np.isfinite(p).all() and np.isfinite(q).all()):
            return None
        return ReferenceHand(found.keypoints, so3.matrix_from_quat(q), p)

    def close(self) -> None:
        self._reader.close()


def origin_rows(hand: HandModel, glove: GloveModel) -> list[int]:
    """(S,) row of the keypoint at which each segment starts: the first one that moves with it."""
    segments = glove.keypoint_segments(hand).tolist()
    return [segments.index(i) for i in range(len(hand.segments))]
