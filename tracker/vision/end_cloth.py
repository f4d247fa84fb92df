"""How a finger's last segment is bent, by the glove's cloth in images (docs/chain.md,
"Fingertips in the cloth").

The segment is a capsule from the end joint, which the filter estimates. Each bend of a grid is
evaluated by all samples that the capsule covers, and by those next to it: exactly, by sums along
the rows of a window (`finger_cloth`).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import ByteMatrix, Matrix, Stack, Stack4, Vector
from tracker.vision.cloth import INSIDE, OUTSIDE
from tracker.vision.finger_cloth import SPACING
from tracker.vision.rig import NEAREST, StereoIntrinsics

PIXELS_ALIKE = 40.0  # px² that count as one sample
CLOTH_COVERED, NONE_COVERED = 0.9, -1.5  # ln of the likelihood ratio of a covered sample
CLOTH_BESIDE, NONE_BESIDE = -1.2, 0.96  # and of one next to the capsule
BESIDE = 1.4  # radii up to which samples count as next to the capsule
START = 0.4  # share of the segment from its joint that other parts may hide
FLEXIONS, FLEXION_STEP = 10, np.deg2rad(7.0)  # on each side of the expected bend
LATERALS, LATERAL_STEP = 3, np.deg2rad(6.0)
FARTHEST2 = 9.0  # squared standard deviations from the expected bend
JOINT_SD, AWAY = 0.0015, 1.7  # m of the joint in the image; standard deviations of its positions
UNLIKELY = (
    5.0  # ln of the least probability, relative to the highest, of a bend that is tried with a
)
# displaced joint
NEARER = 1.15  # of the distance of a window: a segment that points to the camera looks longer
FLAT = 0.05  # of the squared lever arm: bends are not corrected along the line of sight of the axis
WIDEN = np.deg2rad(2.0)  # of the mean, for what the grid does not contain


class ExpectedEnd(NamedTuple):
    """In C: joint (3,) m; axis (3,) m from it to the middle of the tip's ball; J (2, 3) m of the
    latter by flexion and lateral rotation; radius of the ball, m; bend (2,) rad from ``axis`` to
    the expected bend, and its covariance P (2, 2) rad²."""

    joint: Vector
    axis: Vector
    J: Matrix
    radius: float
    bend: Vector
    P: Matrix


class EndImages(NamedTuple):
    """Parts of windows, (c, 4) as in `FingerImages`, with sums (c, 2, rows, columns + 1) of
    `end_evidence`."""

    rig: StereoIntrinsics
    windows: Matrix
    sums: Stack4


@kernel
def part_side(end: ExpectedEnd) -> int:
    """Samples along a side of the part of a window that `fit_end` depends on: the segment in any
    direction, a little nearer to the camera than its joint, and what is beside it."""
    reach = np.sqrt(np.sum(end.axis**2)) + BESIDE * end.radius + AWAY * JOINT_SD
    return 2 * int(np.ceil(NEARER * reach / SPACING)) + 3


@kernel(error_model="numpy")
def part_start(end: ExpectedEnd, rig: StereoIntrinsics, window: Vector) -> tuple[int, int]:
    """(left, top): the first sample of the part of a window that `fit_end` depends on; the part has
    `part_side` samples along each side."""
    x, y, z = end.joint
    half = 0.5 * part_side(end)
    u = rig.fx * (x - window[0]) / z + rig.cx
    v = rig.fy * y / z + rig.cy
    left, top = (u - window[1]) / window[3] - half, (v - window[2]) / window[3] - half
    return int(np.floor(left)), int(np.floor(top))


@kernel
def end_evidence(
    classes: ByteMatrix, known: Matrix, others: Matrix, area: float, first: tuple[int, int]
) -> Stack:
    """(2, m, m + 1) sums along rows, up to each sample, of what it contributes inside a capsule,
    less its contribution beside it; and of the latter. Samples of a window have ``area`` px² and
    classes (n, n); known (n, n) and others (m, m) are probabilities that other parts of the hand
    cover them, the latter in the part whose ``first`` sample is (left, top). Samples outside
    of the window contribute nothing."""
    side, (left, top), count = len(classes), first, len(others)
    out = np.zeros((2, count, count + 1))
    share = area / PIXELS_ALIKE
    for j in range(count):
        inner, outer, y = 0.0, 0.0, top + j
        for i in range(count):
            x = left + i
            if 0 <= y < side and 0 <= x < side:
                free = share * (1.0 - known[y, x]) * (1.0 - others[j, i])
                if classes[y, x] == INSIDE:
                    inner += free * (CLOTH_COVERED - CLOTH_BESIDE)
                    outer += free * CLOTH_BESIDE
                elif classes[y, x] == OUTSIDE:
                    inner += free * (NONE_COVERED - NONE_BESIDE)
                    outer += free * NONE_BESIDE
            out[0, j, i + 1], out[1, j, i + 1] = inner, outer
    return out


@kernel
def _up_to(row: Vector, x: float) -> float:
    """Sum of a row up to x, in samples."""
    if x <= 0.0:
        return 0.0
    i = int(x)
    if i >= len(row) - 1:
        return float(row[-1])
    return float(row[i] + (x - i) * (row[i + 1] - row[i]))


@kernel
def _covered_sum(
    sums: Matrix, start: tuple[float, float], end: tuple[float, float], r: float
) -> float:
    """Sum over a capsule in samples, of sums along rows (n, n + 1)."""
    (ua, va), (ub, vb) = start, end
    du, dv, total = ub - ua, vb - va, 0.0
    length = np.sqrt(du * du + dv * dv) + 1e-9
    nu, nv = -dv / length * r, du / length * r
    first = max(int(np.ceil(min(va, vb) - r)), 0)
    for y in range(first, min(int(np.floor(max(va, vb) + r)) + 1, len(sums))):
        low, high = np.inf, -np.inf
        for u, v in ((ua, va), (ub, vb)):
            d2 = r * r - (y - v) * (y - v)
            if d2 > 0.0:
                half = np.sqrt(d2)
                low, high = min(low, u - half), max(high, u + half)
        if abs(dv) > 1e-6:
            for s in (-1.0, 1.0):
                t = (y - va - s * nv) / dv
                if 0.0 <= t <= 1.0:
                    u = ua + s * nu + t * du
                    low, high = min(low, u), max(high, u)
        if high > low:
            total += _up_to(sums[y], high + 0.5) - _up_to(sums[y], low + 0.5)
    return total


@kernel(error_model="numpy")
def _likelihood(
    joint: tuple[float, float, float], arm: Vector, radius: float, images: EndImages
) -> float:
    """ln of the likelihood ratio of a capsule from ``joint`` along ``arm``, m in C, to none."""
    rig, total, (x, y, z) = images.rig, 0.0, joint
    near, far = z + START * arm[2], z + arm[2]
    for c in range(len(images.windows)):
        shift, u0, v0 = images.windows[c, 0], images.windows[c, 1], images.windows[c, 2]
        pitch = images.windows[c, 3]
        f, g, cu, cv = rig.fx / pitch, rig.fy / pitch, (rig.cx - u0) / pitch, (rig.cy - v0) / pitch
        start = f * (x + START * arm[0] - shift) / near + cu, g * (y + START * arm[1]) / near + cv
        end = f * (x + arm[0] - shift) / far + cu, g * (y + arm[1]) / far + cv
        r = 2.0 * f * radius / (near + far)
        total += _covered_sum(images.sums[c, 0], start, end, r)
        total += _covered_sum(images.sums[c, 1], start, end, BESIDE * r)
    return total


@kernel
def _axis_of(x: Vector, moves: Vector) -> Vector:
    """(3,) unit axis of the rotation by which x (3,) moves by ``moves`` (3,) per radian."""
    axis = np.cross(x, moves)
    out: Vector = axis / (np.sqrt(np.sum(axis * axis)) + 1e-12)
    return out


@kernel
def _rotated(x: Vector, axis: Vector, angle: float) -> Vector:
    c, s = np.cos(angle), np.sin(angle)
    along = (axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2]) * (1.0 - c)
    out = np.empty(3)
    out[0] = c * x[0] + s * (axis[1] * x[2] - axis[2] * x[1]) + along * axis[0]
    out[1] = c * x[1] + s * (axis[2] * x[0] - axis[0] * x[2]) + along * axis[1]
    out[2] = c * x[2] + s * (axis[0] * x[1] - axis[1] * x[0]) + along * axis[2]
    return out


@kernel
def _positions(end: ExpectedEnd) -> tuple[Matrix, Matrix]:
    """Displacements of the joint (5, 3) m in C, across the segment and along it in the image; and
    the bends (5, 2) rad by which the tip is displaced as much."""
    across = np.cross(end.joint, end.axis)
    across /= np.sqrt(np.sum(across * across)) + 1e-12
    along = np.cross(end.joint, across)
    along /= np.sqrt(np.sum(along * along)) + 1e-12
    a, b, c = np.sum(end.J[0] ** 2), np.sum(end.J[0] * end.J[1]), np.sum(end.J[1] ** 2)
    least = FLAT * np.sum(end.axis**2)
    a, c = a + least, c + least
    moved, bends = np.zeros((5, 3)), np.zeros((5, 2))
    for n in range(1, 5):
        away = AWAY * JOINT_SD * (1.0 if n % 2 == 1 else -1.0)
        moved[n] = away * (across if n < 3 else along)
        p, q = np.sum(end.J[0] * moved[n]), np.sum(end.J[1] * moved[n])
        bends[n, 0] = (c * p - b * q) / (a * c - b * b)
        bends[n, 1] = (a * q - b * p) / (a * c - b * b)
    return moved, bends


@kernel
def fit_end(end: ExpectedEnd, images: EndImages, share: float) -> Vector:
    """(6,): the highest ln of the likelihood ratio of the segment to none; and relative to the
    expected bend, the mean, rad of flexion and of lateral rotation, then the variance of flexion,
    its covariance with lateral rotation, and the variance of the latter, rad². ``share`` is that of
    the evidence that earlier images did not contain."""
    moved, bends = _positions(end)
    flexion, lateral = _axis_of(end.axis, end.J[0]), _axis_of(end.axis, end.J[1])
    det = end.P[0, 0] * end.P[1, 1] - end.P[0, 1] ** 2
    pp, pq, qq = end.P[1, 1] / det, -end.P[0, 1] / det, end.P[0, 0] / det
    count = (2 * FLEXIONS + 1) * (2 * LATERALS + 1)
    tried, arms, logs = np.empty((count, 2)), np.empty((count, 3)), np.empty(count)
    most, best, n = -np.inf, -np.inf, 0
    joint = end.joint[0], end.joint[1], end.joint[2]
    for i in range(-FLEXIONS, FLEXIONS + 1):
        for j in range(-LATERALS, LATERALS + 1):
            p, q = i * FLEXION_STEP, j * LATERAL_STEP
            d2 = pp * p * p + 2.0 * pq * p * q + qq * q * q
            if d2 > FARTHEST2:
                continue
            arm = _rotated(end.axis, flexion, end.bend[0] + p)
            arm = _rotated(arm, lateral, end.bend[1] + q)
            if end.joint[2] + min(arm[2], 0.0) < 3 * NEAREST:
                continue
            tried[n, 0], tried[n, 1], arms[n] = p, q, arm
            likely = _likelihood(joint, arm, end.radius, images)
            logs[n] = share * likely - 0.5 * d2
            most, best = max(most, likely), max(best, logs[n])
            n += 1
    mean, square, total = np.zeros(2), np.zeros(3), 0.0
    for k in range(n):
        if logs[k] < best - UNLIKELY:
            continue
        p, q = tried[k]
        for m in range(5):
            weight = logs[k]
            if m > 0:
                x, y = end.joint[0] + moved[m, 0], end.joint[1] + moved[m, 1]
                joint = x, y, end.joint[2] + moved[m, 2]
                likely = _likelihood(joint, arms[k], end.radius, images)
                most = max(most, likely)
                d2 = pp * p * p + 2.0 * pq * p * q + qq * q * q
                weight = share * likely - 0.5 * (d2 + AWAY * AWAY)
            w, x, y = np.exp(weight - best), p + bends[m, 0], q + bends[m, 1]
            total += w
            mean[0], mean[1] = mean[0] + w * x, mean[1] + w * y
            square[0], square[1] = square[0] + w * x * x, square[1] + w * x * y
            square[2] += w * y * y
    out = np.zeros(6)
    out[0] = most
    if total > 0.0:
        x, y = mean[0] / total, mean[1] / total
        out[1], out[2] = x, y
        out[3] = square[0] / total - x * x + WIDEN * WIDEN
        out[4] = square[1] / total - x * y
        out[5] = square[2] / total - y * y + WIDEN * WIDEN
    return out
