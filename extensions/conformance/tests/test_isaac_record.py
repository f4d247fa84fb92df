"""Our records in NVIDIA's own replay, and what may be in them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from mcap.reader import make_reader
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from extensions.conformance.isaac.record import HandRecord, Stamps, decode, encode, joints_of
from extensions.conformance.isaac.schema import SE3, binary_schema
from extensions.conformance.isaac.writer import IsaacWriter
from extensions.conformance.run import read_records
from tests.fixtures import RESOURCES
from tests.notices import raises
from tests.streaming.recorded_hand import RecordedHand, assert_near, assert_parallel
from tracker.base.errors import FileError
from tracker.hand.files import load_hand
from tracker.hand.openxr import JOINTS, OpenXrHand, joint_radii, to_openxr
from tracker.messages import Estimate, Tracking, Validity
from tracker.streaming.publisher import StreamError
from tracker.streaming.registry import StreamSettings, open_streams, with_streams

deviceio = pytest.importorskip("isaacteleop.deviceio")


def posed(side: str, seed: int, lost: str = "") -> OpenXrHand:
    hand = load_hand(RESOURCES / "hands" / f"reference-{side}.toml")
    rng = np.random.default_rng(seed)
    angles = rng.uniform(*hand.angle_limits.T)
    R, p = hand.forward(angles, np.eye(3), rng.normal(size=3))
    n = len(hand.keypoint_names)
    state = np.where([k == lost for k in hand.keypoint_names], 0, int(Validity.MEASURED))
    q = np.tile([0.0, 0.0, 0.0, 1.0], (n, 1))
    known = np.full(len(angles), int(Validity.MEASURED))
    e = Estimate(
        0.0, Tracking.TRACKING, hand.keypoints(R, p), q, state, np.zeros(n), angles, known, R, p
    )
    return to_openxr(e, hand.keypoint_names, joint_radii(hand))


def written(path: Path, hands: dict[str, list[OpenXrHand]]) -> Path:
    """Ten ms apart, both sides at once."""
    with path.open("wb") as file:
        writer = IsaacWriter(file)
        for k in range(max(len(h) for h in hands.values())):
            for side, series in hands.items():
                stamps = Stamps(10_000_000 * k + 3_000_000, 10_000_000 * k, 17 + k)
                writer.write(side, HandRecord(stamps, joints_of(series[k])))
        writer.finish()
    return path


def replayed(path: Path, n: int) -> list[dict[str, object]]:
    """The values of NVIDIA's replay for each update and side: position, quaternion, valid,
    radius."""
    tracker = deviceio.HandTracker()
    config = deviceio.McapReplayConfig(str(path), [(tracker, "hands")])
    out = []
    with deviceio.ReplaySession.run(config) as session:
        for _ in range(n):
            session.update()
            found = {}
            for side in ("left", "right"):
                data = getattr(tracker, f"get_{side}_hand")(session)
                data = getattr(data, "data", data)  # older releases wrap it
                found[side] = None if data is None or data.joints is None else _joints(data)
            out.append(found)
    return out


def _joints(data) -> tuple[np.ndarray, ...]:
    poses = [data.joints.poses(i) for i in range(len(JOINTS))]
    place = [(p.pose.position.x, p.pose.position.y, p.pose.position.z) for p in poses]
    turn = [p.pose.orientation for p in poses]
    return (
        np.array(place),
        np.array([(t.x, t.y, t.z, t.w) for t in turn]),
        np.array([p.is_valid for p in poses]),
        np.array([p.radius for p in poses]),
    )


def test_nvidias_replay_reads_both_hands(tmp_path: Path) -> None:
    hands = {side: [posed(side, k) for k in range(3)] for side in ("left", "right")}
    for k, found in enumerate(replayed(written(tmp_path / "take.mcap", hands), 3)):
        for side in ("left", "right"):
            position, q, valid, radius = found[side]
            wanted = hands[side][k]
            assert_allclose(position, np.float32(wanted.position))
            assert_allclose(q, np.float32(wanted.orientation))
            assert_allclose(radius, np.float32(wanted.radius))
            assert valid.all()


def test_a_lost_joint_is_not_valid_and_a_lost_wrist_is_no_hand(tmp_path: Path) -> None:
    hands = {"right": [posed("right", 1, "index_tip"), posed("right", 2, "wrist")]}
    first, second = replayed(written(tmp_path / "take.mcap", hands), 2)
    _, _, valid, _ = first["right"]
    assert [JOINTS[i] for i in np.flatnonzero(~valid)] == ["index_tip"]
    assert second["right"] is None and first["left"] is None


def test_the_file_is_uncompressed_and_its_schema_is_nvidias(tmp_path: Path) -> None:
    """Against the schema that is compiled into their library: names, types, places and sizes."""
    path = written(tmp_path / "take.mcap", {"right": [posed("right", 1)]})
    with path.open("rb") as file:
        summary = make_reader(file).get_summary()
    assert {c.compression for c in summary.chunk_indexes} == {""}
    (schema,) = summary.schemas.values()
    topics = {c.topic for c in summary.channels.values()}
    assert topics == {"hands/left_hand", "hands/right_hand"}
    assert (schema.name, schema.encoding) == ("core.HandPoseRecord", "flatbuffer")
    theirs = embedded_schemas()
    if not theirs:
        pytest.skip("this build of isaacteleop holds no schema of hands")
    assert described(schema.data) == described(theirs[0])


def embedded_schemas(name: str = "core.HandPoseRecord") -> list[bytes]:
    """Binary schemas in NVIDIA's libraries whose root is a record."""
    out = []
    for library in Path(deviceio.__file__).parents[1].rglob("*.so"):
        data = library.read_bytes()
        at = data.find(b"BFBS")
        while at >= 0:
            start = data[at - 4 : at - 4 + 65536]
            if name.encode() in start[:4096]:
                try:
                    if root_name(start) == name:
                        out.append(start)
                except (IndexError, ValueError, UnicodeDecodeError):
                    pass
            at = data.find(b"BFBS", at + 4)
    return out


class Reflected:
    """A table of google/flatbuffers' reflection.fbs, read by the bytes."""

    def __init__(self, data: bytes, at: int) -> None:
        self.data, self.at = data, at

    def number(self, at: int, size: int, signed: bool = False) -> int:
        return int.from_bytes(self.data[at : at + size], "little", signed=signed)

    def place(self, slot: int) -> int:
        vtable = self.at - self.number(self.at, 4, True)
        entry = vtable + 4 + 2 * slot
        inside = 4 + 2 * slot < self.number(vtable, 2)
        offset = self.number(entry, 2) if inside else 0
        return self.at + offset if offset else 0

    def value(self, slot: int, size: int, usual: int = 0, signed: bool = True) -> int:
        place = self.place(slot)
        return self.number(place, size, signed) if place else usual

    def table(self, slot: int) -> Reflected:
        place = self.place(slot)
        return Reflected(self.data, place + self.number(place, 4))

    def text(self, slot: int) -> str:
        place = self.place(slot)
        start = place + self.number(place, 4)
        return self.data[start + 4 : start + 4 + self.number(start, 4)].decode()

    def rows(self, slot: int) -> list[Reflected]:
        place = self.place(slot)
        start = place + self.number(place, 4)
        at = [start + 4 + 4 * i for i in range(self.number(start, 4))]
        return [Reflected(self.data, a + self.number(a, 4)) for a in at]


def root_of(data: bytes) -> Reflected:
    return Reflected(data, int.from_bytes(data[:4], "little"))


def root_name(data: bytes) -> str:
    return root_of(data).table(4).text(0)


def described(data: bytes) -> dict[str, object]:
    """The parts of a binary schema that a reader needs: objects by name, each with its fields by
    name."""
    root = root_of(data)
    objects = root.rows(0)
    names = [o.text(0) for o in objects]
    assert names == sorted(names), "readers search them by bisection"
    out: dict[str, object] = {"root": root.table(4).text(0)}
    for o in objects:
        fields = {}
        for f in o.rows(1):
            kind = f.table(1)
            index = kind.value(2, 4, -1)
            fields[f.text(0)] = (
                kind.value(0, 1),
                kind.value(1, 1),
                names[index] if index >= 0 and kind.value(0, 1) in (15, 17) else "",
                kind.value(3, 2),
                f.value(2, 2),
                f.value(3, 2),
                f.value(12, 2),
            )
        is_struct = bool(o.value(2, 1))
        out[o.text(0)] = (is_struct, o.value(3, 4), o.value(4, 4) if is_struct else 0, fields)
    return out


def test_records_are_read_bit_for_bit_and_damage_is_reported() -> None:
    record = HandRecord(Stamps(5, 4, -3), joints_of(posed("left", 4)))
    data = encode(record)
    again = decode(data)
    assert again.stamps == record.stamps and (again.joints == record.joints).all()
    assert decode(encode(HandRecord(Stamps(1, 1, 1), None))).joints is None
    for length in (0, 3, 8, 40, 500):
        with raises(FileError, "isaac.damaged"):
            decode(data[:length])


def test_our_reader_reads_what_was_written(tmp_path: Path) -> None:
    hands = {side: [posed(side, k) for k in range(4)] for side in ("left", "right")}
    found = list(read_records(written(tmp_path / "take.mcap", hands)))
    assert [side for side, _ in found] == ["left", "right"] * 4
    assert found[7][1].stamps == Stamps(33_000_000, 30_000_000, 20)
    with raises(FileError, "isaac.not_mcap"):
        (tmp_path / "x.mcap").write_bytes(b"not one")
        list(read_records(tmp_path / "x.mcap"))


def test_a_live_record_is_replayed_and_nothing_is_overwritten(
    tmp_path: Path, recorded: RecordedHand
) -> None:
    """NVIDIA's replay reads the poses of a recording."""
    path = tmp_path / "live.mcap"
    settings, names = with_streams(StreamSettings(), f"isaac:{path}"), [recorded.names]
    (publisher,) = open_streams(settings, names)["isaac"]
    with raises(StreamError, "file.not_created"):
        open_streams(settings, names)
    assert publisher.probe().code == "stream.test_nothing"
    for e in recorded.estimates:
        publisher.send(e)
    assert publisher.probe().code == "isaac.test_written"
    publisher.close()
    replay = replayed(path, len(recorded.estimates))
    for found, e in zip(replay, recorded.estimates, strict=True):
        position, q, valid, _ = found["right"]
        for joint, (p, R) in recorded.openxr(e).items():
            row = JOINTS.index(joint)
            assert_near(position[row], p)
            assert_parallel(Rotation.from_quat(q[row]), R)
        assert valid.all() and found["left"] is None
    with path.open("rb") as file:
        topics = {c.topic for c in make_reader(file).get_summary().channels.values()}
    assert "glovetrack_right_index_tip/se3_tracker_tracked" in topics
    stamps = [r.stamps for _, r in read_records(path)]
    assert all(s.available >= s.sample for s in stamps)
    with raises(StreamError, "isaac.no_file"):
        open_streams(StreamSettings({"isaac": True}), names)


def test_the_schema_of_trackers_is_nvidias() -> None:
    theirs = embedded_schemas(SE3)
    if not theirs:
        pytest.skip("this build of isaacteleop holds no schema of trackers")
    assert described(binary_schema(SE3)) == described(theirs[0])


def test_fingertips_are_named_trackers_in_nvidias_replay(tmp_path: Path) -> None:
    """Each tip by its collection's name, with a flag where it is lost; hands are read as before."""
    path = tmp_path / "tips.mcap"
    series = [posed("right", 1), posed("right", 2, "index_tip"), posed("right", 3)]
    with path.open("wb") as file:
        writer = IsaacWriter(file)
        for k, hand in enumerate(series):
            stamps = Stamps(10_000_000 * k + 3_000_000, 10_000_000 * k, 17 + k)
            writer.write("right", HandRecord(stamps, joints_of(hand)))
            writer.write_tips("right", stamps, hand)
        writer.finish()
    names = ("wrist", "thumb_tip", "index_tip", "middle_tip", "ring_tip", "little_tip")
    theirs = pytest.importorskip("isaacteleop.deviceio_trackers")
    trackers = {n: theirs.Se3Tracker(f"glovetrack_right_{n}") for n in names}
    given = [(tracker, f"glovetrack_right_{n}") for n, tracker in trackers.items()]
    with deviceio.ReplaySession.run(deviceio.McapReplayConfig(str(path), given)) as session:
        for hand in series:
            session.update()
            for name, tracker in trackers.items():
                data = tracker.get_data(session)
                data = getattr(data, "data", data)
                row = JOINTS.index(name)
                lost = hand.state[row] == Validity.LOST
                assert data.is_valid == (not lost)
                if lost:
                    continue
                p, q = data.pose.position, data.pose.orientation
                assert_allclose([p.x, p.y, p.z], np.float32(hand.position[row]))
                assert_allclose([q.x, q.y, q.z, q.w], np.float32(hand.orientation[row]))
    found = replayed(path, 3)
    assert_allclose(found[0]["right"][0], np.float32(series[0].position))
