"""The simulated scene of a case: wearer, motion and surroundings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from extensions.evaluation.sessions import people_of
from extensions.evaluation.vist.cases import Ablation, Case
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, CameraPose
from tracker.simulation.backgrounds import fabric_bgr
from tracker.simulation.guided import HELD_BADLY, GuidedPoses, HoldParams
from tracker.simulation.head import MOVING, HeadParams
from tracker.simulation.motion import Faster, SimulatedMotion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.recorded.load import load_motion
from tracker.simulation.rooms import room_of
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.scene import Extra
from tracker.simulation.smooth import SmoothNoise, rng_for
from tracker.simulation.solids import UNOWNED, Solids, boxes, capsules
from tracker.simulation.wearer import Wearer
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import default_pose, ideal_rig

_NO_BALLS = (np.zeros((0, 3)), np.zeros(0), ())
OBJECTS = ("ball", "bottle", "box", "can", "cup", "phone", "pen", "stick")
"""Objects that can be held, eight as in the paper's experiment."""


class Distractors:
    """Balls of the markers' hues and sizes in the room, static or moving, behind the hand."""

    def __init__(
        self,
        seed: int,
        count: int = 60,
        hues: tuple[str, ...] = ("red", "yellow", "green", "blue"),
        moving: float = 0.0,  # m, standard deviation along each axis
        near: float = 0.45,  # m from the camera along its axis
        far: float = 1.0,
        camera: CameraPose | None = None,
    ) -> None:
        rng, pose = rng_for(seed, "distractors"), camera or default_pose()
        z = rng.uniform(near, far, count)
        x, y = rng.uniform(-0.95, 0.95, count) * z, rng.uniform(-0.55, 0.55, count) * z
        self._centre = np.column_stack([x, y, z]) @ pose.R_GC.T + pose.p_GC
        self._radius = rng.uniform(0.006, 0.011, count)
        self._names = tuple(str(n) for n in rng.choice(hues, count))
        self._colour = np.array([fabric_bgr(n) for n in self._names]).reshape(-1, 3)
        self._moving, self._wander = moving, SmoothNoise(rng, (count, 3), 1.0)

    def _positions(self, t: float) -> Array:
        return self._centre + self._moving * self._wander(np.array([t]))[0]

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        positions = self._positions(t)
        unowned = np.full(len(positions), UNOWNED)
        return capsules(positions, positions, self._radius, unowned, self._colour)

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        return self._positions(t), self._radius, self._names


@dataclass(frozen=True)
class HeldObject:
    """An object in the palm of ``hand``, fixed to the dorsum; ``kind`` is one of OBJECTS."""

    hand: HandModel
    kind: str = "ball"

    def __post_init__(self) -> None:
        if self.kind not in OBJECTS:
            raise ConfigError(
                notice("option.choice", option="--object", known=tuple(OBJECTS), value=self.kind)
            )

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        i = self.hand.root
        return self._in_dorsum().moved(R_GB[i], p_GB[i])

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        return _NO_BALLS

    def _in_dorsum(self) -> Solids:
        root = self.hand.segments[self.hand.root]
        grey, reach = np.array([150.0, 160.0, 165.0]), root.length + 0.012
        one = np.array([UNOWNED])
        if self.kind in ("box", "phone"):
            half = np.array(
                [[0.022, 0.055, 0.018] if self.kind == "box" else [0.037, 0.075, 0.005]]
            )
            centre = np.array([[reach, 0.0, -root.radius - half[0, 2] - 0.004]])
            return boxes(np.eye(3)[None], centre, half, one, grey)
        radius, half_length = _ROUND[self.kind]
        middle = np.array([reach, 0.0, -root.radius - radius - 0.003])
        half_axis = half_length * so3.rz(np.deg2rad(12)) @ np.array([0.0, 1.0, 0.0])
        ends = middle - half_axis, middle + half_axis
        return capsules(ends[0][None], ends[1][None], np.array([radius]), one, grey)


_ROUND = {
    "ball": (0.032, 0.0),
    "bottle": (0.030, 0.085),
    "can": (0.033, 0.035),
    "cup": (0.038, 0.030),
    "pen": (0.006, 0.070),
    "stick": (0.012, 0.120),
}
"""Radius and half length of the axis, m."""


@dataclass(frozen=True)
class FingertipDevices:
    """Haptic devices worn on fingertips: boxes that occlude the distal phalanges."""

    hand: HandModel
    fingers: tuple[str, ...] = ("thumb", "index")
    side: float = 0.013  # m, half of width and height
    extra: float = 0.006  # m beyond the tip

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        rows = [self.hand.index[f"{f}_distal"] for f in self.fingers]
        reach = np.array([(self.hand.segments[i].length + self.extra) / 2 for i in rows])
        half = np.column_stack([reach, np.full((len(rows), 2), self.side)])
        centre = p_GB[rows] + R_GB[rows][:, :, 0] * reach[:, None]
        return boxes(
            R_GB[rows], centre, half, np.full(len(rows), UNOWNED), np.array([45.0, 45.0, 50.0])
        )

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        return _NO_BALLS


POSTURE_EVERY = 3.0  # s, as in the paper
EACH_HELD = 40.0  # s: three objects in a trial of two minutes


@dataclass(frozen=True)
class InTurn:
    """Several held objects, each for `EACH_HELD` seconds."""

    things: tuple[HeldObject, ...]

    def _now(self, t: float) -> HeldObject:
        return self.things[int(t // EACH_HELD) % len(self.things)]

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        """The solids of the current object."""
        return self._now(t).solids(t, R_GB, p_GB)

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        """The current object's blobs with a marker's hue."""
        return self._now(t).coloured(t)


def motion_of(case: Case, hand: HandModel, seed: int, variant: Ablation | None) -> SimulatedMotion:
    """Random postures, or a recording if the case names some (participants take turns)."""
    speed = 1.0 if variant is None else variant.speed
    if case.motion_files:
        motion: SimulatedMotion = load_motion(
            Path(case.motion_files[seed % len(case.motion_files)]), hand
        )
    else:
        duration = 60.0 * case.minutes * speed  # so that a faster trial has the same duration
        motion = RandomPostures(hand, seed=seed, period=POSTURE_EVERY, duration=duration)
    return motion if speed == 1.0 else Faster(motion, speed)


def guided_motion(
    case: Case, hand: HandModel, glove: GloveModel, then: SimulatedMotion, seed: int
) -> GuidedPoses:
    """Guided poses before ``then``, by the person that `simulation_of` draws from ``seed``."""
    params = HELD_BADLY if case.guided == "badly" else HoldParams()
    wearer = Wearer.random(hand, glove, seed)
    return GuidedPoses(wearer, then, seed, params)


def simulation_of(
    case: Case,
    hand: HandModel,
    glove: GloveModel,
    motion: SimulatedMotion,
    seed: int,
    variant: Ablation | None,
    person: int | None = None,
) -> Simulation:
    """A person drawn from ``seed`` in the scene of the experiment. With ``person``, the person is
    drawn from that seed, and the fit of the glove and everything else from ``seed``."""
    fps = case.fps if variant is None or variant.fps is None else variant.fps
    room = room_of("desk" if case.light else "plain", case.light, seed=seed)
    extras = (*extras_of(case, hand, seed), *room.extras)
    head = MOVING if case.experiment == "head" else HeadParams()
    if variant is not None:
        head = replace(head, tells=variant.camera)
    people = people_of(case.session)
    params = SimulationParams(person=person, head=head, render=room.render, wearer=people)
    rig = with_one_camera(ideal_rig()) if case.lenses == "one" else ideal_rig()
    return Simulation(hand, glove, motion, seed, params, fps=fps, rig=rig, extras=extras)


def extras_of(case: Case, hand: HandModel, seed: int) -> Sequence[Extra]:
    """Objects that the hand holds or wears, and other objects with a marker's colour."""
    out: list[Extra] = []
    if case.experiment == "object":
        kinds = rng_for(seed, "held things").choice(OBJECTS, 3, replace=False)
        out.append(InTurn(tuple(HeldObject(hand, str(kind)) for kind in kinds)))
    if case.experiment == "device":
        out.append(FingertipDevices(hand))
    if case.distractors:
        out.append(Distractors(seed, case.distractors))
    return out
