"""How well a finger in an assumed posture explains the glove's cloth in images (docs/chain.md,
"Fingers in the cloth").

Around the hand, each image is resampled to a square window of the rectified image, whose samples
are equally far apart on the hand at any distance from the camera. A finger is three capsules:
samples inside should have the glove's colours, samples along its rim should not.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteMatrix,
    Float32Matrix,
    Float32Stack,
    Float32Stack4,
    Int32Matrix,
    Matrix,
    Stack,
    Vector,
    Written,
)
from tracker.vision.cloth import INSIDE, NOTHING, OUTSIDE, ClothMap, brightness_at, cloth_at
from tracker.vision.rig import NEAREST, Optics, StereoIntrinsics, raw_pixel

SAMPLES = 96  # along a side of a window
SPACING = 0.002  # m on the hand between two samples
COVERED, UNCOVERED = 0.95, 0.02  # probabilities of samples that are on the hand, and next to it
LEAST_ON_HAND, MOST_BESIDE = 0.7, 0.45  # shares of these samples with the glove's colours
LEAST_SAMPLES = 200  # of each
EACH = 16  # samples between two nodes of a window
SOFT = 1.25  # samples, standard deviation of the outline of the parts that are known
SURE_MOST = 0.97  # probability that a known part covers a sample, maximum
FAR = 3 * SOFT  # samples from an outline within which it is uncertain
OUTLINE_STEPS = 128  # per sample
OUTLINE = np.minimum(
    1.0 / (1.0 + np.exp(1.7 / SOFT * np.arange(-FAR, FAR + 1.0, 1.0 / OUTLINE_STEPS))), SURE_MOST
)
"""The probability at a distance of -FAR or more from an outline, outwards."""
CLOTH_COVERED, CLOTH_UNCOVERED = 0.93, 0.38  # probability of the glove's colours
CLOTH_IN_RIM, NONE_IN_RIM = -0.83, 0.67  # ln of the likelihood ratio along the rim of a finger
DEPTH_EVERY = 2  # samples between two whose distance is known
DEPTHS = SAMPLES // DEPTH_EVERY  # along a side of a window
LEVELS = 256  # of how much of a sample is explained
SQUARES_ALIKE = 40.0  # samples² of the comparison of both images that count as one
FRONT = 0.85  # radii from a finger's axis to its surface, where it is evaluated
PIXELS_ALIKE = 200.0  # px² that count as one sample: cloth, shade and outlines are correlated
ALONG = (5, 4, 4)  # positions along each segment
LINE, RIM = 0.5, 1.45  # distance of the lines from the axis, relative to the radius
RIM_FROM = 2  # positions on the first segment that are too close to the palm to have a rim
RIM_WEIGHT, END_WEIGHT = 0.3, 0.35
END_RAYS = tuple((float(np.cos(a)), float(np.sin(a))) for a in (-1.2, -0.6, 0.0, 0.6, 1.2))
"""Directions beyond a fingertip, along and across the finger."""
AHEAD, AHEAD_RAYS = (1.45, 2.0, 2.6), (-0.35, 0.0, 0.35)
"""Distances beyond the end of a finger, in radii, and directions relative to its own, rad, at which
cloth shows that it is longer than a finger."""
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


class FingerImages(NamedTuple):
    """A finger as cameras see it: windows (c, 4) have the camera's shift (m), the first sample (u,
    v) and the distance between samples (rectified px); maps (c, 2, n + 2, n + 2) are those of
    `finger_evidence`; depth (levels, n / 2 + 2, n / 2 + 2), without levels if unknown, is
    `depth_evidence` in the first window; disparity (2,) has samples m and samples: the number of a
    level is the latter less the former divided by the distance of the surface; inside is the weight
    of the first of the maps."""

    finger: Finger
    rig: StereoIntrinsics
    windows: Matrix
    maps: Float32Stack4
    depth: Float32Stack
    disparity: Vector
    inside: float = 1.0


@kernel
def _raw_nodes(window: Vector, camera: Optics) -> Stack:
    """(m, m, 2) raw px of the nodes of a window."""
    count = SAMPLES // EACH + 1
    out = np.empty((count, count, 2))
    for j in range(count):
        for i in range(count):
            u, v = window[1] + i * EACH * window[3], window[2] + j * EACH * window[3]
            out[j, i] = raw_pixel(u, v, camera)
    return out


@kernel
def _raw_at(nodes: Stack, x: int, y: int) -> tuple[float, float]:
    """Raw px of a sample between the nodes of its window."""
    j, b = y // EACH, (y % EACH) / EACH
    i, a = x // EACH, (x % EACH) / EACH
    u = (1 - b) * ((1 - a) * nodes[j, i, 0] + a * nodes[j, i + 1, 0])
    u += b * ((1 - a) * nodes[j + 1, i, 0] + a * nodes[j + 1, i + 1, 0])
    v = (1 - b) * ((1 - a) * nodes[j, i, 1] + a * nodes[j, i + 1, 1])
    v += b * ((1 - a) * nodes[j + 1, i, 1] + a * nodes[j + 1, i + 1, 1])
    return u, v


@kernel(wide=True)
def cloth_window(
    cloth: ClothMap, window: Vector, camera: Optics, textured: bool
) -> tuple[ByteMatrix, Int32Matrix]:
    """The class (`cloth.INSIDE`, …) of each sample, (n, n), of a window (`FingerImages`), and if
    ``textured``, else 0, its texture (`cloth.brightness_at`)."""
    nodes = _raw_nodes(window, camera)
    classes = np.empty((SAMPLES, SAMPLES), np.uint8)
    texture = np.zeros((SAMPLES, SAMPLES), np.int32)
    for y in range(SAMPLES):
        for x in range(SAMPLES):
            u, v = _raw_at(nodes, x, y)
            classes[y, x] = cloth_at(cloth, u, v)
            if textured and classes[y, x] == INSIDE:
                texture[y, x] = brightness_at(cloth, u, v)
    return classes, texture


UNKNOWN_DEPTH = np.zeros((0, DEPTHS + 2, DEPTHS + 2), np.float32), np.zeros(2)
"""depth and disparity of `FingerImages` without texture."""


@kernel(error_model="numpy")
def _in_window(ends: Stack, radius: Vector, rig: StereoIntrinsics, window: Vector) -> Matrix:
    """(k, 5) capsules in the samples of a window, from ends (k, 2, 3) m in C and radii (k,) m."""
    out, f = np.empty((len(ends), 5)), rig.fx / window[3]
    for k in range(len(ends)):
        for i in range(2):
            x, y, z = ends[k, i]
            out[k, 2 * i] = f * (x - window[0]) / z + (rig.cx - window[1]) / window[3]
            out[k, 2 * i + 1] = rig.fy / window[3] * y / z + (rig.cy - window[2]) / window[3]
        out[k, 4] = f * radius[k] / (0.5 * (ends[k, 0, 2] + ends[k, 1, 2]))
    return out


@kernel(wide=True, error_model="numpy")
def surface_levels(
    ends: Stack, radius: Vector, rig: StereoIntrinsics, window: Vector, disparity: Vector
) -> Matrix:
    """(n / 2, n / 2) level of disparity (`FingerImages`) of the nearest of the capsules, as for
    `covered`, at every second sample; infinite where none is."""
    out, capsules = np.full((DEPTHS, DEPTHS), np.inf), _in_window(ends, radius, rig, window)
    for k in range(len(capsules)):
        u0, v0, u1, v1, r = capsules[k]
        du, dv = u1 - u0, v1 - v0
        along_u, along_v = du / (du * du + dv * dv + 1e-9), dv / (du * du + dv * dv + 1e-9)
        m = r + SOFT
        left, right = _between(u0, u1, m)
        top, bottom = _between(v0, v1, m)
        for j in range(top, bottom):
            y = DEPTH_EVERY * j
            for i in range(left, right):
                x = DEPTH_EVERY * i
                t = min(max((x - u0) * along_u + (y - v0) * along_v, 0.0), 1.0)
                a, b = x - u0 - t * du, y - v0 - t * dv
                d2 = a * a + b * b
                if d2 < m * m:
                    z = ends[k, 0, 2] + t * (ends[k, 1, 2] - ends[k, 0, 2])
                    z -= radius[k] * np.sqrt(max(1.0 - d2 / (r * r), 0.0))
                    out[j, i] = min(out[j, i], disparity[1] - disparity[0] / z)
    return out


@kernel
def _between(one: float, other: float, margin: float) -> tuple[int, int]:
    """The first row, or column, of `surface_levels` between two samples, and the one after the
    last."""
    first, last = min(one, other) - margin, max(one, other) + margin
    return max(int(first / DEPTH_EVERY), 0), min(int(last / DEPTH_EVERY) + 2, DEPTHS)


@kernel(wide=True)
def covered(ends: Stack, radius: Vector, rig: StereoIntrinsics, window: Vector) -> Matrix:
    """(n, n) probability that one of the capsules with ends (k, 2, 3) m in C and radii (k,) m
    covers a sample of a window (`FingerImages`)."""
    return _covered(_in_window(ends, radius, rig, window), SAMPLES, SAMPLES)


@kernel(wide=True)
def covered_part(
    ends: Stack, radius: Vector, rig: StereoIntrinsics, window: Vector, size: tuple[int, int]
) -> Matrix:
    """As `covered`, for a window of ``size`` (rows, columns)."""
    return _covered(_in_window(ends, radius, rig, window), size[0], size[1])


@kernel
def _covered(capsules: Matrix, rows: int, columns: int) -> Matrix:
    """As `covered`; a capsule has two ends u, v and a radius, in samples."""
    away, out = np.full((rows, columns), FAR), np.zeros((rows, columns))
    left, right = np.full(rows, columns), np.zeros(rows, np.int64)  # of samples near a capsule
    for u0, v0, u1, v1, r in capsules:
        m, du, dv = r + FAR, u1 - u0, v1 - v0
        along_u, along_v = du / (du * du + dv * dv + 1e-9), dv / (du * du + dv * dv + 1e-9)
        first, end = max(int(min(u0, u1) - m), 0), min(int(max(u0, u1) + m) + 2, columns)
        for y in range(max(int(min(v0, v1) - m), 0), min(int(max(v0, v1) + m) + 2, rows)):
            left[y], right[y] = min(left[y], first), max(right[y], end)
            for x in range(first, end):
                t = (x - u0) * along_u + (y - v0) * along_v
                t = 0.0 if t < 0.0 else (1.0 if t > 1.0 else t)
                a, b = x - u0 - t * du, y - v0 - t * dv
                d = np.sqrt(a * a + b * b) - r
                away[y, x] = d if d < away[y, x] else away[y, x]
    for y in range(rows):
        for x in range(left[y], right[y]):
            if away[y, x] < -FAR:
                out[y, x] = SURE_MOST
            elif away[y, x] < FAR:
                out[y, x] = OUTLINE[int((away[y, x] + FAR) * OUTLINE_STEPS + 0.5)]
    return out


@kernel
def separates(classes: ByteMatrix, known: Matrix) -> bool:
    """Whether cloth differs from what is next to the hand: classes (n, n) of a window, of whose
    samples ``known`` (n, n) is `covered`."""
    on, on_cloth, beside, beside_cloth = 0, 0, 0, 0
    for y in range(len(classes)):
        for x in range(len(classes)):
            if classes[y, x] != NOTHING:
                is_cloth = classes[y, x] == INSIDE
                if known[y, x] > COVERED:
                    on, on_cloth = on + 1, on_cloth + is_cloth
                elif known[y, x] < UNCOVERED:
                    beside, beside_cloth = beside + 1, beside_cloth + is_cloth
    if min(on, beside) < LEAST_SAMPLES:
        return False
    return on_cloth >= LEAST_ON_HAND * on and beside_cloth <= MOST_BESIDE * beside


@kernel(wide=True)
def _disc_means(weight: Float32Matrix, radius: float, out: Written[Float32Matrix]) -> None:
    """Puts the mean of ``weight`` (n, n) in a disc about each sample into ``out`` (n + 2, n + 2),
    inside a border of one sample; it is 0 beyond the edges."""
    side, reach = len(weight), int(radius)
    row = np.zeros(side + 2 * reach + 1, np.float32)  # sums up to a sample
    halves, count = np.empty(2 * reach + 1, np.int64), 0
    for k in range(2 * reach + 1):
        halves[k] = int(np.sqrt(radius * radius - (k - reach) ** 2))
        count += 2 * halves[k] + 1
    share = np.float32(1.0 / count)
    for y in range(side):
        total = np.float32(0.0)
        for x in range(side):
            total += share * weight[y, x]
            row[x + reach + 1] = total
        row[reach + side + 1 :] = total
        for k in range(2 * reach + 1):
            at, half = y + k - reach, halves[k]
            if at < 0 or at >= side:
                continue
            to = out[at + 1, 1 : side + 1]
            first, end = row[reach - half : reach - half + side], row[reach + half + 1 :]
            for x in range(side):
                to[x] += end[x] - first[x]


def _explained() -> NDArray[np.float32]:
    """(3, LEVELS + 1) ln of the likelihood ratio of a sample inside a finger, by its class and how
    much of it is explained."""
    e = np.arange(LEVELS + 1) / LEVELS
    cloth = CLOTH_COVERED * e + CLOTH_UNCOVERED * (1.0 - e)
    out = np.zeros((3, LEVELS + 1), np.float32)
    out[INSIDE] = np.log(CLOTH_COVERED / cloth)
    out[OUTSIDE] = np.log((1.0 - CLOTH_COVERED) / (1.0 - cloth))
    return out


EXPLAINED = _explained()


@kernel(wide=True)
def finger_evidence(
    classes: ByteMatrix, known: Matrix, others: Matrix, radius: float, area: float
) -> Float32Stack:
    """(2, n + 2, n + 2) ln of the likelihood ratio, per sample, of a finger's inside and of its rim
    at each position, for samples of ``area`` px² that are explained by ``known`` parts
    or by ``others``, (n, n) probabilities each; 0 in a border of one sample."""
    side = len(classes)
    inside, rim = np.empty((side, side), np.float32), np.empty((side, side), np.float32)
    share, by_class = area / PIXELS_ALIKE, np.zeros(3)
    by_class[INSIDE], by_class[OUTSIDE] = share * CLOTH_IN_RIM, share * NONE_IN_RIM
    by_level = np.float32(share) * EXPLAINED
    for y in range(side):
        for x in range(side):
            free = (1.0 - known[y, x]) * (1.0 - others[y, x])
            level = np.uint64(int((1.0 - free) * LEVELS + 0.5))
            inside[y, x] = by_level[classes[y, x], level]
            rim[y, x] = by_class[classes[y, x]] * free
    out = np.zeros((2, side + 2, side + 2), np.float32)
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
    """Of the nearest sample, 0 outside; the map has a border of one sample."""
    x = min(max(int(u + 1.5), 0), map_.shape[1] - 1)
    y = min(max(int(v + 1.5), 0), map_.shape[0] - 1)
    return np.float64(map_[np.uint64(y), np.uint64(x)])


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
def _at_depth(
    depth: Float32Stack, at: tuple[float, float], across: tuple[float, float], level: float
) -> float:
    """Mean of the evidence of a surface at a ``level`` on both sides of a position."""
    if level <= -1.0 or level >= len(depth):
        return 0.0
    map_ = depth[np.uint64(min(max(int(level + 0.5), 0), len(depth) - 1))]
    u, v = at[0] / DEPTH_EVERY, at[1] / DEPTH_EVERY
    x, y = LINE / DEPTH_EVERY * across[0], LINE / DEPTH_EVERY * across[1]
    return 0.5 * (_value(map_, u + x, v + y) + _value(map_, u - x, v - y))


@kernel
def _inside(
    map_: Float32Matrix, at: tuple[float, float], across: tuple[float, float], weight: float
) -> float:
    """Mean on both sides of a position, with its weight."""
    (u, v), x, y = at, LINE * across[0], LINE * across[1]
    return 0.5 * weight * (_value(map_, u + x, v + y) + _value(map_, u - x, v - y))


@kernel
def _at_sides(
    maps: Float32Stack, at: tuple[float, float], across: tuple[float, float], inside: float
) -> float:
    """Mean of the inside on both sides of a position, with its weight, and the weighted rim there;
    ``across`` is one radius."""
    (u, v), (x, y) = at, across
    total = _inside(maps[0], at, across, inside)
    rim = maps[1]
    edges = _value(rim, u + RIM * x, v + RIM * y) + _value(rim, u - RIM * x, v - RIM * y)
    return total + RIM_WEIGHT * edges


@kernel
def _first_in_view(
    ends: Matrix, maps: Float32Stack, near: Written[Matrix], inside: float, depth: Float32Stack
) -> float:
    """As `_others_in_view`, of the first segment; puts its positions into ``near`` (n, 2)."""
    du, dv, r = ends[1, 0] - ends[0, 0], ends[1, 1] - ends[0, 1], ends[0, 2]
    length, total = np.sqrt(du * du + dv * dv) + 1e-6, 0.0
    x, y = -dv / length * r, du / length * r
    for q in range(ALONG[0]):
        t = (q + 0.5) / ALONG[0]
        u, v = ends[0, 0] + t * du, ends[0, 1] + t * dv
        near[q, 0], near[q, 1] = u, v
        if q >= RIM_FROM:
            total += _at_sides(maps, (u, v), (x, y), inside)
        else:
            total += _inside(maps[0], (u, v), (x, y), inside)
        if len(depth) > 0 and q >= RIM_FROM:
            level = ends[0, 3] + t * (ends[1, 3] - ends[0, 3])
            total += _at_depth(depth, (u, v), (x, y), level) / SQUARES_ALIKE
    return 2 * r * length / ALONG[0] * total


@kernel
def _others_in_view(
    ends: Matrix, maps: Float32Stack, near: Matrix, inside: float, depth: Float32Stack
) -> float:
    """ln of the likelihood ratio in one window of the second and third segment: ends (6, 4) are u,
    v and radius, in samples, and the level of disparity, of both ends of each segment; near (n, 2)
    are positions on the first segment."""
    total, past = 0.0, near[ALONG[0] - 1]
    along_u, along_v = past[0] - near[0, 0], past[1] - near[0, 1]
    along2 = along_u * along_u + along_v * along_v
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
            ahead = (u - past[0]) * along_u + (v - past[1]) * along_v
            is_clear = ahead > 0.0 and ahead * ahead > whole * along2
            if (k == 2 or q > 0) and not is_clear:  # a bent finger covers itself
                least = whole
                for i in range(ALONG[0]):
                    x, y = u - near[i, 0], v - near[i, 1]
                    least = min(least, x * x + y * y)
                if least < whole:
                    weight *= np.sqrt(least / whole)
            total += weight * _at_sides(maps, (u, v), (-ev * r, eu * r), inside)
            if len(depth) > 0:
                level = ends[2 * k, 3] + t * (ends[2 * k + 1, 3] - ends[2 * k, 3])
                there = _at_depth(depth, (u, v), (-ev * r, eu * r), level)
                total += weight / SQUARES_ALIKE * there
    return total


@kernel(error_model="numpy")
def _put_ends(ends: Written[Matrix], joints: Matrix, images: FingerImages, window: Vector) -> None:
    """u, v and radius in the samples of a window, and level of disparity, (6, 4), of both ends of
    each segment."""
    finger, rig, disparity = images.finger, images.rig, images.disparity
    shift, u0, v0, pitch = window[0], window[1], window[2], window[3]
    fx, fy, u0, v0 = rig.fx / pitch, rig.fy / pitch, (rig.cx - u0) / pitch, (rig.cy - v0) / pitch
    for k in range(4):
        nearer = 1.0 / joints[k, 2]
        u, v = fx * (joints[k, 0] - shift) * nearer + u0, fy * joints[k, 1] * nearer + v0
        if k < 3:
            r = finger.radius[k] * fx / (0.5 * (joints[k, 2] + joints[k + 1, 2]))
            ends[2 * k, 0], ends[2 * k, 1], ends[2 * k, 2] = u, v, r
            front = joints[k, 2] - FRONT * finger.radius[k]
            ends[2 * k, 3] = disparity[1] - disparity[0] / front
        if k > 0:
            ends[2 * k - 1, 0], ends[2 * k - 1, 1], ends[2 * k - 1, 2] = u, v, ends[2 * k - 2, 2]
            front = joints[k, 2] - FRONT * finger.radius[k - 1]
            ends[2 * k - 1, 3] = disparity[1] - disparity[0] / front


@kernel(error_model="numpy")
def beyond_end(posture: Vector, images: FingerImages) -> float:
    """Mean ln of the likelihood ratio of an independent sample of the rim beyond the end of a
    finger in a posture (5,): negative where cloth that nothing else explains continues there."""
    finger, windows = images.finger, images.windows
    joints, ends, total, count = np.empty((4, 3)), np.empty((6, 4)), 0.0, 0
    _put_joints(joints, posture, finger)
    if joints[:, 2].min() < 3 * NEAREST:
        return 0.0
    for c in range(len(windows)):
        _put_ends(ends, joints, images, windows[c])
        du, dv, r = ends[5, 0] - ends[4, 0], ends[5, 1] - ends[4, 1], ends[5, 2]
        length = np.sqrt(du * du + dv * dv) + 1e-6
        eu, ev = du / length, dv / length
        u, v = ends[5, 0] - 0.5 * r * eu, ends[5, 1] - 0.5 * r * ev
        for angle in AHEAD_RAYS:
            for radii in AHEAD:
                x, y = np.cos(angle) * radii * r, np.sin(angle) * radii * r
                value = _value(images.maps[c, 1], u + eu * x - ev * y, v + ev * x + eu * y)
                total += value * PIXELS_ALIKE / windows[c, 3] ** 2
                count += 1
    return total / max(count, 1)


@kernel(wide=True, error_model="numpy")
def finger_likelihoods(postures: Matrix, images: FingerImages) -> Vector:
    """(n,) ln of the likelihood ratio (eq. 70) of a finger in each of the postures (n, 5) to
    none."""
    finger, windows, maps = images.finger, images.windows, images.maps
    out, joints, ends = np.zeros(len(postures)), np.empty((4, 3)), np.empty((6, 4))
    none = images.depth[:0]
    near, first = np.empty((len(windows), ALONG[0], 2)), np.zeros(len(windows))
    short = 0.5 * finger.radius[2] / finger.length[2]
    before = -1  # the posture whose first segment is in `near`
    for h in range(len(postures)):
        _put_joints(joints, postures[h], finger)
        if min(min(joints[0, 2], joints[1, 2]), min(joints[2, 2], joints[3, 2])) < 3 * NEAREST:
            continue
        is_new = before < 0
        for i in range(BEND):
            is_new = is_new or postures[h, i] != postures[before, i]
        for i in range(3):  # the last capsule ends before the fingertip
            joints[3, i] += short * (joints[2, i] - joints[3, i])
        before = h
        for c in range(len(windows)):
            _put_ends(ends, joints, images, windows[c])
            depth = images.depth if c == 0 else none
            if is_new:
                first[c] = _first_in_view(ends, maps[c], near[c], images.inside, depth)
            out[h] += first[c] + _others_in_view(ends, maps[c], near[c], images.inside, depth)
    return out
