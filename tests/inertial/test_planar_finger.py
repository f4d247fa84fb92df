"""The planar chain against numerical differentiation and rotation matrices."""

from __future__ import annotations

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.geometry import so3
from tracker.inertial.finger import (
    Finger,
    joint_angles,
    joint_positions,
    phalanx_angles,
    readings,
    sensor_accelerations,
    sensor_positions,
)
from tracker.inertial.plane import (
    gravity_angle,
    in_plane,
    kinematic,
    out_of_plane,
    runge_kutta,
)
from tracker.messages import Array

FINGER = Finger()


def _motion(t: Array) -> tuple[Array, Array, Array]:
    """θ (n, 3) and its derivatives, a different smooth motion per phalanx."""
    w, a = np.array([7.0, 11.0, 5.0]), np.array([0.6, 0.9, 1.1])
    s = np.multiply.outer(t, w)
    return a * np.sin(s), a * w * np.cos(s), -a * w**2 * np.sin(s)


def test_product_by_a_unit_number_is_the_flexion_of_the_conventions() -> None:
    v_B = np.array([0.3, 0.0, -0.7])
    for angle in (-0.4, 0.9, 2.8):
        turned = out_of_plane(in_plane(v_B) * np.exp(1j * angle))
        np.testing.assert_allclose(turned, so3.ry(angle) @ v_B, atol=1e-12)


def test_sensor_accelerations_are_second_derivatives_of_positions() -> None:
    h = 1e-4
    t = np.linspace(0.0, 1.0, 23)
    before, now, after = (sensor_positions(FINGER, _motion(t + d)[0]) for d in (-h, 0.0, h))
    theta, omega, alpha = _motion(t)
    expected = (after - 2 * now + before) / h**2
    np.testing.assert_allclose(
        sensor_accelerations(FINGER, theta, omega, alpha), expected, atol=2e-5
    )


def test_compiled_kinematics_equal_the_array_form() -> None:
    theta, omega, alpha = (level[0] for level in _motion(np.array([0.37])))
    expected = sensor_accelerations(FINGER, theta, omega, alpha)
    np.testing.assert_allclose(kinematic(FINGER.levers, theta, omega, alpha), expected, rtol=1e-13)


def test_a_sensor_at_rest_measures_one_g_upwards() -> None:
    root = np.array([-1j * GRAVITY])  # palm down: up is against the palm
    theta = np.array([[0.0, np.pi / 2, np.pi]])
    still = np.zeros((1, 3))
    f = readings(FINGER, theta, still, still, root)[0]
    expected = GRAVITY * np.array([[0, 0, 1.0], [-1.0, 0, 0]])
    np.testing.assert_allclose(out_of_plane(f), expected, atol=1e-12)


def test_straight_finger_points_along_x_and_a_flexed_one_to_the_palm() -> None:
    tips = joint_positions(FINGER, np.array([[0.0, 0, 0], [np.pi / 2, np.pi / 2, np.pi / 2]]))
    length = sum(FINGER.lengths)
    np.testing.assert_allclose(
        out_of_plane(tips[:, 2]), [[length, 0, 0], [0, 0, -length]], atol=1e-15
    )


def test_joint_angles_invert_phalanx_angles_under_the_coupling() -> None:
    phi = np.array([0.3, 0.8, 0.8])
    theta = phalanx_angles(phi + np.array([0.2, 0, 0]))  # the metacarpus is at 0.2
    np.testing.assert_allclose(joint_angles(theta[:2], 0.2), phi)


@pytest.mark.parametrize("angle", [-1.5, -0.2, 0.0, 1.0, 3.0, 4.6])
def test_gravity_angle_covers_a_fingers_range(angle: float) -> None:
    root = 3.0 - 9.0j
    assert gravity_angle(root, root * np.exp(-1j * angle)) == pytest.approx(angle)


def test_runge_kutta_is_exact_for_rates_up_to_second_order_in_time() -> None:
    dt, c = 0.01, (3.0, -40.0, 500.0)
    rate = np.polynomial.Polynomial(c)
    exact = rate.integ()(dt) - rate.integ()(0.0)
    assert runge_kutta(rate(dt), rate(0.0), rate(-dt), dt) == pytest.approx(exact, rel=1e-12)
