"""Written data is read back: the same floats, in the order of feeding."""

from collections.abc import Callable
from dataclasses import fields, is_dataclass, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from rosbags.highlevel import AnyReader

from tests.session.ros_types import typestore
from tracker.geometry import so3
from tracker.messages import (
    BlobFrame,
    Calibration,
    Estimate,
    Event,
    ImuSample,
    Status,
    StereoFrame,
    Tracking,
    Validity,
)
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder

RESOURCES = Path(__file__).resolve().parents[2] / "resources"
Record = Callable[..., Path]
LOOSE = {"segment_R", "rejected_left", "rejected_right"}  # rounding of a quaternion; not stored


def same(a: object, b: object) -> bool:
    """Bitwise equal, with NaN equal to NaN."""
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and np.array_equal(a, b, equal_nan=a.dtype.kind == "f")  # type: ignore[attr-defined,arg-type]
    if is_dataclass(a) and type(a) is type(b):
        return all(
            same(getattr(a, f.name), getattr(b, f.name)) for f in fields(a) if f.name not in LOOSE
        )
    if isinstance(a, float) and np.isnan(a):
        return bool(np.isnan(b))  # type: ignore[call-overload]
    return a == b


@pytest.fixture
def session(tmp_path: Path, record: Record, maker) -> tuple[Path, list]:
    messages = list(maker.stream(1500))
    return record(tmp_path / "a.mcap", messages), messages


@pytest.mark.parametrize(
    "kind", [ImuSample, StereoFrame, BlobFrame, Estimate, Calibration, Event, Status]
)
def test_each_kind_is_read_back_bit_for_bit(session, kind: type) -> None:
    path, messages = session
    with SessionReader(path) as reader:
        found = list(reader.messages([kind]))
    wanted = [m for m in messages if type(m) is kind]
    assert len(found) == len(wanted) > 0
    assert all(same(a, b) for a, b in zip(wanted, found, strict=True))


def test_segments_are_read_back_except_for_rounding(session) -> None:
    path, messages = session
    with SessionReader(path) as reader:
        found = [m.segment_R for m in reader.messages([Estimate])]
    wanted = [m.segment_R for m in messages if type(m) is Estimate]
    assert np.allclose(found, wanted, atol=1e-14)


def test_sensor_messages_are_in_the_order_of_feeding(session) -> None:
    path, messages = session
    fed = [m for m in messages if type(m) in (ImuSample, BlobFrame)]
    with SessionReader(path) as reader:
        found = list(reader.messages([ImuSample, BlobFrame]))
    assert [(type(m), m.t) for m in found] == [(type(m), m.t) for m in fed]


def test_two_packets_with_one_arrival_time_remain_two(
    tmp_path: Path, record: Record, maker
) -> None:
    first, second = maker.imu(0), maker.imu(10)
    second = replace(second, t_arrival=first.t_arrival)
    nothing = replace(maker.imu(20), valid=np.zeros(7, bool), accel=np.full((7, 3), np.nan))
    nothing = replace(nothing, gyro=np.full((7, 3), np.nan))
    path = record(tmp_path / "a.mcap", [first, second, nothing])
    with SessionReader(path) as reader:
        found = list(reader.messages([ImuSample]))
    assert len(found) == 3
    assert all(same(a, b) for a, b in zip([first, second, nothing], found, strict=True))


def test_a_moving_cameras_pose_is_read_back_bit_for_bit(
    tmp_path: Path, session_info, maker
) -> None:
    info = replace(session_info, moving_camera=True)
    frames = [maker.blob_frame(20.0 * k, k, moving=True) for k in range(5)]
    with SessionRecorder(tmp_path / "a.mcap", info) as recorder:
        for f in frames:
            recorder.write(f)
    with SessionReader(tmp_path / "a.mcap") as reader:
        assert reader.info.moving_camera
        found = list(reader.messages([BlobFrame]))
    assert all(same(a, b) for a, b in zip(frames, found, strict=True))


def test_the_description_is_read_back(session, session_info) -> None:
    path, _ = session
    with SessionReader(path) as reader:
        info = reader.info
        assert info.metadata() == session_info.metadata()
        assert info.attachments() == session_info.attachments()
        assert not info.moving_camera
        rig, wanted = reader.rig(), session_info.rig
    assert same(rig.left, wanted.left)
    assert same(rig.right, wanted.right)
    assert np.array_equal(rig.pose.R_GC, wanted.pose.R_GC)
    assert np.array_equal(rig.pose.p_GC, wanted.pose.p_GC)


def test_seeking_returns_the_rest_with_the_valid_states(session) -> None:
    path, messages = session
    estimates = [m for m in messages if type(m) is Estimate]
    start = estimates[93].t - 0.001
    with SessionReader(path) as reader:
        found = list(reader.messages([Estimate], start=start))
    assert found[0].t <= estimates[93].t
    tail = [m for m in estimates if m.t >= found[0].t]
    assert all(same(a, b) for a, b in zip(tail, found, strict=True))


def test_states_are_written_only_on_changes(session) -> None:
    path, messages = session
    states = [(m.tracking, m.keypoint_state.tobytes()) for m in messages if type(m) is Estimate]
    changes = 1 + sum(a != b for a, b in pairwise(states))
    with AnyReader([path], default_typestore=typestore()) as bag:
        counts = {c.topic: c.msgcount for c in bag.connections}
    assert counts["/hand/right/states"] == changes


def test_rosbags_reads_the_file_as_a_bag(session) -> None:
    path, messages = session
    with AnyReader([path], default_typestore=typestore()) as bag:
        topics = {c.topic: c for c in bag.connections}
        sample = next(m for m in messages if type(m) is ImuSample)
        wanted = topics["/glove/right/imu/dorsum"]
        _, _, raw = next(bag.messages([wanted]))
        imu = bag.deserialize(raw, wanted.msgtype)
        assert imu.linear_acceleration.x == sample.accel[0, 0]
        assert topics["/camera/left/image/compressed"].msgcount == 75
        statics = topics["/tf_static"]
        tf = bag.deserialize(next(bag.messages([statics]))[2], statics.msgtype)
        assert [t.child_frame_id for t in tf.transforms] == ["camera_left", "camera_right"]
        assert tf.transforms[1].transform.translation.x == pytest.approx(0.063)


def test_lost_is_nan_in_the_file(session) -> None:
    path, _ = session
    with SessionReader(path) as reader:
        for m in reader.messages([Estimate]):
            lost = m.keypoint_state == Validity.LOST
            assert np.isnan(m.keypoints[lost]).all()
            assert lost.any() == (m.tracking == Tracking.COASTING)


def test_truth_is_stored_separately(tmp_path: Path, session_info, maker) -> None:
    truth, estimate = maker.estimate(0), maker.estimate(0)
    with SessionRecorder(tmp_path / "a.mcap", session_info) as recorder:
        recorder.write(estimate)
        recorder.write_truth(truth)
    with SessionReader(tmp_path / "a.mcap") as reader:
        (found,) = reader.truth()
        (other,) = reader.messages([Estimate])
    assert np.array_equal(found.keypoints, truth.keypoints)
    assert np.array_equal(found.angles, truth.angles)
    assert np.array_equal(other.keypoints, estimate.keypoints)


def test_jpeg_images_are_read_back_approximately(tmp_path: Path, record: Record, maker) -> None:
    frame = maker.image(0, 0)
    smooth = np.broadcast_to(np.arange(64, dtype=np.uint8)[None, :, None] * 3, (48, 64, 3)).copy()
    frame = replace(frame, left=smooth, right=None)
    path = record(tmp_path / "a.mcap", [frame], images="jpeg", jpeg_quality=95)
    with SessionReader(path) as reader:
        (found,) = reader.messages([StereoFrame])
    assert found.right is None
    assert np.abs(found.left.astype(int) - smooth).max() < 12


def test_the_last_of_several_attachments_is_used(session) -> None:
    path, _ = session
    text = (RESOURCES / "gloves" / "vist-small-distal.toml").read_text()
    with SessionReader(path, {"glove.toml": text}) as reader:
        assert reader.info.glove.name == "vist-small-distal"


def test_quaternions_in_the_file_are_those_of_the_segments(session) -> None:
    path, messages = session
    wanted = next(m for m in messages if type(m) is Estimate)
    with SessionReader(path) as reader:
        found = next(iter(reader.messages([Estimate])))
    assert np.allclose(so3.matrix_from_quat(found.keypoint_q[0]), wanted.segment_R[0])


def test_two_estimates_with_one_arrival_time_keep_their_segments(
    tmp_path: Path, record: Record, maker
) -> None:
    late = replace(maker.imu(0), t_arrival=maker.imu(40).t_arrival)
    estimates = [maker.estimate(ms) for ms in (0.0, 10.0, 20.0)]
    path = record(tmp_path / "a.mcap", [late, *estimates])
    with SessionReader(path) as reader:
        found = list(reader.messages([Estimate]))
    for a, b in zip(found, estimates, strict=True):
        assert np.array_equal(a.segment_p, b.segment_p)
        assert np.array_equal(a.angles, b.angles)
        assert np.array_equal(a.keypoint_sd, b.keypoint_sd)
