"""Poses of trackers arrive as other programs send them: python-osc, NatNet packets, LSL."""

from __future__ import annotations

import contextlib
import socket
import struct
import threading
from collections.abc import Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pythonosc.osc_bundle_builder import IMMEDIATELY, OscBundleBuilder
from pythonosc.osc_message_builder import OscMessageBuilder
from pythonosc.udp_client import SimpleUDPClient
from scipy.spatial.transform import Rotation

from extensions.osc.vmc_pose import unity_pose
from extensions.room import alignment_file
from extensions.room.alignment import Alignment
from extensions.room.doors import NatNetError, protocol_version, rigid_bodies
from extensions.room.frames import UPRIGHT, from_unity
from tests.notices import raises
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.geometry import so3
from tracker.messages import WristPose
from tracker.streaming.connection import LOOPBACK, ConnectionSettings, StreamError
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.registry import DOORS, open_door, with_doors
from tracker.streaming.remote.request import FIELDS, Reply, Request

P, Q = np.array([0.3, -0.2, 1.1]), Rotation.from_rotvec([0.4, -0.6, 0.9]).as_quat()


class Hands:
    """Takes poses as the window does; ``running`` or not."""

    def __init__(self) -> None:
        self.poses: list[WristPose] = []
        self.running = True

    def answer(self, request: Request) -> Future[Reply]:
        assert request.do == "wrist" and request.do not in FIELDS
        pose = request.data["pose"]
        assert isinstance(pose, WristPose)
        self.poses.append(pose)
        future: Future[Reply] = Future()
        future.set_result(Reply(self.running, request.do, ""))
        return future


@pytest.fixture
def hands() -> Hands:
    return Hands()


@contextlib.contextmanager
def opened(hands: Hands, name: str, **options: Any) -> Iterator[Door]:
    kind = DOORS.get(name)
    port = {} if name == "lslpose" else {"port": 0}
    door = open_door(kind, kind.options(**(port | options)), hands.answer)
    try:
        yield door
    finally:
        door.close()
    assert not [t for t in threading.enumerate() if "poses" in t.name]


def assert_pose(pose: WristPose, p: Any = P, q: Any = Q, atol: float = 1e-6) -> None:
    np.testing.assert_allclose(pose.p_GT, p, atol=atol)
    same = np.abs(np.dot(pose.q_GT, np.asarray(q)))
    assert same == pytest.approx(1.0, abs=atol)


def test_vmc_trackers_in_a_bundle(hands: Hands, wait_for) -> None:
    """As Virtual Motion Capture sends all devices of SteamVR in one bundle."""
    p, q = unity_pose(P, Q)
    bundle = OscBundleBuilder(IMMEDIATELY)
    for serial, x in (("LHR-1", 5.0), ("LHR-2", float(p[0])), ("LHR-3", 9.0)):
        message = OscMessageBuilder("/VMC/Ext/Tra/Pos")
        for value in (serial, x, *map(float, p[1:]), *map(float, q)):
            message.add_arg(value)
        bundle.add_content(message.build())
    with opened(hands, "room", right="LHR-2") as door:
        with SimpleUDPClient(LOOPBACK, door.port) as client:
            before = monotonic()
            client.send(bundle.build())
            wait_for(lambda: hands.poses)
        (pose,) = hands.poses
        assert_pose(pose)
        assert pose.side == "right" and before <= pose.t <= monotonic()
        assert pose.t_arrival == pose.t and pose.position_variance == pytest.approx(4e-6)
        counts = door.counts()
        assert (counts.asked, counts.refused) == (1, 0) and len(counts.peers) == 1


def test_trackers_of_vrchat_by_position_and_angles(hands: Hands, wait_for) -> None:
    """Unity turns about z, x and y; a quaternion of its axes by an independent library."""
    degrees = np.array([20.0, -50.0, 35.0])
    # Unity's angles are left-handed: mirrored at its x axis they are right-handed ones
    mirrored = Rotation.from_euler("YXZ", [-degrees[1], degrees[0], -degrees[2]], degrees=True)
    x, y, z, w = mirrored.as_quat()
    _, q = from_unity(np.zeros(3), np.array([x, -y, -z, w]))
    with opened(hands, "room", left="3") as door, SimpleUDPClient(LOOPBACK, door.port) as client:
        client.send_message("/tracking/trackers/3/position", [0.0, 1.0, 0.5])
        wait_for(lambda: hands.poses)
        assert np.isnan(hands.poses[0].q_GT).all(), "no rotation has arrived yet"
        client.send_message("/tracking/trackers/3/rotation", degrees.tolist())
        client.send_message("/tracking/trackers/head/position", [0.0, 1.7, 0.0])
        client.send_message("/tracking/trackers/3/position", [0.0, 1.0, 0.5])
        wait_for(lambda: len(hands.poses) == 2)
    assert hands.poses[1].side == "left"
    assert_pose(hands.poses[1], [0.5, 0.0, 1.0], q)


def test_own_addresses_with_and_without_rotation(hands: Hands, wait_for) -> None:
    options = {"right": "any", "yaw_deg": 90.0, "delay_ms": 20.0}
    with opened(hands, "room", **options) as door, SimpleUDPClient(LOOPBACK, door.port) as client:
        client.send_message("/glovetrack/wrist", ["hand", *P.tolist(), *Q.tolist()])
        client.send_message("/glovetrack/wrist", ["hand", *P.tolist()])
        wait_for(lambda: len(hands.poses) == 2)
    turned = Rotation.from_euler("z", 90, degrees=True)
    assert_pose(hands.poses[0], turned.apply(P), (turned * Rotation.from_quat(Q)).as_quat())
    assert hands.poses[0].t == pytest.approx(hands.poses[0].t_arrival - 0.02)
    assert np.isnan(hands.poses[1].q_GT).all()


def test_unreadable_packets_are_counted(hands: Hands, wait_for) -> None:
    bad: list[bytes] = [b"", b"\0" * 40, b"#bundle\0" + bytes(8) + b"\x7f\xff\xff\xff", b"/x\0\0"]
    nested = b"/x\0\0,\0\0\0"
    for _ in range(9):
        nested = b"#bundle\0" + bytes(8) + struct.pack(">i", len(nested)) + nested
    with opened(hands, "room", right="any") as door, SimpleUDPClient(LOOPBACK, door.port) as client:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as plain:
            for data in (*bad, nested):
                plain.sendto(data, (LOOPBACK, door.port))
        client.send_message("/glovetrack/wrist", ["hand", 1.0, 2.0])
        client.send_message("/glovetrack/wrist", ["hand", 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
        client.send_message("/glovetrack/wrist", ["hand", float("nan"), 0.0, 0.0])
        client.send_message("/glovetrack/wrist", ["hand", *P.tolist()])
        wait_for(lambda: hands.poses)
        assert len(hands.poses) == 1
        assert door.counts().refused == 7, "an unknown address and an empty packet are not errors"


def test_poses_of_ignored_are_counted_as_refused(hands: Hands, wait_for) -> None:
    hands.running = False
    with opened(hands, "room", right="any") as door, SimpleUDPClient(LOOPBACK, door.port) as client:
        client.send_message("/glovetrack/wrist", ["hand", *P.tolist()])
        wait_for(lambda: door.counts().refused == 1)


def test_the_alignment_of_a_file_goes_with_each_pose(
    hands: Hands, tmp_path: Path, wait_for
) -> None:
    path = tmp_path / "alignment.toml"
    aligned = Alignment(np.array([0.03, 0.0, 0.04]), Q, 0.015)
    alignment_file.write(path, {"right": aligned})
    settings = with_doors(ConnectionSettings(), f"room?alignment={path}&right=a&left=a")
    options = settings.options(DOORS.get("room"))
    assert options.alignment == str(path)
    both = {"alignment": str(path), "right": "a", "left": "a"}
    with opened(hands, "room", **both) as door, SimpleUDPClient(LOOPBACK, door.port) as client:
        client.send_message("/glovetrack/wrist", ["a", *P.tolist(), *Q.tolist()])
        wait_for(lambda: len(hands.poses) == 2)
    by_side = {pose.side: pose for pose in hands.poses}
    np.testing.assert_allclose(by_side["right"].p_BT, aligned.p_BT, atol=1e-9)
    np.testing.assert_allclose(by_side["right"].q_BT, aligned.q_BT, atol=1e-8)
    assert by_side["right"].t == pytest.approx(by_side["right"].t_arrival - 0.015)
    assert not by_side["left"].p_BT.any(), "that side is not in the file"


def test_a_port_in_use_is_an_error(hands: Hands) -> None:
    with (
        opened(hands, "room") as door,
        raises(StreamError, "remote.not_started"),
        opened(hands, "room", port=door.port),
    ):
        pass


# ---- OptiTrack


def frame(version: tuple[int, int], bodies: list[tuple[int, Any, Any, bool]]) -> bytes:
    """A frame of data as Motive sends it, with a marker set and unlabelled markers before."""

    def section(count: int, content: bytes) -> bytes:
        size = struct.pack("<i", len(content)) if version >= (4, 1) else b""
        return struct.pack("<i", count) + size + content

    out = struct.pack("<i", 1234)
    markers = struct.pack("<i6f", 2, *range(6))
    out += section(1, b"Hand\0" + markers) + section(1, struct.pack("<3f", 1, 2, 3))
    content = b""
    for number, p, q, valid in bodies:
        content += struct.pack("<i7f", number, *p, *q)
        if version < (3, 0):
            content += struct.pack("<i", 1) + struct.pack("<3fif", 0, 0, 0, 1, 0.01)
        content += struct.pack("<fH", 0.001, int(valid))
    out += section(len(bodies), content)
    for _ in range(5 + (version >= (4, 1))):  # skeletons, assets, labelled markers, plates, devices
        out += section(0, b"")
    out += struct.pack("<IId3QH", 0, 0, 1.5, 1, 2, 3, 0)
    return struct.pack("<HH", 7, len(out)) + out


VERSIONS = [(2, 10), (3, 1), (4, 0), (4, 1)]


@pytest.mark.parametrize("version", VERSIONS)
def test_rigid_bodies_of_each_protocol(version: tuple[int, int]) -> None:
    data = frame(version, [(7, P, Q, True), (8, -P, Q, False)])
    one, other = rigid_bodies(data, version)
    assert (one.number, one.valid, other.number, other.valid) == (7, True, 8, False)
    np.testing.assert_allclose(one.p, P, atol=1e-6)
    np.testing.assert_allclose(one.q, Q, atol=1e-6)
    for end in range(8, len(data) - 60, 7):
        with contextlib.suppress(NatNetError):
            rigid_bodies(data[:end], version)
    with pytest.raises(NatNetError):
        rigid_bodies(data[:60], version)


def test_another_client_reads_the_same_frames() -> None:
    natnet = pytest.importorskip("natnet", reason="it reads the stand-in's frames")
    from natnet.packet_buffer import PacketBuffer
    from natnet.version import Version

    buffer = PacketBuffer(frame((4, 1), [(7, P, Q, True)])[4:])
    read = natnet.DataFrame.read_from_buffer(buffer, Version(4, 1))
    (body,) = read.rigid_bodies
    assert (body.id_num, body.tracking_valid) == (7, True)
    np.testing.assert_allclose(body.pos, P, atol=1e-6)


def test_a_stand_in_for_motive_is_asked_and_read(
    hands: Hands, wait_for, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Unicast: it answers with its version, 3.1, then sends frames to who has asked."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as motive:
        motive.bind((LOOPBACK, 0))
        motive.settimeout(60)
        port = motive.getsockname()[1]
        monkeypatch.setattr("extensions.room.doors.COMMAND_PORT", port)
        with opened(hands, "natnet", server=LOOPBACK, group="", right="7") as door:
            data, client = motive.recvfrom(1000)
            assert struct.unpack_from("<H", data)[0] == 0 and client[1] == door.port
            info = b"Motive".ljust(256, b"\0") + bytes([3, 0, 1, 0]) + bytes([3, 1, 0, 0])
            motive.sendto(struct.pack("<HH", 1, len(info)) + info, client)
            motive.sendto(frame((3, 1), [(6, -P, Q, True), (7, P, Q, True)]), client)
            motive.sendto(frame((3, 1), [(7, P, Q, False)]), client)
            motive.sendto(b"\x07\0\x20\0short", client)
            wait_for(lambda: door.counts().refused == 1)
    (pose,) = hands.poses
    assert_pose(pose, UPRIGHT @ P, so3.quat_from_matrix(UPRIGHT @ so3.matrix_from_quat(Q)))
    assert protocol_version(struct.pack("<HH", 1, len(info)) + info) == (3, 1)


def test_multicast_frames_are_received(hands: Hands, wait_for) -> None:
    group = "239.255.42.98"
    with opened(hands, "natnet", group=group, right="7", up="z") as door:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as motive:
            motive.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(LOOPBACK))
            motive.sendto(frame((4, 1), [(7, P, Q, True)]), (group, door.port))
        wait_for(lambda: hands.poses)
    assert_pose(hands.poses[0])


def test_an_unknown_axis_is_refused(hands: Hands) -> None:
    with raises(ConfigError, "room.unknown_axis"), opened(hands, "natnet", up="w"):
        pass


# ---- LSL


def test_poses_by_lsl_have_their_own_instants(hands: Hands) -> None:
    try:
        import pylsl
    except (ImportError, RuntimeError) as error:
        pytest.skip(f"pylsl is not usable: {error}")
    info = pylsl.StreamInfo("Wrist", "MoCapTest", 7, 100.0, "double64", "room-1")
    outlet, ago = pylsl.StreamOutlet(info), 0.05
    with opened(hands, "lslpose", type="MoCapTest", right="Wrist") as door:
        if not outlet.wait_for_consumers(20):
            pytest.skip("LSL finds nothing here: this machine passes no multicast")
        deadline, pushed = monotonic() + 60, []
        while len(hands.poses) < 20 and monotonic() < deadline:
            before = monotonic() - ago
            outlet.push_sample([*P, *Q], pylsl.local_clock() - ago)
            pushed.append((before, monotonic() - ago))
            threading.Event().wait(0.01)
        outlet.push_sample([float("nan")] * 7)
        assert door.counts().clients == 1
    pose, ended = hands.poses[-1], monotonic()
    assert_pose(pose)
    assert any(before - 0.005 < pose.t < after + 0.005 for before, after in pushed)
    assert pose.t <= pose.t_arrival < ended
