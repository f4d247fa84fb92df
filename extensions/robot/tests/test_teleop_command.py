"""A session drives a robot, which is recorded, and driven again to the last bit."""

from __future__ import annotations

import json
import socket
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from extensions.robot.command import RobotCommand
from extensions.robot.driver import RobotDriver
from extensions.robot.settings import RobotSettings
from extensions.robot.teleop import Teleop
from extensions.robot.teleop_command import follow_stream
from extensions.robot.teleop_run import DriveFigures, drive_again
from extensions.robot.tests.hands import wearer_model
from tests.notices import raises, shows
from tracker.base.clock import ClockAnchor, seconds
from tracker.cli import main
from tracker.geometry import so3
from tracker.glove.files import load_glove
from tracker.messages import Estimate, RobotState, Tracking, Validity
from tracker.session.decode_robot import read_robot, robot_names
from tracker.session.description import SessionInfo
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder
from tracker.simulation.gestures import FIST
from tracker.simulation.postures import posture
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.websocket import WebSocketPublisher

RESOURCES = Path(__file__).parents[3] / "resources"
ANCHOR = ClockAnchor(wall_ns=1_760_000_000_123_456_789, monotonic_ns=5_000_000_321)
GLOVE = RESOURCES / "gloves" / "vist-small.toml"


def info() -> SessionInfo:
    hand = wearer_model()
    hand_text = (RESOURCES / "hands" / "reference-right.toml").read_text()
    return SessionInfo(hand, load_glove(GLOVE, hand), hand_text, GLOVE.read_text(), ANCHOR)


def estimates(n: int) -> list[Estimate]:
    """A hand that closes while it moves sideways, lost for some time; stamps between two ns."""
    about = info()
    hand, glove = about.hand, about.glove
    names = glove.keypoint_names(hand)
    out = []
    for k in range(n):
        angles = min(k / 100, 1.0) * posture(hand, FIST)
        R, p = hand.forward(angles, so3.rz(0.003 * k), np.array([0.1, 0.001 * k, 0.3]))
        scale = np.ones((len(hand.segments), 3))
        state = np.full(len(names), int(Validity.MEASURED))
        one = Estimate(
            seconds(ANCHOR.monotonic_ns) + k * 0.0100000003, Tracking.TRACKING,
            glove.keypoint_positions(hand, R, p, scale),
            so3.quat_from_matrix(R[glove.keypoint_segments(hand)]), state,
            np.full(len(names), 0.002), angles, np.full(len(angles), 2), R, p,
        )  # fmt: skip
        lost = 60 <= k < 80
        out.append(replace(one, tracking=Tracking.LOST) if lost else one)
    return out


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("teleop") / "s.mcap"
    with SessionRecorder(path, info(), RecorderParams(sync=False)) as recorder:
        for estimate in estimates(150):
            recorder.write(estimate)
    return path


@pytest.mark.long
def test_a_session_drives_a_robot_and_the_new_session_contains_both(
    session: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "with.mcap"
    assert main(["teleop", str(session), "-o", str(out), "--json", "-"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["hands"] == 150
    assert report["holding_percent"] == pytest.approx(100 * 20 / 150)
    assert report["within_5_mm_percent"] > 50  # a fist is more than this robot's thumb can do
    with SessionReader(session) as before, SessionReader(out) as after:
        assert robot_names(before) == () and robot_names(after) == ("shadow_right",)
        assert before.topic_names < after.topic_names
        stored = [list(r.messages((Estimate,))) for r in (before, after)]
        assert len(stored[0]) == len(stored[1]) == 150
    assert main(["teleop", str(out), "--check"]) == 0
    assert "150 states" not in capsys.readouterr().out  # the first is the one it remembers
    assert drive_again(out).compared == 149


def test_a_recorded_drive_with_commands_is_repeated_exactly(tmp_path: Path) -> None:
    """With clutch, scale and reset as during the drive, and with hands that were not seen."""
    about = info()
    driver = RobotDriver(
        Teleop(RobotSettings()), about.hand, about.glove.keypoint_names(about.hand)
    )
    path = tmp_path / "live.mcap"
    with SessionRecorder(path, about, RecorderParams(sync=False)) as recorder:
        for k, estimate in enumerate(estimates(150)):
            recorder.write(estimate)
            if k % 7 == 3:
                continue  # it came too late for the robot
            word = {30: "release", 45: "engage", 50: "scale", 120: "reset"}.get(k)
            if word:
                driver.ask(RobotCommand(word, 0.5))
            for message in driver.feed(estimate):
                recorder.write(message)
    again = drive_again(path)
    assert again.compared > 120
    assert again.different == 0
    with SessionReader(path) as reader:
        states = [m for m in read_robot(reader, "shadow_right") if hasattr(m, "joints")]
    assert {s.engaged for s in states} == {True, False}


def test_a_changed_record_of_a_robot_is_detected(session: Path, tmp_path: Path) -> None:
    about = info()
    driver = RobotDriver(
        Teleop(RobotSettings()), about.hand, about.glove.keypoint_names(about.hand)
    )
    path = tmp_path / "changed.mcap"
    with SessionRecorder(path, about, RecorderParams(sync=False)) as recorder:
        for k, estimate in enumerate(estimates(50)):
            recorder.write(estimate)
            for message in driver.feed(estimate):
                if k == 40 and hasattr(message, "joints"):
                    message = replace(message, joints=np.nextafter(message.joints, 9.0))
                recorder.write(message)
    assert drive_again(path).different == 1
    assert main(["teleop", str(path), "--check"]) == 1


def followed(
    address: str,
    send: Callable[[Estimate], None],
    seconds: float = 0.7,
    watch: Callable[[RobotState], None] = lambda state: None,
) -> list[RobotState]:
    """The output of a robot that follows ``address``, to which a hand is sent continuously."""
    figures, states, ended = DriveFigures(), [], threading.Event()

    def see(state: RobotState) -> None:
        states.append(state)
        watch(state)

    def go_on() -> None:
        k, shown = 0, estimates(50)
        while not ended.wait(0.01):
            send(replace(shown[k % 50], t=10.0 + 0.01 * k))
            k += 1

    driver, sender = RobotDriver(Teleop(RobotSettings())), threading.Thread(target=go_on)
    sender.start()
    try:
        follow_stream(driver, address, seconds, figures, see)
    finally:
        ended.set()
        sender.join()
    assert len(states) == len(figures.times_ms)
    return states


def test_a_live_stream_by_udp_drives_a_robot() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    names = Names.of(info().hand, info().glove)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:

        def send(estimate: Estimate) -> None:
            out.sendto(b"not a hand", ("127.0.0.1", port))
            out.sendto(to_json(estimate, names).encode(), ("127.0.0.1", port))

        states = followed(str(port), send)
    assert len(states) > 3 and not any(state.holding for state in states)


def test_a_live_stream_by_websocket_drives_a_robot_until_it_ends() -> None:
    server = WebSocketPublisher(Names.of(info().hand, info().glove), port=0)
    address = f"ws://127.0.0.1:{server.port}"

    def send(estimate: Estimate) -> None:
        with suppress(StreamError):  # the robot's first state closes the server meanwhile
            server.send(estimate)

    states = followed(address, send, 0.0, lambda state: server.close())
    assert states and not any(state.holding for state in states)
    with raises(StreamError, "stream.no_connection"):
        follow_stream(RobotDriver(Teleop(RobotSettings())), address, 0.0, DriveFigures(), print)


def test_contradictory_arguments_are_errors(
    session: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["teleop"]) == 1
    assert shows(capsys.readouterr().err, "option.exactly_one")
    assert main(["teleop", str(session), "--check"]) == 1
    assert shows(capsys.readouterr().err, "robot.not_recorded")
    assert main(["teleop", "--listen", "somewhere"]) == 1
    assert shows(capsys.readouterr().err, "teleop.address", address="somewhere")
    assert main(["teleop", str(session), "--objects", "teapot"]) == 1
    assert "teapot" in capsys.readouterr().err
