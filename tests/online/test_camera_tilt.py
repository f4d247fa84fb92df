"""A camera that sways and tilts, measured by its own IMU alone."""

import copy
from itertools import pairwise

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.geometry import so3
from tracker.messages import CameraImuSample, CameraPose
from tracker.online.camera_tilt import CameraTilt
from tracker.simulation.head import MOVING, Head
from tracker.simulation.scenario import CameraImuParams, camera_imu_samples
from tracker.vision.rig import ideal_rig

UP = np.array([0.0, 0.0, 1.0])
NO_ERRORS = CameraImuParams(
    gyro_noise_deg=0.0, accel_noise_ug=0.0, gyro_bias_deg=0.0, accel_bias_mg=0.0
)


def tilted(degrees: float) -> CameraPose:
    """The calibrated camera, then tilted forward."""
    stand = ideal_rig().pose
    return CameraPose(stand.R_GC @ so3.rx(np.deg2rad(degrees)), stand.p_GC)


def tilt_error(pose: CameraPose, truth: CameraPose) -> float:
    """Degrees between the two camera's up directions."""
    cosine = np.clip((pose.R_GC.T @ UP) @ (truth.R_GC.T @ UP), -1, 1)
    return float(np.rad2deg(np.arccos(cosine)))


def swaying(params: CameraImuParams, end: float = 20.0) -> tuple[Head, list[CameraImuSample]]:
    head = Head(tilted(20.0), 3, MOVING)
    return head, list(camera_imu_samples(head, 3, end, params))


def test_the_simulated_imu_measures_the_heads_motion():
    """Double integration reproduces the path; at rest it measures gravity alone."""
    head, samples = swaying(NO_ERRORS, 3.0)
    R, p = head.pose(0.0).R_GC, head.pose(0.0).p_GC
    v = (head.pose(1e-4).p_GC - head.pose(-1e-4).p_GC) / 2e-4
    for a, b in pairwise(samples):
        dt = b.t - a.t
        R_mid = R @ so3.exp(a.gyro * dt / 2)
        acceleration = R_mid @ ((a.accel + b.accel) / 2) - GRAVITY * UP
        p, v = p + v * dt + acceleration * dt**2 / 2, v + acceleration * dt
        R = R @ so3.exp((a.gyro + b.gyro) / 2 * dt)
    there = head.pose(samples[-1].t)
    assert np.rad2deg(np.linalg.norm(so3.log(R.T @ there.R_GC))) < 0.02
    assert np.linalg.norm(p - there.p_GC) < 0.001
    still = next(iter(camera_imu_samples(Head(tilted(0.0), 0), 0, 0.1, NO_ERRORS)))
    np.testing.assert_allclose(still.gyro, 0, atol=1e-12)
    np.testing.assert_allclose(still.accel, tilted(0.0).R_GC.T @ UP * GRAVITY, atol=1e-9)


@pytest.mark.long
def test_tilt_follows_the_head_within_a_degree():
    """The pose in the file is 20° off; 10 mg of bias alone are 0.6°."""
    head, samples = swaying(CameraImuParams())
    tilt = CameraTilt(ideal_rig().pose)
    errors = []
    for s in samples:
        tilt.feed(s)
        errors.append(tilt_error(tilt.pose(s.t), head.pose(s.t)))
    assert max(errors) < 1.5
    assert np.mean(errors[-2000:]) < 1.0


@pytest.mark.long
def test_heading_starts_as_in_the_file_and_rotates_with_the_head():
    """The initial difference, the sway at that time, remains to the end."""
    head, samples = swaying(NO_ERRORS)
    tilt = CameraTilt(tilted(20.0))
    tilt.feed(samples[0])
    first = tilt.pose(0.0).R_GC @ head.pose(0.0).R_GC.T
    for s in samples[1:]:
        tilt.feed(s)
    last = tilt.pose(s.t).R_GC @ head.pose(s.t).R_GC.T
    np.testing.assert_allclose(last, first, atol=0.01)
    np.testing.assert_allclose(last @ UP, UP, atol=0.003)


def test_a_past_image_gets_the_pose_of_its_own_time():
    head, samples = swaying(NO_ERRORS, 3.0)
    tilt = CameraTilt(tilted(20.0))
    for s in samples:
        tilt.feed(s)
    for t in (s.t - 0.0531, s.t - 0.4, s.t + 0.03):
        moved = so3.log(tilt.pose(t).R_GC.T @ tilt.pose(s.t).R_GC)
        truly = so3.log(head.pose(t).R_GC.T @ head.pose(s.t).R_GC)
        np.testing.assert_allclose(moved, truly, atol=2e-3)


def test_gaps_bad_values_and_late_samples():
    head, samples = swaying(CameraImuParams(), 6.0)
    tilt = CameraTilt(ideal_rig().pose)
    assert tilt.pose(0.0) is None
    tilt.feed(CameraImuSample(0.0, 0.0, np.full(3, np.nan), np.zeros(3)))
    assert tilt.pose(0.0) is None
    for s in samples:
        if not 2.0 < s.t < 5.0:  # no samples for three seconds
            tilt.feed(s)
    before = tilt.pose(s.t)
    tilt.feed(samples[0])
    np.testing.assert_array_equal(tilt.pose(s.t).R_GC, before.R_GC)
    assert tilt_error(before, head.pose(s.t)) < 1.5


def test_an_upside_down_camera_is_detected():
    pose = tilted(180.0)
    tilt = CameraTilt(tilted(0.0))
    tilt.feed(CameraImuSample(0.0, 0.0, np.zeros(3), pose.R_GC.T @ UP * GRAVITY))
    assert tilt_error(tilt.pose(0.0), pose) == pytest.approx(0, abs=1e-4)


def test_a_saved_filter_resumes_identically():
    _, samples = swaying(CameraImuParams(), 4.0)
    one = CameraTilt(ideal_rig().pose)
    for s in samples[:400]:
        one.feed(s)
    other = CameraTilt(ideal_rig().pose)
    other.set_state(copy.deepcopy(one.get_state()))
    for s in samples[400:]:
        one.feed(s)
        other.feed(s)
    np.testing.assert_array_equal(one.pose(s.t).R_GC, other.pose(s.t).R_GC)
