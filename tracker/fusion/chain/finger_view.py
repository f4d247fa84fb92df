"""The cloth around a hand as the cameras see it, and the parts of the hand that are sensed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.hand.model import HandModel
from tracker.messages import Array, CameraPose, Cloth, IntArray
from tracker.vision.cloth import cloth_map
from tracker.vision.cloth_depth import NEAREST_LEVEL, depth_evidence, matches
from tracker.vision.end_cloth import EndImages, ExpectedEnd, end_evidence, part_side, part_start
from tracker.vision.finger_cloth import (
    DEPTH_EVERY,
    SAMPLES,
    SPACING,
    UNKNOWN_DEPTH,
    Finger,
    FingerImages,
    beyond_end,
    cloth_window,
    covered,
    covered_part,
    finger_evidence,
    finger_joints,
    finger_likelihoods,
    separates,
    surface_levels,
)
from tracker.vision.rig import NEAREST, Camera, StereoIntrinsics, StereoRig

LINES = 5  # capsules side by side that represent a broad segment
PALM_START = np.array([0.017, 0.24, -0.009])  # of a metacarpal: m, share of the knuckle's y, m
PALM_END = np.array([-0.003, 0.002, -0.008])  # m from the knuckle; y outwards
PALM_RADIUS = 0.0135  # m
LONGER = -0.25  # of `beyond_end`; below, cloth continues beyond the fingertip
ARM, ARM_WIDTH, ARM_RADIUS = 0.1, 0.02, 0.025  # m of the forearm that may have the glove's colours


class KnownParts(NamedTuple):
    """Capsules (k,) on the parts of a hand that are sensed: the segment of each, its ends (k, 2, 3)
    m in the segment's nominal B, and its nominal radius (k,) m."""

    segment: IntArray
    ends: Array
    radius: Array

    @classmethod
    def ends_of(cls, hand: HandModel, rows: Sequence[int]) -> KnownParts:
        """One capsule on each of the segments ``rows``."""
        segments = [hand.segments[i] for i in rows]
        ends = [((0.0, 0.0, 0.0), (s.length, 0.0, 0.0)) for s in segments]
        radius = np.array([s.radius for s in segments], float)
        return cls(np.array(rows, np.int64), np.array(ends, float).reshape(-1, 2, 3), radius)

    @classmethod
    def of(cls, hand: HandModel, without: Sequence[int], fingers: Sequence[int]) -> KnownParts:
        """All segments ``without`` some, and the palm of the ``fingers`` (their first segments)."""
        rows = [
            (i, ((0.0, y, 0.0), (s.length, y, 0.0)), s.radius)
            for i, s in enumerate(hand.segments)
            if i not in without
            for y in _across(s.width / 2 - s.radius if s.width > 0 else 0.0)
        ]
        for first in fingers:
            x, y, z = hand.segments[first].origin
            x0, share, z0 = PALM_START
            end = (x + PALM_END[0], y + np.sign(y) * PALM_END[1], z + PALM_END[2])
            rows.append((hand.root, ((x0, y * (1.0 - share), z0), end), PALM_RADIUS))
        for side in (-1.0, 1.0):
            start, end = (0.017, side * ARM_WIDTH, -0.01), (-ARM, side * ARM_WIDTH / 2, 0.0)
            rows.append((hand.root, (start, end), ARM_RADIUS))
        segment, ends, radius = zip(*rows, strict=True)
        return cls(np.array(segment, np.int64), np.array(ends, float), np.array(radius, float))

    def capsules(self, R: Array, p: Array, scale: Array) -> tuple[Array, Array]:
        """Ends (k, 2, 3) m in G and radii (k,) m, for R_GB (S, 3, 3), p_GB (S, 3) m, scale (S, 3)
        of the hand's segments."""
        scaled = scale[self.segment, None] * self.ends
        ends = p[self.segment, None] + np.einsum("kij,kej->kei", R[self.segment], scaled)
        return ends, self.radius * scale[self.segment, 1]


def _across(half: float) -> list[float]:
    """m, of the capsules of a segment whose axes are up to ``half`` beside its own."""
    return [0.0] if half <= 0.0 else np.linspace(-half, half, LINES).tolist()


class FingerView(NamedTuple):
    """One camera's window (`FingerImages`); classes (n, n) of its samples; known (n, n) probability
    that a known part covers a sample; texture (n, n) of the cloth, 0 if it is unknown."""

    window: Array
    classes: NDArray[np.uint8]
    known: Array
    texture: NDArray[np.int32]

    @property
    def is_right(self) -> bool:
        """Whether it is a window of the right image."""
        return bool(self.window[0] > 0.0)


def finger_views(
    rig: StereoRig,
    pose: CameraPose,
    cloths: Sequence[Cloth | None],
    known: tuple[Array, Array],
    centre: Array,
    textured: bool = False,
) -> list[FingerView]:
    """The cameras in whose images the glove's cloth differs from its surroundings; windows are
    about ``centre`` (3,) m in C. Their texture is set if ``textured``."""
    ends = (known[0] - pose.p_GC) @ pose.R_GC
    if min(centre[2], ends[..., 2].min()) <= 3 * NEAREST:
        return []
    views = [
        _view(rig, bool(c), (cloth, textured), centre, (ends, known[1]))
        for c, cloth in enumerate(cloths)
        if cloth is not None
    ]
    return [v for v in views if separates(v.classes, v.known)]


def _view(
    rig: StereoRig,
    right: bool,
    cloth: tuple[Cloth, bool],
    centre: Array,
    known: tuple[Array, Array],
) -> FingerView:
    """A window about ``centre`` (3,) m in C, with the ``known`` capsules in C; ``cloth`` has
    whether its texture is wanted."""
    camera: Camera = rig.right if right else rig.left
    pitch = SPACING * rig.fx / centre[2]
    start = rig.project(centre[None], right=right)[0] - SAMPLES / 2 * pitch
    window = np.array([rig.baseline if right else 0.0, start[0], start[1], pitch])
    wanted = cloth[1] and cloth[0].bright is not None
    classes, texture = cloth_window(cloth_map(cloth[0]), window, camera.optics, wanted)
    return FingerView(window, classes, covered(*known, rig.intrinsics, window), texture)


class ClothViews(NamedTuple):
    """The cameras that show the cloth, the known parts, ends (k, 2, 3) m in C and radii (k,) m, and
    the `matches` of both windows, (levels, n / 2, n / 2), or without levels if they are unknown."""

    each: list[FingerView]
    known: tuple[Array, Array]
    matches: NDArray[np.float32]


def cloth_views(
    rig: StereoRig,
    pose: CameraPose,
    cloths: Sequence[Cloth | None],
    known: tuple[Array, Array],
    centre: Array,
) -> ClothViews:
    """As `finger_views`, with the cloth's distance."""
    each = finger_views(rig, pose, cloths, known, centre, textured=True)
    in_C = (known[0] - pose.p_GC) @ pose.R_GC, known[1]
    if len(each) < 2 or any(c is None or c.bright is None for c in cloths):
        return ClothViews(each, in_C, UNKNOWN_DEPTH[0])
    return ClothViews(each, in_C, matches(*(view.texture for view in each)))


def finger_images(
    finger: Finger,
    others: Sequence[tuple[Finger, Array]],
    rig: StereoRig,
    views: ClothViews,
) -> FingerImages:
    """The evidence where ``others`` are the other fingers without sensors in their assumed postures
    (5,)."""
    ends, radius, of = [np.zeros((0, 2, 3))], [np.zeros(0)], rig.intrinsics
    for other, posture in others:
        joints = finger_joints(posture[None], other)[0]
        if joints[:, 2].min() > 3 * NEAREST:
            ends.append(np.stack([joints[:-1], joints[1:]], axis=1))
            radius.append(other.radius)
    capsules = np.concatenate(ends), np.concatenate(radius)
    r, maps = float(finger.radius.mean()) / SPACING, []
    drawn = [covered(*capsules, of, view.window) for view in views.each]
    for view, others_drawn in zip(views.each, drawn, strict=True):
        area = float(view.window[3]) ** 2
        maps.append(finger_evidence(view.classes, view.known, others_drawn, r, area))
    depth, disparity = _depth(views, drawn, capsules, of)
    windows = np.array([v.window for v in views.each])
    return FingerImages(finger, of, windows, np.array(maps), depth, disparity)


def _depth(
    views: ClothViews, drawn: Sequence[Array], others: tuple[Array, Array], of: StereoIntrinsics
) -> tuple[NDArray[np.float32], Array]:
    """depth and disparity of `FingerImages`, for ``others`` (capsules) that cover the samples of
    each view as ``drawn``."""
    if not len(views.matches):
        return UNKNOWN_DEPTH
    left, right = views.each
    pitch = left.window[3]
    offset = (left.window[1] - right.window[1]) / pitch
    disparity = np.array([of.fx * of.baseline / pitch, NEAREST_LEVEL + offset])
    ends, radius = (np.concatenate(p) for p in zip(views.known, others, strict=True))
    level = surface_levels(ends, radius, of, left.window, disparity)
    every = slice(None, None, DEPTH_EVERY)
    covered_too = 1.0 - (1.0 - left.known[every, every]) * (1.0 - drawn[0][every, every])
    return depth_evidence(views.matches, left.classes, covered_too, level), disparity


def rim_part(posture: Array, images: FingerImages) -> float:
    """What the rim and the distance contribute to the ln of the likelihood ratio of a posture (5,):
    negative where the finger is in front of other things with the glove's colours, unless these
    are farther away."""
    return float(finger_likelihoods(posture[None], images._replace(inside=0.0))[0])


def is_other_thing(posture: Array, images: FingerImages) -> bool:
    """Whether what looks like a finger in a posture (5,) is not one: it is longer, or in another
    distance from the cameras."""
    if beyond_end(posture, images) < LONGER:
        return True
    if not len(images.depth):
        return False
    flat = images._replace(depth=UNKNOWN_DEPTH[0])
    with_depth, without = (finger_likelihoods(posture[None], i)[0] for i in (images, flat))
    return bool(with_depth < without)


def end_images(
    end: ExpectedEnd, drawn: tuple[Array, Array], rig: StereoRig, views: Sequence[FingerView]
) -> EndImages:
    """The evidence of the last segment of a digit (eq. 59); ``drawn`` are the capsules of those of
    other digits: ends (k, 2, 3) m in C, radii (k,) m."""
    of, side = rig.intrinsics, part_side(end)
    windows, sums = [], []
    for view in views:
        first, part, pitch = part_start(end, of, view.window), view.window.copy(), view.window[3]
        part[1:3] += pitch * np.array(first)
        others = covered_part(*drawn, of, part, (side, side))
        sums.append(end_evidence(view.classes, view.known, others, float(pitch) ** 2, first))
        windows.append(part)
    return EndImages(of, np.array(windows), np.array(sums))
