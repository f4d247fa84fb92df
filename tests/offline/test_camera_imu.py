"""A session of a moving camera without poses, with only its own IMU's samples."""

import numpy as np
import pytest
from rosbags.highlevel import AnyReader

from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.engine.pipeline import Pipeline
from tracker.messages import CameraImuSample, Estimate, ImuSample
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, build, simulate
from tracker.offline.track import track
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.long

OPTIONS = SimulateOptions(seed=4, duration=2.5, fps=20.0, images=False, camera="head-imu")


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    path = tmp_path_factory.mktemp("camera") / "head.mcap"
    simulate(path, OPTIONS)
    return path


def test_the_samples_are_read_back_bit_for_bit(session):
    sim, _ = build(OPTIONS)
    fed = [m for m in sim.messages() if isinstance(m, CameraImuSample) and m.t <= 2.5]
    with SessionReader(session) as reader:
        read = list(reader.messages((CameraImuSample,)))
    assert len(read) == len(fed) > 450
    for one, other in zip(fed, read, strict=True):
        assert (one.t, one.t_arrival) == (other.t, other.t_arrival)
        np.testing.assert_array_equal(one.gyro, other.gyro)
        np.testing.assert_array_equal(one.accel, other.accel)


def test_other_programs_read_them_as_an_imu(session):
    with AnyReader([session]) as reader:
        (topic,) = [c for c in reader.connections if c.topic == "/camera/imu/data_raw"]
        _, _, data = next(reader.messages([topic]))
        message = reader.deserialize(data, topic.msgtype)
    assert topic.msgtype == "sensor_msgs/msg/Imu"
    assert message.header.frame_id == "camera_left"
    assert message.orientation_covariance[0] == -1  # without an orientation
    force = message.linear_acceleration
    assert np.linalg.norm([force.x, force.y, force.z]) == pytest.approx(9.8, abs=0.4)


def test_tracking_again_equals_the_live_run_and_is_reproducible(session, tmp_path):
    out, again = tmp_path / "out.mcap", tmp_path / "again.mcap"
    track(session, out, TrackOptions(with_sensors=True))
    track(out, again)
    with SessionReader(session) as reader:
        pipeline = Pipeline(reader.info.hand, reader.info.glove, reader.rig())
        live = [feed(pipeline, m) for m in reader.messages() if type(m).__name__ in FED]
    live = [e.keypoints for e in live if e is not None]
    for path in (out, again):
        np.testing.assert_array_equal(live, [e.keypoints for e in estimates(path)])


def test_smoothing_uses_the_same_poses(session, tmp_path):
    live, smooth = tmp_path / "live.mcap", tmp_path / "smooth.mcap"
    track(session, live, TrackOptions())
    track(session, smooth, TrackOptions(smooth=True))
    one, other = (np.array([e.keypoints for e in estimates(p)]) for p in (live, smooth))
    assert one.shape == other.shape
    late = len(one) // 2
    assert np.nanmean(np.linalg.norm(one - other, axis=2)[late:]) < 0.004


FED = ("ImuSample", "CameraImuSample", "BlobFrame")


def feed(pipeline, message):
    if isinstance(message, CameraImuSample):
        return pipeline.feed_camera_imu(message)
    if isinstance(message, ImuSample):
        return pipeline.feed_imu(message)
    return pipeline.feed_frame(message)


def estimates(path):
    with SessionReader(path) as reader:
        return list(reader.messages((Estimate,)))


def test_a_saved_pipeline_resumes_identically():
    sim, info = build(OPTIONS)
    one, other = (Pipeline(info.hand, info.glove, sim.rig) for _ in range(2))
    messages = [m for m in sim.messages() if m.t < 1.6]
    half = len(messages) // 2
    for m in messages[:half]:
        feed(one, m)
    other.set_state(one.get_state())
    for m in messages[half:]:
        feed(one, m)
        feed(other, m)
    np.testing.assert_array_equal(one.predict(1.6).keypoints, other.predict(1.6).keypoints)
    np.testing.assert_array_equal(one.camera_pose(1.5).R_GC, other.camera_pose(1.5).R_GC)


def test_an_unknown_camera_is_rejected():
    with raises(ConfigError, "option.choice", option="--camera", value="tripod"):
        build(SimulateOptions(camera="tripod"))
