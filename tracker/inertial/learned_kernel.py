"""The Kalman filter of `tracker.inertial.learned`, one sample at a time, compiled."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.inertial.plane import SENSORS, Levers, kinematic, runge_kutta
from tracker.kernels import kernel
from tracker.kernels.arrays import ComplexMatrix, ComplexVector, Matrix, Stack, Vector, Written
from tracker.messages import Array

SIZE = 4  # θ, b_g, b_x (along), b_z (palmar)


@record(
    "finger.learned",
    shapes={
        "x": "2 4",
        "P": "2 4 4",
        "gyro": "2 2",
        "accel": "complex 2",
        "root": "complex 1",
        "rest_accel": "complex 2",
        "samples": "1",
        "rest_count": "1",
        "static": "1",
    },
)
class LearnedState(NamedTuple):
    """x (2, 4), P (2, 4, 4); gyro (2, 2) of the last and the last but one sample; accel (2,) and
    root (1,) of the last; mean of accel since it came to rest (2,); samples (1,) so far and of them
    at rest (1,); static (1,) 1 while the known start lasts."""

    x: Written[Matrix]
    P: Written[Stack]
    gyro: Written[Matrix]
    accel: Written[ComplexVector]
    root: Written[ComplexVector]
    rest_accel: Written[ComplexVector]
    samples: Written[Vector]
    rest_count: Written[Vector]
    static: Written[Vector]


class Model(NamedTuple):
    """`LearnedParams` per sample."""

    dt: float
    levers: Levers
    gyro_sd: float
    accel_sd: float
    gyro_walk: float
    accel_walk: float
    lever_share: float
    static_samples: float
    rest_samples: float
    rest_gyro: float
    rest_accel: float
    rest_sd: float


def start(theta: Array, variances: tuple[float, ...]) -> LearnedState:
    """The state before the first sample."""
    x = np.zeros((SENSORS, SIZE))
    x[:, 0] = theta
    P = np.stack([np.diag(np.array(variances, float))] * SENSORS)
    zero = np.zeros(SENSORS, complex)
    return LearnedState(
        x, P, np.zeros((2, SENSORS)), zero, np.zeros(1, complex), zero.copy(),
        np.zeros(1), np.zeros(1), np.ones(1),
    )  # fmt: skip


@kernel
def step(
    state: LearnedState, model: Model, gyro: Vector, accel: ComplexVector, root: complex
) -> None:
    """Correct at the last sample, whose neighbours are known now; then continue with this one."""
    _watch_rest(state, model, gyro, accel)
    if state.static[0] > 0:
        _learn_static(state, model, gyro, accel, root)
    else:
        _correct_accel(state, model, gyro)
        _propagate(state, model, gyro)
        if state.rest_count[0] > model.rest_samples:
            for k in range(SENSORS):
                _update(state, k, 1, gyro[k] - state.x[k, 1], model.rest_sd**2)
    state.gyro[1] = state.gyro[0]
    state.gyro[0] = gyro
    state.accel[:] = accel
    state.root[0] = root
    state.samples[0] += 1


@kernel
def correct_angle(state: LearnedState, k: int, theta: float, variance: float) -> None:
    """An angle of sensor ``k`` that something else knows."""
    _update(state, k, 0, theta - state.x[k, 0], variance)


@kernel
def _watch_rest(state: LearnedState, model: Model, gyro: Vector, accel: ComplexVector) -> None:
    """Count samples since both sensors began to stand still; end the static start in time."""
    still = True
    known = state.static[0] == 0.0 or state.samples[0] > 0  # the first sample meets no offset yet
    for k in range(SENSORS):
        n = state.rest_count[0]
        if n == 0:
            state.rest_accel[k] = accel[k]
        else:
            state.rest_accel[k] += (accel[k] - state.rest_accel[k]) / min(n + 1, 50.0)
        if known and abs(gyro[k] - state.x[k, 1]) > model.rest_gyro:
            still = False
        if abs(accel[k] - state.rest_accel[k]) > model.rest_accel:
            still = False
    state.rest_count[0] = state.rest_count[0] + 1 if still else 0.0
    if not still or state.samples[0] >= model.static_samples:
        state.static[0] = 0.0


@kernel
def _learn_static(
    state: LearnedState, model: Model, gyro: Vector, accel: ComplexVector, root: complex
) -> None:
    """The pose is known and nothing moves: all that the sensors add is offset and noise."""
    for k in range(SENSORS):
        _update(state, k, 1, gyro[k] - state.x[k, 1], model.gyro_sd**2)
        _update_accel(state, k, accel[k], root, model.accel_sd**2)


@kernel
def _correct_accel(state: LearnedState, model: Model, gyro: Vector) -> None:
    """Compare the last sample's accelerometers with the chain at that instant."""
    omega = state.gyro[0] - state.x[:, 1]
    alpha = (gyro - state.gyro[1]) / (2 * model.dt)
    mu_0, mu_1 = kinematic(model.levers, state.x[:, 0], omega, alpha)
    for k in range(SENSORS):
        mu = mu_0 if k == 0 else mu_1
        variance = model.accel_sd**2 + (model.lever_share * abs(mu)) ** 2
        _update_accel(state, k, state.accel[k], state.root[0] + mu, variance)


@kernel
def _propagate(state: LearnedState, model: Model, gyro: Vector) -> None:
    """From the last sample to this one."""
    dt = model.dt
    for k in range(SENSORS):
        last, older = state.gyro[0, k], state.gyro[1, k]
        state.x[k, 0] += runge_kutta(gyro[k], last, older, dt) - state.x[k, 1] * dt
        P = state.P[k]
        P[0, :] -= dt * P[1, :]  # J_x_x is the identity but for -dt of θ by b_g
        P[:, 0] -= dt * P[:, 1]
        bend = gyro[k] - 2 * last + older  # a rate this curved is not followed exactly
        P[0, 0] += (dt * model.gyro_sd) ** 2 + (dt * bend / 24) ** 2
        P[1, 1] += dt * model.gyro_walk**2
        P[2, 2] += dt * model.accel_walk**2
        P[3, 3] += dt * model.accel_walk**2


@kernel
def _update_accel(state: LearnedState, k: int, f: complex, force: complex, variance: float) -> None:
    """Both components of a reading f = exp(-iθ) force + b, one after the other."""
    x, P = state.x[k], state.P[k]
    expected = np.exp(-1j * x[0]) * force
    jacobian = -1j * expected  # J_f_θ
    innovation = f - expected - (x[2] + 1j * x[3])
    before = x.copy()
    for axis in range(2):
        h = jacobian.real if axis == 0 else jacobian.imag
        r = innovation.real if axis == 0 else innovation.imag
        # the linearisation point stays while the first component moves the state
        r -= h * (x[0] - before[0]) + x[2 + axis] - before[2 + axis]
        Ph = h * P[:, 0] + P[:, 2 + axis]
        s = h * Ph[0] + Ph[2 + axis] + variance
        K = Ph / s
        x += K * r
        for i in range(SIZE):
            for j in range(SIZE):
                P[i, j] -= K[i] * Ph[j]


@kernel
def _update(state: LearnedState, k: int, i: int, innovation: float, variance: float) -> None:
    """A scalar measurement of component ``i`` of sensor ``k``."""
    x, P = state.x[k], state.P[k]
    Ph = P[:, i].copy()
    K = Ph / (Ph[i] + variance)
    x += K * innovation
    for a in range(SIZE):
        for b in range(SIZE):
            P[a, b] -= K[a] * Ph[b]


@kernel
def run(
    state: LearnedState,
    model: Model,
    gyro: Matrix,
    accel: ComplexMatrix,
    root: ComplexVector,
    out: Written[Matrix],
) -> None:
    """`step` over n samples; θ (n, 2) into ``out``."""
    for i in range(len(root)):
        step(state, model, gyro[i], accel[i], root[i])
        out[i] = state.x[:, 0]
