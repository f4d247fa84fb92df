"""Planar chain of three phalanges on a moving metacarpus, with two sensors (section 2.1)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.inertial.plane import ComplexArray, Levers
from tracker.messages import Array


@dataclass(frozen=True)
class Finger:
    """Lengths of the phalanges and the sensors' distances from their proximal joints, m."""

    length_0: float = 0.045  # r_i of eq. 1, and h_k below
    length_1: float = 0.026
    length_2: float = 0.018
    sensor_0: float = 0.0225  # p_k: the middle of the phalanx
    sensor_1: float = 0.013

    @property
    def lengths(self) -> tuple[float, float, float]:
        return self.length_0, self.length_1, self.length_2

    @property
    def levers(self) -> Levers:
        return Levers(complex(self.sensor_0), complex(self.length_0), complex(self.sensor_1))


def phalanx_angles(joints: Array) -> Array:
    """θ_i, each phalanx against P, from joint angles φ_i whose first is against P too."""
    return np.cumsum(joints, axis=-1)


def joint_angles(theta: Array, metacarpus: Array | float = 0.0) -> Array:
    """Three joint angles φ (…, 3) from the two measured θ (…, 2) and the metacarpus's angle.

    The distal joint moves as the proximal interphalangeal one does (section 2.2): φ_2 = φ_1.
    """
    phi_1 = theta[..., 1] - theta[..., 0]
    return np.stack([theta[..., 0] - metacarpus, phi_1, phi_1], axis=-1)


def joint_positions(finger: Finger, theta: Array) -> ComplexArray:
    """Ends of the phalanges (…, 3) in P from their angles θ (…, 3); joint 0 is the origin."""
    return np.cumsum(np.array(finger.lengths) * np.exp(1j * theta), axis=-1)


def sensor_positions(finger: Finger, theta: Array) -> ComplexArray:
    """s_k (…, 2) in P, from joint 0 (eq. 1)."""
    u = np.exp(1j * theta)
    s_0 = finger.sensor_0 * u[..., 0]
    s_1 = finger.length_0 * u[..., 0] + finger.sensor_1 * u[..., 1]
    return np.stack([s_0, s_1], axis=-1)


def sensor_accelerations(finger: Finger, theta: Array, omega: Array, alpha: Array) -> ComplexArray:
    """μ_k (…, 2) m/s² in P, relative to joint 0 (eq. 2 without a_0)."""
    c = (1j * alpha - omega**2) * np.exp(1j * theta)
    mu_0 = finger.sensor_0 * c[..., 0]
    mu_1 = finger.length_0 * c[..., 0] + finger.sensor_1 * c[..., 1]
    return np.stack([mu_0, mu_1], axis=-1)


def readings(
    finger: Finger, theta: Array, omega: Array, alpha: Array, root: ComplexArray
) -> ComplexArray:
    """Specific force f_k (…, 2) that ideal sensors on phalanges 0 and 1 read (eq. 3).

    ``root`` (…,) is joint 0's specific force a_0 - g in P. The paper's f has the opposite sign;
    here, as accelerometers do, a sensor at rest reads upwards.
    """
    total = root[..., None] + sensor_accelerations(finger, theta, omega, alpha)
    return total * np.exp(-1j * theta[..., :2])
