"""Exposures: samples of a scene over the shutter time, and patches sewn to cloth."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

import numpy as np

from tracker.messages import Array, CameraPose, IntArray
from tracker.simulation.camera_view import pixels_of
from tracker.simulation.patches import SQUARE
from tracker.simulation.raster import ball_bounds
from tracker.simulation.sewn import ON_PLANE, SeenPatches, SewnPatches
from tracker.simulation.solids import SceneInstant, Solids
from tracker.simulation.wearer import Wearer, tangents
from tracker.vision.rig import Camera, StereoRig


class Scene(Protocol):
    """The content of an image: `SimulatedScene`, or two hands in one."""

    rig: StereoRig
    seed: int

    @property
    def wearers(self) -> Sequence[Wearer]:
        """The wearers whose segments and markers an instant contains, concatenated."""

    def instant(self, t: float) -> SceneInstant:
        """Everything in C at the time t (s)."""

    def positions(self, t: Array) -> Array:
        """(n, S, 3) m: the origins of all segments in C at the times t (n,) s."""

    def reported_pose(self, t: float) -> CameraPose | None:
        """The pose reported by the camera; None for a static one."""


class EyeView(NamedTuple):
    """From ``eye`` (3,) in C, with the rectified fx, fy, cx and cy of one of the two cameras."""

    eye: Array
    K: Array
    camera: Camera


JITTER_PX = np.array([[-0.25, 0.15], [0.3, 0.3], [-0.05, -0.35], [0.2, -0.1]])
"""Sub-pixel offset of each instant: smooths edges at no cost."""
SPEED_STEP = 0.005  # s
REACH = 0.04
"""m: from a segment's origin to its end with cloth, at most."""
SLOW_PX = 0.5
"""px of motion over half the shutter below which two instants are sufficient."""


class HandMotion(NamedTuple):
    """The speed (px/s) of the fastest segment, and the rows of an image that contain all hands:
    from the first to before the last."""

    speed: float
    rows: tuple[int, int]


def motion_at(scene: Scene, t: float) -> HandMotion:
    """The motion of the hands around the time t (s)."""
    p_CB, rig = scene.positions(t + np.array([-SPEED_STEP, SPEED_STEP])), scene.rig
    path = float(np.abs(p_CB[1] - p_CB[0]).max())
    depth = max(float(p_CB[0, 0, 2]), 0.05)
    points = p_CB.reshape(-1, 3)
    reach = rig.fy * REACH / np.maximum(points[:, 2], 2 * REACH)
    row = rig.left.unrectify(rig.project(points))[:, 1]
    some = np.isfinite(row)
    low, high = (row - reach)[some], (row + reach)[some]
    ends = (low.min(), high.max()) if some.any() else (0.0, 0.0)
    first, end = np.clip(np.round(ends).astype(int), 0, rig.left.height)
    return HandMotion(path / (2 * SPEED_STEP) / depth * rig.fx, (int(first), int(end)))


def moments_of(
    scene: Scene, t: float, shutter: float, count: int, fewest: int = 2
) -> list[SceneInstant]:
    """The scene at the midpoints of equal parts of the shutter (s); ``fewest`` (1 or 2) are used
    for a slow hand."""
    n = max(count, 1)
    if n > 2:
        first, last = (scene.instant(t + shutter * s) for s in (-0.25, 0.25))
        path = np.abs(last.p_CB - first.p_CB).max() / max(first.p_CB[0, 2], 0.05)
        if path * scene.rig.fx < SLOW_PX:
            return [first, last] if fewest == 2 else [scene.instant(t)]
    middle = (np.arange(n) + 0.5) / n - 0.5
    return [scene.instant(t + shutter * m) for m in middle]


def patches_of_all(
    wearers: Sequence[Wearer], colour_of: Callable[[str], Array]
) -> tuple[IntArray, SewnPatches]:
    """`sewn_patches` of all wearers, with concatenated segments and markers."""
    orders, parts = zip(*(sewn_patches(w, colour_of) for w in wearers), strict=True)
    before = np.cumsum([0, *(len(order) for order in orders)])
    joined = [np.concatenate(field) for field in zip(*parts, strict=True)]
    begins = [p.first[:-1] + n for p, n in zip(parts, before, strict=False)]
    first = np.concatenate([*begins, before[-1:]])
    order = np.concatenate([o + n for o, n in zip(orders, before, strict=False)])
    return order, SewnPatches(first, *joined[1:])


def sewn_patches(wearer: Wearer, colour_of: Callable[[str], Array]) -> tuple[IntArray, SewnPatches]:
    """The wearer's patches and the markers' rows in their order; positions are filled in for each
    instant. ``colour_of`` returns the BGR (3,) of a hue's fabric."""
    order = np.argsort(wearer.marker_segment, kind="stable")
    segment = wearer.marker_segment[order]
    markers = [wearer.glove.markers[i] for i in order]
    root, normal = wearer.hand.root, wearer.marker_normal[order]
    flat = [s == root or abs(m.normal[0]) > 0.5 for s, m in zip(segment, markers, strict=True)]
    fabric = np.array([colour_of(m.hue) for m in markers], float).reshape(-1, 3)
    return order, SewnPatches(
        np.searchsorted(segment, np.arange(len(wearer.hand.segments) + 1)),
        np.zeros((len(markers), 3)),
        np.concatenate([tangents(normal), normal[:, None]], axis=1),
        wearer.glove.marker_size[order],
        np.array([int(m.shape == "square") * SQUARE for m in markers], np.int64),
        np.array(flat, np.int64),
        fabric,
    )


def seen_patches(sewn: SewnPatches, now: SceneInstant, view: EyeView) -> SeenPatches:
    """Patches at one instant, in C and as pixel bounds: `shade` tests only these for each pixel."""
    segment = np.repeat(np.arange(len(sewn.first) - 1), np.diff(sewn.first))
    R, p = now.R_CB[segment], now.p_CB[segment]
    flat, (x, y, z) = sewn.flat == 1, sewn.position.T
    around, none = np.hypot(y, z), np.zeros_like(x)
    wrapped = np.array([[none + 1, none, none], [none, -z, y], [none, y, z]])
    axes = np.where(flat[:, None, None], sewn.axes, wrapped.transpose(2, 0, 1))
    origin = np.where(flat[:, None], sewn.position, np.column_stack([x, none, none]))
    middle = np.einsum("mij,mj->mi", R, sewn.position) + p
    size = _reach_of(sewn, around, _girth(now.solids, len(now.p_CB))[segment])
    box = ball_bounds((middle - view.eye)[:, None], size[:, None], view.K)
    return SeenPatches(
        sewn.first,
        pixels_of(box, view.camera),
        np.ascontiguousarray(np.einsum("mij,mkj->mki", R, axes)),
        np.einsum("mij,mj->mi", R, origin) + p,
        sewn.size / 2,
        np.where(flat, 0.0, around),
        sewn.shape,
        sewn.fabric,
    )


def _reach_of(sewn: SewnPatches, around: Array, girth: Array) -> Array:
    """(M,) m: from each patch's centre to the farthest point that it can cover. A wrapped one at
    ``around`` from the bone covers points from the bone to the cloth, at ``girth``."""
    half = sewn.size / 2
    turn = np.minimum(half / np.maximum(around, 1e-9), np.pi)
    across2 = np.maximum(around**2, around**2 + girth**2 - 2 * around * girth * np.cos(turn))
    return np.sqrt(half**2 + np.where(sewn.flat == 1, half**2 + ON_PLANE**2, across2))


def _girth(solids: Solids, segments: int) -> Array:
    """(S,) m: radius of each segment's thickest capsule."""
    out, owned = np.zeros(segments), solids.owner >= 0
    np.maximum.at(out, solids.owner[owned], solids.radius[owned])
    return out
