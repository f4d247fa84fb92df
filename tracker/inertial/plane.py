"""The flexion plane as complex numbers, and what every planar estimator does with them.

A vector in the plane is ``along + i * palmar``: along is +x of B, palmar is -z of B. With Ry(θ)
x = (cos θ, 0, -sin θ), so that a vector v of a segment flexed by θ is ``exp(iθ) v`` in the plane's
own axes P. Lemak et al. 2020 write the same as rotations about their x axis (section 2.1).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.kernels import kernel
from tracker.kernels.arrays import Vector
from tracker.messages import Array

ComplexArray = NDArray[np.complex128]
SENSORS = 2  # on the first and the second phalanx
MIDDLE = np.pi / 2  # centre of a finger's range: angles by atan2 are taken within half a turn of it


def in_plane(v: Array) -> ComplexArray:
    """The part in the flexion plane of vectors (…, 3) in B."""
    return np.asarray(v[..., 0] - 1j * v[..., 2], complex)


def out_of_plane(v: ComplexArray) -> Array:
    """Vectors (…, 3) in B of complex numbers in the flexion plane."""
    return np.stack([v.real, np.zeros_like(v.real), -v.imag], axis=-1)


class Levers(NamedTuple):
    """Levers of the sensors' accelerations, m in each phalanx's axes (h_k and r_i of the paper).

    The paper's sensors lie on the bones' axes and so have real levers; a glove's lie above them.
    """

    sensor_0: complex  # joint 0 to the sensor on phalanx 0
    length_0: complex  # joint 0 to joint 1
    sensor_1: complex  # joint 1 to the sensor on phalanx 1


@kernel
def arm_factors(theta: Vector, omega: Vector, alpha: Vector) -> tuple[complex, complex]:
    """Acceleration per metre of lever on each phalanx, in P: (iα - ω²) exp(iθ)."""
    c_0 = (1j * alpha[0] - omega[0] ** 2) * np.exp(1j * theta[0])
    c_1 = (1j * alpha[1] - omega[1] ** 2) * np.exp(1j * theta[1])
    return c_0, c_1


@kernel
def kinematic(
    levers: Levers, theta: Vector, omega: Vector, alpha: Vector
) -> tuple[complex, complex]:  # eq. 2 without a_0
    """Accelerations μ_k of both sensors relative to joint 0, in P, m/s²."""
    c_0, c_1 = arm_factors(theta, omega, alpha)
    return levers.sensor_0 * c_0, levers.length_0 * c_0 + levers.sensor_1 * c_1


@kernel
def gravity_angle(root: complex, f: complex) -> float:
    """The angle that turns the reading ``f`` onto ``root`` (section 2.2.2, atan2), within half a
    turn of MIDDLE.
    """
    angle = np.angle(root * f.conjugate())
    if angle < MIDDLE - np.pi:
        return angle + 2 * np.pi
    return angle


@kernel
def runge_kutta(new: float, old: float, older: float, dt: float) -> float:
    """Increment of θ over one sample of angular rates (section 2.2.3).

    θ' = ω(t) does not depend on θ, so the classical Runge-Kutta step is Simpson's rule; the rate
    at its midpoint comes from the parabola through the last three samples.
    """
    middle = (3 * new + 6 * old - older) / 8
    return dt / 6 * (old + 4 * middle + new)
