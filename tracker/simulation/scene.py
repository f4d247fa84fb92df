"""The stereo camera's view of a wearer, marker by marker: blobs without images."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from tracker.base.clock import nanoseconds
from tracker.messages import Array, BlobFrame, Blobs, CameraPose, IntArray
from tracker.simulation.head import Head
from tracker.simulation.motion import SimulatedMotion
from tracker.simulation.patches import (
    CIRCLE,
    SQUARE,
    PatchShapes,
    in_sight,
    sample_pattern,
    view_patches,
)
from tracker.simulation.row_sampling import OwnRow, instants_for, row_delay
from tracker.simulation.smooth import rng_for
from tracker.simulation.solids import BodyShape, SceneInstant, Solids, together
from tracker.simulation.wearer import Wearer
from tracker.vision.rig import Camera, StereoRig


@dataclass(frozen=True)
class BlobParams:
    """Conditions for a marker to produce a blob, and measurement noise."""

    noise_px: float = 0.3
    dropout: float = 0.02  # of blobs that should be detected
    facing: float = 0.18  # mean cosine of the patch, minimum: 80° off the axis
    whole: float = 0.35  # share not occluded, minimum
    size_noise: float = 0.05


class Extra(Protocol):
    """An additional object in the scene: in the hand, on a fingertip, or a coloured distractor."""

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        """Its solids in G, given the segments' poses R_GB (S, 3, 3), p_GB (S, 3)."""
        ...

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        """Balls of a marker's hue: centres (n, 3) m in G, radii (n,) m, hue names."""
        ...


@runtime_checkable
class MovingExtra(Protocol):
    """An `Extra` that takes little longer for several times than for one."""

    def solids_at(self, t: Array) -> list[Solids]:
        """Its solids in G at each of the times t (n,) s."""
        ...


class SeenMarkers(NamedTuple):
    """Markers in one image: raw pixel centroids (M, 2), extents (M, 2) px, and whether they are
    blobs.

    facing (M,) is the mean cosine of the whole patch, 0 for occluded parts; whole (M,) the share of
    the facing part that is not occluded.
    """

    uv: Array
    extent: Array
    visible: NDArray[np.bool_]
    facing: Array
    whole: Array


class _Balls(NamedTuple):
    """Coloured balls in one image: uv, extent (n, 2) px, hue (n,), and which of them are seen."""

    uv: Array
    extent: Array
    hue: IntArray
    seen: NDArray[np.bool_]


class SimulatedScene:
    """A wearer moving in front of a rig."""

    def __init__(
        self,
        wearer: Wearer,
        motion: SimulatedMotion,
        rig: StereoRig,
        seed: int,
        params: BlobParams | None = None,
        extras: Sequence[Extra] = (),
        head: Head | None = None,
    ) -> None:
        self.head = head or Head(rig.pose, seed)
        self.wearer, self.motion, self.rig = wearer, motion, rig
        self.params, self.extras = params or BlobParams(), tuple(extras)
        self.shape = BodyShape.of(wearer)
        self.seed = seed
        glove = wearer.glove
        self._pattern = sample_pattern()
        self._patches = PatchShapes(
            np.ascontiguousarray(glove.marker_normal, float),
            np.ascontiguousarray(glove.marker_size, float),
            np.array([SQUARE if m.shape == "square" else CIRCLE for m in glove.markers], np.int64),
            np.ascontiguousarray(wearer.marker_segment, np.int64),
            (wearer.marker_segment == wearer.hand.root).astype(np.int64),
        )

    @property
    def wearers(self) -> tuple[Wearer]:
        """The only one."""
        return (self.wearer,)

    def pose(self, t: float) -> CameraPose:
        """The camera's true pose at the time t (s)."""
        return self.head.pose(t)

    def reported_pose(self, t: float) -> CameraPose | None:
        """The pose reported by the camera; None for a static one."""
        return self.head.reported(t)

    def instant(self, t: float) -> SceneInstant:
        """Everything in C at the time t (s)."""
        return self.instants(np.array([t]))[0]

    def instants(self, t: Array) -> list[SceneInstant]:
        """`instant` at each of the times t (n,) s."""
        R_GB, p_GB, _ = self.wearer.segments(self.motion, t)
        markers = self.wearer.markers_at(t)
        extras = [_solids(e, t, R_GB, p_GB) for e in self.extras]
        out = []
        for k, at in enumerate(t):
            pose = self.pose(float(at))
            R_CG, p_CG = pose.R_GC.T, -pose.R_GC.T @ pose.p_GC
            own = self.shape.solids(R_GB[k], p_GB[k])
            solids = together([own, *(e[k] for e in extras)]).moved(R_CG, p_CG)
            out.append(SceneInstant(R_CG @ R_GB[k], p_GB[k] @ R_CG.T + p_CG, solids, markers[k]))
        return out

    def positions(self, t: Array) -> Array:
        """(n, S, 3) m: the origins of all segments in C at the times t (n,) s."""
        _, p_GB, _ = self.wearer.segments(self.motion, t)
        poses = [self.pose(at) for at in t]
        return np.stack([(p - c.p_GC) @ c.R_GC for p, c in zip(p_GB, poses, strict=True)])

    def markers_seen(self, now: SceneInstant, right: bool) -> SeenMarkers:
        """The markers in one image without noise."""
        rig = self.rig
        eye = np.array([rig.baseline if right else 0.0, 0.0, 0.0])
        K = np.array([rig.fx, rig.fy, rig.cx, rig.cy])
        uv, extent, facing, whole = view_patches(eye, K, now, self._patches, self._pattern)
        camera = rig.right if right else rig.left
        some = np.isfinite(uv[:, 0])
        uv[some] = camera.unrectify(uv[some])
        extent *= camera.K[0, 0] / rig.fx
        visible = (facing > self.params.facing) & (whole > self.params.whole)
        visible &= inside(camera, uv, extent)
        return SeenMarkers(uv, extent, visible, facing, whole)

    def visible(self, t: float) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """(M,) bool for the left and the right image: which markers produce a blob."""
        now = self.instant(t)
        return self.markers_seen(now, False).visible, self.markers_seen(now, True).visible

    def blobs(self, t: float, t_arrival: float | None = None, index: int = -1) -> BlobFrame:
        """The blobs that a good detector finds in the exposure at t (s)."""
        now = self.instant(t)
        rng = rng_for(self.seed, "blobs", nanoseconds(t) % 2**32, nanoseconds(t) // 2**32)
        look = self._look_by_rows if self.rig.line_time else self._look
        left = self._side(*look(now, t, False), rng)
        right = None if self.rig.one_camera else self._side(*look(now, t, True), rng)
        arrival = t if t_arrival is None else t_arrival
        hues = self.wearer.glove.hues
        return BlobFrame(t, arrival, hues, left, right, self.reported_pose(t), index=index)

    def _look(self, now: SceneInstant, t: float, right: bool) -> tuple[SeenMarkers, list[_Balls]]:
        """What one camera sees at one instant."""
        balls = [self._coloured(now, extra, t, right) for extra in self.extras]
        return self.markers_seen(now, right), balls

    def _look_by_rows(
        self, now: SceneInstant, t: float, right: bool
    ) -> tuple[SeenMarkers, list[_Balls]]:
        """The same with a rolling shutter: everything at the instant at which its row is
        exposed."""
        rig, camera = self.rig, self.rig.right if right else self.rig.left
        first = self._look(now, t, right)
        rows = np.concatenate([first[0].uv[:, 1], *(b.uv[:, 1] for b in first[1])])
        after = instants_for(rig, camera, rows)
        times = t + after
        looks = [
            self._look(then, float(at), right)
            for at, then in zip(times, self.instants(times), strict=True)
        ]
        seen, balls = [look[0] for look in looks], list(zip(*(b for _, b in looks), strict=True))

        def own(uv: Array) -> OwnRow:
            return OwnRow.of(after, row_delay(rig, camera, uv[..., 1]))

        uv, extent, _, facing, whole = (np.stack(column) for column in zip(*seen, strict=True))
        there = own(uv)
        uv, extent, facing, whole = map(there.of_values, (uv, extent, facing, whole))
        visible = (facing > self.params.facing) & (whole > self.params.whole)
        visible &= inside(camera, uv, extent)
        out = []
        for same in balls:
            at = own(np.stack([b.uv for b in same]))
            place, size = (
                at.of_values(np.stack([getattr(b, n) for b in same])) for n in ("uv", "extent")
            )
            shown = np.stack([b.seen for b in same])[at.before, np.arange(len(place))]
            out.append(_Balls(place, size, same[0].hue, shown & inside(camera, place, size)))
        return SeenMarkers(uv, extent, visible, facing, whole), out

    def _side(self, seen: SeenMarkers, balls: list[_Balls], rng: np.random.Generator) -> Blobs:
        kept = seen.visible & (rng.random(len(seen.visible)) >= self.params.dropout)
        hue = self.wearer.glove.marker_hue[kept]
        uv, size = seen.uv[kept], seen.extent[kept]
        for more in balls:
            uv = np.concatenate([uv, more.uv[more.seen]])
            size = np.concatenate([size, more.extent[more.seen]])
            hue = np.concatenate([hue, more.hue[more.seen]])
        free = ~touching(uv, size, hue)
        return self._measured(uv[free], size[free], hue[free], rng)

    def _measured(self, uv: Array, size: Array, hue: IntArray, rng: np.random.Generator) -> Blobs:
        """Adds noise and shuffles the rows."""
        order = rng.permutation(len(uv))
        noise = rng.normal(0, self.params.noise_px, uv.shape)
        size = size * (1 + self.params.size_noise * rng.normal(size=size.shape))
        score = rng.uniform(0.7, 1.0, len(uv))
        return Blobs((uv + noise)[order], size[order], hue[order], score)

    def _coloured(self, now: SceneInstant, extra: Extra, t: float, right: bool) -> _Balls:
        """Distractors in one image; those ``seen`` are not occluded."""
        centre, radius, names = extra.coloured(t)
        if not names:
            none = np.zeros((0, 2))
            return _Balls(none, none, np.zeros(0, np.int64), np.zeros(0, bool))
        pose = self.pose(t)
        p_C = (centre - pose.p_GC) @ pose.R_GC
        camera = self.rig.right if right else self.rig.left
        uv = self.rig.project(p_C, right).reshape(-1, 2)
        front = np.isfinite(uv[:, 0])
        uv[front] = camera.unrectify(uv[front])
        focal = [camera.K[0, 0], camera.K[1, 1]]
        size = 2 * radius[:, None] * focal / np.maximum(p_C[:, 2:], 0.01)
        hues = self.wearer.glove.hues
        known = np.array([h in hues for h in names], bool)
        seen = front & known & inside(camera, uv, size) & self._in_sight(now, p_C, radius, right)
        hue = np.array([hues.index(h) if h in hues else -1 for h in names], np.int64)
        return _Balls(uv, size, hue, seen)

    def _in_sight(
        self, now: SceneInstant, p_C: Array, radius: Array, right: bool
    ) -> NDArray[np.bool_]:
        """(n,) bool: whether the balls' centres are visible past the solids."""
        eye = np.array([self.rig.baseline if right else 0.0, 0.0, 0.0])
        away = p_C - eye
        unit = away / np.linalg.norm(away, axis=1, keepdims=True)
        return in_sight(eye, p_C - unit * (radius[:, None] + 1e-4), now.solids)


def _solids(extra: Extra, t: Array, R_GB: Array, p_GB: Array) -> list[Solids]:
    """Those of an additional object at each of the times t (n,) s."""
    if isinstance(extra, MovingExtra):
        return extra.solids_at(t)
    return [extra.solids(float(at), R, p) for at, R, p in zip(t, R_GB, p_GB, strict=True)]


def inside(camera: Camera, uv: Array, extent: Array) -> NDArray[np.bool_]:
    """(n,) bool: whether blobs are completely in the image."""
    low = uv - extent / 2
    high = uv + extent / 2
    with np.errstate(invalid="ignore"):
        return (
            (low[:, 0] > 0) & (low[:, 1] > 0)
            & (high[:, 0] < camera.width - 1) & (high[:, 1] < camera.height - 1)
        )  # fmt: skip


def touching(uv: Array, size: Array, hue: IntArray) -> NDArray[np.bool_]:
    """(n,) bool: adjacent blobs of one hue, which a detector rejects for their shape."""
    gap = np.abs(uv[:, None] - uv[None]) - (size[:, None] + size[None]) / 2
    close = np.all(gap < 0, axis=2) & (hue[:, None] == hue[None])
    np.fill_diagonal(close, False)
    return close.any(axis=1)
