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
from tracker.kernels.arrays import (
    ByteMatrix,
    Float32Matrix,
    Float32Stack,
    Float32Stack4,
    Matrix,
    Stack,
    Vector,
    Written,
)
from tracker.vision.cloth import ClothMap
from tracker.vision.rig import NEAREST, StereoIntrinsics
from tracker.vision.tip_scan import INSIDE, NOTHING, cloth_at

SAMPLES = 96  # along a side of a window
SPACING = 0.002  # m on the hand between two samples
EACH = 16  # samples between two nodes of a window
SOFT = 1.25  # samples, standard deviation of the outline of the parts that are known
SURE_MOST = 0.97  # probability that a known part covers a sample, maximum
CLOTH_COVERED, CLOTH_UNCOVERED = 0.93, 0.38  # probability of the glove's colours
CLOTH_IN_RIM, NONE_IN_RIM = -0.83, 0.67  # ln of the likelihood ratio along the rim of a finger
LEVELS = 256  # of how much of a sample is explained
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


@kernel(wide=True)
def _disc_means(weight: Matrix, radius: float, out: Written[Float32Matrix]) -> None:
    """Puts the mean of ``weight`` (n, n) in a disc about each sample into ``out`` (n, n); it is 0
    beyond the edges."""
    side, reach = len(weight), int(radius)
    sums = np.zeros((side + 2 * reach, side + 2 * reach + 1))
    for y in range(side):
        total = 0.0
        for x in range(side):
            total += weight[y, x]
            sums[y + reach, x + reach + 1] = total
        sums[y + reach, side + reach + 1 :] = total
    means, count = np.zeros((side, side)), 0
    for k in range(2 * reach + 1):
        half = int(np.sqrt(radius * radius - (k - reach) ** 2))
        count += 2 * half + 1
        for y in range(side):
            row, to = sums[y + k], means[y]
            first, end = row[reach - half : reach - half + side], row[reach + half + 1 :]
            for x in range(side):
                to[x] += end[x] - first[x]
    for y in range(side):
        for x in range(side):
            out[y, x] = means[y, x] / count


@kernel(wide=True)
def finger_evidence(
    classes: ByteMatrix, explained: Matrix, radius: float, area: float
) -> Float32Stack:
    """(2, n, n) ln of the likelihood ratio, per sample, of a finger's inside and of its rim at each
    position, for samples of ``area`` px² that are ``explained`` (n, n) otherwise."""
    side = len(classes)
    inside, rim = np.zeros((side, side)), np.zeros((side, side))
    share = area / PIXELS_ALIKE
    of_cloth, of_others = np.empty(LEVELS + 1), np.empty(LEVELS + 1)
    for k in range(LEVELS + 1):
        e = k / LEVELS
        cloth = CLOTH_COVERED * e + CLOTH_UNCOVERED * (1.0 - e)
        of_cloth[k] = share * np.log(CLOTH_COVERED / cloth)
        of_others[k] = share * np.log((1.0 - CLOTH_COVERED) / (1.0 - cloth))
    for y in range(side):
        for x in range(side):
            e = explained[y, x]
            level = int(e * LEVELS + 0.5)
            if classes[y, x] == INSIDE:
                inside[y, x] = of_cloth[level]
                rim[y, x] = share * CLOTH_IN_RIM * (1.0 - e)
            elif classes[y, x] != NOTHING:
                inside[y, x] = of_others[level]
                rim[y, x] = share * NONE_IN_RIM * (1.0 - e)
    out = np.empty((2, side, side), np.float32)
    _disc_means(inside, 0.5 * radius + 0.3, out[0])
    _disc_means(rim, 0.35 * radius + 0.3, out[1])
    return out


@kernel
def _put_joints(out: Written[Matrix], posture: Vector, finger: Finger) -> None:
    """The joints and the end (4, 3) m in C of a finger in a posture (5,)."""
    for i in range(3):
        x, y = posture[JOINT_X], posture[JOINT_Y]
        out[0, i] = finger.base[i] + finger.palm[i, 0] * x + finger.palm[i, 1] * y
    across, forward = np.sin(posture[ASIDE]), np.cos(posture[ASIDE])
    flexion = posture[FLEXION]
    for k in range(3):
        if k > 0:
            flexion += posture[BEND] * (1.0 if k == 1 else finger.last)
        z, flat = -np.sin(flexion), np.cos(flexion)
        x, y = forward * flat, across * flat
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
def _value(map_: Float32Matrix, u: float, v: float) -> float:
    """Of the nearest sample, 0 outside."""
    if u < -0.5 or v < -0.5:
        return 0.0
    x, y = int(u + 0.5), int(v + 0.5)
    if x >= map_.shape[1] or y >= map_.shape[0]:
        return 0.0
    return float(map_[y, x])


@kernel
def _end_rim(rim: Float32Matrix, end: tuple[float, float, float, float], r: float) -> float:
    """Beyond a fingertip: around its last position, u and v, and the finger's direction there."""
    u, v, du, dv = end
    total = 0.0
    for k in range(len(END_RAYS)):
        x, y = END_RAYS[k][0] * RIM * r, END_RAYS[k][1] * RIM * r
        total += _value(rim, u + du * x - dv * y, v + dv * x + du * y)
    return END_WEIGHT * r * r * total


@kernel
def _at_sides(maps: Float32Stack, at: tuple[float, float], across: tuple[float, float]) -> float:
    """Mean of the inside on both sides of a position, and the weighted rim there; ``across`` is one
    radius."""
    (u, v), (x, y) = at, across
    inside, rim = maps[0], maps[1]
    total = _value(inside, u + LINE * x, v + LINE * y) + _value(inside, u - LINE * x, v - LINE * y)
    edges = _value(rim, u + RIM * x, v + RIM * y) + _value(rim, u - RIM * x, v - RIM * y)
    return 0.5 * total + RIM_WEIGHT * edges


@kernel
def _first_in_view(ends: Matrix, maps: Float32Stack, near: Written[Matrix]) -> float:
    """As `_others_in_view`, of the first segment; puts its positions into ``near`` (n, 2)."""
    du, dv, r = ends[1, 0] - ends[0, 0], ends[1, 1] - ends[0, 1], ends[0, 2]
    length, total = np.sqrt(du * du + dv * dv) + 1e-6, 0.0
    x, y = -dv / length * r, du / length * r
    for q in range(ALONG[0]):
        t = (q + 0.5) / ALONG[0]
        u, v = ends[0, 0] + t * du, ends[0, 1] + t * dv
        near[q, 0], near[q, 1] = u, v
        if q >= RIM_FROM:
            total += _at_sides(maps, (u, v), (x, y))
        else:
            total += 0.5 * _value(maps[0], u + LINE * x, v + LINE * y)
            total += 0.5 * _value(maps[0], u - LINE * x, v - LINE * y)
    return 2 * r * length / ALONG[0] * total


@kernel
def _others_in_view(ends: Matrix, maps: Float32Stack, near: Matrix) -> float:
    """ln of the likelihood ratio in one window of the second and third segment: ends (6, 3) are u,
    v and radius, in samples, of both ends of each segment; near (n, 2) are positions on the first
    segment."""
    total = 0.0
    for k in range(1, 3):
        du, dv = ends[2 * k + 1, 0] - ends[2 * k, 0], ends[2 * k + 1, 1] - ends[2 * k, 1]
        length, r, count = np.sqrt(du * du + dv * dv) + 1e-6, ends[2 * k, 2], ALONG[k]
        eu, ev = du / length, dv / length
        whole = (OVERLAP * r) ** 2 + 1e-9
        for q in range(count):
            t = (q + 0.5) / count
            u, v = ends[2 * k, 0] + t * du, ends[2 * k, 1] + t * dv
            weight = 2 * r * length / count
            if k == 2 and q == count - 1:
                weight += 1.57 * r * r
                total += _end_rim(maps[1], (u, v, eu, ev), r)
            if k == 2 or q > 0:  # a bent finger covers itself
                least = whole
                for i in range(ALONG[0]):
                    x, y = u - near[i, 0], v - near[i, 1]
                    least = min(least, x * x + y * y)
                if least < whole:
                    weight *= np.sqrt(least / whole)
            total += weight * _at_sides(maps, (u, v), (-ev * r, eu * r))
    return total


@kernel(error_model="numpy")
def _put_ends(
    ends: Written[Matrix], joints: Matrix, finger: Finger, rig: StereoIntrinsics, window: Vector
) -> None:
    """u, v and radius (6, 3) of both ends of each segment in the samples of a window."""
    shift, u0, v0, pitch = window[0], window[1], window[2], window[3]
    fx, fy, u0, v0 = rig.fx / pitch, rig.fy / pitch, (rig.cx - u0) / pitch, (rig.cy - v0) / pitch
    for k in range(4):
        nearer = 1.0 / joints[k, 2]
        u, v = fx * (joints[k, 0] - shift) * nearer + u0, fy * joints[k, 1] * nearer + v0
        if k < 3:
            r = finger.radius[k] * fx / (0.5 * (joints[k, 2] + joints[k + 1, 2]))
            ends[2 * k, 0], ends[2 * k, 1], ends[2 * k, 2] = u, v, r
        if k > 0:
            ends[2 * k - 1, 0], ends[2 * k - 1, 1], ends[2 * k - 1, 2] = u, v, ends[2 * k - 2, 2]


@kernel(wide=True, error_model="numpy")
def finger_likelihoods(
    postures: Matrix, finger: Finger, rig: StereoIntrinsics, windows: Matrix, maps: Float32Stack4
) -> Vector:
    """(n,) ln of the likelihood ratio of a finger in each of the postures (n, 5) to none.

    windows (c, 4) have the camera's shift (m), the first sample (u, v) and the distance between
    samples (rectified px); maps (c, 2, n, n) are those of `finger_evidence`.
    """
    out, joints, ends = np.zeros(len(postures)), np.empty((4, 3)), np.empty((6, 3))
    near, first = np.empty((len(windows), ALONG[0], 2)), np.zeros(len(windows))
    short = 0.5 * finger.radius[2] / finger.length[2]
    before = -1  # the posture whose first segment is in `near`
    for h in range(len(postures)):
        _put_joints(joints, postures[h], finger)
        if min(min(joints[0, 2], joints[1, 2]), min(joints[2, 2], joints[3, 2])) < 3 * NEAREST:
            continue
        is_new = before < 0
        for i in range(3):  # the last capsule ends before the fingertip
            joints[3, i] += short * (joints[2, i] - joints[3, i])
        for i in range(BEND):
            is_new = is_new or postures[h, i] != postures[before, i]
        before = h
        for c in range(len(windows)):
            _put_ends(ends, joints, finger, rig, windows[c])
            if is_new:
                first[c] = _first_in_view(ends, maps[c], near[c])
            out[h] += first[c] + _others_in_view(ends, maps[c], near[c])
    return out
