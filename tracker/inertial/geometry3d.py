"""Where a finger's joints and IMUs are, and how the dorsum that carries it moves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

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


@dataclass(frozen=True, eq=False)
class DorsumMotion:
    """The dorsum at one sample.

    R_GB (3, 3); w_B (3,) rad/s its angular rate; f_B (3,) m/s² the specific force a - g at
    ``point`` (3,) m, all in the dorsum's B. With the dorsum's IMU these are its readings and place;
    with vision alone, f_B = R_GBᵀ (p̈ - g) at the origin.
    """

    R_GB: Array
    w_B: Array
    f_B: Array
    point: Array


def force_at(dorsum: DorsumMotion, alpha_B: Array, place: Array) -> Array:
    """Specific force (3,) in the dorsum's B at ``place`` of it, by rigid-body kinematics."""
    lever = place - dorsum.point
    w = dorsum.w_B
    force: Array = dorsum.f_B + np.cross(alpha_B, lever) + np.cross(w, np.cross(w, lever))
    return force
