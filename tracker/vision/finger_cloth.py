"""How well a finger in an assumed posture explains the glove's cloth in images (docs/chain.md,
"Fingers in the cloth").

Around the hand, each image is resampled to a square window of the rectified image, whose samples
are equally far apart on the hand at any distance from the camera. A finger is three capsules:
samples inside should have the glove's colours, samples along its rim should not.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import ByteMatrix, Matrix, Stack, Stack4, Vector, Written
from tracker.vision.cloth import ClothMap
from tracker.vision.rig import NEAREST, StereoIntrinsics
from tracker.vision.tip_scan import INSIDE, NOTHING, cloth_at

SAMPLES = 128  # along a side of a window
SPACING = 0.002  # m on the hand between two samples
EACH = 16  # samples between two nodes of a window
SOFT = 1.25  # samples, standard deviation of the outline of the parts that are known
SURE_MOST = 0.97  # probability that a known part covers a sample, maximum
CLOTH_COVERED, CLOTH_UNCOVERED = 0.93, 0.38  # probability of the glove's colours
CLOTH_IN_RIM, NONE_IN_RIM = -0.83, 0.67  # ln of the likelihood ratio along the rim of a finger
PIXELS_ALIKE = 200.0  # px² that count as one sample: cloth, shade and outlines are correlated
ALONG = (5, 4, 4)  # positions along each segment
LINE, RIM = 0.5, 1.45  # distance of the lines from the axis, relative to the radius
RIM_FROM = 2  # positions on the first segment that are too close to the palm to have a rim
RIM_WEIGHT, END_WEIGHT = 0.3, 0.35
END_RAYS = tuple((float(np.cos(a)), float(np.sin(a))) for a in (-1.2, -0.6, 0.0, 0.6, 1.2))
"""Directions beyond a fingertip, along and across the finger."""
OVERLAP = 1.6  # radii between two parts of a finger that do not overlap
JOINT_X, JOINT_Y, FLEXION, ASIDE, BEND = range(5)
"""Numbers of a posture: displacement of the first joint, m along and across the palm; flexion and
abduction there, and flexion of the second joint, rad."""


class Finger(NamedTuple):
    """In C: base (3,) m of the first joint, palm (3, 3) axes of the hand, R (3, 3) of the extended
    finger; length (3,) and radius (3,) m of its segments; last, flexion of the last joint relative
    to the one before."""

    base: Vector
    palm: Matrix
    R: Matrix
    length: Vector
    radius: Vector
    last: float


@kernel(wide=True)
def cloth_window(cloth: ClothMap, nodes: Stack) -> ByteMatrix:
    """The class (`tip_scan.INSIDE`, …) of each sample, (n, n), between nodes (m, m, 2), which are
    raw px."""
    side = EACH * (len(nodes) - 1)
    out = np.empty((side, side), np.uint8)
    for y in range(side):
        j, b = y // EACH, (y % EACH) / EACH
        for x in range(side):
            i, a = x // EACH, (x % EACH) / EACH
            u = (1 - b) * ((1 - a) * nodes[j, i, 0] + a * nodes[j, i + 1, 0])
            u += b * ((1 - a) * nodes[j + 1, i, 0] + a * nodes[j + 1, i + 1, 0])
            v = (1 - b) * ((1 - a) * nodes[j, i, 1] + a * nodes[j, i + 1, 1])
            v += b * ((1 - a) * nodes[j + 1, i, 1] + a * nodes[j + 1, i + 1, 1])
            out[y, x] = cloth_at(cloth, u, v)
    return out


@kernel(wide=True)
def covered(capsules: Matrix, side: int) -> Matrix:
    """(side, side) probability that one of the capsules (k, 5) covers a sample; a capsule has two
    ends u, v and a radius, in samples."""
    away = np.full((side, side), 3 * SOFT)
    for u0, v0, u1, v1, r in capsules:
        m, du, dv = r + 3 * SOFT, u1 - u0, v1 - v0
        length2 = du * du + dv * dv + 1e-9
        for y in range(max(int(min(v0, v1) - m), 0), min(int(max(v0, v1) + m) + 2, side)):
            for x in range(max(int(min(u0, u1) - m), 0), min(int(max(u0, u1) + m) + 2, side)):
                t = min(max(((x - u0) * du + (y - v0) * dv) / length2, 0.0), 1.0)
                a, b = x - u0 - t * du, y - v0 - t * dv
                d = np.sqrt(a * a + b * b) - r
                away[y, x] = min(away[y, x], d)
    out = np.zeros((side, side))
    for y in range(side):
        for x in range(side):
            if away[y, x] < 3 * SOFT:
                out[y, x] = min(1.0 / (1.0 + np.exp(1.7 * away[y, x] / SOFT)), SURE_MOST)
    return out


@kernel
def _disc_means(weight: Matrix, radius: float) -> Matrix:
    """(n, n) mean of ``weight`` (n, n) in a disc about each sample; 0 beyond the edges."""
    side, reach = len(weight), int(radius)
    sums, out = np.zeros((side, side + 1)), np.zeros((side, side))
    half, count = np.empty(2 * reach + 1, np.int64), 0
    for k in range(2 * reach + 1):
        half[k] = int(np.sqrt(radius * radius - (k - reach) ** 2))
        count += 2 * half[k] + 1
    for y in range(side):
        for x in range(side):
            sums[y, x + 1] = sums[y, x] + weight[y, x]
    for y in range(side):
        for x in range(side):
            total = 0.0
            for k in range(2 * reach + 1):
                row = y + k - reach
                if 0 <= row < side:
                    end = min(x + half[k] + 1, side)
                    total += sums[row, end] - sums[row, max(x - half[k], 0)]
            out[y, x] = total / count
    return out


@kernel(wide=True)
def finger_evidence(classes: ByteMatrix, explained: Matrix, radius: float, area: float) -> Stack:
    """(2, n, n) ln of the likelihood ratio, per sample, of a finger's inside and of its rim at each
    position, for samples of ``area`` px² that are ``explained`` (n, n) otherwise."""
    side = len(classes)
    inside, rim = np.zeros((side, side)), np.zeros((side, side))
    share = area / PIXELS_ALIKE
    for y in range(side):
        for x in range(side):
            e = explained[y, x]
            cloth = CLOTH_COVERED * e + CLOTH_UNCOVERED * (1.0 - e)
            if classes[y, x] == INSIDE:
                inside[y, x] = share * np.log(CLOTH_COVERED / cloth)
                rim[y, x] = share * CLOTH_IN_RIM * (1.0 - e)
            elif classes[y, x] != NOTHING:
                inside[y, x] = share * np.log((1.0 - CLOTH_COVERED) / (1.0 - cloth))
                rim[y, x] = share * NONE_IN_RIM * (1.0 - e)
    out = np.empty((2, side, side))
    out[0], out[1] = _disc_means(inside, 0.5 * radius + 0.3), _disc_means(rim, 0.35 * radius + 0.3)
    return out


@kernel
def _put_joints(out: Written[Matrix], posture: Vector, finger: Finger) -> None:
    """The joints and the end (4, 3) m in C of a finger in a posture (5,)."""
    for i in range(3):
        x, y = posture[JOINT_X], posture[JOINT_Y]
        out[0, i] = finger.base[i] + finger.palm[i, 0] * x + finger.palm[i, 1] * y
    lateral, flexion = posture[ASIDE], posture[FLEXION]
    for k in range(3):
        if k > 0:
            flexion += posture[BEND] * (1.0 if k == 1 else finger.last)
        x = np.cos(lateral) * np.cos(flexion)
        y, z = np.sin(lateral) * np.cos(flexion), -np.sin(flexion)
        for i in range(3):
            along = finger.R[i, 0] * x + finger.R[i, 1] * y + finger.R[i, 2] * z
            out[k + 1, i] = out[k, i] + finger.length[k] * along


@kernel
def finger_joints(postures: Matrix, finger: Finger) -> Stack:
    """(n, 4, 3) m in C: the joints and the end of a finger in each of the postures (n, 5)."""
    out = np.empty((len(postures), 4, 3))
    for h in range(len(postures)):
        _put_joints(out[h], postures[h], finger)
    return out


@kernel
def _value(map_: Matrix, u: float, v: float) -> float:
    """Of the nearest sample, 0 outside."""
    x, y = int(np.floor(u + 0.5)), int(np.floor(v + 0.5))
    if x < 0 or y < 0 or x >= map_.shape[1] or y >= map_.shape[0]:
        return 0.0
    return float(map_[y, x])


@kernel
def _end_rim(rim: Matrix, end: tuple[float, float, float, float], r: float) -> float:
    """Beyond a fingertip: around its last position, u and v, and the finger's direction there."""
    u, v, du, dv = end
    total = 0.0
    for k in range(len(END_RAYS)):
        x, y = END_RAYS[k][0] * RIM * r, END_RAYS[k][1] * RIM * r
        total += _value(rim, u + du * x - dv * y, v + dv * x + du * y)
    return END_WEIGHT * r * r * total


@kernel
def _in_view(ends: Matrix, maps: Stack, near: Written[Matrix]) -> float:
    """ln of the likelihood ratio in one window: ends (6, 3) are u, v and radius, in samples, of
    both ends of each segment; near (n, 2) has room for the positions on the first segment."""
    total, inside, rim = 0.0, maps[0], maps[1]
    for k in range(3):
        du, dv = ends[2 * k + 1, 0] - ends[2 * k, 0], ends[2 * k + 1, 1] - ends[2 * k, 1]
        length, r, count = np.sqrt(du * du + dv * dv) + 1e-6, ends[2 * k, 2], ALONG[k]
        eu, ev = du / length, dv / length
        for q in range(count):
            t = (q + 0.5) / count
            u, v = ends[2 * k, 0] + t * du, ends[2 * k, 1] + t * dv
            weight = 2 * r * length / count
            if k == 2 and q == count - 1:
                weight += 1.57 * r * r
                total += _end_rim(rim, (u, v, eu, ev), r)
            if k == 0:
                near[q, 0], near[q, 1] = u, v
            elif k == 2 or q > 0:  # a bent finger covers itself
                least = (OVERLAP * r) ** 2 + 1e-9
                whole = least
                for i in range(ALONG[0]):
                    x, y = u - near[i, 0], v - near[i, 1]
                    least = min(least, x * x + y * y)
                weight *= np.sqrt(least / whole)
            for side in (-1.0, 1.0):
                x, y = -side * ev * r, side * eu * r
                total += 0.5 * weight * _value(inside, u + LINE * x, v + LINE * y)
                if k > 0 or q >= RIM_FROM:
                    total += RIM_WEIGHT * weight * _value(rim, u + RIM * x, v + RIM * y)
    return total


@kernel
def finger_likelihoods(
    postures: Matrix, finger: Finger, rig: StereoIntrinsics, windows: Matrix, maps: Stack4
) -> Vector:
    """(n,) ln of the likelihood ratio of a finger in each of the postures (n, 5) to none.

    windows (c, 4) have the camera's shift (m), the first sample (u, v) and the distance between
    samples (rectified px); maps (c, 2, n, n) are those of `finger_evidence`.
    """
    out, joints = np.zeros(len(postures)), np.empty((4, 3))
    ends, near = np.empty((6, 3)), np.empty((ALONG[0], 2))
    for h in range(len(postures)):
        _put_joints(joints, postures[h], finger)
        if joints[:, 2].min() < 3 * NEAREST:
            continue
        for i in range(3):  # the last capsule ends before the fingertip
            short = 0.5 * finger.radius[2] / finger.length[2]
            joints[3, i] += short * (joints[2, i] - joints[3, i])
        for c in range(len(windows)):
            shift, u0, v0, pitch = windows[c]
            for k in range(3):
                z = 0.5 * (joints[k, 2] + joints[k + 1, 2])
                for e in range(2):
                    p = joints[k + e]
                    ends[2 * k + e, 0] = (rig.fx * (p[0] - shift) / p[2] + rig.cx - u0) / pitch
                    ends[2 * k + e, 1] = (rig.fy * p[1] / p[2] + rig.cy - v0) / pitch
                    ends[2 * k + e, 2] = finger.radius[k] * rig.fx / z / pitch
            out[h] += _in_view(ends, maps[c], near)
    return out
