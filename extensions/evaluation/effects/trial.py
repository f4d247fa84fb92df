"""Tracks one simulated person with devices that have some of the errors of real ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import NamedTuple

from extensions.evaluation.tracked import compared, estimates_of
from extensions.evaluation.vist.trial import models
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.simulation.flicker import FlickerParams
from tracker.simulation.imu_errors import ImuParams
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.rig_errors import BOARD, RigErrorParams, with_lenses
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.rig import ideal_rig, with_readout

READOUT = 0.018  # s from the first row to the last, of a ZED at 30 images per second
STAMP_JITTER = 0.004  # s
IMU_SCALE = 0.015  # standard deviation
WARM_UP_SLOPE = 0.25  # °/s/°C, standard deviation: 1.5 °/s over the warm-up of 6 °C
WARM_UP_TIME = 30.0  # s, time constant
FLICKER = 0.5  # of an LED lamp with a poor supply
POSTURE_EVERY = 3.0  # s


@dataclass(frozen=True)
class Effects:
    """Which errors the simulated devices have."""

    readout: bool = False
    rig: bool = False
    stamps: bool = False
    imu_scale: bool = False
    warm_up: bool = False
    flicker: bool = False


CLEAN, ALL = Effects(), Effects(*[True] * len(fields(Effects)))
EFFECTS: dict[str, Effects] = {
    "clean": CLEAN,
    "rolling shutter": Effects(readout=True),
    "lenses and rig": Effects(rig=True),
    "stamp jitter": Effects(stamps=True),
    "IMU scale": Effects(imu_scale=True),
    "warm-up": Effects(warm_up=True),
    "flicker": Effects(flicker=True),
    "all": ALL,
}
"""By the names of the rows; lamps flicker in images only."""


@dataclass(frozen=True)
class EffectsCase:
    """The ``effects`` in free motion of ``seconds`` s; ``fps`` in Hz."""

    effects: Effects
    engine: str = "chain"
    images: bool = False
    fps: float = 60.0
    seconds: float = 20.0


class EffectsFigures(NamedTuple):
    """For one person: mean error (mm) of the four keypoints, share of instants at which the hand is
    tracked, and the number of keypoints called measured that are more than 50 mm wrong."""

    seed: int
    error_mm: float
    tracked: float
    wrong: int


def simulation_of(case: EffectsCase, seed: int) -> Simulation:
    """The person of a seed; the same hand and motion with all devices."""
    hand, glove = models()
    effects, rig = case.effects, ideal_rig()
    if effects.readout:
        rig = with_readout(rig, READOUT)
    if effects.rig:
        rig = with_lenses(rig, seed)
    params = SimulationParams(
        imu=_imus(effects),
        rig_errors=BOARD if effects.rig else RigErrorParams(),
        stamp_jitter=STAMP_JITTER if effects.stamps else 0.0,
        flicker=FlickerParams(FLICKER if effects.flicker else 0.0),
    )
    motion = RandomPostures(hand, seed, POSTURE_EVERY, case.seconds + 0.1, camera=rig.pose)
    return Simulation(hand, glove, motion, seed, params, case.fps, rig)


def _imus(effects: Effects) -> ImuParams:
    """IMUs with constant biases and noise, and the errors in question. Scale errors come with
    those of the axes and of the instants of reading."""
    out = replace(ImuParams(), gyro_slope_deg=0.0, accel_slope_mg=0.0)
    if effects.warm_up:
        slope = {"gyro_slope_deg": WARM_UP_SLOPE, "gyro_slope_limit_deg": 2 * WARM_UP_SLOPE}
        out = replace(out, accel_slope_mg=0.5, warm_up_time=WARM_UP_TIME, **slope)
    if effects.imu_scale:
        return replace(out, gyro_scale=IMU_SCALE, accel_scale=IMU_SCALE)
    none = dict.fromkeys(("gyro_scale", "accel_scale", "cross_axis", "g_sensitivity_deg"), 0.0)
    return replace(out, read_skew=0.0, **none)


def run_trial(
    case: EffectsCase, seed: int, progress: Callable[[float], None] = lambda share: None
) -> EffectsFigures:
    """Simulate and track; a task of `tracker.base.workers`."""
    sim = simulation_of(case, seed)
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig, Settings(engine=case.engine))
    found = compared(sim, pipeline, estimates_of(sim, pipeline, case.images, progress))
    return EffectsFigures(seed, *found)
