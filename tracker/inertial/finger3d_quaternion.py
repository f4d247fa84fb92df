"""The modified Madgwick filter in quaternion form, both IMUs of a finger (section 2.3).

Two vectors correct each gyro-integrated orientation: the specific force, compared with gravity plus
the acceleration of the chain below the sensor, and the flexion plane's normal, which the dorsum's
pose gives and which takes the place of the magnetic field.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from tracker.geometry import so3
from tracker.inertial.geometry3d import DorsumMotion, FingerGeometry, force_at
from tracker.inertial.madgwick import MadgwickParams
from tracker.messages import Array

_NORMAL_B = np.array([0.0, 1.0, 0.0])


class _Moment(NamedTuple):
    """What one sample told: gyro, accel (2, 3) in B; w_B (3,) of the dorsum, its R_GB (3, 3)."""

    gyro: Array
    accel: Array
    dorsum: DorsumMotion


class QuaternionFinger:
    """q_GB of both phalanges by gradient descent; central differences, so one sample late."""

    def __init__(self, geometry: FingerGeometry, dt: float, params: MadgwickParams) -> None:
        self._geometry, self._dt, self._params = geometry, dt, params
        self._q_GB: Array | None = None  # (2, 4) xyzw
        self._past: list[_Moment] = []  # the last two samples, newest last

    def update(self, dorsum: DorsumMotion, gyro: Array, accel: Array) -> tuple[Array, Array]:
        """R_01, R_12 from the dorsum and both IMUs (2, 3)."""
        if self._q_GB is None:
            R_0 = dorsum.R_GB @ self._geometry.R_rest_0
            self._q_GB = so3.quat_from_matrix(np.stack([R_0, R_0 @ self._geometry.R_rest_1]))
        now = _Moment(gyro, accel, dorsum)
        if len(self._past) == 2:
            self._correct(self._past[1], self._past[0], now)
        if self._past:
            middle = 0.5 * (gyro + self._past[-1].gyro)
            _integrate(self._q_GB, middle, self._dt)
        self._past = [*self._past[-1:], now]
        R_G0, R_G1 = so3.matrix_from_quat(self._q_GB)
        return dorsum.R_GB.T @ R_G0, R_G0.T @ R_G1

    def _correct(self, at: _Moment, before: _Moment, after: _Moment) -> None:
        """One descent step at the sample between two others."""
        assert self._q_GB is not None
        g, p, span = self._geometry, self._params, 2 * self._dt
        alpha_B = (after.dorsum.w_B - before.dorsum.w_B) / span
        root_G = at.dorsum.R_GB @ force_at(at.dorsum, alpha_B, g.joint_0)
        R = so3.matrix_from_quat(self._q_GB)
        mu_G = _chain(R, at.gyro, (after.gyro - before.gyro) / span, g)
        force_G = root_G + mu_G if p.compensate else np.stack([root_G, root_G])
        normal_G = at.dorsum.R_GB @ g.R_rest_0 @ _NORMAL_B
        beta = np.full(2, p.beta)
        if p.spurious > 0:
            beta = beta / (1 + (np.linalg.norm(mu_G, axis=1) / p.spurious) ** 2)
        _descend(self._q_GB, force_G, normal_G, at.accel, 2 * beta * self._dt)


def _chain(R_GB: Array, w: Array, alpha: Array, g: FingerGeometry) -> Array:
    """μ_k (2, 3) m/s² in G of both sensors, relative to joint 0 (eq. 2 in three dimensions)."""
    to_sensor_0 = R_GB[0] @ _centripetal(w[0], alpha[0], g.sensor_0)
    to_joint_1 = R_GB[0] @ _centripetal(w[0], alpha[0], g.joint_1)
    to_sensor_1 = R_GB[1] @ _centripetal(w[1], alpha[1], g.sensor_1)
    return np.stack([to_sensor_0, to_joint_1 + to_sensor_1])


def _centripetal(w: Array, alpha: Array, lever: Array) -> Array:
    turned: Array = np.cross(alpha, lever) + np.cross(w, np.cross(w, lever))
    return turned


@njit(cache=True)
def _integrate(q: Array, w: Array, dt: float) -> None:
    """q ← q ⊗ exp(ω dt / 2) for rows of ``q`` (n, 4) and ``w`` (n, 3) rad/s in B."""
    for i in range(len(q)):
        half = 0.5 * dt * w[i]
        n = np.sqrt(np.sum(half**2))
        f = np.sin(n) / n if n > 1e-12 else 1.0
        _multiply(q[i], f * half, np.cos(n))


@njit(cache=True)
def _descend(q: Array, force_G: Array, normal_G: Array, f_B: Array, step: Array) -> None:
    """Rotate each q by ``step`` rad down the gradient of both vectors' squared misfits.

    With a = Rᵀ a_G estimated and b measured, turning B by δ changes a by a × δ, so the gradient of
    ½|a - b|² is a × b; Madgwick's quaternion gradient is this vector in the tangent space.
    """
    for i in range(len(q)):
        norm_f, norm_g = np.sqrt(np.sum(f_B[i] ** 2)), np.sqrt(np.sum(force_G[i] ** 2))
        gradient = np.cross(_to_body(q[i], normal_G), _NORMAL_B)
        if norm_f > 0 and norm_g > 0:
            gradient += np.cross(_to_body(q[i], force_G[i]), f_B[i]) / (norm_f * norm_g)
        size = np.sqrt(np.sum(gradient**2))
        if size > 1e-12:
            # never past the minimum: near it the gradient is the error itself
            turn = min(step[i], size)
            _multiply(q[i], -0.5 * turn / size * gradient, np.sqrt(1 - 0.25 * turn**2))


@njit(cache=True)
def _to_body(q: Array, v: Array) -> Array:
    """Rᵀ v of the unit quaternion q_GB."""
    u = -q[:3]
    t = 2 * np.cross(u, v)
    return v + q[3] * t + np.cross(u, t)


@njit(cache=True)
def _multiply(q: Array, v: Array, w: float) -> None:
    """q ← q ⊗ (v, w), normalised."""
    vector = q[3] * v + w * q[:3] + np.cross(q[:3], v)
    scalar = q[3] * w - np.sum(q[:3] * v)
    n = np.sqrt(np.sum(vector**2) + scalar**2)
    q[:3] = vector / n
    q[3] = scalar / n
