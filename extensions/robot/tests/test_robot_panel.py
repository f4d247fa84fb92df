"""The robot hand in the window: it follows, is recorded, and a replay shows it."""

from __future__ import annotations

import dataclasses
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from extensions.robot.look import Placed, RobotShape
from extensions.robot.window.job import RobotPlayback
from extensions.robot.window.view_model import RobotFigures, RobotView
from tests.gui.gui_fakes import (
    ScriptedEngine,
    ScriptedGlove,
    models,
    scripted_setup,
    with_glove,
    with_live,
)
from tests.notices import shows
from tests.session.conftest import ANCHOR, RESOURCES
from tracker.base.clock import monotonic, seconds
from tracker.glove import library
from tracker.messages import Estimate, Message, RobotModel, RobotState
from tracker.session.description import SessionInfo
from tracker.session.writer import RecorderParams, SessionRecorder

needs_mujoco = pytest.mark.skipif(
    find_spec("mujoco") is None or find_spec("gymnasium_robotics") is None,
    reason="the extra robot is not installed",
)


class Followed(ScriptedEngine):
    """A live hand that a test moves."""

    def __init__(self) -> None:
        super().__init__()
        self.follower = None
        self.recorded: list[Message] = []

    def follow(self, follower) -> None:
        self.follower = follower

    def unfollow(self) -> None:
        self.follower = None

    def record(self, message: Message) -> None:
        self.recorded.append(message)


@pytest.mark.long
@needs_mujoco
def test_a_robot_follows_the_hand_is_recorded_and_holds_when_released(window, qtbot) -> None:
    followed, glove = Followed(), ScriptedGlove()
    felt = glove.vibrated
    setup = with_glove(with_live(scripted_setup(ScriptedEngine()), hand=followed), glove)
    window.host.adopt(setup)
    window.show_panel("robot")
    link, controls = window.panels["robot"].link, window.panels["robot"].controls
    controls.connect_robot.click()
    qtbot.waitUntil(lambda: link.view is not None)
    feed = _Feed(followed, setup.engine.latest_estimate())
    qtbot.waitUntil(lambda: feed() and _state(link) is not None)
    assert not link.view.state.holding
    model = next(m for m in followed.recorded if isinstance(m, RobotModel))
    assert model.name == "shadow_right"
    assert any(isinstance(m, RobotState) for m in followed.recorded)
    window.panels["robot"].refresh(window.host.snapshot())
    assert window.panels["robot"]._drawn is not None
    controls.clutch.click()
    qtbot.waitUntil(lambda: feed() and _state(link).holding)
    assert link.figures.text == "Clutch released: the robot holds its pose"
    window.panels["robot"].refresh(window.host.snapshot())
    assert not controls.clutch.isChecked()
    assert felt == []  # it is in the air
    link._act(_shown(3.0))
    assert [command[0] for command in felt] == [1]  # the index finger's motor
    controls.connect_robot.click()
    assert followed.follower is None and link.view is None


class Process:
    """A substitute for a robot's process: whose it is, and whether it has ended."""

    def __init__(self, settings, hand, names, receive) -> None:
        self.side, self.hand, self.closed, self.missed = settings.side, hand, False, 0

    def feed(self, hand: Estimate, t_arrival: float) -> None: ...

    def close(self) -> None:
        self.closed = True


@needs_mujoco
def test_selecting_the_other_hand_selects_a_robot_of_that_side(window, monkeypatch) -> None:
    made: list[Process] = []

    def make(*given) -> Process:
        made.append(Process(*given))
        return made[-1]

    monkeypatch.setattr("extensions.robot.window.job.RobotProcess", make)
    right, left = Followed(), Followed()
    hand, glove = library.load("vist-small-left")
    setup = with_live(scripted_setup(ScriptedEngine()), hand=right)
    other = dataclasses.replace(with_live(setup, hand=left), hand=hand, glove=glove)
    window.host.adopt(dataclasses.replace(setup, others=(other,)))
    window.panels["robot"].link.switch(True)
    assert made[0].side == "right" and right.follower == made[0].feed
    window.host.show_hand("left")
    assert made[0].closed and right.follower is None
    assert made[1].side == "left" and left.follower == made[1].feed


class _Feed:
    """The next hand, 10 ms after the previous one."""

    def __init__(self, followed: Followed, estimate: Estimate) -> None:
        self._followed, self._estimate = followed, estimate

    def __call__(self) -> bool:
        self._estimate = dataclasses.replace(self._estimate, t=self._estimate.t + 0.01)
        self._followed.follower(self._estimate, monotonic())
        return True


def _state(link) -> RobotState | None:
    return link.view.state if link.view is not None else None


@pytest.mark.long
@needs_mujoco
def test_a_file_without_a_hand_is_reported_and_the_robot_is_off(window, qtbot, tmp_path) -> None:
    wrong = tmp_path / "ball.xml"
    wrong.write_text("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")
    errors: list[str] = []
    window.host.error.connect(errors.append)
    window.panels["robot"].link.change(model=str(wrong))
    window.host.adopt(with_live(scripted_setup(ScriptedEngine()), hand=Followed()))
    window.panels["robot"].controls.connect_robot.click()
    qtbot.waitUntil(lambda: bool(errors))
    assert shows(errors[0], "robot.no_fingers")
    assert not window.panels["robot"].link.on
    assert not window.panels["robot"].controls.connect_robot.isChecked()


def test_settings_are_stored_and_wrong_ones_refused(window) -> None:
    controls, errors = window.panels["robot"].controls, []
    controls.refused.connect(errors.append)
    controls.scale.setValue(2.5)
    controls.gesture.setCurrentIndex(controls.gesture.findData("thumb_up"))
    controls.gesture.activated.emit(controls.gesture.currentIndex())
    stored = window.store.value.robot
    assert (stored["motion_scale"], stored["clutch"]) == (2.5, "thumb_up")
    controls._ask(lambda: window.panels["robot"].link.change(objects="teapot"))
    assert "teapot" in errors[0]


def test_without_mujoco_the_panel_names_the_package_to_install(window, monkeypatch) -> None:
    monkeypatch.setattr("extensions.robot.library.is_there", lambda: False)
    errors: list[str] = []
    window.host.error.connect(errors.append)
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.panels["robot"].controls.connect_robot.click()
    assert shows(errors[0], "robot.needs_mujoco")
    assert not window.panels["robot"].link.on


def _view() -> RobotView:
    """For two points: one of the index fingertip's, one of the palm's."""
    shape = RobotShape(
        np.array([[1.0, 0, 0], [0, 1.0, 0]]), np.array([[1.0, 0, 0], [0, 1.0, 0]]),
        np.array([0, 1]), np.zeros((0, 3), np.int64), np.zeros(0, np.int64),
        np.full((2, 3), 0.5), np.array([1, -1]),
    )  # fmt: skip
    return RobotView(shape, RobotModel(0.0, "claw", (), (), "", "{}"))


def _shown(force: float, **flags: bool) -> RobotState:
    flags = {"engaged": True, "holding": False, **flags}
    felt = np.array([0.0, force, 0, 0, 0])
    return RobotState(
        0.0, "claw", np.zeros(0), np.zeros(0), np.zeros(7), np.zeros((0, 7)), felt, **flags
    )


def test_points_move_with_their_bodies_and_a_pressing_tip_changes_colour() -> None:
    view = _view()
    assert view.draped() is None
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    placed = Placed(np.stack([turn, np.eye(3)]), np.array([[0.0, 0, 5], [0, 0, 0]]))
    view.show(_shown(0.0), placed, 0.001)
    draped = view.draped()
    assert draped.points == pytest.approx(np.array([[0, 1, 5], [0, 1, 0]]))
    assert draped.normals[0] == pytest.approx([0, 1, 0])
    assert (draped.looks[0] == draped.looks[1]).all()
    view.show(_shown(9.0), placed, 0.001)
    looks = view.draped().looks
    assert (looks[0, :3] != looks[1, :3]).any()


@pytest.mark.parametrize(
    ("flags", "text"),
    [
        ({"engaged": False, "holding": True}, "Clutch released"),
        ({"holding": True}, "Hand lost: the robot holds its pose"),
        ({}, "Following · fingertip error 2.0 mm · latency 4 ms (99 %)"),
    ],
)
def test_the_status_line_describes_the_robot(flags, text) -> None:
    view = _view()
    view.show(_shown(0.0, **flags), Placed(np.zeros((2, 3, 3)), np.zeros((2, 3))), 0.002)
    assert RobotFigures.of(True, view, [0.004] * 100, 0).text.startswith(text)


def test_a_replay_shows_the_recorded_robot_at_any_instant(tmp_path: Path) -> None:
    path = _session(tmp_path)
    playback = RobotPlayback.of(path)
    assert playback is not None
    t = [playback.model.t + 0.01 * k for k in range(100)]
    for k in (3, 4, 50, 10, 99, 0):  # on, on, far on, back, to the end, to the beginning
        state = playback.at(t[k] + 0.004)
        assert state is not None and state.command[0] == k
    playback.close()


def _session(tmp_path: Path) -> Path:
    hand, glove, _ = models()
    info = SessionInfo(
        hand, glove, (RESOURCES / "hands" / "reference-right.toml").read_text(),
        (RESOURCES / "gloves" / "vist-small.toml").read_text(), ANCHOR,
    )  # fmt: skip
    start = seconds(ANCHOR.monotonic_ns)
    path = tmp_path / "s.mcap"
    with SessionRecorder(path, info, RecorderParams(sync=False)) as recorder:
        recorder.write(RobotModel(start, "claw", ("a",), (), "", "{}"))
        for k in range(100):
            one = dataclasses.replace(
                _shown(0.0), t=start + 0.01 * k, command=np.array([float(k)]), joints=np.zeros(1)
            )
            recorder.write(one)
    return path
