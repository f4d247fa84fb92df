"""The delay of the right camera's exposure when two cameras are not synchronized.

Two webcams run freely, so a moving marker appears in another row of the right image than of the
left one:

    row_right - row_left = shift + late * speed of the row

The slope of this line is the delay of the right image, whatever row shift the calibration
leaves. The filter's estimate enters only by the assignment of blobs to markers. The blobs of the
right image are then moved back by the hand's expected motion during the delay, which is
some pixels, and which the IMUs give within a few per cent.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector
from tracker.messages import Array, BlobFrame, Blobs, CameraPose, FrameResult, IntArray
from tracker.online.time_offset import Offset
from tracker.vision.rig import StereoRig

WAITING = 60  # maximum number of pending images


@dataclass(frozen=True)
class PairOffsetParams:
    """Times in s."""

    memory: float = 20.0  # over which older images are forgotten: free clocks drift
    block: float = 1.5  # over which images are compared with all before
    jump: float = 0.006  # by which they differ where a camera has skipped an image
    gap: float = 0.12  # longest time between an image and the one after the next
    markers: int = 6  # in both images
    row_px: float = 1.5  # beyond which a row difference weighs less
    most_shift_px: float = 40.0  # of a row; more is another blob
    images: int = 60  # before anything is reported
    sure: float = 0.002  # standard deviation, at most
    worth: float = 0.004  # below it the right image is not changed
    limit: float = 0.06  # beyond it the estimate is not used
    near_px: float = 80.0  # a blob this far from every marker is not moved


@record("pair_offset.rows", shapes={"marker": "int n", "left": "n", "right": "n"})
class _Rows(NamedTuple):
    """Markers (n,) that both images at ``t`` (s) show, and their rectified rows (n,) px."""

    t: float
    marker: IntArray
    left: Array
    right: Array


@record("pair_offset.line")
@dataclass(eq=False)
class LineSavedState:
    """Weighted sums over images: of 1, the speed w, the row difference e, w w, w e, the squared
    residual, and the number of images; and the arrival (s) of the last one."""

    n: float = 0.0
    w: float = 0.0
    e: float = 0.0
    ww: float = 0.0
    we: float = 0.0
    rr: float = 0.0
    images: float = 0.0
    last: float = -np.inf

    def take(self, t: float, w: Array, e: Array, memory: float, row_px: float) -> None:
        """Adds an image: speeds w (n,) px/s and row differences e (n,) px."""
        keep = float(np.exp(-(t - self.last) / memory)) if np.isfinite(self.last) else 1.0
        slope, shift = self.fit()
        r = e - shift - slope * w
        weight = np.minimum(1.0, row_px / np.maximum(np.abs(r), 1e-9))
        self.n = keep * self.n + float(weight.sum())
        self.w, self.e = keep * self.w + float(weight @ w), keep * self.e + float(weight @ e)
        self.ww = keep * self.ww + float(weight @ w**2)
        self.we = keep * self.we + float(weight @ (w * e))
        self.rr = keep * self.rr + float(weight @ r**2)
        self.images, self.last = keep * self.images + 1.0, t

    def fit(self) -> tuple[float, float]:
        """Slope (s) and shift (px), zeros while there is nothing."""
        spread = self.spread
        if spread <= 0:
            return 0.0, 0.0
        slope = (self.we - self.w * self.e / self.n) / spread
        return float(slope), float((self.e - slope * self.w) / self.n)

    @property
    def spread(self) -> float:
        """Variance of the speeds, px²/s²."""
        return float(self.ww - self.w**2 / self.n) if self.n > 0 else 0.0

    @property
    def sd(self) -> float:
        """s, of the slope: the markers of an image err together, so that images count."""
        if self.spread <= 0 or self.images <= 0:
            return float("inf")
        return float(np.sqrt(self.rr / self.images / self.spread))


@record("pair_offset")
@dataclass(eq=False)
class PairOffsetSavedState:
    """The saved state."""

    seen: list[_Rows] = field(default_factory=list)
    all: LineSavedState = field(default_factory=LineSavedState)
    block: LineSavedState = field(default_factory=LineSavedState)
    since: float = np.inf  # s when the block began
    under_way: list[BlobFrame] = field(default_factory=list)


class PairOffset:
    """Processes images before the engine and results after it. Does nothing with one camera."""

    def __init__(self, rig: StereoRig, params: PairOffsetParams | None = None) -> None:
        self._rig, self._params = rig, params or PairOffsetParams()
        self._seen: deque[_Rows] = deque(maxlen=3)
        self._all, self._block, self._since = LineSavedState(), LineSavedState(), np.inf
        self._under_way: deque[BlobFrame] = deque(maxlen=WAITING)

    @property
    def estimate(self) -> Offset:
        """The measured delay of the right image relative to the left one."""
        value, p = self._all.fit()[0], self._params
        if self._all.images < p.images or abs(value) > p.limit:
            return Offset()
        return Offset(value, self._all.sd)

    @property
    def applied(self) -> float:
        """Time (s) by which the right image is corrected; 0 if negligible or uncertain."""
        found, p = self.estimate, self._params
        clear = found.sd <= p.sure and abs(found.value) > max(p.worth, 3 * found.sd)
        return found.value if clear else 0.0

    # ---- images

    def remember(self, frame: BlobFrame) -> None:
        """Stores an image as received, until its result is available."""
        if frame.left is not None and frame.right is not None:
            self._under_way.append(frame)

    def moved_back(self, frame: BlobFrame, then: Array, late: Array) -> BlobFrame:
        """The image with the right one's blobs moved to the instant of the left one.

        ``then`` and ``late`` (M, 3) m in G: markers expected at the two exposures.
        """
        pose = frame.pose or self._rig.pose
        if frame.right is None or len(then) == 0:
            return frame
        return replace(frame, right=self._moved(frame.right, then, late, pose))

    def _moved(self, blobs: Blobs, then: Array, late: Array, pose: CameraPose) -> Blobs:
        rig = self._rig
        at = [rig.project((p_G - pose.p_GC) @ pose.R_GC, right=True) for p_G in (then, late)]
        there = np.isfinite(at[0]).all(axis=1) & np.isfinite(at[1]).all(axis=1)
        if not there.any() or len(blobs) == 0:
            return blobs
        before, after = at[0][there], at[1][there]
        uv = rig.right.rectify(blobs.uv)
        apart = np.linalg.norm(uv[:, None] - after[None], axis=2)
        nearest = apart.argmin(axis=1)
        near = apart.min(axis=1) <= self._params.near_px
        uv[near] -= (after - before)[nearest[near]]
        return replace(blobs, uv=rig.right.unrectify(uv), cloth=None)  # of another instant

    # ---- results

    def learn(self, result: FrameResult) -> None:
        """Evaluates an image's markers."""
        while self._under_way and self._under_way[0].t < result.t:
            self._under_way.popleft()
        if not self._under_way or self._under_way[0].t != result.t:
            return
        frame = self._under_way.popleft()
        both = np.flatnonzero((result.match_left >= 0) & (result.match_right >= 0))
        if len(both) < self._params.markers:
            return
        assert frame.left is not None and frame.right is not None
        left = self._rig.left.rectify(frame.left.uv[result.match_left[both]])
        right = self._rig.right.rectify(frame.right.uv[result.match_right[both]])
        self._seen.append(_Rows(frame.t, both, left[:, 1], right[:, 1]))
        if len(self._seen) == 3:
            self._take(*self._seen)

    def _take(self, before: _Rows, now: _Rows, after: _Rows) -> None:
        """Speeds are those between the image before and the one after."""
        p, dt = self._params, after.t - before.t
        if not 0 < dt <= p.gap:
            return
        rows = _in_all(before.marker, now.marker, after.marker)
        if len(rows) < p.markers:
            return
        old, mid, new = before.left[rows[:, 0]], now.left[rows[:, 1]], after.left[rows[:, 2]]
        e = now.right[rows[:, 1]] - mid
        w = (new - old) / dt
        fits = np.abs(e) <= p.most_shift_px
        if fits.sum() < p.markers:
            return
        for line, memory in ((self._all, p.memory), (self._block, np.inf)):
            line.take(now.t, w[fits], e[fits], memory, p.row_px)
        self._since = min(self._since, now.t)
        if now.t - self._since >= p.block:
            self._notice_jump()
            self._block, self._since = LineSavedState(), np.inf

    def _notice_jump(self) -> None:
        """A camera that skipped an image has another delay from then on: after a block in
        which it did, the next block shows by how much."""
        p, block = self._params, self._block
        apart = abs(block.fit()[0] - self._all.fit()[0])
        if self._all.images >= p.images and apart > max(p.jump, 4 * block.sd) > 0:
            self._all = replace(block, images=float(p.images))

    # ---- saving

    def get_state(self) -> PairOffsetSavedState:
        """The state to save."""
        return PairOffsetSavedState(
            list(self._seen),
            replace(self._all),
            replace(self._block),
            float(self._since),
            list(self._under_way),
        )

    def set_state(self, state: PairOffsetSavedState) -> None:
        """Continues from `get_state`."""
        self._seen = deque(state.seen, maxlen=3)
        self._all, self._block = replace(state.all), replace(state.block)
        self._since = state.since
        self._under_way = deque(state.under_way, maxlen=WAITING)


@kernel(nogil=False)
def _in_all(a: IntVector, b: IntVector, c: IntVector) -> IntMatrix:
    """Rows (n, 3) of the numbers that are in all three, each in rising order."""
    out = np.empty((len(a), 3), np.int64)
    n = i = j = k = 0
    while i < len(a) and j < len(b) and k < len(c):
        most = max(a[i], b[j], c[k])
        if a[i] == most and b[j] == most and c[k] == most:
            out[n, 0], out[n, 1], out[n, 2] = i, j, k
            n += 1
            i, j, k = i + 1, j + 1, k + 1
        else:
            i, j, k = i + (a[i] < most), j + (b[j] < most), k + (c[k] < most)
    return out[:n]
