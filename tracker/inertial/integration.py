"""Angles by integrating the gyroscopes (Lemak et al. 2020, section 2.2.3)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.inertial.planar import PlanarReadings, WithState, start_angles
from tracker.inertial.plane import SENSORS, ComplexArray, runge_kutta
from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Vector, Written
from tracker.messages import Array


@record("finger.integration", shapes={"theta": "2", "rate": "2 2", "samples": "1"})
class IntegrationState(NamedTuple):
    """theta (2,) rad; rate (2, 2) rad/s of the last and the last but one; samples (1,) so far."""

    theta: Written[Vector]
    rate: Written[Matrix]
    samples: Written[Vector]

    @staticmethod
    def start(theta: Array | tuple[float, float]) -> IntegrationState:
        return IntegrationState(start_angles(theta), np.zeros((2, SENSORS)), np.zeros(1))


class Integration(WithState[IntegrationState]):
    """Runge-Kutta from a known start; drifts by the gyroscopes' offset.

    Lemak et al. 2020, doi:10.3390/computers9020040, section 2.2.3.
    """

    def __init__(self, dt: float, theta: Array | tuple[float, float] = (0.0, 0.0)) -> None:
        self._dt = dt
        super().__init__(IntegrationState.start(theta))

    def update(self, gyro: Array, accel: ComplexArray, root: complex) -> Array:
        integrate(self._state, gyro, self._dt)
        return self._state.theta.copy()

    def run(self, readings: PlanarReadings) -> Array:
        out = np.empty(readings.gyro.shape)
        _run(self._state, readings.gyro, self._dt, out)
        return out


@kernel
def integrate(state: IntegrationState, gyro: Vector, dt: float) -> None:
    """Advance θ by one sample. The first sample is at the known start and changes nothing."""
    last, older = state.rate[0], state.rate[1]
    for k in range(SENSORS):
        if state.samples[0] > 0:
            before = older[k] if state.samples[0] > 1 else 2 * last[k] - gyro[k]
            state.theta[k] += runge_kutta(gyro[k], last[k], before, dt)
        older[k] = last[k]
        last[k] = gyro[k]
    state.samples[0] += 1


@kernel
def _run(state: IntegrationState, gyro: Matrix, dt: float, out: Written[Matrix]) -> None:
    for i in range(len(gyro)):
        integrate(state, gyro[i], dt)
        out[i] = state.theta
