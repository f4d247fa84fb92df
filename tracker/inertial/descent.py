"""Quaternion integration and Madgwick's normalised gradient step, compiled.

Madgwick, Harrison, Vaidyanathan 2011, doi 10.1109/ICORR.2011.5975346, with the second vector of
Lemak et al. 2020 (section 2.3): the flexion plane's normal in place of the magnetic field.
"""

from __future__ import annotations

import numpy as np

from tracker.inertial.geometry3d import to_body
from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Vector, Written

NORMAL_B = np.array([0.0, 1.0, 0.0])  # a phalanx's flexion axis
UP_G = np.array([0.0, 0.0, 1.0])


@kernel
def integrate_rates(q: Written[Matrix], w: Matrix, dt: float) -> None:
    """q ← q ⊗ exp(ω dt / 2) (eq. 10) for rows of q_GB (n, 4) xyzw and ``w`` (n, 3) rad/s in B."""
    for i in range(len(q)):
        half = 0.5 * dt * w[i]
        n = np.sqrt(np.sum(half**2))
        f = np.sin(n) / n if n > 1e-12 else 1.0
        _multiply(q[i], f * half, np.cos(n))


@kernel
def descend(
    q: Written[Matrix], force_G: Matrix, f_B: Matrix, normal_G: Vector, step: Vector
) -> None:
    """Turn each q by ``step`` (n,) rad down the gradient of its misfit to two vectors.

    force_G (n, 3) is the specific force expected, f_B (n, 3) the one read, normal_G (3,) the
    flexion axis in G; a zero normal leaves that vector out.
    """
    for i in range(len(q)):
        g = gradient(q[i], force_G[i], f_B[i]) + gradient(q[i], normal_G, NORMAL_B)
        size = np.sqrt(np.sum(g**2))
        if size > 1e-12:
            angle = min(step[i], size)  # near the minimum the gradient is the error itself
            _multiply(q[i], -0.5 * angle / size * g, np.sqrt(1 - 0.25 * angle**2))  # eq. 18


@kernel
def gradient(q: Vector, a_G: Vector, b_B: Vector) -> Vector:
    """Gradient (3,) of ½|a - b|² (eq. 11) by a small turn δ of B, of unit vectors a = Rᵀ a_G, b.

    The turn changes a by a × δ, so that the gradient is a × b. Madgwick's gradient by the
    quaternion's components is this vector in the tangent space.
    """
    size = np.sqrt(np.sum(a_G**2) * np.sum(b_B**2))
    if size == 0:
        return np.zeros(3)
    return np.cross(to_body(q, a_G), b_B) / size


@kernel
def plain_madgwick(gyro: Matrix, accel: Matrix, dt: float, beta: float) -> Matrix:
    """q_GB (n, 4) xyzw of one IMU by the filter of 2011 without magnetometer, level at first."""
    out = np.empty((len(gyro), 4))
    q = np.array([[0.0, 0.0, 0.0, 1.0]])
    step, no_normal, up = np.array([2 * beta * dt]), np.zeros(3), UP_G.reshape(1, 3)
    for _ in range(200):  # down to the first sample's inclination
        descend(q, up, accel[:1], no_normal, np.array([0.05]))
    for i in range(len(gyro)):
        if i > 0:
            integrate_rates(q, gyro[i : i + 1], dt)
        descend(q, up, accel[i : i + 1], no_normal, step)
        out[i] = q[0]
    return out


@kernel
def _multiply(q: Written[Vector], v: Vector, w: float) -> None:
    """q ← q ⊗ (v, w), normalised (eq. 19)."""
    vector = q[3] * v + w * q[:3] + np.cross(q[:3], v)
    scalar = q[3] * w - np.sum(q[:3] * v)
    n = np.sqrt(np.sum(vector**2) + scalar**2)
    q[:3] = vector / n
    q[3] = scalar / n
