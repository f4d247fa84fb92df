"""A finger on a dorsum that moves in three dimensions; readings by numerical differentiation."""

from __future__ import annotations

import copy
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

from tests.notices import raises
from tracker import GRAVITY
from tracker.base.errors import ConfigError
from tracker.geometry import so3
from tracker.glove.files import load_glove
from tracker.hand.files import load_hand
from tracker.inertial.finger3d import (
    VARIANTS,
    FingerEstimator3D,
    ImuPair,
    finger_geometry,
    finger_pairs,
    flexion_angle,
)
from tracker.inertial.geometry3d import DorsumMotion, FingerGeometry
from tracker.messages import Array

DT, H = 0.01, 1e-4
POINT = np.array([0.045, 0.0, 0.016])
GEOMETRY = FingerGeometry(
    joint_0=np.array([0.085, 0.024, -0.001]),
    joint_1=np.array([0.042, 0.0, 0.0]),
    R_rest_0=so3.rz(0.1),
    R_rest_1=np.eye(3),
    sensor_0=np.array([0.021, 0.0, 0.0125]),
    sensor_1=np.array([0.012, 0.0, 0.0115]),
)
Pose = tuple[Array, Array]


def _swell(t: float) -> float:
    """Time that is constant for 0.3 s and then starts smoothly."""
    s = max(t - 0.3, 0.0)
    return s**3 / (0.2 + s**2)


def _joints(t: float) -> tuple[float, float]:
    s = _swell(t)
    return 0.7 * (1 - np.cos(4.0 * s)), 0.6 * (1 - np.cos(5.0 * s))


def _dorsum(t: float) -> Pose:
    s = _swell(t)
    R = (
        so3.rz(0.8 * np.sin(1.5 * s))
        @ so3.ry(0.4 * np.sin(2.1 * s))
        @ so3.rx(0.5 * np.sin(1.7 * s))
    )
    return R, np.array([0.1 * np.sin(2 * s), 0.05 * np.sin(3 * s), 0.08 * np.sin(2.5 * s)])


def _phalanx_0(t: float) -> Pose:
    R, p = _dorsum(t)
    return R @ GEOMETRY.R_rest_0 @ so3.ry(_joints(t)[0]), p + R @ GEOMETRY.joint_0


def _phalanx_1(t: float) -> Pose:
    R, p = _phalanx_0(t)
    return R @ GEOMETRY.R_rest_1 @ so3.ry(_joints(t)[1]), p + R @ GEOMETRY.joint_1


def _sense(pose: Callable[[float], Pose], place: Array, t: float) -> Pose:
    """Angular rate and specific force of an ideal IMU at ``place`` of a segment at t."""
    points = [p + R @ place for R, p in (pose(t - H), pose(t), pose(t + H))]
    R = pose(t)[0]
    acceleration = (points[0] - 2 * points[1] + points[2]) / H**2
    rate = so3.log(pose(t - H)[0].T @ pose(t + H)[0]) / (2 * H)
    return rate, R.T @ (acceleration + np.array([0, 0, GRAVITY]))


def _sample(t: float) -> tuple[DorsumMotion, ImuPair]:
    w, f = _sense(_dorsum, POINT, t)
    one = _sense(_phalanx_0, GEOMETRY.sensor_0, t)
    two = _sense(_phalanx_1, GEOMETRY.sensor_1, t)
    pair = ImuPair(np.stack([one[0], two[0]]), np.stack([one[1], two[1]]))
    return DorsumMotion(_dorsum(t)[0], w, f, POINT), pair


@pytest.fixture(scope="module")
def recording() -> list[tuple[DorsumMotion, ImuPair]]:
    return [_sample(i * DT) for i in range(400)]


def _errors_deg(
    recording: list[tuple[DorsumMotion, ImuPair]],
    variant: str,
    gyro_offset: Array | float = 0.0,
    accel_offset: Array | float = 0.0,
) -> Array:
    """Rotation errors (n, 2) of both joints."""
    estimator = FingerEstimator3D(GEOMETRY, DT, variant)
    out = []
    for i, (dorsum, pair) in enumerate(recording):
        shifted = ImuPair(pair.gyro + gyro_offset, pair.accel + accel_offset)
        R_01, R_12 = estimator.update(dorsum, shifted)
        phi = _joints(i * DT)
        true_01 = GEOMETRY.R_rest_0 @ so3.ry(phi[0])
        true_12 = GEOMETRY.R_rest_1 @ so3.ry(phi[1])
        pairs = ((R_01, true_01), (R_12, true_12))
        out.append([np.linalg.norm(so3.log(a.T @ b)) for a, b in pairs])
    return np.rad2deg(np.array(out))


@pytest.mark.parametrize(("variant", "bound_deg"), [("learned", 0.5), ("madgwick", 1.0)])
def test_ideal_readings_are_tracked(
    recording: list[tuple[DorsumMotion, ImuPair]], variant: str, bound_deg: float
) -> None:
    assert _errors_deg(recording, variant).max() < bound_deg


@pytest.mark.parametrize("variant", ["switching", "switching_offset"])
def test_switching_is_accurate_within_its_own_bound(
    recording: list[tuple[DorsumMotion, ImuPair]], variant: str
) -> None:
    """Although it assumes a drift of 5 °/s for a second or two, ideal gyroscopes cause no error."""
    error = _errors_deg(recording, variant)
    assert np.sqrt(np.mean(error**2)) < 3.0


def test_gyroscope_offsets_are_bounded_by_gravity_and_the_plane(
    recording: list[tuple[DorsumMotion, ImuPair]],
) -> None:
    offset = np.deg2rad(5.0) * np.array([[1.0, -1, 1], [-1, 1, 1]])
    drift_deg = (5.0 + 5.0) * 4.0  # of the second joint, whose sensors drift apart
    for variant, bound_deg in (("madgwick", 5.0), ("switching", 15.0), ("learned", 0.5)):
        assert _errors_deg(recording, variant, offset).max() < bound_deg < drift_deg


def test_the_chains_own_acceleration_is_compensated(
    recording: list[tuple[DorsumMotion, ImuPair]],
) -> None:
    """With levers half as long as the finger's the error must be visibly larger."""
    half = FingerGeometry(
        GEOMETRY.joint_0,
        0.5 * GEOMETRY.joint_1,
        GEOMETRY.R_rest_0,
        GEOMETRY.R_rest_1,
        0.5 * GEOMETRY.sensor_0,
        0.5 * GEOMETRY.sensor_1,
    )
    worst = []
    for geometry in (GEOMETRY, half):
        estimator = FingerEstimator3D(geometry, DT, "madgwick")
        error = 0.0
        for i, (dorsum, pair) in enumerate(recording):
            found = flexion_angle(estimator.update(dorsum, pair).R_01, geometry.R_rest_0)
            error = max(error, abs(found - _joints(i * DT)[0]))
        worst.append(error)
    assert worst[1] > 3 * worst[0]


@pytest.mark.parametrize("variant", VARIANTS)
def test_an_invalid_imu_gives_finite_joints(
    recording: list[tuple[DorsumMotion, ImuPair]], variant: str
) -> None:
    estimator = FingerEstimator3D(GEOMETRY, DT, variant)
    lost = np.array([[np.nan], [0.0]])
    for i, (dorsum, pair) in enumerate(recording[:150]):
        seen = ImuPair(pair.gyro + lost, pair.accel) if i in range(2) or i % 7 == 0 else pair
        joints = estimator.update(dorsum, seen)
        for R in joints:
            np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-9)


@pytest.mark.parametrize("variant", VARIANTS)
def test_a_copy_continues_identically(
    recording: list[tuple[DorsumMotion, ImuPair]], variant: str
) -> None:
    estimator = FingerEstimator3D(GEOMETRY, DT, variant)
    for dorsum, pair in recording[:60]:
        estimator.update(dorsum, pair)
    saved = copy.deepcopy(estimator)
    ahead = [estimator.update(*sample) for sample in recording[60:90]]
    again = [saved.update(*sample) for sample in recording[60:90]]
    np.testing.assert_array_equal(np.array(ahead), np.array(again))


@pytest.mark.parametrize("variant", VARIANTS)
def test_a_bent_start_is_held_at_rest(variant: str) -> None:
    bent = (0.8, 0.6)
    estimator = FingerEstimator3D(GEOMETRY, DT, variant, bent)
    R_0 = GEOMETRY.R_rest_0 @ so3.ry(bent[0])
    R_1 = R_0 @ GEOMETRY.R_rest_1 @ so3.ry(bent[1])
    up = np.array([0, 0, GRAVITY])
    still = DorsumMotion(np.eye(3), np.zeros(3), up, POINT)
    pair = ImuPair(np.zeros((2, 3)), np.stack([R_0.T @ up, R_1.T @ up]))
    for _ in range(100):
        R_01, R_12 = estimator.update(still, pair)
    assert flexion_angle(R_01, GEOMETRY.R_rest_0) == pytest.approx(bent[0], abs=0.01)
    assert flexion_angle(R_12, GEOMETRY.R_rest_1) == pytest.approx(bent[1], abs=0.01)


def test_an_unknown_variant_is_rejected() -> None:
    with raises(ConfigError, "engine.finger_estimator"):
        FingerEstimator3D(GEOMETRY, DT, "kalman")


def test_pairs_and_geometry_come_from_hand_and_glove() -> None:
    root = Path(str(files("resources")))
    hand = load_hand(root / "hands" / "reference-right.toml")
    glove = load_glove(root / "gloves" / "five-finger.toml", hand)
    pairs = finger_pairs(hand, glove)
    assert ("thumb_metacarpal", "thumb_proximal") in pairs
    assert ("index_proximal", "index_intermediate") in pairs
    assert len(pairs) == 5
    geometry = finger_geometry(hand, glove, "index_proximal", "index_intermediate")
    np.testing.assert_allclose(geometry.sensor_0, [0.02075, 0.0, 0.0125])
    np.testing.assert_array_equal(
        geometry.joint_0, hand.segments[hand.index["index_proximal"]].origin
    )
    with raises(ConfigError, "glove.no_imu_on"):
        finger_geometry(hand, glove, "index_intermediate", "index_distal")


@pytest.mark.parametrize("angle", [-1.2, 0.0, 1.0, 2.5, 4.0])
def test_flexion_recovers_a_rotation_about_the_flexion_axis(angle: float) -> None:
    rest = so3.exp(np.array([0.3, -0.2, 0.5]))
    assert flexion_angle(rest @ so3.ry(angle), rest) == pytest.approx(angle)
