"""The estimators of the experiment, by their names in tables, figures and JSON."""

from __future__ import annotations

from collections.abc import Callable

from extensions.evaluation.inertial.errors import MPU9250
from tracker.inertial.finger import Finger
from tracker.inertial.gravity import Gravity
from tracker.inertial.integration import Integration
from tracker.inertial.learned import Learned
from tracker.inertial.madgwick import ADAPTIVE, Madgwick, MadgwickParams
from tracker.inertial.planar import PlanarEstimator
from tracker.inertial.switching import Switching, SwitchingParams

Maker = Callable[[Finger, float], PlanarEstimator]
"""Makes an estimator at the known initial pose from a finger and the sampling time in s."""

BETAS = (0.033, 0.1, 0.33)  # rad/s, the trade-off of section 3


def _madgwick(params: MadgwickParams) -> Maker:
    return lambda finger, dt: Madgwick(dt, finger.levers, params)


def _switching_offset(finger: Finger, dt: float) -> PlanarEstimator:
    return Switching(dt, finger.levers, SwitchingParams.with_offset(MPU9250.accel_offset))


ESTIMATORS: dict[str, Maker] = {
    "gravity": lambda finger, dt: Gravity(),
    "integration": lambda finger, dt: Integration(dt),
    "switching": lambda finger, dt: Switching(dt, finger.levers),
    "switching_offset": _switching_offset,
    "madgwick": _madgwick(MadgwickParams()),
    "madgwick_adaptive": _madgwick(ADAPTIVE),
    "learned": lambda finger, dt: Learned(dt, finger.levers),
}

VARIANTS: dict[str, Maker] = {
    f"madgwick_{kind}_{beta:g}": _madgwick(params)
    for beta in BETAS
    for kind, params in (
        ("central", MadgwickParams(beta)),
        ("backward", MadgwickParams(beta, central=False)),
        ("plain", MadgwickParams(beta, compensate=False)),
    )
}
"""The Madgwick filter with and without compensation, for the study of β and of the derivative."""
