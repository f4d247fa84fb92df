"""Poses from a VRPN server: a fake one, and VRPN's own where it is installed.

``vrpn_server`` is in no package index. Built from vrpn/vrpn and on the PATH, or named by the
environment variable VRPN_SERVER, it is the server of the last test.
"""

from __future__ import annotations

import os
import shutil
import socket
import struct
import subprocess
import threading
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from extensions.room.frames import UPRIGHT
from extensions.room.tests.test_pose_doors import Hands, P, Q, assert_pose, hands, opened
from extensions.room.tests.vrpn_server import (
    VrpnServer,
    described,
    greeting,
    in_pieces,
    message,
    pose,
)
from extensions.room.vrpn_poses import (
    MOST_BYTES,
    MOST_LATE,
    WINDOW,
    ServerClock,
    VrpnError,
    VrpnReader,
)
from tests.notices import raises
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.geometry import so3
from tracker.streaming.connection import StreamError

__all__ = ["hands"]


def test_poses_are_read_from_bytes_in_any_pieces() -> None:
    data = greeting(("VRPN Control", "Wrist")) + pose(1, 0, P, 2 * Q, 100.25)
    data += message(1, 2, bytes(72)) + message(0, 0, b"") + pose(1, 3, -P, -Q) + pose(9, 0, P, Q)
    for sizes in ((1,), (7, 30), (len(data),)):
        first, third, unknown = in_pieces(data, sizes, VrpnReader().poses)
        assert (first.tracker, first.sensor, first.stamp) == ("Wrist", 0, 100.25)
        assert (third.tracker, third.sensor) == ("Wrist", 3)
        assert unknown.tracker == "9", "its sender was not described"
        np.testing.assert_array_equal(first.p, P)
        np.testing.assert_allclose(first.q, Q, atol=1e-12)
        np.testing.assert_allclose(third.q, -Q, atol=1e-12)


@pytest.mark.parametrize(
    "data",
    [
        b"HTTP/1.1 400 Bad Request\r\n\r\n",
        b"vrpn: ver. 06.04  0".ljust(24, b"\0"),
        greeting(()) + struct.pack(">IIIiiI", MOST_BYTES + 1, 0, 0, 0, 0, 0),
        greeting(()) + struct.pack(">IIIiiI", 23, 0, 0, 0, 0, 0),
        greeting(()) + message(0, 1, bytes(20)),
        greeting(()) + message(0, -1, b"\0"),
    ],
)
def test_another_protocols_bytes_are_refused(data: bytes) -> None:
    with pytest.raises(VrpnError):
        VrpnReader().poses(data)


def test_a_sensor_without_a_pose_is_left_out() -> None:
    reader = VrpnReader()
    data = greeting(("Wrist",)) + pose(0, 0, P, np.zeros(4)) + pose(0, 0, [np.nan] * 3, Q)
    assert reader.poses(data) == []
    reader.poses(described(1, -1, "x" * 300) + described(1, -1, "Later"))
    (found,) = reader.poses(pose(1, 0, P, Q))
    assert found.tracker == "Later"


def test_a_server_is_read_and_found_again_after_it_ended(hands: Hands, wait_for) -> None:
    with VrpnServer(("VRPN Control", "Wrist", "Head")) as server:
        options = {"port": server.port, "right": "Wrist", "left": "Wrist:2", "up": "y"}
        with opened(hands, "vrpn", **options) as door:
            wait_for(lambda: server.clients)
            assert server.cookies[0].startswith(b"vrpn: ver. 07.")
            server.send(pose(1, 0, P, Q) + pose(2, 0, -P, Q))
            server.send(pose(1, 2, -P, Q))
            wait_for(lambda: len(hands.poses) == 2)
            assert door.counts().clients == 1
            assert set(door.taker.received()) == {"Wrist", "Wrist:2", "Head"}  # type: ignore[attr-defined]
            server.drop()
            wait_for(lambda: server.clients)
            server.send(pose(1, 0, P, Q))
            wait_for(lambda: len(hands.poses) == 3)
            server.send(struct.pack(">IIIiiI", 3, 0, 0, 0, 0, 0))
            wait_for(lambda: door.counts().refused == 1)
    right, left, again = hands.poses
    q = so3.quat_from_matrix(UPRIGHT @ so3.matrix_from_quat(Q))
    assert (right.side, left.side, again.side) == ("right", "left", "right")
    assert_pose(right, UPRIGHT @ P, q, atol=1e-12)
    assert_pose(left, UPRIGHT @ -P, q, atol=1e-12)
    assert right.t <= right.t_arrival <= monotonic()


def test_a_client_waits_for_its_server(hands: Hands, wait_for) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))  # no process listens
        with opened(hands, "vrpn", port=taken.getsockname()[1], right="any") as door:
            assert door.counts().clients == 0
    with (
        VrpnServer(cookie=b"vrpn: ver. 05.00  0") as old,
        opened(hands, "vrpn", port=old.port, right="any") as door,
    ):
        wait_for(lambda: door.counts().refused > 0)
    assert not hands.poses


def test_bad_addresses_and_axes_are_errors(hands: Hands) -> None:
    with raises(StreamError, "remote.not_started"), opened(hands, "vrpn", server="no such host!"):
        pass
    with raises(ConfigError, "room.unknown_axis"), opened(hands, "vrpn", up="x"):
        pass


def test_instants_are_those_of_the_server() -> None:
    """The extra transit time of a message over the fastest one does not delay its measurement."""
    clock, rng = ServerClock(), np.random.default_rng(2)
    stamps = np.arange(0.0, 30.0, 0.01)
    took = 0.002 + rng.exponential(0.004, len(stamps))
    here = np.array([clock.here(s + 1e9, s + d) for s, d in zip(stamps, took, strict=True)])
    settled = here[100:] - stamps[100:]
    assert np.all(settled >= 0.002 - 1e-6) and np.all(settled < 0.003)


def test_a_server_whose_clock_is_set_is_followed_again() -> None:
    clock = ServerClock()
    assert clock.here(1000.0, 5.0) == 5.0
    assert clock.here(1000.1, 5.12) == pytest.approx(5.1)
    assert clock.here(900.0, 5.2) == 5.2, "set back: the stamp is not believed"
    assert clock.here(900.1, 5.3) == pytest.approx(5.3)
    assert clock.here(2000.0, 5.4) == pytest.approx(5.4), "set forward"
    assert clock.here(2000.0 + 2 * WINDOW, 5.4 + 2 * WINDOW + MOST_LATE / 2) == pytest.approx(
        5.4 + 2 * WINDOW + MOST_LATE / 2
    ), "what was compared long ago is forgotten"
    assert clock.here(float("nan"), 6.0) == 6.0


def _own_server() -> str:
    return os.environ.get("VRPN_SERVER") or shutil.which("vrpn_server") or ""


@pytest.mark.skipif(not _own_server(), reason="VRPN's own server is not installed")
def test_vrpn_s_own_server_is_read(hands: Hands, tmp_path: Path, wait_for) -> None:
    """Its device Spin turns sensors about an axis, here half a turn a second."""
    axis = np.array([0.3, 0.4, 0.5])
    config = tmp_path / "vrpn.cfg"
    config.write_text(
        "vrpn_Tracker_Spin Spin 2 100.0 0.3 0.4 0.5 0.5\nvrpn_Tracker_NULL Rest 1 60\n"
    )
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    server = subprocess.Popen(
        [_own_server(), "-f", str(config), str(port)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        with opened(hands, "vrpn", port=port, right="Spin:1", left="Rest") as door:
            deadline = monotonic() + 60
            while len(hands.poses) < 300 and monotonic() < deadline:
                threading.Event().wait(0.05)
            received = door.taker.received()  # type: ignore[attr-defined]
    finally:
        server.kill()
        server.wait()
    assert set(received) == {"Spin", "Spin:1", "Rest"}
    turning = [p for p in hands.poses if p.side == "right"]
    for p in (p for p in hands.poses if p.side == "left"):
        assert_pose(p, np.zeros(3), [0, 0, 0, 1], atol=1e-12)
    turns = Rotation.from_quat(np.array([p.q_GT for p in turning]))
    steps = (turns[:-1].inv() * turns[1:]).as_rotvec()
    t = np.array([p.t for p in turning])
    np.testing.assert_allclose(np.cross(steps, axis), 0, atol=1e-9)
    speed = np.linalg.norm(steps.sum(axis=0)) / (t[-1] - t[0])
    assert speed == pytest.approx(np.pi, rel=0.02)
