"""VMT's messages, read as SteamVR's driver does: poses, controls, what is lost."""

from __future__ import annotations

import contextlib
import socket
import threading
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from pythonosc.udp_client import SimpleUDPClient
from scipy.spatial.transform import Rotation

from extensions.applications.tests.hands import GLOVE, HAND, estimates
from extensions.vr.buttons import ButtonGestures
from extensions.vr.tests.openvr_reader import messages, received, skeleton
from extensions.vr.vmt import HELD, VmtDevice, VmtPublisher, driver_version
from tests.notices import raises
from tests.streaming.posed_hand import posed_estimate, side_names
from tests.streaming.recorded_hand import RecordedHand, assert_near, assert_parallel
from tracker.hand.names import FINGERS
from tracker.messages import Tracking
from tracker.simulation.scripted import Key
from tracker.streaming.connection import LOOPBACK
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.registry import STREAMS, StreamSettings, open_streams, with_streams

OPENVR_OF_G = np.array([[0.0, -1, 0], [0, 0, 1], [-1, 0, 0]])  # x right, y up, -z forward
KEYPOINT = {
    1: "wrist",
    **{2 + i: f"thumb_{part}" for i, part in enumerate(("cmc", "mcp", "ip", "tip"))},
    **{
        6 + 5 * k + 1 + i: f"{finger}_{part}"
        for k, finger in enumerate(FINGERS)
        for i, part in enumerate(("mcp", "pip", "dip", "tip"))
    },
    26: "thumb_ip",
    **{27 + k: f"{finger}_dip" for k, finger in enumerate(FINGERS)},
}


@pytest.fixture
def client() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
        out.bind((LOOPBACK, 0))
        out.settimeout(60)
        yield out


def opened(client: socket.socket, names: Names, **options: object) -> Any:
    """The stream as a user enables it."""
    table = {"vmt": True, "vmt_port": client.getsockname()[1]}
    table |= {f"vmt_{key}": value for key, value in options.items()}
    return open_streams(StreamSettings(table), [names])["vmt"][0]


@pytest.mark.parametrize("side", ["right", "left"])
@pytest.mark.parametrize("controller", [False, True])
def test_every_bone_is_where_the_keypoint_is(
    client: socket.socket, side: str, controller: bool
) -> None:
    names = side_names(side)
    out, e = opened(client, names, controller=controller), posed_estimate(names, 3)
    with contextlib.closing(out):
        out.send(e)
        found = received(client)
    device = 57 if side == "right" else 56
    assert found[0][:4] == ["/VMT/Room/Unity", device, 6 if side == "right" else 5, 0.0]
    world = skeleton(found, device)
    assert set(world) == set(range(31))
    for bone, keypoint in KEYPOINT.items():
        k = names.keypoints.index(keypoint)
        p, R = world[bone]
        assert_allclose(p, OPENVR_OF_G @ e.keypoints[k], atol=1e-5)
        G = OPENVR_OF_G @ Rotation.from_quat(e.keypoint_q[k]).as_matrix()
        to_tip, dorsal = G @ [1, 0, 0], G @ [0, 0, 1]
        sign = 1 if side == "left" else -1  # Valve's right bones point backwards
        axes = R.as_matrix().T
        if bone == 1:  # the wrist: z to the fingers, x out of the back on the left hand
            assert_allclose((axes[2], axes[0]), (to_tip, sign * dorsal), atol=1e-5)
        else:
            assert_allclose((axes[0], axes[1]), (sign * to_tip, -sign * dorsal), atol=1e-5)
    assert ["/VMT/Skeleton/Apply", device, 0.0] in found


def test_the_device_has_the_wrists_pose(client: socket.socket, names: Names, make_estimate) -> None:
    """As in Unity: x right, y up, z forward; a flat hand that points ahead has no rotation."""
    out, e = opened(client, names), make_estimate()
    with contextlib.closing(out):
        out.send(e)
        room = received(client)[0]
    x, y, z = e.keypoints[0]
    assert_allclose(room[4:7], [-y, z, x], atol=1e-6)
    turn = Rotation.from_quat(room[7:]).as_rotvec()
    a, b, c = Rotation.from_quat(e.keypoint_q[0]).as_rotvec()
    assert_allclose(turn, [b, -c, -a], atol=1e-5)


def test_a_held_controller_has_valves_offset() -> None:
    """16 cm from the wrist, and the right one is the left one's mirror image."""
    left, right = HELD["left"], HELD["right"]
    assert np.linalg.norm(left.p) == pytest.approx(0.1721, abs=1e-4)
    assert_allclose(right.p, left.p * [-1, 1, 1])
    assert_allclose(right.R, left.R * np.outer([-1, 1, 1], [-1, 1, 1]))


def test_what_is_lost_is_not_sent(client: socket.socket, names: Names, make_estimate) -> None:
    out = opened(client, names)
    with contextlib.closing(out):
        out.send(make_estimate(lost=("index_pip",)))
        bones = {m[2] for m in received(client) if m[0] == "/VMT/Skeleton/Unity"}
        out.send(make_estimate(lost=names.keypoints, tracking=Tracking.LOST))
        nothing = received(client)
    assert set(range(31)) - bones == {8, 9}  # the joint, and the next, which is relative to it
    assert {m[0] for m in nothing}.isdisjoint({"/VMT/Room/Unity", "/VMT/Skeleton/Unity"})


def shown(client: socket.socket, names: Names, gesture: str, **options: object) -> dict[Any, Any]:
    """{(kind, index): value} of the controls while a gesture is made."""
    out = opened(client, names, **options)
    still = [Key(t, gesture, (0.1, 0.0, 0.2)) for t in (0.0, 1.0)]
    with contextlib.closing(out):
        for e in estimates(still)[::5]:
            out.send(e)
            found = received(client)
    return {(m[0].removeprefix("/VMT/Input/"), m[2]): m[4] for m in found if "Input" in m[0]}


def test_gestures_press_buttons(client: socket.socket) -> None:
    names = Names.of(HAND, GLOVE)
    pinch = shown(client, names, "pinch_index")
    assert pinch["Trigger", 0] > 0.6 and pinch["Trigger/Click", 0] == 1
    assert pinch["Button", 1] == pinch["Button", 3] == 0
    a = shown(client, names, "pinch_middle")
    assert a["Button", 1] == 1 and a["Trigger/Click", 0] == 0
    changed = shown(client, names, "pinch_middle", a="", trigger="pinch_middle")
    assert changed["Button", 1] == 0 and changed["Trigger/Click", 0] == 1
    fist = shown(client, names, "fist")
    flat = shown(client, names, "open_palm")
    for finger in range(3, 7):  # how far each finger is curled
        assert fist["Trigger", finger] > 0.6 > 0.3 > flat["Trigger", finger] >= 0.0


def test_closing_turns_the_device_off(client: socket.socket, names: Names) -> None:
    out = opened(client, names)
    out.close()
    (found,) = messages(client.recv(65536))
    assert found[:4] == ["/VMT/Room/Unity", 57, 0, 0.0]
    out.close()


@pytest.mark.parametrize(
    ("words", "code", "values"),
    [
        ("vmt?right=58", "option.range", {"high": 57}),
        ("vmt?grip=clutch", "vr.unknown_gesture", {"name": "clutch"}),
    ],
)
def test_invalid_options_are_refused(
    names: Names, words: str, code: str, values: dict[str, object]
) -> None:
    with raises(StreamError, code, **values):
        open_streams(with_streams(StreamSettings(), words), [names])


def test_a_bundle_fits_the_drivers_buffer(
    client: socket.socket, names: Names, make_estimate
) -> None:
    """oscpack, with which the driver reads, takes 4098 bytes."""
    publisher = VmtPublisher(
        names, VmtDevice(0), ButtonGestures(), LOOPBACK, client.getsockname()[1]
    )
    with contextlib.closing(publisher):
        publisher.send(make_estimate())
        assert len(client.recv(65536)) < 4098
    assert STREAMS.get("vmt").options().port == 39570


def test_a_connection_test_waits_for_the_drivers_heartbeat() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind((LOOPBACK, 0))
        port = probe.getsockname()[1]
    stop = threading.Event()

    def driver() -> None:
        client = SimpleUDPClient(LOOPBACK, port)
        while not stop.wait(0.02):
            client.send_message("/VMT/Out/Log", [0, "hello"])
            client.send_message("/VMT/Out/Alive", ["VMT_015", "C:/VMT"])

    playing = threading.Thread(target=driver)
    playing.start()
    try:
        assert driver_version(port) == "VMT_015"
    finally:
        stop.set()
        playing.join()
    assert driver_version(port, timeout=0.1) is None


def test_without_a_driver_the_port_is_judged(names: Names, make_estimate, client) -> None:
    out = opened(client, names)
    with contextlib.closing(out):
        assert out.probe().code == "stream.test_nothing"
        out.send(make_estimate())
        assert out.probe().code == "stream.test_udp"
        client.close()
        assert out.probe().code == "stream.test_refused"


def test_a_recording_reaches_steamvr(recorded: RecordedHand, client: socket.socket) -> None:
    """As SteamVR adds the bones up: each joint's position, and the wrist's axes."""
    out = opened(client, recorded.names)
    of_G = Rotation.from_matrix(OPENVR_OF_G)
    wrist_axes = Rotation.from_matrix([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])  # z to the fingers
    with contextlib.closing(out):
        for e in recorded.estimates:
            out.send(e)
            world, wanted = skeleton(received(client), 57), recorded.points(e)
            found = np.array([world[bone][0] for bone in KEYPOINT])
            assert_near(found, [OPENVR_OF_G @ wanted[name] for name in KEYPOINT.values()])
            assert_parallel(world[1][1], of_G * recorded.turns(e)["wrist"] * wrist_axes)
