"""Tracks one simulated person with a camera whose rows are exposed one after the other."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from extensions.evaluation.tracked import compared, estimates_of
from extensions.evaluation.vist.trial import models
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.simulation.head import HeadParams
from tracker.simulation.motion import Swinging
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.rig import ideal_rig, with_readout

POSTURE_EVERY = 3.0  # s


@dataclass(frozen=True)
class ShutterCase:
    """A hand whose swings reach ``speed`` m/s before a camera whose turns reach ``turning_deg``
    °/s; ``readout`` s from the first row to the last. ``engine`` gets the camera's line time where
    it is ``compensated``."""

    speed: float
    turning_deg: float
    readout: float
    compensated: bool = True
    engine: str = "chain"
    images: bool = False
    fps: float = 60.0
    seconds: float = 20.0


@dataclass(frozen=True)
class ShutterFigures:
    """For one person in one case: mean error (mm) of the four keypoints in the camera's frame,
    share of instants at which the hand is tracked, and the estimated time offset (ms)."""

    seed: int
    error_mm: float
    tracked: float
    offset_ms: float


def simulation_of(case: ShutterCase, seed: int) -> Simulation:
    """The person of a seed in a case; the same hand with every camera."""
    hand, glove = models()
    rig = with_readout(ideal_rig(), case.readout)
    own = RandomPostures(hand, seed, POSTURE_EVERY, case.seconds + 0.1, camera=rig.pose)
    motion = Swinging(own, case.speed, rig.pose) if case.speed else own
    params = SimulationParams(head=HeadParams(turn_deg=case.turning_deg))
    return Simulation(hand, glove, motion, seed, params, case.fps, rig)


def run_trial(
    case: ShutterCase, seed: int, progress: Callable[[float], None] = lambda share: None
) -> ShutterFigures:
    """Simulate and track; a task of `tracker.base.workers`."""
    sim = simulation_of(case, seed)
    rig = sim.rig if case.compensated else replace(sim.rig, line_time=0.0)
    pipeline = Pipeline(sim.hand, sim.glove, rig, Settings(engine=case.engine))
    estimates = estimates_of(sim, pipeline, case.images, progress)
    found = compared(sim, pipeline, estimates)
    offset = pipeline.timing.offset.value
    return ShutterFigures(seed, found.error_mm, found.tracked, 1e3 * offset)
