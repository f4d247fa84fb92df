"""A left and a right hand in front of one camera that occlude each other."""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tracker.base.clock import nanoseconds
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.names import SIDES
from tracker.messages import (
    Array,
    BlobFrame,
    Blobs,
    CameraPose,
    ImuSample,
    IntArray,
    StereoFrame,
)
from tracker.simulation.desk.renderer import DeskParams
from tracker.simulation.motion import Poses, SimulatedMotion
from tracker.simulation.random_postures import PostureParams, RandomPostures
from tracker.simulation.render import Renderer
from tracker.simulation.scenario import Simulation, SimulationParams, stamped
from tracker.simulation.scene import SimulatedScene, touching
from tracker.simulation.smooth import minimum_jerk, rng_for
from tracker.simulation.solids import BodyShape, SceneInstant, Solids, together
from tracker.simulation.wearer import Wearer
from tracker.vision.rig import StereoRig, ideal_rig

CLOSE = PostureParams(near=0.30, far=0.36, wide=0.03, high=0.08, roll_deg=25.0, yaw_deg=10.0)
"""Postures of hands near the centre of the camera's view."""


@dataclass(frozen=True)
class MeetingParams:
    """Separations (m) along the image's rows between the centres of two palms, the right hand's
    minus the left one's: negative with crossed arms."""

    apart: tuple[float, float] = (0.18, 0.25)
    near: tuple[float, float] = (0.12, 0.15)
    touching: tuple[float, float] = (0.095, 0.11)
    folded: tuple[float, float] = (0.02, 0.06)
    crossed: tuple[float, float] = (-0.16, -0.12)
    over: float = 0.095  # m along the optical axis between two overlapping hands
    width: float = 0.09  # m of separation, beyond which they do not overlap
    first_hold: float = 1.5  # s apart
    period: float = 2.0  # s between successive separations
    move: float = 0.9  # s for the transition


class Meeting:
    """The relative position of two hands over time, drawn from a seed."""

    def __init__(self, seed: int, duration: float, params: MeetingParams | None = None) -> None:
        self._params = p = params or MeetingParams()
        rng = rng_for(seed, "meeting")
        count = max(int(np.ceil((duration - p.first_hold) / p.period)), 0)
        kinds = (p.apart, p.near, p.touching, p.folded, p.crossed)
        drawn = rng.choice(len(kinds), count, p=[0.15, 0.2, 0.25, 0.2, 0.2])
        self._separation = np.array(
            [rng.uniform(*p.apart), *(rng.uniform(*kinds[k]) for k in drawn)]
        )
        self._upper = float(rng.choice([-1.0, 1.0]))  # which hand is nearer to the camera

    def offset(self, t: Array) -> Array:
        """(n, 3) m in C from the left to the right hand at the times t (n,) s."""
        p = self._params
        start = p.first_hold + p.period * np.arange(len(self._separation) - 1)
        steps = np.diff(self._separation)
        share = minimum_jerk((np.asarray(t, float)[:, None] - start) / p.move)
        along = self._separation[0] + share @ steps
        depth = self._upper * p.over * np.exp(-((along / p.width) ** 4))
        return np.column_stack([along, np.zeros(len(along)), depth])


@dataclass(frozen=True, eq=False)
class OneOfTwo:
    """A motion about the centre, shifted to its position in a meeting; ``side`` is the hand's."""

    motion: SimulatedMotion
    meeting: Meeting
    side: str
    camera: CameraPose

    @property
    def duration(self) -> float:
        return self.motion.duration

    @property
    def follows_synergies(self) -> bool:
        return self.motion.follows_synergies

    def poses(self, t: Array) -> Poses:
        poses = self.motion.poses(t)
        half = 0.5 if self.side == "right" else -0.5
        shift = half * self.meeting.offset(t) @ self.camera.R_GC.T
        return poses._replace(p_GB=poses.p_GB + shift)


class GlovedHand(NamedTuple):
    """A hand and its glove."""

    hand: HandModel
    glove: GloveModel


class SidedMessage(NamedTuple):
    """A message, and the side of its glove; empty for images of both."""

    side: str
    message: ImuSample | BlobFrame | StereoFrame


class OccludingHand:
    """The other hand as an object in the scene: it occludes, and adds no blobs of its own."""

    def __init__(self, wearer: Wearer, motion: SimulatedMotion) -> None:
        self._wearer, self._motion, self._shape = wearer, motion, BodyShape.of(wearer)

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        return self.solids_at(np.array([t]))[0]

    def solids_at(self, t: Array) -> list[Solids]:
        """(n,) `solids` at the times t (n,) s."""
        all_R, all_p, _ = self._wearer.segments(self._motion, t)
        found = [self._shape.solids(R, p) for R, p in zip(all_R, all_p, strict=True)]
        return [
            s._replace(owner=-np.ones_like(s.owner), box_owner=-np.ones_like(s.box_owner))
            for s in found
        ]

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        return np.zeros((0, 3)), np.zeros(0), ()


class TwoHandsScene:
    """Two hands as one scene to be drawn: the segments and markers of the second follow those of
    the first."""

    def __init__(self, first: SimulatedScene, second: SimulatedScene, seed: int) -> None:
        self._scenes, self.rig, self.seed = (first, second), first.rig, seed
        self.wearers = (first.wearer, second.wearer)

    def instant(self, t: float) -> SceneInstant:
        """Everything in C at the time t (s)."""
        first, second = (scene.instant(t) for scene in self._scenes)
        owner, box_owner = (
            np.where(owner >= 0, owner + len(first.p_CB), owner)
            for owner in (second.solids.owner, second.solids.box_owner)
        )
        solids = second.solids._replace(owner=owner, box_owner=box_owner)
        return SceneInstant(
            np.concatenate([first.R_CB, second.R_CB]),
            np.concatenate([first.p_CB, second.p_CB]),
            together([first.solids, solids]),
            np.concatenate([first.markers, second.markers]),
        )

    def positions(self, t: Array) -> Array:
        """(n, S, 3) m: the origins of all segments of both hands in C at the times t (n,) s."""
        return np.concatenate([scene.positions(t) for scene in self._scenes], axis=1)

    def reported_pose(self, t: float) -> CameraPose | None:
        """The pose reported by the camera; None for a static one."""
        return self._scenes[0].reported_pose(t)


def hand_seed(seed: int, side: str) -> int:
    """The seed of one of two hands."""
    return 2 * seed + SIDES.index(side)


class TwoHandsSimulation:
    """A left and a right hand that meet, in G of one camera. One seed determines everything."""

    def __init__(
        self,
        dressed: Mapping[str, GlovedHand],
        seed: int,
        duration: float,
        fps: float = 60.0,
        params: SimulationParams | None = None,
        rig: StereoRig | None = None,
    ) -> None:
        self.seed, self.rig, self.fps = seed, rig or ideal_rig(), fps
        self.params = params = replace(params or SimulationParams(), camera=seed)
        if isinstance(params.render, DeskParams):
            raise ConfigError(notice("simulate.two_hands_scene"))
        self._drawn_with = params.render
        meeting, camera = Meeting(seed, duration), self.rig.pose
        seeds = {side: hand_seed(seed, side) for side in SIDES}
        motions = {
            side: OneOfTwo(
                RandomPostures(dressed[side].hand, seeds[side], 3.0, duration, CLOSE, camera),
                meeting, side, camera,
            )
            for side in SIDES
        }  # fmt: skip
        others = {}
        for side, other in zip(SIDES, reversed(SIDES), strict=True):
            wearer = Wearer.random(*dressed[other], seeds[other], params.wearer)
            others[side] = OccludingHand(wearer, motions[other])
        self.hands = {
            side: Simulation(
                *dressed[side], motions[side], seeds[side], params, fps, self.rig, [others[side]]
            )
            for side in SIDES
        }
        self.alone = {
            side: Simulation(*dressed[side], motions[side], seeds[side], params, fps, self.rig)
            for side in SIDES
        }
        """Each hand as it would be without the other."""

    @property
    def duration(self) -> float:
        return self.hands["left"].duration

    def exposures(self) -> Iterator[tuple[int, float, float]]:
        """(index, t, arrival) of each image, as `Simulation.exposures`."""
        return self.hands["left"].exposures()

    def blob_frames(self) -> Iterator[BlobFrame]:
        """The blobs of both hands that a good detector finds."""
        for index, t, arrival in self.exposures():
            left, right = (self.hands[side].scene.blobs(t, arrival, index) for side in SIDES)
            yield both_seen(left, right, self.seed)

    @cached_property
    def renderer(self) -> Renderer:
        """Created for the first image: it contains ray maps and backgrounds."""
        left, right = (self.alone[side].scene for side in SIDES)
        return Renderer(
            TwoHandsScene(left, right, self.seed), self._drawn_with, self.params.flicker
        )

    def image_frames(self) -> Iterator[StereoFrame]:
        """Images of both hands."""
        for index, t, arrival in self.exposures():
            yield self.renderer.frame(t, arrival, index)

    def messages(self, images: bool = False) -> Iterator[SidedMessage]:
        """All packets, and blobs or images, in the order of arrival; packets first of simultaneous
        messages."""
        parts = [self._packets(side) for side in SIDES]
        how = self.params.stamp_jitter, self.seed
        seen: Iterator[BlobFrame | StereoFrame]
        seen = stamped(self.image_frames(), *how) if images else stamped(self.blob_frames(), *how)
        frames = (SidedMessage("", frame) for frame in seen)
        return heapq.merge(*parts, frames, key=lambda m: m.message.t_arrival)

    def _packets(self, side: str) -> Iterator[SidedMessage]:
        for sample in self.hands[side].imu_samples():
            yield SidedMessage(side, sample)


def both_seen(a: BlobFrame, b: BlobFrame, seed: int) -> BlobFrame:
    """The blobs of two hands in one exposure, in random order."""
    ns = nanoseconds(a.t)
    rng = rng_for(seed, "both", ns % 2**32, ns // 2**32)
    names = tuple(dict.fromkeys((*a.hue_names, *b.hue_names)))
    number = np.array([names.index(n) for n in b.hue_names], np.int64)
    sides = [_merged(x, y, number, rng) for x, y in ((a.left, b.left), (a.right, b.right))]
    return replace(a, hue_names=names, left=sides[0], right=sides[1])


def _merged(
    a: Blobs | None, b: Blobs | None, number: IntArray, rng: np.random.Generator
) -> Blobs | None:
    """``number`` are the hues of ``b`` in the numbering of ``a``. Touching blobs merge, and do not
    have the shape of a marker."""
    if a is None or b is None:
        return a or b
    uv, size = np.concatenate([a.uv, b.uv]), np.concatenate([a.size, b.size])
    hue = np.concatenate([a.hue, number[b.hue]]).astype(np.int64)
    score = np.concatenate([a.score, b.score])
    kept = rng.permutation(np.flatnonzero(~touching(uv, size, hue)))
    return Blobs(uv[kept], size[kept], hue[kept], score[kept])
