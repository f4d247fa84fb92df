"""Reference hands of a replay: another tracking of the same movement, or the true motion of the
hand."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from app.engines.protocols import ReferenceHand
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Estimate
from tracker.session.holes import is_hole
from tracker.session.reader import SessionReader

LEAD = 0.2  # s; an estimate may have been fed this long after its instant


class ReferenceTrack:
    """Follows a replay through the estimates of a file (``root`` is ``hand``), through the ground
    truth of a simulation (``truth``) or through a laboratory's recording (``reference``).

    ``side``: of the hand, in a file of both. ``shift``: s that its clock is ahead of the replay's,
    if it is of another movement.
    """

    def __init__(self, path: Path, side: str = "", root: str = "hand", shift: float = 0.0) -> None:
        self._reader = SessionReader(path, side=side)
        self._root, self._shift = root, shift
        info = self._reader.info
        self._rows = origin_rows(info.hand, info.glove)
        self._estimates_ahead: Iterator[Estimate] = iter(())
        self._last: Estimate | None = None
        self._next: Estimate | None = None

    def seek(self, t: float) -> None:
        """Restart at ``t`` s of the monotonic clock."""
        self._estimates_ahead = self._messages(t + self._shift - LEAD)
        self._last = self._next = None

    def _messages(self, start: float) -> Iterator[Estimate]:
        if self._root != "hand":
            known = {"truth": self._reader.truth, "reference": self._reader.reference}
            yield from known[self._root](start)
            return
        for message in self._reader.messages((Estimate,), start=start):
            assert isinstance(message, Estimate)
            yield message

    def advance(self, t: float) -> None:
        """Advance to the last estimate that is not later than ``t``."""
        while self._next is None or self._next.t <= t + self._shift + 1e-6:
            self._last = self._next if self._next is not None else self._last
            self._next = next(self._estimates_ahead, None)
            if self._next is None:
                return

    def pose(self, t: float) -> ReferenceHand | None:
        """The hand at ``t``; None where it was lost or is unknown."""
        found = self._last
        if found is None or is_hole(found.t - self._shift, t):
            return None
        if not np.isfinite(found.keypoints).all(axis=1).any():
            return None
        p, q = found.keypoints[self._rows], found.keypoint_q[self._rows]
        return ReferenceHand(found.keypoints, so3.matrix_from_quat(q), p)

    def close(self) -> None:
        self._reader.close()


def origin_rows(hand: HandModel, glove: GloveModel) -> list[int]:
    """(S,) row of the keypoint at which each segment starts: the first one that moves with it."""
    segments = glove.keypoint_segments(hand).tolist()
    return [segments.index(i) for i in range(len(hand.segments))]


class References:
    """Reference hands of one hand of a replay; ``known``: what the file contains besides, ``truth``
    or a laboratory's ``reference``, or nothing.

    `want` is called by the window, everything else by the replay's thread.
    """

    def __init__(self, path: Path, side: str, known: str) -> None:
        self._side = side
        self._known = known
        self._truth = ReferenceTrack(path, side, known) if known else None
        self._other: ReferenceTrack | None = None
        self._wanted: ReferenceTrack | None = None
        self.true_hand: ReferenceHand | None = None
        self.other_hand: ReferenceHand | None = None

    def truth(self) -> ReplayedTruth | None:
        """The true hand at the instant of the latest estimate; None without truth."""
        return None if self._truth is None else ReplayedTruth(self, self._known == "reference")

    def want(self, path: Path | None, shift: float = 0.0) -> None:
        """The tracking in ``path``, from the next `seek` on. Raises FileError."""
        self._wanted = None if path is None else ReferenceTrack(path, self._side, shift=shift)

    def seek(self, t: float) -> None:
        """Restart at ``t`` s of the monotonic clock."""
        self._change()
        for track in (self._truth, self._other):
            if track is not None:
                track.seek(t)

    def _change(self) -> None:
        """The only place that closes a track, so that none is closed while it is read."""
        if self._other is not self._wanted:
            if self._other is not None:
                self._other.close()
            self._other, self.other_hand = self._wanted, None

    def advance(self, t: float) -> None:
        """Advance to the instant of an estimate of the replay."""
        if self._truth is not None:
            self._truth.advance(t)
            self.true_hand = self._truth.pose(t)
        if self._other is not None:
            self._other.advance(t)
            self.other_hand = self._other.pose(t)

    def close(self) -> None:
        for track in {self._truth, self._other, self._wanted}:
            if track is not None:
                track.close()


class ReplayedTruth:
    """The true hand of a replay: at the instant of the latest estimate, for any ``t``.

    ``is_measured``: by a laboratory; otherwise it is the simulated one.
    """

    def __init__(self, references: References, is_measured: bool = False) -> None:
        self._references, self.is_measured = references, is_measured

    def at(self, t: float) -> ReferenceHand | None:
        return self._references.true_hand
