"""Angles from the accelerometers alone (Lemak et al. 2020, section 2.2.2)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.inertial.planar import PlanarReadings, WithState
from tracker.inertial.plane import SENSORS, ComplexArray, gravity_angle
from tracker.kernels import kernel
from tracker.kernels.arrays import ComplexMatrix, ComplexVector, Matrix, Vector, Written
from tracker.messages import Array


class GravityState(NamedTuple):
    """theta (2,) rad."""

    theta: Written[Vector]


class Gravity(WithState[GravityState]):
    """θ_k = atan2 of the reading against joint 0's specific force; accurate while motion is slow.

    Lemak et al. 2020, doi:10.3390/computers9020040, section 2.2.2.
    """

    def __init__(self) -> None:
        super().__init__(GravityState(np.zeros(SENSORS)))

    def update(self, gyro: Array, accel: ComplexArray, root: complex) -> Array:
        _step(self._state, accel, root)
        return self._state.theta.copy()

    def run(self, readings: PlanarReadings) -> Array:
        out = np.empty(readings.gyro.shape)
        _run(self._state, readings.accel, readings.root, out)
        return out


@kernel
def _step(state: GravityState, accel: ComplexVector, root: complex) -> None:
    for k in range(SENSORS):
        state.theta[k] = gravity_angle(root, accel[k])


@kernel
def _run(
    state: GravityState, accel: ComplexMatrix, root: ComplexVector, out: Written[Matrix]
) -> None:
    for i in range(len(root)):
        _step(state, accel[i], root[i])
        out[i] = state.theta
