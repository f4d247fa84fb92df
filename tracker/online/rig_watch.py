"""Detects a stereo camera that does not match its calibration: swapped images, moved lenses.

Three indications, none of which requires the hand's position:

- **Swapped**: blobs of one hue match in one row, with a positive disparity. If many match with
  a negative one and few with a positive one, the images are swapped. Such an image is not used.
- **Row shift**: the row difference that most pairs agree on. It is 0 for a calibrated pair;
  a lens that moved up or down, turned or was knocked changes it permanently.
- **Jump**: between two images all markers are displaced from the filter's prediction by the same
  vector, and stay there (`jump_watch`). No hand does that. A lens moved along the baseline
  gives no other indication: afterwards the hand appears to have another size and distance.

A lens that had already moved along the baseline when tracking began cannot be detected.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, replace
from statistics import median
from typing import Any

import numpy as np

from tracker.base.notices import Outbox, notice, warning
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix
from tracker.messages import Array, BlobFrame, Blobs, FrameResult, IntArray
from tracker.online.jump_watch import Jump, JumpParams, JumpWatch
from tracker.vision.rig import StereoRig

SHIFTS = 24  # rows up or down, among which the most frequent shift is searched
RIGHT_WAY, WRONG_WAY = 0, 1


@dataclass(frozen=True)
class RigWatchParams:
    """Limits. Pixels are for a focal length of 640 and grow with it."""

    nearest: float = 0.15  # m, of markers
    farthest: float = 0.9  # m
    row_px: float = 1.5  # half the width of a row
    votes: int = 4  # pairs that a verdict needs
    clear: float = 2.0  # ratio to the votes for any other shift
    shift_px: float = 1.5  # row shift of a camera that has moved
    shift_pictures: int = 15  # over which the median is taken
    swapped_pictures: int = 3  # in a row, before it is reported


@dataclass(frozen=True)
class RigState:
    """``row_shift_px`` is NaN until enough images showed pairs; ``jumps`` counts."""

    swapped: bool = False
    moved: bool = False
    row_shift_px: float = float("nan")
    jumps: int = 0
    refused: int = 0


class RigWatch:
    """Receives every image before the filter and every result after it."""

    def __init__(
        self, rig: StereoRig, params: RigWatchParams | None = None, jumps: JumpParams | None = None
    ) -> None:
        self._rig, self._params = rig, params or RigWatchParams()
        self._scale = rig.fx / 640.0
        self._shifts: deque[float] = deque(maxlen=self._params.shift_pictures)
        self._wrong_way = self._right_way = 0
        self._jumps = JumpWatch(rig.fx, jumps)
        self.notices = Outbox()
        self.state = RigState()
        self.shift = float("nan")
        """px by which the rows of the left image exceed those of the right one in the last image;
        NaN if pairs do not agree."""

    def usable(self, frame: BlobFrame, reported_px: float = 0.0) -> bool:
        """Whether this image is not swapped, judged by this image alone. A row shift that is
        explained by ``reported_px``, the offset reported by the rig alignment, is not reported
        again."""
        self._jumps.image(frame.t, frame.t_arrival)
        self.shift = float("nan")
        if frame.left is None or frame.right is None:
            return True
        right, wrong, others, shift = leaders(*self._votes(frame.left, frame.right))
        p = self._params
        swapped = wrong >= p.votes and wrong > p.clear * right
        self._note_order(swapped, right >= p.votes and right > wrong)
        if not swapped and right >= p.votes and right > p.clear * others:
            self.shift = shift
            self._note_shift(shift, reported_px)
        return not swapped

    def packet(self, t: float, t_arrival: float) -> None:
        """Adds a packet of the glove, sampled at ``t`` (s): without packets a jump cannot be
        detected."""
        self._jumps.packet(t, t_arrival)

    def check(self, result: FrameResult) -> None:
        """Compares an image with the filter's prediction."""
        jump = self._jumps.check(result)
        if jump is not None:
            self._note_jump(jump)

    # ---- verdicts

    def _note_order(self, swapped: bool, in_order: bool) -> None:
        """Reports swapped images, and correct ones again, after several in a row."""
        self._wrong_way = self._wrong_way + 1 if swapped else 0
        self._right_way = self._right_way + 1 if in_order else 0
        state, enough = self.state, self._params.swapped_pictures
        if swapped:
            self._set(refused=state.refused + 1)
        if self._wrong_way >= enough and not state.swapped:
            self._set(swapped=True)
            self.notices.post(warning("camera.swapped"))
        elif self._right_way >= enough and state.swapped:
            self._set(swapped=False)
            self.notices.post(notice("camera.in_order"))

    def _note_shift(self, shift: float, reported_px: float) -> None:
        """The median over images that show one row shift clearly."""
        p = self._params
        self._shifts.append(shift)
        if len(self._shifts) < p.shift_pictures:
            return
        shift = median(self._shifts)
        limit = p.shift_px * self._scale * (0.6 if self.state.moved else 1.0)
        is_new = abs(shift) - reported_px > p.shift_px * self._scale
        self._report_moved(abs(shift) > limit, shift, is_new)
        self._set(row_shift_px=shift, moved=abs(shift) > limit)

    def _report_moved(self, moved: bool, shift: float, is_new: bool) -> None:
        if moved and is_new and not self.state.moved:
            self.notices.post(warning("camera.lens_moved", apart_px=abs(shift)))
        elif self.state.moved and not moved:
            self.notices.post(notice("camera.fits_again"))

    def _note_jump(self, jump: Jump) -> None:
        self._set(jumps=self.state.jumps + 1)
        if jump.apart > jump.together:
            self.notices.post(warning("camera.lens_knocked", jump_px=jump.apart))
        else:
            self.notices.post(warning("camera.moved", jump_px=jump.together))

    def _set(self, **changes: Any) -> None:
        self.state = replace(self.state, **changes)

    def _votes(self, left: Blobs, right: Blobs) -> tuple[IntArray, Array]:
        focal, p = self._rig.fx * self._rig.baseline, self._params
        return row_votes(
            np.ascontiguousarray(self._rig.left.rectify(left.uv)),
            left.hue,
            np.ascontiguousarray(self._rig.right.rectify(right.uv)),
            right.hue,
            (focal / p.farthest, focal / p.nearest),
            p.row_px * self._scale,
        )


@kernel(nogil=False)
def leaders(counts: IntMatrix, means: Matrix) -> tuple[int, int, int, float]:
    """For `row_votes`: the most votes for one shift with a possible disparity, the most with a
    negative one, the most with a possible one more than three rows from the first, and the mean
    shift (px).
    """
    best, wrong, others = 0, 0, 0
    n = counts.shape[1]
    for k in range(n):
        if counts[RIGHT_WAY, k] > counts[RIGHT_WAY, best]:
            best = k
        wrong = max(wrong, counts[WRONG_WAY, k])
    for k in range(n):
        if abs(k - best) > 3:
            others = max(others, counts[RIGHT_WAY, k])
    return counts[RIGHT_WAY, best], wrong, others, means[RIGHT_WAY, best]


@kernel(nogil=False)
def row_votes(
    left: Matrix,
    left_hue: IntVector,
    right: Matrix,
    right_hue: IntVector,
    disparity: tuple[float, float],
    row_px: float,
) -> tuple[IntMatrix, Matrix]:
    """Number of left blobs with a match at each row shift: counts (2, 49), mean shift (2, 49) px.

    Columns are shifts (left minus right row) of -24 to 24 px. Row 0 counts matches with a
    ``disparity`` (least, most; px) that a hand can have, row 1 with the negative of this
    disparity. A blob with several matches at one shift counts once.
    """
    n = 2 * SHIFTS + 1
    counts, total = np.zeros((2, n), np.int64), np.zeros((2, n))
    nearest = np.empty((2, n))
    for i in range(len(left)):
        nearest[:] = np.inf
        for j in range(len(right)):
            du, dv = left[i, 0] - right[j, 0], left[i, 1] - right[j, 1]
            way = RIGHT_WAY if du > 0 else WRONG_WAY
            if left_hue[i] != right_hue[j] or not disparity[0] <= abs(du) <= disparity[1]:
                continue
            first = int(np.ceil(dv - row_px)) + SHIFTS
            last = int(np.floor(dv + row_px)) + SHIFTS
            for k in range(max(first, 0), min(last, n - 1) + 1):
                if abs(dv - (k - SHIFTS)) < abs(nearest[way, k] - (k - SHIFTS)):
                    nearest[way, k] = dv
        for way in range(2):
            for k in range(n):
                if nearest[way, k] < np.inf:
                    counts[way, k] += 1
                    total[way, k] += nearest[way, k]
    return counts, total / np.maximum(counts, 1)
