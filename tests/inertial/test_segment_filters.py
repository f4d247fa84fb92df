"""The batched orientation filter: invariants, known motions, offsets, and restored states."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tracker import GRAVITY
from tracker.geometry import so3
from tracker.inertial.descent import gradient, plain_madgwick
from tracker.inertial.segments import SegmentFilters
from tracker.messages import Array

DT = 0.01
UP = np.array([0.0, 0.0, 1.0])


def _tumbling(n: int, seed: int = 0, speed: float = 2.0) -> tuple[Array, Array, Array]:
    """Ideal gyro, accel (n, 3) of an IMU that rotates in place, and its R_GB (n, 3, 3).

    The rates are constant over each sample, so that the truth is a product of exact rotations.
    """
    rng = np.random.default_rng(seed)
    t = np.arange(n)[:, None] * DT
    w = np.sin(t * rng.uniform(0.5, 3.0, 3) + rng.uniform(0, 6, 3)) * speed
    R = np.empty((n, 3, 3))
    R[0] = so3.exp(rng.normal(size=3))
    for i in range(1, n):
        R[i] = R[i - 1] @ so3.exp(w[i] * DT)
    return w, R.transpose(0, 2, 1) @ (GRAVITY * UP), R


def _tilt_deg(q: Array, R: Array) -> Array:
    """Angle between estimated and true upward vectors in B."""
    estimated = so3.matrix_from_quat(q)[..., 2, :]
    return np.asarray(np.rad2deg(np.arccos(np.clip(np.sum(estimated * R[:, 2], axis=-1), -1, 1))))


def _several(n: int, count: int) -> tuple[Array, Array]:
    each = [_tumbling(n, seed)[:2] for seed in range(count)]
    return np.stack([g for g, _ in each], axis=1), np.stack([a for _, a in each], axis=1)


def test_rotation_in_place_is_tracked_with_heading() -> None:
    gyro, accel, R = _tumbling(3000)
    q = SegmentFilters(1, DT).run(gyro[:, None], accel[:, None])[:, 0]
    assert _tilt_deg(q, R).max() < 0.05
    relative = Rotation.from_matrix(R[0]).inv() * Rotation.from_matrix(R[-1])
    found = Rotation.from_quat(q[0]).inv() * Rotation.from_quat(q[-1])
    assert np.rad2deg((relative.inv() * found).magnitude()) < 0.1


def test_each_imu_is_filtered_independently_and_updates_equal_run() -> None:
    gyro, accel = _several(300, 3)
    together = SegmentFilters(3, DT)
    for g, a in zip(gyro, accel, strict=True):
        together.update(g, a)
    for i in range(3):
        alone = SegmentFilters(1, DT).run(gyro[:, i : i + 1], accel[:, i : i + 1])
        np.testing.assert_array_equal(together.q_GB[i], alone[-1, 0])


def test_a_restored_state_resumes_identically() -> None:
    gyro, accel = _several(400, 2)
    first, second = SegmentFilters(2, DT), SegmentFilters(2, DT)
    first.run(gyro[:150], accel[:150])
    second.state = first.state
    rest = first.run(gyro[150:], accel[150:])
    np.testing.assert_array_equal(second.run(gyro[150:], accel[150:]), rest)


def test_a_rest_reveals_the_gyroscopes_offset() -> None:
    rng = np.random.default_rng(1)
    offset = np.deg2rad([[5.0, -5.0, 3.0]])
    filters = SegmentFilters(1, DT)
    for _ in range(2000):
        gyro = offset + 1e-3 * rng.standard_normal((1, 3))
        filters.update(gyro, GRAVITY * UP[None] + 0.02 * rng.standard_normal((1, 3)))
    assert filters.at_rest.all()
    np.testing.assert_allclose(filters.gyro_offset, offset, atol=np.deg2rad(0.1))


def test_motion_reveals_the_gyroscopes_offset_too() -> None:
    gyro, accel, _ = _tumbling(40000, speed=0.5)
    offset = np.deg2rad([1.0, -0.5, 0.7])
    filters = SegmentFilters(1, DT)
    filters.run((gyro + offset)[:, None], accel[:, None])
    assert not filters.at_rest.any()
    assert np.linalg.norm(filters.gyro_offset[0] - offset) < 0.25 * np.linalg.norm(offset)


def test_manual_shaking_is_averaged_out() -> None:
    """±2.5 m/s² at 2 Hz is a tilt of 14° for an accelerometer alone."""
    t = np.arange(3000) * DT
    accel = np.tile(GRAVITY * UP, (len(t), 1))
    accel[:, 0] += 2.5 * np.sin(4 * np.pi * t)
    q = SegmentFilters(1, DT).run(np.zeros((len(t), 1, 3)), accel[:, None])[:, 0]
    still = np.tile(np.eye(3), (len(t), 1, 1))
    assert _tilt_deg(q, still)[1500:].max() < 0.1


def test_an_invalid_imu_keeps_its_orientation_and_others_continue() -> None:
    gyro, accel = _several(100, 2)
    filters = SegmentFilters(2, DT)
    filters.run(gyro[:50], accel[:50])
    before = filters.q_GB
    lost = gyro[50].copy()
    lost[0] = np.nan
    filters.update(lost, accel[50])
    np.testing.assert_array_equal(filters.q_GB[0], before[0])
    assert np.abs(filters.q_GB[1] - before[1]).max() > 1e-4


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_every_face_up_starts_level(axis: int, sign: float) -> None:
    accel = np.zeros((1, 3))
    accel[0, axis] = sign * GRAVITY
    filters = SegmentFilters(1, DT)
    filters.update(np.zeros((1, 3)), accel)
    np.testing.assert_allclose(
        so3.matrix_from_quat(filters.q_GB[0]) @ accel[0], GRAVITY * UP, atol=1e-5
    )


def test_gradient_of_a_vectors_misfit_against_finite_differences() -> None:
    rng = np.random.default_rng(2)
    R = so3.exp(rng.normal(size=3))
    a_G, b_B = rng.normal(size=(2, 3))

    def misfit(delta: Array) -> float:
        a = (R @ so3.exp(delta)).T @ a_G / np.linalg.norm(a_G)
        return 0.5 * float(np.sum((a - b_B / np.linalg.norm(b_B)) ** 2))

    h = 1e-6
    numeric = [(misfit(h * e) - misfit(-h * e)) / (2 * h) for e in np.eye(3)]
    np.testing.assert_allclose(gradient(so3.quat_from_matrix(R), a_G, b_B), numeric, atol=1e-9)


def test_plain_madgwick_follows_and_returns_to_gravity() -> None:
    gyro, accel, R = _tumbling(1500)
    assert _tilt_deg(plain_madgwick(gyro, accel, DT, 0.033), R).max() < 0.2
    turned = gyro.copy()
    turned[:50, 0] += 0.5  # half a second of a wrong rate, then 2β = 3.8 °/s back
    tilt = _tilt_deg(plain_madgwick(turned, accel, DT, 0.033), R)
    assert tilt[50] > 3.0
    assert tilt[-1] < 0.2
