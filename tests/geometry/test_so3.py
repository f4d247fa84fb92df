"""Rotations against SciPy and their identities."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tracker.geometry import so3

RNG = np.random.default_rng(1)
VECTORS = np.concatenate(
    [RNG.normal(size=(50, 3)), 1e-9 * RNG.normal(size=(5, 3)), np.zeros((1, 3))]
)
NEAR_PI = Rotation.from_rotvec((np.pi - 1e-7) * np.eye(3))


def test_exp_equals_scipy() -> None:
    assert np.allclose(so3.exp(VECTORS), Rotation.from_rotvec(VECTORS).as_matrix(), atol=1e-14)


def test_log_inverts_exp_within_half_a_turn() -> None:
    assert np.allclose(
        so3.log(so3.exp(VECTORS)), Rotation.from_rotvec(VECTORS).as_rotvec(), atol=1e-7
    )


def test_log_near_half_a_turn() -> None:
    assert np.allclose(so3.log(NEAR_PI.as_matrix()), NEAR_PI.as_rotvec(), atol=1e-6)


@pytest.mark.parametrize("rotation", [Rotation.random(40, rng=2), NEAR_PI])
def test_quaternions_equal_scipy(rotation: Rotation) -> None:
    q = so3.quat_from_matrix(rotation.as_matrix())
    assert np.allclose(q, rotation.as_quat(canonical=True), atol=1e-9)
    assert np.allclose(so3.matrix_from_quat(q), rotation.as_matrix(), atol=1e-12)


def test_many_rotations_are_converted_like_each_alone() -> None:
    """To the bit: recordings are written one hand at a time."""
    turns = so3.exp(np.pi * np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0.8, 0.0]]))
    many = np.concatenate([Rotation.random(500, rng=4).as_matrix(), turns, np.eye(3)[None]])
    quaternions = so3.quat_from_matrix(many)
    assert np.array_equal(quaternions, [so3.quat_from_matrix(R) for R in many])
    matrices = [so3.matrix_from_quat(q) for q in quaternions]
    assert np.array_equal(so3.matrix_from_quat(quaternions), matrices)


def test_zyx_beyond_a_right_angle_of_flexion() -> None:
    for abduction, flexion, twist in [(0.2, 1.9, -0.1), (-0.3, 0.5, 0.2), (0.1, -0.4, 0.0)]:
        R = so3.rz(abduction) @ so3.ry(flexion) @ so3.rx(twist)
        assert np.allclose(so3.joint_angles(R), (abduction, flexion, twist), atol=1e-12)


def test_joint_angles_of_a_joint_without_twist() -> None:
    for abduction, flexion in [(0.2, 1.9), (-0.35, np.pi / 2), (0.1, -0.4), (0.0, 1.5)]:
        R = so3.rz(abduction) @ so3.ry(flexion)
        assert np.allclose(so3.joint_angles(R, True, False), (abduction, flexion, 0), atol=1e-9)
        assert so3.joint_angles(so3.ry(flexion), False, False)[1] == pytest.approx(flexion)


def test_joint_angles_do_not_jump_at_a_right_angle() -> None:
    """A finger that closes with 6° of unmodelled twist: Euler angles jump by half a turn."""
    flexion = np.deg2rad(np.linspace(60, 115, 111))
    R = np.array([so3.rz(0.1) @ so3.ry(f) @ so3.rx(0.1) for f in flexion])
    found = so3.joint_angles(R, True, False)
    assert np.abs(np.diff(found, axis=0)).max() < np.deg2rad(1.0)
    assert np.abs(found[:, 1] - flexion).max() < np.deg2rad(1.0)
    assert np.abs(found[:, 0]).max() < 0.25


def test_skew_is_the_cross_product() -> None:
    a, b = RNG.normal(size=(2, 3))
    assert np.allclose(so3.skew(a) @ b, np.cross(a, b))
