"""Estimates the delay of the camera's stamps from the motion of the back of the hand.

Markers on the root segment that both cameras see give its orientation R_GB without any IMU, as do
more of them in the image of one camera, by perspective; the root's gyroscope gives the rotation
since a moment before. If images are stamped late by o,

    log(D_gyro^T D_markers) = o (D_gyro^T w_0 - w_1)

for the turns D and the rates w at the two instants: a straight line through zero whose slope is o.
Differences over a fraction of a second leave out drift, gyro bias and the camera's yaw. Nothing of
the filter's estimate enters except the assignment of blobs to markers, so correcting the offset
does not change the measurement.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass
from typing import NamedTuple

import cv2
import numpy as np

from tracker.base.records import record
from tracker.geometry.kernels import exp3, log3, mul3, nearest_rotation, rotate, rotate_back, tmul3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Vector
from tracker.messages import Array, BlobFrame, FrameResult, ImuSample
from tracker.vision.rig import StereoIntrinsics, StereoRig, triangulated

FLAT = 1e-6  # m², for markers on one line
FIRST_SD = 0.003  # m of a marker about the rigid root, before it is measured


@dataclass(frozen=True)
class TimeOffsetParams:
    """Times in s."""

    least: float = 0.20  # between the two images of a pair
    most: float = 0.45
    every: float = 0.03  # between two images that are used: more add little information
    packet_gap: float = 0.05  # a longer one breaks the gyroscope's integral
    memory: float = 180.0  # over which older pairs are forgotten
    markers: int = 4  # that an image needs
    markers_of_one: int = 5  # that the image of one camera needs
    misfit: float = 0.004  # m, RMS of the markers about the rigid root
    huber: float = 2.0  # standard deviations
    limit: float = 0.1  # beyond it the estimate is not used
    correlation: float = 2.0  # of neighbouring pairs: factor on the variance
    correlation_of_one: float = 8.0  # the same for one camera, whose perspective errors last longer
    pairs: int = 60  # before anything is reported


@dataclass(frozen=True)
class Offset:
    """``value``: delay (s) of the images' stamps (negative: early), with ``sd`` (s); NaN, inf
    while unknown."""

    value: float = float("nan")
    sd: float = float("inf")


@record("time_offset.rotation", shapes={"R": "3 3", "rate": "3"})
class _GyroRotation(NamedTuple):
    """The root by its gyroscope: R (3, 3) up to a constant on the left, rate (3,) rad/s in B."""

    t: float
    R: Matrix
    rate: Vector


@record("time_offset.view", shapes={"marker": "int n", "p_G": "n 3", "R_GB": "3 3"})
class _RootView(NamedTuple):
    """The root's markers in an image: rows ``marker`` (n,), positions p_G (n, 3) m but for the
    camera's own; and their R_GB (3, 3), within the error of their placement."""

    t: float
    marker: IntVector
    p_G: Matrix
    R_GB: Matrix


@record("time_offset")
@dataclass(eq=False)
class TimeOffsetSavedState:
    """The saved state: recent gyroscope samples and images, sums over pairs of
    images, and the times (s) of the images used and seen last."""

    gyro: list[_GyroRotation]
    seen: list[_RootView]
    late: list[_RootView]
    ata: float
    atb: float
    rss: float
    count: float
    last: float
    last_seen: float
    of_one: bool = False


class TimeOffset:
    """Receives packets and images in order; `estimate` is available at any time."""

    def __init__(
        self,
        hand: HandModel,
        glove: GloveModel,
        rig: StereoRig,
        params: TimeOffsetParams | None = None,
    ) -> None:
        self._params, self._rig = params or TimeOffsetParams(), rig
        segment = glove.marker_segment(hand)
        self._nominal = glove.marker_position
        on_root = glove.imu_segment(hand) == 0
        self._imu = int(np.flatnonzero(on_root)[0]) if on_root.any() else -1
        self._R_BI = glove.imus[self._imu].R_BI if self._imu >= 0 else np.eye(3)
        self._markers = np.flatnonzero(segment == 0)
        self._gyro: deque[_GyroRotation] = deque()
        self._seen: deque[_RootView] = deque()
        self._late: deque[_RootView] = deque()  # seen, and waiting for packets
        self._ata = self._atb = self._count = 0.0
        self._rss, self._last, self._last_seen = 0.0, -np.inf, -np.inf
        self._of_one = False  # estimated from images of one camera

    @property
    def estimate(self) -> Offset:
        """The current estimate of the offset."""
        p = self._params
        if self._count < p.pairs or self._ata <= 0:
            return Offset()
        value = self._atb / self._ata
        correlation = p.correlation_of_one if self._of_one else p.correlation
        variance = self._rss / (3 * self._count) * correlation / self._ata
        if abs(value) > p.limit:
            return Offset()
        return Offset(float(value), float(np.sqrt(variance)))

    def feed_imu(self, sample: ImuSample) -> None:
        """Continues the gyroscope's integral."""
        if self._imu < 0 or not sample.valid[self._imu]:
            return
        rate = rotate(self._R_BI, sample.gyro[self._imu])
        gyro = self._gyro
        if not gyro or not 0 < sample.t - gyro[-1].t <= self._params.packet_gap:
            gyro.clear()
            self._seen.clear()
            gyro.append(_GyroRotation(sample.t, np.eye(3), rate))
            return
        last = gyro[-1]
        R = _rotated(last.R, last.rate, rate, sample.t - last.t)
        gyro.append(_GyroRotation(sample.t, R, rate))
        while gyro[-1].t - gyro[0].t > 2 * self._params.most + 0.5:
            gyro.popleft()
        self._process()

    def feed_image(self, frame: BlobFrame, result: FrameResult) -> None:
        """Adds an image with its own stamp and the assignment of blobs to markers."""
        if abs(frame.t - self._last_seen) < self._params.every:
            return
        view = self._view(frame, result)
        if view is not None:
            self._last_seen = frame.t
            self._late.append(view)
            self._process()

    def get_state(self) -> TimeOffsetSavedState:
        """The state to save."""
        return TimeOffsetSavedState(
            gyro=list(self._gyro),
            seen=list(self._seen),
            late=list(self._late),
            ata=float(self._ata),
            atb=float(self._atb),
            rss=float(self._rss),
            count=float(self._count),
            last=float(self._last),
            last_seen=float(self._last_seen),
            of_one=self._of_one,
        )

    def set_state(self, state: TimeOffsetSavedState) -> None:
        """Continues from `get_state`."""
        self._gyro, self._seen, self._late = deque(state.gyro), deque(state.seen), deque(state.late)
        self._ata, self._atb, self._rss = state.ata, state.atb, state.rss
        self._count, self._last, self._last_seen = state.count, state.last, state.last_seen
        self._of_one = state.of_one

    # ---- markers

    def _view(self, frame: BlobFrame, result: FrameResult) -> _RootView | None:
        """The root's markers that all images show; None if they are too few or do not match."""
        if not frame.left or not frame.right:  # no markers, or none with a blob
            return self._view_of_one(frame, result)
        marker, left, right = _in_both(self._markers, result.match_left, result.match_right)
        if len(marker) < self._params.markers:
            return None
        pose, rig = frame.pose or self._rig.pose, self._rig
        sides = rig.left.rectify(frame.left.uv[left]), rig.right.rectify(frame.right.uv[right])
        if result.row_shift is not None:
            sides = sides[0] - result.row_shift[0, marker], sides[1] - result.row_shift[1, marker]
        p_G, R_GB, misfit = _placed(
            np.ascontiguousarray(sides[0]), np.ascontiguousarray(sides[1]),
            rig.intrinsics, pose.R_GC, self._nominal[marker],
        )  # fmt: skip
        return _RootView(frame.t, marker, p_G, R_GB) if misfit < self._params.misfit else None

    def _view_of_one(self, frame: BlobFrame, result: FrameResult) -> _RootView | None:
        """The same for one camera; its markers are placed by the root's pose."""
        blobs, match = frame.left, result.match_left
        camera = self._rig.left
        if not blobs:
            blobs, match, camera = frame.right, result.match_right, self._rig.right
        marker = self._markers[match[self._markers] >= 0]
        if blobs is None or len(marker) < self._params.markers_of_one:
            return None
        uv, rig = camera.rectify(blobs.uv[match[marker]]), self._rig
        if result.row_shift is not None:
            uv = uv - result.row_shift[int(camera is rig.right), marker]
        seen = (uv - [rig.cx, rig.cy]) / [rig.fx, rig.fy]
        found = posed(self._nominal[marker], seen)
        if found is None or found[2] > self._params.misfit:
            return None
        self._of_one = True
        R_CB, p_CB, _ = found
        R_GC = (frame.pose or rig.pose).R_GC
        p_G = (self._nominal[marker] @ R_CB.T + p_CB) @ R_GC.T
        return _RootView(frame.t, marker, p_G, R_GC @ R_CB)

    # ---- pairs

    def _process(self) -> None:
        """Pairs images that packets cover with an earlier one."""
        while self._late and self._gyro and self._late[0].t <= self._gyro[-1].t:
            now = self._late.popleft()
            if now.t < self._gyro[0].t:
                continue
            p = self._params
            while self._seen and now.t - self._seen[0].t > p.most:
                self._seen.popleft()
            if self._seen and now.t - self._seen[0].t >= p.least:
                self._pair(self._seen[0], now)
            self._seen.append(now)

    def _pair(self, before: _RootView, now: _RootView) -> None:
        """The rotation of the same markers, which does not depend on their placement."""
        gyro_0, gyro_1 = self._rotation_at(before.t), self._rotation_at(now.t)
        if gyro_0 is None or gyro_1 is None:
            return
        fits, a, e = _point(
            self._nominal, before, now, gyro_0, gyro_1, self._params.markers, self._params.misfit
        )
        if fits:
            self._take(now.t, a, e)

    def _rotation_at(self, t: float) -> _GyroRotation | None:
        """The gyroscope's orientation between two packets."""
        gyro = self._gyro
        for k in range(len(gyro) - 1, 0, -1):
            if gyro[k - 1].t <= t <= gyro[k].t:
                a, b = gyro[k - 1], gyro[k]
                w = (t - a.t) / (b.t - a.t)
                rate = (1 - w) * a.rate + w * b.rate
                return _GyroRotation(t, _rotated(a.R, a.rate, rate, t - a.t), rate)
        return None

    def _take(self, t: float, a: Array, e: Array) -> None:
        """Adds a point of the line (three equations of equal variance) with Huber's weight."""
        p = self._params
        keep = float(np.exp(-(t - self._last) / p.memory)) if np.isfinite(self._last) else 1.0
        self._last = t
        slope = self._atb / self._ata if self._ata > 0 else 0.0
        r = e - slope * a
        sd = np.sqrt(self._rss / (3 * self._count)) if self._count > 10 else FIRST_SD
        weight = min(1.0, p.huber * float(sd) * np.sqrt(3) / max(math.sqrt(r @ r), 1e-9))
        self._ata = keep * self._ata + weight * float(a @ a)
        self._atb = keep * self._atb + weight * float(a @ e)
        self._rss = keep * self._rss + weight * float(r @ r)
        self._count = keep * self._count + 1.0


def posed(points: Array, seen: Array) -> tuple[Array, Array, float] | None:
    """R_CB (3, 3), p_CB (3,) m of points (n, 3) m in B that are seen in the directions (n, 2), at
    depth 1 in C; and the misfit, m RMS across the rays. None without a solution."""
    found, turn, place = cv2.solvePnP(
        points.reshape(-1, 1, 3), seen.reshape(-1, 1, 2), np.eye(3), None, flags=cv2.SOLVEPNP_SQPNP
    )
    if not found:
        return None
    R_CB, p_CB = cv2.Rodrigues(turn)[0], place.reshape(3)
    p_C = points @ R_CB.T + p_CB
    if p_C[:, 2].min() <= 0:
        return None
    off = (p_C[:, :2] / p_C[:, 2:] - seen) * p_CB[2]
    return R_CB, p_CB, float(np.sqrt(np.mean(np.sum(off**2, axis=1))))


def rigid(p_out: Array, p_in: Array) -> tuple[Array, float]:
    """Kabsch: R (3, 3) that turns p_in (n, 3) m into p_out (n, 3) m, both about their means.

    Also returns the misfit, m RMS.
    """
    return _rigid(np.ascontiguousarray(p_out), np.ascontiguousarray(p_in))


@kernel(nogil=False)
def _rigid(p_out: Matrix, p_in: Matrix) -> tuple[Matrix, float]:
    """Compiled: numpy's checks would take longer than the arithmetic."""
    n = len(p_out)
    a, b, M = np.empty((n, 3)), np.empty((n, 3)), np.zeros((3, 3))
    for k in range(3):
        a[:, k] = p_out[:, k] - p_out[:, k].mean()
        b[:, k] = p_in[:, k] - p_in[:, k].mean()
    for i in range(n):
        for r in range(3):
            for c in range(3):
                M[r, c] += a[i, r] * b[i, c]
    R, total = nearest_rotation(M), 0.0
    for i in range(n):
        turned = rotate(R, b[i])
        for k in range(3):
            total += (a[i, k] - turned[k]) ** 2
    return R, float(np.sqrt(total / n))


@kernel(nogil=False)
def _in_both(
    markers: IntVector, left: IntVector, right: IntVector
) -> tuple[IntVector, IntVector, IntVector]:
    """Those of ``markers`` that both images show, and their rows left and right (M,), -1: none."""
    seen = markers[(left[markers] >= 0) & (right[markers] >= 0)]
    return seen, left[seen], right[seen]


@kernel(nogil=False)
def _placed(
    left: Matrix, right: Matrix, camera: StereoIntrinsics, R_GC: Matrix, nominal: Matrix
) -> tuple[Matrix, Matrix, float]:
    """p_G (n, 3) m but for the camera's position, R_GB (3, 3) and misfit (m) of points whose
    rectified pixels are left and right (n, 2); nominal (n, 3) m in B. Infinite if one is behind
    the camera.
    """
    fx, fy, cx, cy, baseline = camera
    p_G = triangulated(left, right, baseline, fx, fy, cx, cy)
    for k in range(len(p_G)):
        p_G[k] = rotate(R_GC, p_G[k])
    if not np.isfinite(np.sum(p_G)):
        return p_G, np.eye(3), np.inf
    R_GB, misfit = _rigid(p_G, nominal)
    return p_G, R_GB, misfit


@kernel(nogil=False)
def _rotated(R: Matrix, rate_0: Vector, rate_1: Vector, dt: float) -> Matrix:
    """R (3, 3) after ``dt`` with a rate (3,) rad/s that changes linearly from one to the other."""
    return mul3(R, exp3((rate_0 + rate_1) / 2 * dt))


@kernel(nogil=False)
def _point(
    nominal: Matrix,
    before: _RootView,
    now: _RootView,
    gyro_0: _GyroRotation,
    gyro_1: _GyroRotation,
    least: int,
    most_misfit: float,
) -> tuple[bool, Vector, Vector]:
    """A point of the line: whether two views fit, and a, e (3,) of e = o a, of equal variance.

    ``nominal`` (M, 3) m in B of all markers.
    """
    # 1. the markers that both views have
    marker_0, marker_1 = before.marker, now.marker
    rows = np.empty((2, len(marker_0)), np.int64)
    n = 0
    for i in range(len(marker_0)):
        for j in range(len(marker_1)):
            if marker_0[i] == marker_1[j]:
                rows[0, n], rows[1, n] = i, j
                n += 1
    if n < least:
        return False, np.zeros(3), np.zeros(3)
    # 2. their rotation
    R_made, misfit = _rigid(now.p_G[rows[1, :n]], before.p_G[rows[0, :n]])
    if misfit > most_misfit:
        return False, np.zeros(3), np.zeros(3)
    # 3. compared with the gyroscope's, weighted by the markers' information on each axis
    D = tmul3(gyro_0.R, gyro_1.R)
    e = log3(tmul3(D, tmul3(before.R_GB, mul3(R_made, before.R_GB))))
    a = rotate_back(D, gyro_0.rate) - gyro_1.rate
    L = np.linalg.cholesky(_information(nominal[marker_0[rows[0, :n]]])).astype(np.float64)
    return True, rotate_back(L, a), rotate_back(L, e)


@kernel
def _information(p_B: Matrix) -> Matrix:
    """(3, 3) m²: information on a rotation of points (n, 3), in B. Points near one line leave the
    angle about it undetermined."""
    b = p_B.copy()
    for k in range(3):
        b[:, k] -= p_B[:, k].mean()
    return (np.sum(b**2) + FLAT) * np.eye(3) - b.T @ b
