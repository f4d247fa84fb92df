"""The simulated scene of a case: wearer, motion and surroundings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from extensions.evaluation.vist.cases import Ablation, Case
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array
from tracker.simulation.extras import OBJECTS, Distractors, FingertipDevices, HeldObject
from tracker.simulation.guided import HELD_BADLY, GuidedPoses, HoldParams
from tracker.simulation.head import MOVING, HeadParams
from tracker.simulation.motion import Faster, SimulatedMotion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.recorded.load import load_motion
from tracker.simulation.rooms import room_of
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.scene import Extra
from tracker.simulation.smooth import rng_for
from tracker.simulation.solids import Solids
from tracker.simulation.wearer import Wearer
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import ideal_rig

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
    params = SimulationParams(person=person, head=head, render=room.render)
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
