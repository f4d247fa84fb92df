"""Where a finger's joints and IMUs are, and how the dorsum that carries it moves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.base.records import record
from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Vector
from tracker.messages import Array


@dataclass(frozen=True, eq=False)
class FingerGeometry:
    """joint_0 (3,) m in the dorsum's B; joint_1 and sensor_0 in the first phalanx's B, sensor_1 in
    the second's; R_rest_k (3, 3) R_parentB of the straight finger."""

    joint_0: Array
    joint_1: Array
    R_rest_0: Array
    R_rest_1: Array
    sensor_0: Array
    sensor_1: Array


@record("finger.dorsum", shapes={"R_GB": "3 3", "w_B": "3", "f_B": "3", "point": "3"})
@dataclass(frozen=True, eq=False)
class DorsumMotion:
    """The dorsum at one sample.

    R_GB (3, 3); w_B (3,) rad/s its angular rate; f_B (3,) m/s² the specific force a - g at
    ``point`` (3,) m, all in the dorsum's B. With the dorsum's IMU these are its readings and
    position;
    with vision alone, f_B = R_GBᵀ (p̈ - g) at the origin.
    """

    R_GB: Array
    w_B: Array
    f_B: Array
    point: Array


def force_at(dorsum: DorsumMotion, alpha_B: Array, position: Array) -> Array:
    """Specific force (3,) in the dorsum's B at ``position`` in it, by rigid-body kinematics."""
    return dorsum.f_B + lever_acceleration(dorsum.w_B, alpha_B, position - dorsum.point)


@kernel
def lever_acceleration(w: Vector, alpha: Vector, lever: Vector) -> Vector:
    """Acceleration (3,) of the end of a lever fixed to a body, from that of its start, in B."""
    return np.cross(alpha, lever) + np.cross(w, np.cross(w, lever))


@kernel
def chain_accelerations(
    q_GB: Matrix, w: Matrix, alpha: Matrix, sensor_0: Vector, joint_1: Vector, sensor_1: Vector
) -> Matrix:
    """μ_k (2, 3) m/s² in G of both sensors, relative to joint 0 (eq. 2 in three dimensions).

    q_GB (2, 4) xyzw; w, alpha (2, 3) in each phalanx's B; the levers in theirs.
    """
    out = np.empty((2, 3))
    out[0] = to_global(q_GB[0], lever_acceleration(w[0], alpha[0], sensor_0))
    out[1] = to_global(q_GB[0], lever_acceleration(w[0], alpha[0], joint_1))
    out[1] += to_global(q_GB[1], lever_acceleration(w[1], alpha[1], sensor_1))
    return out


@kernel
def to_global(q_GB: Vector, v_B: Vector) -> Vector:
    """R v of the unit quaternion xyzw."""
    t = 2 * np.cross(q_GB[:3], v_B)
    return v_B + q_GB[3] * t + np.cross(q_GB[:3], t)


@kernel
def to_body(q_GB: Vector, v_G: Vector) -> Vector:
    """Rᵀ v of the unit quaternion xyzw."""
    t = 2 * np.cross(v_G, q_GB[:3])
    return v_G + q_GB[3] * t + np.cross(t, q_GB[:3])
