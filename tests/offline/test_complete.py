"""A tracked file is self-contained, checked with rosbags."""

from pathlib import Path

import numpy as np
import pytest
from rosbags.highlevel import AnyReader

from tests.session.ros_types import typestore
from tracker.messages import BlobFrame, Estimate, ImuSample
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.long


@pytest.fixture(scope="module", params=["head", "head-imu"])
def head(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three seconds with a moving camera, which reports its pose, or the samples of its own IMU."""
    path = tmp_path_factory.mktemp("head") / f"{request.param}.mcap"
    simulate(path, SimulateOptions(images=False, duration=3.0, fps=30.0, camera=request.param))
    return path


def camera_transforms(path: Path, topic: str) -> dict[int, np.ndarray]:
    """Stamp (ns) to translation of world → camera_left."""
    out = {}
    with AnyReader([path], default_typestore=typestore()) as bag:
        wanted = [c for c in bag.connections if c.topic == topic]
        for connection, _, raw in bag.messages(wanted):
            for t in bag.deserialize(raw, connection.msgtype).transforms:
                if (t.header.frame_id, t.child_frame_id) == ("world", "camera_left"):
                    p = t.transform.translation
                    stamp = t.header.stamp.sec * 10**9 + t.header.stamp.nanosec
                    out[stamp] = np.array([p.x, p.y, p.z])
    return out


@pytest.fixture(scope="module")
def tracked(head: Path) -> Path:
    """Without the sensors."""
    out = head.with_name(f"{head.stem}-tracked.mcap")
    track(head, out)
    return out


@pytest.mark.parametrize("with_sensors", [False, True])
def test_a_moving_camera_has_a_transform_per_frame(
    head: Path, tracked: Path, tmp_path: Path, with_sensors: bool
) -> None:
    out = tracked
    if with_sensors:
        out = tmp_path / "out.mcap"
        track(head, out, TrackOptions(with_sensors=True))
    with SessionReader(head) as reader:
        frames = {reader.anchor.wall(m.t): m for m in reader.messages((BlobFrame,))}
    found_transforms = camera_transforms(out, "/tf")
    assert found_transforms.keys() == frames.keys()
    for stamp, frame in frames.items():
        if frame.pose is not None:
            assert np.array_equal(found_transforms[stamp], frame.pose.p_GC)
    static = camera_transforms(out, "/tf_static")
    assert bool(static) == (with_sensors and head.stem == "head-imu")
    with SessionReader(out) as reader:
        assert reader.info.rig is not None
        assert len(list(reader.messages((Estimate,)))) > 200
    if with_sensors:
        again = tmp_path / "again.mcap"
        track(out, again)
        assert compare(out, again)["identical"]


def test_status_is_written_every_second(head: Path, tracked: Path) -> None:
    with SessionReader(head) as reader:
        packets = [reader.anchor.wall(m.t) for m in reader.messages((ImuSample,))]
    stamps, diagnostics = [], []
    with AnyReader([tracked], default_typestore=typestore()) as bag:
        for connection, _, raw in bag.messages():
            if connection.topic == "/tracker/status":
                message = bag.deserialize(raw, connection.msgtype)
                stamps.append(message.header.stamp.sec * 10**9 + message.header.stamp.nanosec)
                diagnostics.append({v.key: float(v.value) for v in message.status[0].values})
                assert message.status[0].name == "tracker"
    assert np.diff([packets[0], *stamps, packets[-1]]).max() <= 10**9
    assert diagnostics[-1]["imu_rate_hz"] == pytest.approx(100, abs=2)
    assert diagnostics[-1]["frame_rate_hz"] == pytest.approx(30, abs=2)
    assert diagnostics[-1]["imu_lost"] == 0 and diagnostics[-1]["latency_imu_ms"] > 0
