"""The dialog *Room tracker* in the real window, with sources that are simulated."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pythonosc.udp_client import SimpleUDPClient

from app.viewmodels.states import BAD, WARN
from app.window.main_window import MainWindow
from extensions.osc.vmc_pose import unity_pose
from extensions.room import alignment_file
from extensions.room.alignment import AlignmentError
from extensions.room.osc_poses import NO_ROTATION, RoomPose
from extensions.room.taker import ReceivedPoses
from extensions.room.tests.test_alignment import DELAY, IN_PLACE, TRUE, errors
from extensions.room.tests.turning import Turning
from extensions.room.tests.vrpn_server import VrpnServer, pose
from extensions.room.window import align_box
from extensions.room.window.align_box import GuidedMovement, MovementPhase
from extensions.room.window.dialog import RoomDialog
from extensions.room.window.listening import Listened, tracker_lines, verdict
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup
from tests.notices import raises, shows
from tracker.geometry import so3
from tracker.messages import ImuSample, WristPose
from tracker.simulation.scenario import Simulation

PATIENCE_MS = 60_000  # on a loaded computer
LASTS = align_box.STILL_S + align_box.TURN_S + 0.6


class Clock:
    """The clock of the doors and of the dialog."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


class TurnedHand(ScriptedEngine):
    """A glove whose wearer makes the movement of an alignment; takes the poses of a tracker."""

    def __init__(self, clock: Clock) -> None:
        super().__init__()
        self._clock = clock
        hand, glove, _ = models()
        motion = Turning(len(hand.joint_names), LASTS)
        self.sim = Simulation(hand, glove, motion, 3, IN_PLACE)
        self._samples = list(self.sim.imu_samples())
        self.placed: list[WristPose] = []

    def recent_imu(self) -> list[ImuSample]:
        return [s for s in self._samples if s.t_arrival <= self._clock.now]

    def place(self, pose: object) -> None:
        assert isinstance(pose, WristPose)
        self.placed.append(pose)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    made = Clock()
    for module in ("doors", "taker", "window.align_box"):
        monkeypatch.setattr(f"extensions.room.{module}.monotonic", made)
    return made


@pytest.fixture
def dialog(window: MainWindow, tmp_path: Path) -> RoomDialog:
    window.run_command("room_tracker")
    found = window.set_up.dialogs["room_tracker"]
    assert isinstance(found, RoomDialog) and found.isVisible()
    return found


def choose(dialog: RoomDialog, name: str) -> None:
    index = dialog.source.findData(name)
    dialog.source.setCurrentIndex(index)
    dialog.source.activated.emit(index)


def outcome(dialog: RoomDialog, qtbot) -> str:
    dialog.test.click()
    qtbot.waitUntil(dialog.test.isEnabled, timeout=PATIENCE_MS)
    return dialog.outcome.text()


def switched_on(dialog: RoomDialog, window: MainWindow, qtbot) -> int:
    """The port."""
    if not dialog.on.isChecked():
        dialog.on.click()
    qtbot.waitUntil(lambda: window.remote.door(dialog.name) is not None, timeout=PATIENCE_MS)
    door = window.remote.door(dialog.name)
    assert door is not None
    return door.port


def test_a_source_is_chosen_tested_and_its_trackers_are_offered(
    dialog: RoomDialog, window: MainWindow, qtbot
) -> None:
    assert dialog.source.count() == 4
    choose(dialog, "vrpn")
    with VrpnServer(("VRPN Control", "Wrist", "Head")) as server:
        dialog.form.fields["port"].setValue(server.port)  # type: ignore[attr-defined]
        dialog.form.fields["up"].setCurrentText("y")  # type: ignore[attr-defined]
        dialog.test.click()
        assert not dialog.test.isEnabled()
        qtbot.waitUntil(lambda: server.clients == 1, timeout=PATIENCE_MS)

        def has_received() -> bool:
            server.send(pose(1, 0, [0, 0, 0], [0, 0, 0, 1]) + pose(2, 0, [0, 0, 1], [0, 0, 0, 1]))
            return dialog.test.isEnabled()

        qtbot.waitUntil(has_received, timeout=PATIENCE_MS)
        text = dialog.outcome.text()
        assert WARN.colour in text and shows(text, "room.test_unnamed", count=2)
        assert "Wrist: " in text and "Head: " in text
        combo = dialog.form.trackers["right"]
        assert combo.findText("Wrist") > 0 and combo.findText("Head") > 0
        combo.setCurrentText("Wrist")
        switched_on(dialog, window, qtbot)
    options = window.remote.settings.options(window.remote.kinds["vrpn"])
    assert (options.port, options.up, options.right) == (server.port, "y", "Wrist")
    assert window.store.value.remote["vrpn_right"] == "Wrist", "as live tracking uses it"


def test_the_test_reports_missing_data(
    dialog: RoomDialog, window: MainWindow, qtbot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("extensions.room.window.listening.LISTEN_S", 0.3)
    choose(dialog, "vrpn")
    with VrpnServer() as server:
        port = server.port
    dialog.form.fields["port"].setValue(port)  # type: ignore[attr-defined]
    text = outcome(dialog, qtbot)
    assert BAD.colour in text and shows(text, "room.test_no_connection")
    choose(dialog, "room")
    dialog.form.fields["port"].setValue(free_port())  # type: ignore[attr-defined]
    assert shows(outcome(dialog, qtbot), "room.test_nothing")
    dialog.on.click()
    qtbot.waitUntil(lambda: window.remote.door("room") is not None, timeout=PATIENCE_MS)
    assert shows(outcome(dialog, qtbot), "room.test_nothing"), "at the open one"
    assert window.remote.is_on("room") and not window.remote.is_on("vrpn")


def free_port() -> int:
    import socket

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("127.0.0.1", 0))
        port: int = sock.getsockname()[1]
        return port


@pytest.mark.long
def test_the_guided_movement_aligns_the_tracker_and_live_tracking_uses_it(
    dialog: RoomDialog, window: MainWindow, clock: Clock, qtbot
) -> None:
    """As Virtual Motion Capture sends a tracker of SteamVR, while the hand turns for 17 s."""
    assert not dialog.align.start_button.isEnabled(), "no glove is there"
    engine = TurnedHand(clock)
    window.host.adopt(scripted_setup(engine))
    qtbot.waitUntil(dialog.align.start_button.isEnabled, timeout=PATIENCE_MS)
    dialog.form.fields["port"].setValue(free_port())  # type: ignore[attr-defined]
    dialog.align.start_button.click()
    assert "Switch the source on" in dialog.align.words.text()
    port = switched_on(dialog, window, qtbot)
    dialog.align.start_button.click()
    assert dialog.align.words.text() == "Choose the tracker on this hand first."
    dialog.form.trackers["right"].setCurrentText("LHR-1")
    dialog.form.apply()
    qtbot.waitUntil(lambda: window.remote.door("room") is not None, timeout=PATIENCE_MS)
    with SimpleUDPClient("127.0.0.1", port) as client:
        dialog.align.start_button.click()
        assert not dialog.align.start_button.isEnabled()
        assert "hold the hand still" in dialog.align.words.text()
        send_movement(engine, clock, client, dialog, window)
        qtbot.waitUntil(dialog.align.save_button.isEnabled, timeout=PATIENCE_MS)
        words = dialog.align.words.text()
        assert "agree within" in words and "mm from the wrist" in words
        dialog.align.save_button.click()
        path = Path(window.remote.settings.options(window.remote.kinds["room"]).alignment)
        (found,) = alignment_file.read(path).values()
        mm, degrees = errors(found)
        assert mm < 5.0 and degrees < 3.0
        assert found.delay == pytest.approx(DELAY, abs=0.006)
        qtbot.waitUntil(lambda: window.remote.door("room") is not None, timeout=PATIENCE_MS)
        engine.placed.clear()
        send(client, TRUE.pose(engine.sim, 5.0, np.random.default_rng(1)))
        qtbot.waitUntil(lambda: bool(engine.placed), timeout=PATIENCE_MS)
    np.testing.assert_allclose(engine.placed[0].p_BT, found.p_BT, atol=1e-8)
    assert engine.placed[0].t == pytest.approx(clock.now - found.delay, abs=1e-6)


def send(client: SimpleUDPClient, true: WristPose) -> None:
    p, q = unity_pose(true.p_GT, true.q_GT)
    client.send_message("/VMC/Ext/Tra/Pos", ["LHR-1", *map(float, p), *map(float, q)])


def send_movement(
    engine: TurnedHand,
    clock: Clock,
    client: SimpleUDPClient,
    dialog: RoomDialog,
    window: MainWindow,
) -> None:
    """Each pose arrives `DELAY` after it was measured."""
    door = window.remote.door("room")
    taker = door.taker  # type: ignore[union-attr]
    for k, true in enumerate(replace(TRUE, rate=60.0).poses(engine.sim)):
        clock.now = true.t + DELAY
        send(client, true)
        while taker.received().get("LHR-1", ReceivedPoses(0, True)).count <= k:
            pass
        if k % 12 == 0:
            dialog.align.tick()
    clock.now = LASTS
    dialog.align.tick()


# ---- what a movement is made of


def guided_with(name: str) -> GuidedMovement:
    hand, glove, _ = models()
    run = GuidedMovement(hand, glove, name, 0.02)
    run.start(10.0)
    return run


def test_a_movement_without_packets_or_poses_is_refused() -> None:
    hand, glove, _ = models()
    sim = Simulation(hand, glove, Turning(len(hand.joint_names), 1.0), 3, IN_PLACE)
    packets = [replace(s, t=s.t + 10.0) for s in sim.imu_samples()]
    run = guided_with("a")
    with raises(AlignmentError, "room.no_packets"):
        run.moved()
    run.tick(10.5, packets)
    run.pose(RoomPose("b", np.zeros(3), np.array([0, 0, 0, 1.0])), 10.4)
    with raises(AlignmentError, "room.not_received"):
        run.moved()
    run.pose(RoomPose("a", np.zeros(3), NO_ROTATION), 10.4)
    with raises(AlignmentError, "room.only_positions"):
        run.moved()
    for t in (10.5, 10.5, 10.6):
        run.pose(RoomPose("a", np.array([t, 0, 0]), so3.quat_from_matrix(np.eye(3))), t)
    run.tick(10.6, packets)
    moved = run.moved()
    np.testing.assert_allclose(moved.t_T, [10.48, 10.58])
    np.testing.assert_allclose(moved.p_WT[:, 0], [10.5, 10.6])
    assert len(moved.t_B) and np.all(np.diff(moved.t_B) > 0), "packets are not taken twice"


def test_each_kind_of_turn_is_asked_for() -> None:
    run, said = guided_with("a"), []
    for t in np.arange(10.0, 30.0, 0.5):
        run.tick(float(t), [])
        said += [run.words(float(t))] if run.phase != MovementPhase.DONE else []
    assert len(dict.fromkeys(said)) == 4 and run.phase == MovementPhase.DONE and run.share == 1.0


def test_the_verdict_names_what_to_do() -> None:
    one = Listened(
        "x", 2.0, {"a": ReceivedPoses(180, True), "b": ReceivedPoses(20, False)}, 0, None
    )
    none = replace(one, trackers={})
    assert verdict(one, {"right": "a"}).code == "room.test_received"
    assert verdict(one, {"right": "any", "left": ""}).code == "room.test_received"
    assert verdict(one, {"right": "a", "left": "c"}).code == "room.test_missing"
    assert verdict(one, {}).code == "room.test_unnamed"
    assert verdict(none, {}).code == "room.test_nothing"
    assert verdict(replace(none, unreadable=3), {}).code == "room.test_unreadable"
    assert verdict(replace(none, connected=False), {}).code == "room.test_no_connection"
    lines = tracker_lines(one)
    assert "90" in lines[0] and "without rotation" in lines[1]
    many = replace(one, trackers={f"t{k:02}": ReceivedPoses(20, True) for k in range(20)})
    assert len(tracker_lines(many)) == 13
