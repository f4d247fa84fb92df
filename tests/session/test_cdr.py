"""Our bytes against those of rosbags, an independent implementation of CDR."""

from dataclasses import replace

import numpy as np
import pytest

from tests.session.ros_types import typestore
from tracker.messages import Blobs, Cloth
from tracker.session.ros import motion, sensors
from tracker.session.ros.cdr import CdrError, CdrWriter
from tracker.session.ros.definitions import definition
from tracker.vision.rig import ideal_rig

NS = 1_700_000_000_123_456_789
RNG = np.random.default_rng(3)
BLOBS = Blobs(
    RNG.normal(size=(3, 2)), RNG.uniform(1, 9, (3, 2)), np.array([1, 0, 1]), RNG.uniform(size=3)
)
CLOTH = Cloth(80, 45, np.array([3, 4, 5, 90, 200, 201]), RNG.integers(-(2**63), 2**63 - 1, 6))

PACKED = {
    sensors.IMU: sensors.pack_imu(
        sensors.ImuMessage(NS, "dorsum", RNG.normal(size=3), np.ones(3), 0.25, 4.0)
    ),
    sensors.IMAGE: sensors.pack_image(
        sensors.ImageMessage(NS, "camera_left", "jpeg", b"\xff\xd8abc")
    ),
    sensors.CAMERA_INFO: sensors.pack_camera_info(NS, "camera_left", ideal_rig().right),
    sensors.TIME_REFERENCE: sensors.pack_time_reference(sensors.TimeReference(NS, 12345, "glove")),
    sensors.DETECTIONS: sensors.pack_detections(
        sensors.Detections(NS, "camera_left", BLOBS, ("red", "blue"))
    ),
    sensors.CLOTH: sensors.pack_cloth(CLOTH),
    motion.TF: motion.pack_transforms(
        [motion.Transform(NS, "world", c, RNG.normal(size=3), RNG.normal(size=4)) for c in "ab"]
    ),
    motion.POSES: motion.pack_poses(
        motion.PoseArray(NS, "world", RNG.normal(size=(5, 3)), RNG.normal(size=(5, 4)))
    ),
    motion.JOINTS: motion.pack_joints(motion.JointState(NS, ["a", "bcd"], RNG.normal(size=2))),
    motion.DIAGNOSTICS: motion.pack_diagnostics(
        NS,
        [
            motion.Diagnostic(1, "n", "words", {"k": "v", "äö": ""}),
            motion.Diagnostic(0, "", "", {}),
        ],
    ),
    motion.STRING: motion.pack_string("hällo"),
    motion.NUMBERS: motion.pack_numbers(RNG.normal(size=12)),
}
UNPACK = {
    sensors.IMU: sensors.unpack_imu,
    sensors.IMAGE: sensors.unpack_image,
    sensors.CAMERA_INFO: sensors.unpack_camera_info,
    sensors.TIME_REFERENCE: sensors.unpack_time_reference,
    sensors.DETECTIONS: sensors.unpack_detections,
    sensors.CLOTH: sensors.unpack_cloth,
    motion.TF: motion.unpack_transforms,
    motion.POSES: motion.unpack_poses,
    motion.JOINTS: motion.unpack_joints,
    motion.DIAGNOSTICS: motion.unpack_diagnostics,
    motion.STRING: motion.unpack_string,
    motion.NUMBERS: motion.unpack_numbers,
}


@pytest.mark.parametrize("name", PACKED)
def test_rosbags_reads_and_writes_the_same_bytes(name: str) -> None:
    store = typestore()
    message = store.deserialize_cdr(PACKED[name], name)
    assert bytes(store.serialize_cdr(message, name)) == PACKED[name]


@pytest.mark.parametrize("name", PACKED)
def test_a_big_endian_message_is_read_the_same(name: str) -> None:
    store = typestore()
    message = store.deserialize_cdr(PACKED[name], name)
    big = bytes(store.serialize_cdr(message, name, little_endian=False))
    assert repr(UNPACK[name](big)) == repr(UNPACK[name](PACKED[name]))


def transforms(names: str, big: bool) -> tuple[bytes, list[motion.Transform]]:
    """A message of other numbers each time, and what it contains."""
    stamp = int(RNG.integers(-(2**31) * 10**9, 2**31 * 10**9))
    made = [
        motion.Transform(stamp + k, "world", n, *np.split(RNG.normal(size=7), [3]))
        for k, n in enumerate(names)
    ]
    return _as_sent(motion.TF, motion.pack_transforms(made), big), made


def joints(names: str, big: bool) -> tuple[bytes, motion.JointState]:
    made = motion.JointState(int(RNG.integers(2**60)), tuple(names), RNG.normal(size=len(names)))
    return _as_sent(motion.JOINTS, motion.pack_joints(made), big), made


def _as_sent(name: str, data: bytes, big: bool) -> bytes:
    store = typestore()
    message = store.deserialize_cdr(data, name)
    return bytes(store.serialize_cdr(message, name, little_endian=not big))


@pytest.mark.parametrize("make", [transforms, joints])
def test_messages_like_an_earlier_one_are_read_by_their_own_bytes(make) -> None:
    """In turns: other numbers, other names of the same length, another byte order, other counts."""
    for names, big in [("ab", False), ("ab", False), ("cb", False), ("ab", True)] * 2 + [
        ("", False),
        ("abc", False),
        ("ab", True),
        ("", False),
    ]:
        data, made = make(names, big)
        found = UNPACK[motion.TF if make is transforms else motion.JOINTS](data)
        assert repr(found) == repr(made)
        arrays = [t.rotation for t in found] if make is transforms else [found.position]
        assert all(a.flags.writeable for a in arrays)


@pytest.mark.parametrize("name", PACKED)
def test_a_shortened_message_is_an_error(name: str) -> None:
    data = PACKED[name]
    for end in range(0, len(data) - 24, 7):
        with pytest.raises(CdrError):
            UNPACK[name](data[:end])


def test_fields_land_where_ros_expects_them() -> None:
    store = typestore()
    imu = store.deserialize_cdr(PACKED[sensors.IMU], sensors.IMU)
    assert imu.orientation_covariance[0] == -1
    np.testing.assert_array_equal(imu.angular_velocity_covariance.reshape(3, 3), 0.25 * np.eye(3))
    np.testing.assert_array_equal(imu.linear_acceleration_covariance.reshape(3, 3), 4 * np.eye(3))
    assert imu.linear_acceleration.y == 1.0
    assert imu.header.stamp.nanosec == 123_456_789
    info = store.deserialize_cdr(PACKED[sensors.CAMERA_INFO], sensors.CAMERA_INFO)
    assert info.p[3] == pytest.approx(-640 * 0.063)
    assert (info.width, info.height) == (1280, 720)
    found = store.deserialize_cdr(PACKED[sensors.DETECTIONS], sensors.DETECTIONS).detections
    assert [d.results[0].hypothesis.class_id for d in found] == ["blue", "red", "blue"]
    assert found[2].bbox.center.position.y == BLOBS.uv[2, 1]
    assert found[1].bbox.size_x == BLOBS.size[1, 0]


def test_unpacking_gives_the_identical_floats() -> None:
    blobs = sensors.unpack_detections(PACKED[sensors.DETECTIONS])
    assert np.array_equal(blobs.blobs.uv, BLOBS.uv)
    assert np.array_equal(blobs.blobs.score, BLOBS.score)
    assert [blobs.names[h] for h in blobs.blobs.hue] == ["blue", "red", "blue"]


@pytest.mark.parametrize("tile", [[], [0], [3599], [3598, 3599], list(range(3600))])
def test_a_cloth_map_is_read_back_for_any_tiles(tile: list[int]) -> None:
    bits = RNG.integers(-(2**63), 2**63 - 1, len(tile))
    plain = Cloth(80, 45, np.array(tile, int), bits)  # as in earlier versions
    for cloth in (plain, replace(plain, bright=~bits)):
        back = sensors.unpack_cloth(sensors.pack_cloth(cloth))
        assert (back.columns, back.rows) == (80, 45)
        assert back.tile.tolist() == tile and back.bits.tolist() == bits.tolist()
        assert tile == [] or (back.bright is None) == (cloth.bright is None)
        assert back.bright is None or back.bright.tolist() == (~bits).tolist()


@pytest.mark.parametrize(
    "values",
    [
        [],
        [80, 45],
        [80, 45, 1, 3599, 2, 0, 0],  # the second is beyond the image
        [80, 45, 1, -1, 1, 0],
        [80, 45, 1, 0, 2, 0],  # bits of one
        [80, 45, 2, 0, 5, -1, 3, 0, 0],
        [80, 45, 9, 0, 1, 0],
        [1 << 40, 1 << 40, 0],
        [80, 45, 1, 2**62, 2**62, 0],
    ],
)
def test_a_damaged_map_of_cloth_is_an_error(values: list[int]) -> None:
    out = CdrWriter()
    out.no_layout()
    out.long_list(values)
    with pytest.raises(CdrError):
        sensors.unpack_cloth(out.done())


@pytest.mark.parametrize("name", PACKED)
def test_definitions_are_those_of_rosbags(name: str) -> None:
    text, _ = typestore().generate_msgdef(name, ros_version=2)
    assert definition(name) == text
