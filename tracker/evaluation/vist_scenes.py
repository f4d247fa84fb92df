"""The simulated scene of a case: whose hand moves how, and what is around it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from tracker.evaluation.vist_cases import Ablation, Case
from tracker.evaluation.vist_extras import Device, HeldObject
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.motion import Faster, Motion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.simulation.scene import Extra

POSTURE_EVERY = 3.0  # s, as in the paper


def motion_of(case: Case, hand: HandModel, seed: int, variant: Ablation | None) -> Motion:
    """Random postures, or a recording if the case names some (participants take turns)."""
    if case.motion_files:
        from tracker.simulation.recorded import load_motion

        path = Path(case.motion_files[seed % len(case.motion_files)])
        motion: Motion = load_motion(path, hand)
    else:
        motion = RandomPostures(hand, seed=seed, period=POSTURE_EVERY, duration=60.0 * case.minutes)
    if variant is not None and variant.speed != 1.0:
        motion = Faster(motion, variant.speed)
    return motion


def simulation_of(
    case: Case,
    hand: HandModel,
    glove: GloveModel,
    motion: Motion,
    seed: int,
    variant: Ablation | None,
) -> Simulation:
    """A person drawn from ``seed`` in the scene of the experiment."""
    fps = case.fps if variant is None or variant.fps is None else variant.fps
    return Simulation(
        hand, glove, motion, seed=seed, fps=fps, extras=extras_of(case.experiment, hand, seed)
    )


def extras_of(experiment: str, hand: HandModel, seed: int) -> Sequence[Extra]:
    """What the hand holds or wears."""
    if experiment == "object":
        return (HeldObject(hand, seed),)
    if experiment == "device":
        return (Device(hand),)
    return ()
