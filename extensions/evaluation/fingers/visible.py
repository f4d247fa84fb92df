"""How much of each digit of a true hand the cameras see."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from extensions.evaluation.fingers.silhouettes import capsules
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array, CameraPose
from tracker.vision.rig import NEAREST, Camera, StereoRig

DIGITS = ("thumb", *FINGERS)
SEGMENTS = 3  # of a digit; `capsules` begins with those of `DIGITS`
COARSE = 2.0  # px between two samples


class Seen(NamedTuple):
    """For f stereo pairs at the times t (f,) s: the share (f, 5) of each of `DIGITS` that is
    visible in the image that shows more of it."""

    t: Array
    share: Array

    def at(self, t: float, digit: str) -> float:
        """The share of a digit in the pair closest to ``t``, NaN without one."""
        if not len(self.t):
            return np.nan
        return float(self.share[int(np.argmin(np.abs(self.t - t))), DIGITS.index(digit)])


def shares_seen(
    keypoints: Array, names: Sequence[str], hand: HandModel, rig: StereoRig, pose: CameraPose
) -> Array:
    """(5,) share of each of `DIGITS` of a hand with true ``keypoints`` (K, 3) m in G that is in the
    image and not behind another part of the hand, in the image that shows more of it.

    Other objects are not known.
    """
    ends, radius = capsules(keypoints, names, hand)
    in_C = (ends - pose.p_GC) @ pose.R_GC
    return np.max([_shares(in_C, radius, rig, right) for right in (False, True)], axis=0)


def _shares(ends: Array, radius: Array, rig: StereoRig, right: bool) -> Array:
    """In one image, of capsules with ends (k, 2, 3) m in C and radii (k,) m."""
    camera: Camera = rig.right if right else rig.left
    rows, columns = (int(n / COARSE) for n in (camera.height, camera.width))
    depth, nearest = np.full((rows, columns), np.inf), np.full((rows, columns), -1)
    alone = np.zeros((len(DIGITS), rows, columns), bool)
    beyond = np.zeros(len(DIGITS))
    for k, (capsule, r) in enumerate(zip(ends, radius, strict=True)):
        digit, z = k // SEGMENTS, capsule[:, 2]
        if z.min() <= 3 * NEAREST:
            continue
        (a, b), size = rig.project(capsule, right=right) / COARSE, r * rig.fx / z.mean() / COARSE
        low = np.floor(np.minimum(a, b) - size).astype(int)
        high = np.ceil(np.maximum(a, b) + size).astype(int) + 1
        y, x = np.mgrid[low[1] : high[1], low[0] : high[0]]
        (du, dv), u, v = b - a, x - a[0], y - a[1]
        t = np.clip((u * du + v * dv) / (du**2 + dv**2 + 1e-9), 0.0, 1.0)
        away = np.hypot(u - t * du, v - t * dv) / size
        covered, inside = away <= 1.0, (x >= 0) & (y >= 0) & (x < columns) & (y < rows)
        if digit < len(DIGITS):
            beyond[digit] += (covered & ~inside).sum()
        at = covered & inside
        front = z[0] + t[at] * (z[1] - z[0]) - r * np.sqrt(1.0 - away[at] ** 2)
        y, x = y[at], x[at]
        if digit < len(DIGITS):
            alone[digit, y, x] = True
        first = front < depth[y, x]
        depth[y[first], x[first]], nearest[y[first], x[first]] = front[first], digit
    seen = np.array([(nearest == d).sum() for d in range(len(DIGITS))])
    return np.asarray(seen / np.maximum(alone.sum(axis=(1, 2)) + beyond, 1.0))
