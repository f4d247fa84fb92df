"""Estimates the right camera's rotation since the stereo calibration and corrects images for it.

Both rectified images show a marker in the same row. If the right camera has turned by a small
r = (r_x, r_y, r_z) about its rectified axes, a marker that it shows at (x, y), in focal lengths
from the principal point, is too low there by (docs/chain.md, eq. 69)

    e = f_y ( (1 + y²) r_x - x y r_y - x r_z )

r_x is the vertical (epipolar) offset, r_z the roll. r_y, which changes distances, appears only
between opposite corners; where markers do not determine it, it stays at its small prior. What
enters is the assignment of blobs to markers, and nothing else of the filter, so correcting images
does not change the measurement.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field, replace

import numpy as np

from tracker.base.notices import Outbox, warning
from tracker.base.records import record
from tracker.geometry import so3
from tracker.messages import Array, BlobFrame, Blobs, FrameResult
from tracker.vision.rig import StereoRig

WAITING = 64  # maximum number of pending images
GRID = np.array([[x, y] for x in (-0.5, 0.0, 0.5) for y in (-0.3, 0.0, 0.3)])
"""Directions (n, 2), in focal lengths, over which an offset is averaged: where hands are."""


@dataclass(frozen=True)
class AlignmentParams:
    """Angles in rad, times in s; pixels are for a focal length of 640 and grow with it."""

    apply: bool = True
    rotation: float = 0.006  # prior standard deviation of pitch and roll
    yaw: float = 0.001  # the same about the vertical, which rows hardly show
    drift: float = 2e-5  # per √s: a housing that warms up
    every: float = 0.1  # between two images that are used: neighbours err alike
    markers: int = 6  # in both images
    image_px: float = 0.4  # noise that the markers of an image have in common,
    marker_px: float = 1.0  # and that each has
    outlier_px: float = 3.0  # from the median, beyond which a pair is another marker's
    changed_px: float = 1.5  # residual of an image that contradicts the estimate,
    changed_images: int = 8  # after which, in a row, a lens has been knocked
    worth_px: float = 0.3  # offset from which on images are corrected
    clear: float = 3.0  # standard deviations of the offset, at least
    start_px: float = 1.5  # row shift that would keep a hand from being found,
    start_images: int = 10  # as the median of this number of images
    recalibrate_px: float = 1.0  # offset from which on the rig should be calibrated again


@record("rig_alignment", shapes={"r": "3", "P": "3 3 | 0 0", "applied": "3"})
@dataclass(eq=False)
class RigAlignmentSavedState:
    """The saved state: rotation r (3,) rad with its covariance P (3, 3), the time (s) of the image
    used last, the applied correction, the number of contradicting images, row
    shifts (px) before the first match, pending images, and the offset (px) that was reported."""

    r: Array = field(default_factory=lambda: np.zeros(3))
    P: Array = field(default_factory=lambda: np.zeros((0, 0)))
    last: float = -np.inf
    applied: Array = field(default_factory=lambda: np.zeros(3))
    contradicted: int = 0
    shifts: list[float] = field(default_factory=list)
    under_way: list[BlobFrame] = field(default_factory=list)
    reported: float = 0.0


class RigAlignment:
    """Processes images before the engine and results after it. Does nothing with one camera."""

    def __init__(self, rig: StereoRig, params: AlignmentParams | None = None) -> None:
        self._rig, self._params = rig, params or AlignmentParams()
        self._scale = rig.fx / 640.0
        self._r, self._P = np.zeros(3), self._prior()
        self._last, self._contradicted = -np.inf, 0
        self._shifts: list[float] = []
        self._under_way: deque[BlobFrame] = deque(maxlen=WAITING)
        self.applied: Array = np.zeros(3)
        """(3,) rad: the right camera's rotation for which images are corrected."""
        self.reported = 0.0
        """px, the vertical offset that was reported; 0 if none was."""
        self.notices = Outbox()

    @property
    def rotation(self) -> Array:
        """(3,) rad about the right camera's rectified axes, as measured."""
        return self._r.copy()

    @property
    def offset_px(self) -> tuple[float, float]:
        """The vertical offset between the images where hands are, RMS, and its standard
        deviation."""
        H = self._rows(GRID)
        offset, sd = H @ self._r, np.einsum("ni,ij,nj->n", H, self._P, H)
        return float(np.sqrt(np.mean(offset**2))), float(np.sqrt(np.mean(sd)))

    # ---- images

    def remember(self, frame: BlobFrame) -> None:
        """Stores an image as received, until its result is available."""
        if frame.left is not None and frame.right is not None:
            self._under_way.append(frame)

    def start_from(self, shift: float) -> None:
        """An image's row shift (left minus right, px; NaN: unknown), which needs no hand. It is
        used until the first markers are matched."""
        p = self._params
        if not p.apply or np.isfinite(self._last) or not np.isfinite(shift):
            return
        self._shifts = [*self._shifts, shift][-p.start_images :]
        middle = float(np.median(self._shifts))
        if len(self._shifts) == p.start_images and abs(middle) > p.start_px * self._scale:
            self._r = np.array([-middle / self._rig.fy, 0.0, 0.0])
            self.applied = self._r.copy()

    def aligned(self, frame: BlobFrame) -> BlobFrame:
        """The image as if the right camera had not moved since the calibration."""
        if not self.applied.any() or frame.right is None:
            return frame
        return replace(frame, right=self._moved(frame.right))

    def _moved(self, blobs: Blobs) -> Blobs:
        if len(blobs) == 0:
            return blobs
        camera = self._rig.right
        return replace(blobs, uv=camera.unrectify(self._turned(camera.rectify(blobs.uv), 1.0)))

    def _turned(self, uv: Array, sign: float) -> Array:
        """Rectified pixels (n, 2) with the applied rotation removed (1) or added (-1)."""
        rays = np.column_stack([self._directions(uv), np.ones(len(uv))])
        rays = rays @ so3.exp(sign * self.applied).T
        rig = self._rig
        out: Array = rays[:, :2] / rays[:, 2:] * [rig.fx, rig.fy] + [rig.cx, rig.cy]
        return out

    # ---- results

    def restored(self, result: FrameResult) -> FrameResult:
        """Converts the engine's result for an aligned image to the image as received."""
        if not self.applied.any():
            return result
        camera, uv = self._rig.right, result.predicted_right.copy()
        seen = np.isfinite(uv).all(axis=1)
        if seen.any():
            uv[seen] = camera.unrectify(self._turned(camera.rectify(uv[seen]), -1.0))
        return replace(result, predicted_right=uv)

    def learn(self, result: FrameResult, is_known: bool = False) -> None:
        """Evaluates an image's markers. With ``is_known``, the rig watch has reported the offset,
        which is not reported again."""
        while self._under_way and self._under_way[0].t < result.t:
            self._under_way.popleft()
        if not self._under_way or self._under_way[0].t != result.t:
            return
        frame, p = self._under_way.popleft(), self._params
        both = np.flatnonzero((result.match_left >= 0) & (result.match_right >= 0))
        if len(both) < p.markers or frame.t - self._last < p.every:
            return
        assert frame.left is not None and frame.right is not None
        left = self._rig.left.rectify(frame.left.uv[result.match_left[both]])
        right = self._rig.right.rectify(frame.right.uv[result.match_right[both]])
        e = right[:, 1] - left[:, 1]
        if result.row_shift is not None:
            e = e - (result.row_shift[1, both, 1] - result.row_shift[0, both, 1])
        usual = np.isfinite(e) & (np.abs(e - np.nanmedian(e)) < p.outlier_px * self._scale)
        if np.count_nonzero(usual) >= p.markers:
            self._take(frame.t, self._rows(self._directions(right[usual])), e[usual])
            self._decide(is_known)

    def _take(self, t: float, H: Array, e: Array) -> None:
        """Updates with one image: rows H (n, 3) px/rad and offsets e (n,) px."""
        p, scale = self._params, self._scale
        since = t - self._last if np.isfinite(self._last) else 0.0
        self._P = self._P + np.eye(3) * p.drift**2 * max(since, 0.0)
        self._last = t
        r = e - H @ self._r
        contradicts = abs(float(np.median(r))) > p.changed_px * scale
        self._contradicted = self._contradicted + 1 if contradicts else 0
        if self._contradicted >= p.changed_images:
            self._P, self._contradicted = self._prior(), 0
        R = scale**2 * (p.image_px**2 + p.marker_px**2 * np.eye(len(e)))
        K = np.linalg.solve(H @ self._P @ H.T + R, H @ self._P).T
        self._r = self._r + K @ r
        self._P = self._P - K @ H @ self._P
        self._P = (self._P + self._P.T) / 2

    def _decide(self, is_known: bool) -> None:
        """Whether images are corrected, and whether it is time to calibrate again."""
        p, (offset, sd) = self._params, self.offset_px
        if not p.apply:
            return
        clear = offset > max(p.worth_px * self._scale, p.clear * sd)
        if clear or self.applied.any():
            self.applied = self._r.copy()
        limit = p.recalibrate_px * self._scale
        if offset + 2 * sd < limit:
            self.reported = 0.0
        is_due = offset - 2 * sd > limit
        if is_due and not is_known and self.reported == 0.0:
            self.reported = offset
            self.notices.post(warning("camera.calibrate_again", apart_px=offset))

    def _prior(self) -> Array:
        p = self._params
        return np.diag(np.square([p.rotation, p.yaw, p.rotation]))

    def _directions(self, uv: Array) -> Array:
        """(n, 2) in focal lengths of rectified pixels (n, 2)."""
        rig = self._rig
        out: Array = (uv - [rig.cx, rig.cy]) / [rig.fx, rig.fy]
        return out

    def _rows(self, seen: Array) -> Array:
        """(n, 3) px/rad: d e / d r of markers in the directions (n, 2)."""
        x, y = seen.T
        return self._rig.fy * np.column_stack([1 + y**2, -x * y, -x])

    # ---- saving

    def get_state(self) -> RigAlignmentSavedState:
        """The state to save."""
        return RigAlignmentSavedState(
            self._r.copy(), self._P.copy(), float(self._last), self.applied.copy(),
            self._contradicted, list(self._shifts), list(self._under_way), self.reported,
        )  # fmt: skip

    def set_state(self, state: RigAlignmentSavedState) -> None:
        """Continues from `get_state`; a recording without a state starts from the prior."""
        self._r, self.applied = state.r.copy(), state.applied.copy()
        self._P = state.P.copy() if state.P.size else self._prior()
        self._last, self._contradicted = state.last, state.contradicted
        self._shifts, self.reported = list(state.shifts), state.reported
        self._under_way = deque(state.under_way, maxlen=WAITING)
