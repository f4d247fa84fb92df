"""The test motion of Lemak et al. 2020 (section 3) and the ideal readings along it.

The paper gives the poses and durations, not the profile between them. Here each stage is a minimum
jerk movement (Flash and Hogan 1985), as unguided hand movements are.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker import GRAVITY
from tracker.inertial.finger import Finger, phalanx_angles, readings
from tracker.inertial.planar import PlanarReadings
from tracker.inertial.plane import ComplexArray
from tracker.messages import Array

STATIC = 0.2  # t_d, s
DURATIONS: tuple[float, ...] = tuple(np.logspace(-1, 3, 32).tolist())  # t_m, s
EXTENDED = np.deg2rad([-28.0, 0.0, 0.0])  # φ_i: extension is negative flexion
GRASPED = np.deg2rad([90.0, 85.0, 85.0])


@dataclass(frozen=True)
class MotionCondition:
    """The direction of gravity and the motion of the metacarpus.

    Its joint 0 sways by ``sway`` m and its angle in the plane by ``turn`` rad, at ``frequency`` Hz.
    """

    name: str
    in_plane: float = 1.0  # the share of gravity in the flexion plane: cosine of the plane's tilt
    sway: float = 0.0
    turn: float = 0.0
    frequency: float = 1.0


VERTICAL = MotionCondition("vertical")
HORIZONTAL = MotionCondition("horizontal", in_plane=0.0)
MOVING = MotionCondition("moving", sway=0.05, turn=np.deg2rad(30.0))
CONDITIONS = (VERTICAL, HORIZONTAL, MOVING)


@dataclass(frozen=True, eq=False)
class FingerMotion:
    """Truth at n samples: t (n,) s, theta, omega, alpha (n, 3) of the phalanges in P; metacarpus
    (n,) rad its angle in P; ideal readings; normal_gravity m/s² across the plane (to +y)."""

    t: Array
    theta: Array
    omega: Array
    alpha: Array
    metacarpus: Array
    ideal: PlanarReadings
    normal_gravity: float


def grasp(
    finger: Finger, t_m: float, rate_hz: float, condition: MotionCondition = VERTICAL
) -> FingerMotion:
    """Static, straight finger extended, then grasp; sampled at ``rate_hz``."""
    n = round((STATIC + t_m) * rate_hz) + 1
    t = np.arange(n) / rate_hz
    joints = [_joints(t - STATIC, t_m)[i] for i in range(3)]
    turn = _sine(t, condition.turn, condition.frequency)
    for level, extra in zip(joints, turn, strict=True):
        level[:, 0] += extra
    theta, omega, alpha = (phalanx_angles(level) for level in joints)
    sway = _sine(t, condition.sway, condition.frequency)[2]
    root = _root(sway, condition)
    ideal = PlanarReadings(omega[:, :2].copy(), readings(finger, theta, omega, alpha, root), root)
    across = GRAVITY * np.sqrt(1 - condition.in_plane**2)
    return FingerMotion(t, theta, omega, alpha, turn[0], ideal, float(across))


def _root(sway: Array, condition: MotionCondition) -> ComplexArray:
    """Specific force of joint 0 in P: sway along the hand, gravity against the palm (-i)."""
    return np.asarray(sway - 1j * GRAVITY * condition.in_plane, complex)


def _sine(t: Array, amplitude: float, frequency: float) -> tuple[Array, Array, Array]:
    """A sinusoidal sway that starts from rest with the motion, and its two derivatives.

    The first period fades in as sin³, so that the static interval remains static.
    """
    w = 2 * np.pi * frequency
    s = np.maximum(t - STATIC, 0.0)
    sin, cos = np.sin(w * s), np.cos(w * s)
    value = amplitude * sin**3
    rate = amplitude * 3 * w * sin**2 * cos
    acceleration = amplitude * 3 * w**2 * sin * (2 * cos**2 - sin**2)
    return value, rate, acceleration


def _joints(t: Array, t_m: float) -> tuple[Array, Array, Array]:
    """φ (n, 3) and two derivatives; ``t`` starts at the end of the static interval."""
    third = t_m / 3
    first = _minimum_jerk(t / third)
    second = _minimum_jerk((t - third) / (2 * third))
    angle, rate, acceleration = (
        np.outer(a, EXTENDED) / third**i + np.outer(b, GRASPED - EXTENDED) / (2 * third) ** i
        for i, (a, b) in enumerate(zip(first, second, strict=True))
    )
    return angle, rate, acceleration


def _minimum_jerk(s: Array) -> tuple[Array, Array, Array]:
    """10 s³ - 15 s⁴ + 6 s⁵ on 0..1, constant outside, and its two derivatives by s."""
    s = np.clip(s, 0.0, 1.0)
    value = s**3 * (10 + s * (6 * s - 15))
    rate = 30 * s**2 * (1 - s) ** 2
    acceleration = 60 * s * (1 - s) * (1 - 2 * s)
    return value, rate, acceleration
