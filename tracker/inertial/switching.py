"""The switching algorithm: gravity while motion is slow, integration while it is fast.

Lemak et al. 2020, sections 2.2.4 and 2.2.5.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.inertial.integration import IntegrationState, integrate
from tracker.inertial.planar import PlanarReadings, WithState
from tracker.inertial.plane import SENSORS, ComplexArray, Levers, gravity_angle
from tracker.kernels import kernel
from tracker.kernels.arrays import ComplexMatrix, ComplexVector, Matrix, Vector, Written
from tracker.messages import Array


@dataclass(frozen=True)
class SwitchingParams:
    """What the error bounds know of finger and sensors."""

    gyro_error: float = np.deg2rad(5.0)  # |Δω| rad/s, MPU-9250 zero-rate tolerance
    longest: float = 0.045  # l_max, m
    accel_offset: float = 0.0  # m/s², 0 as in the paper; else the bound knows the zero-g offset
    own_levers: bool = False  # bound μ by each sensor's own levers instead of (k + 1) l_max

    @staticmethod
    def with_offset(accel_offset: float) -> SwitchingParams:
        """The variant that also counts on an accelerometer offset (m/s²) and knows its levers."""
        return SwitchingParams(accel_offset=accel_offset, own_levers=True)


@record("finger.switching", shapes={"bound": "2", "fast": "2"})
class SwitchingState(NamedTuple):
    """Integrator, bound (2,) rad of each angle's error, fast (2,) 1 while integrating."""

    integrator: IntegrationState
    bound: Written[Vector]
    fast: Written[Vector]


class _Bounds(NamedTuple):
    dt: float
    gyro_error: float
    longest: float
    accel_offset: float
    own_levers: bool
    levers: Levers


class Switching(WithState[SwitchingState]):
    """For each sensor, of two estimates always the one whose error bound is smaller.

    Lemak et al. 2020, doi:10.3390/computers9020040, sections 2.2.4 and 2.2.5.
    """

    def __init__(
        self,
        dt: float,
        levers: Levers,
        params: SwitchingParams | None = None,
        theta: Array | tuple[float, float] = (0.0, 0.0),
    ) -> None:
        p = params or SwitchingParams()
        self.params = p
        self._bounds = _Bounds(dt, p.gyro_error, p.longest, p.accel_offset, p.own_levers, levers)
        start = IntegrationState.start(theta)
        super().__init__(SwitchingState(start, np.zeros(SENSORS), np.ones(SENSORS)))

    def turn(self, angle: float) -> None:
        """P's own axes have turned by ``angle`` rad in the plane since the last sample."""
        self._state.integrator.theta[:] -= angle

    def update(self, gyro: Array, accel: ComplexArray, root: complex) -> Array:
        _step(self._state, self._bounds, gyro, accel, root)
        return self._state.integrator.theta.copy()

    def run(self, readings: PlanarReadings) -> Array:
        out = np.empty(readings.gyro.shape)
        _run(self._state, self._bounds, readings.gyro, readings.accel, readings.root, out)
        return out


@kernel
def _acceleration_bounds(
    state: SwitchingState, bounds: _Bounds, gyro: Vector
) -> tuple[float, float]:
    """Largest |μ_k| of both sensors at the measured rates, m/s² (eq. 6)."""
    jump = np.zeros(SENSORS)
    if state.integrator.samples[0] > 0:
        jump[:] = (gyro - state.integrator.rate[0]) / bounds.dt
    if bounds.own_levers:
        a_0, a_1 = np.sqrt(jump**2 + gyro**4)
        levers = bounds.levers
        return abs(levers.sensor_0) * a_0, abs(levers.length_0) * a_0 + abs(levers.sensor_1) * a_1
    arm = bounds.longest * np.sqrt(np.max(np.abs(jump)) ** 2 + np.max(np.abs(gyro)) ** 4)
    return arm, 2 * arm  # eq. 6


@kernel
def _step(
    state: SwitchingState, bounds: _Bounds, gyro: Vector, accel: ComplexVector, root: complex
) -> None:
    """One sample for both sensors: integrate, and take gravity's angle where that errs less."""
    started = state.integrator.samples[0] > 0
    mu = _acceleration_bounds(state, bounds, gyro)
    integrate(state.integrator, gyro, bounds.dt)  # from the last estimate, whichever it was
    size = abs(root)
    for k in range(SENSORS):
        # eq. 7; a zero-g offset turns the measured vector exactly as an acceleration does
        gravity_bound = (mu[k] + bounds.accel_offset) / size if size > 0 else np.inf
        drift_bound = state.bound[k] + (bounds.gyro_error * bounds.dt if started else 0.0)  # eq. 8
        if gravity_bound < drift_bound:
            state.integrator.theta[k] = gravity_angle(root, accel[k])
        state.bound[k] = min(gravity_bound, drift_bound)
        state.fast[k] = 0.0 if gravity_bound < drift_bound else 1.0


@kernel
def _run(
    state: SwitchingState,
    bounds: _Bounds,
    gyro: Matrix,
    accel: ComplexMatrix,
    root: ComplexVector,
    out: Written[Matrix],
) -> None:
    for i in range(len(gyro)):
        _step(state, bounds, gyro[i], accel[i], root[i])
        out[i] = state.integrator.theta
