"""The modified Madgwick filter in the flexion plane (Lemak et al. 2020, section 2.3).

Gravity is compensated by the acceleration that the chain's own motion predicts, so that a moving
finger is not mistaken for a tilted one. In the plane the flexion normal is satisfied by
construction and the normalised gradient is the sign of the angular error.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker.inertial.integration import IntegrationState, integrate
from tracker.inertial.planar import PlanarReadings, WithState
from tracker.inertial.plane import SENSORS, ComplexArray, Levers, kinematic
from tracker.kernels import kernel
from tracker.kernels.arrays import ComplexMatrix, ComplexVector, Matrix, Vector, Written
from tracker.messages import Array


@dataclass(frozen=True)
class MadgwickParams:
    """β and what becomes of it while the finger accelerates."""

    beta: float = 0.1  # rad/s of the quaternion; twice that as an angular rate
    spurious: float = 0.0  # m/s² of |μ| at which β is halved; 0: β is constant
    least: float = 0.0  # rad/s that β never falls below: below ω_offset / 2 the estimate drifts
    compensate: bool = True  # False: the plain filter, every acceleration taken for gravity
    central: bool = True  # angular acceleration by central differences, one sample late


ADAPTIVE = MadgwickParams(beta=0.1, spurious=1.0, least=0.05)
"""β falls while the finger accelerates (end of section 2.3.2)."""


class MadgwickState(NamedTuple):
    """Integrator; accel (2,) and root (1,) of the last sample, for central differences."""

    integrator: IntegrationState
    accel: Written[ComplexVector]
    root: Written[ComplexVector]


class _Gains(NamedTuple):
    dt: float
    beta: float
    spurious: float
    least: float
    compensate: bool
    central: bool


class Madgwick(WithState[MadgwickState]):
    """Gyroscopes integrated, and at each sample a step of fixed size down the gradient.

    Lemak et al. 2020, doi:10.3390/computers9020040, section 2.3: eqs. 10, 15 and 18.
    """

    def __init__(
        self,
        dt: float,
        levers: Levers,
        params: MadgwickParams | None = None,
        theta: Array | tuple[float, float] = (0.0, 0.0),
    ) -> None:
        p = params or MadgwickParams()
        self.params = p
        self._levers = levers
        self._gains = _Gains(dt, p.beta, p.spurious, p.least, p.compensate, p.central)
        super().__init__(
            MadgwickState(
                IntegrationState.start(theta), np.zeros(SENSORS, complex), np.zeros(1, complex)
            )
        )

    def update(self, gyro: Array, accel: ComplexArray, root: complex) -> Array:
        _step(self._state, self._gains, self._levers, gyro, accel, root)
        return self._state.integrator.theta.copy()

    def run(self, readings: PlanarReadings) -> Array:
        out = np.empty(readings.gyro.shape)
        gyro, accel, root = readings
        _run(self._state, self._gains, self._levers, gyro, accel, root, out)
        return out


@kernel
def _step(
    state: MadgwickState,
    gains: _Gains,
    levers: Levers,
    gyro: Vector,
    accel: ComplexVector,
    root: complex,
) -> None:
    """Central: correct at the last sample, then integrate to this one. Else the other way."""
    s = state.integrator
    if gains.central:
        if s.samples[0] > 1:
            alpha = (gyro - s.rate[1]) / (2 * gains.dt)
            _descend(s.theta, gains, levers, s.rate[0], alpha, state.accel, state.root[0])
        integrate(s, gyro, gains.dt)
    else:
        alpha = (gyro - s.rate[0]) / gains.dt
        first = s.samples[0] == 0
        integrate(s, gyro, gains.dt)
        if not first:
            _descend(s.theta, gains, levers, gyro, alpha, accel, root)
    state.accel[:] = accel
    state.root[0] = root


@kernel
def _descend(
    theta: Written[Vector],
    gains: _Gains,
    levers: Levers,
    omega: Vector,
    alpha: Vector,
    accel: ComplexVector,
    root: complex,
) -> None:
    """One normalised gradient step of both angles (eqs. 16-18)."""
    mu_0, mu_1 = kinematic(levers, theta, omega, alpha)
    for k in range(SENSORS):
        mu = mu_0 if k == 0 else mu_1
        expected = root + mu if gains.compensate else root  # eqs. 2 and 11
        error = np.angle(expected * (np.exp(1j * theta[k]) * accel[k]).conjugate())
        beta = gains.beta
        if gains.spurious > 0:
            beta = max(gains.least, beta / (1 + (abs(mu) / gains.spurious) ** 2))
        theta[k] += 2 * beta * gains.dt * np.sign(error)  # eq. 18: |dq| = β dt turns by twice that


@kernel
def _run(
    state: MadgwickState,
    gains: _Gains,
    levers: Levers,
    gyro: Matrix,
    accel: ComplexMatrix,
    root: ComplexVector,
    out: Written[Matrix],
) -> None:
    for i in range(len(gyro)):
        _step(state, gains, levers, gyro[i], accel[i], root[i])
        out[i] = state.integrator.theta
