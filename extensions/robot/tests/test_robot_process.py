"""The robot's own process: the newest hand counts, and its end is reported."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Callable

import numpy as np

from extensions.robot.command import RobotCommand
from extensions.robot.process import Answer, RobotFailed, RobotMoved, RobotProcess, RobotReady
from extensions.robot.settings import RobotSettings
from extensions.robot.tests.hands import wearer_model
from tracker.messages import Estimate, RobotState, Tracking

PATIENCE = 60.0  # s, for a process that is starting on a loaded machine


class Received:
    """The replies of a robot, and how long to wait for a condition."""

    def __init__(self) -> None:
        self.answers: list[Answer] = []
        self._new = threading.Condition()

    def __call__(self, answer: Answer, took: float) -> None:
        with self._new:
            self.answers.append(answer)
            self._new.notify_all()

    def until(self, fact: Callable[[], bool]) -> bool:
        with self._new:
            return self._new.wait_for(fact, PATIENCE)

    @property
    def states(self) -> list[RobotState]:
        outputs = [m for a in self.answers if isinstance(a, RobotMoved) for m in a.outputs]
        return [m for m in outputs if isinstance(m, RobotState)]


def estimate(t: float) -> Estimate:
    hand = wearer_model()
    n, angles = len(hand.keypoint_names), np.zeros(len(hand.joint_names))
    R, p = hand.forward(angles, np.eye(3), np.array([0.0, 0.0, 0.3]))
    return Estimate(
        t, Tracking.TRACKING, hand.keypoints(R, p), np.tile([0.0, 0, 0, 1], (n, 1)),
        np.full(n, 2), np.full(n, 0.002), angles, np.full(len(angles), 2), R, p,
    )  # fmt: skip


def test_the_newest_hand_is_used_after_commands_and_a_sudden_end_is_reported() -> None:
    receive, hand = Received(), wearer_model()
    robot = RobotProcess(RobotSettings(objects=""), hand, hand.keypoint_names, receive)
    try:
        for k in range(50):  # before it has started: one of them is stored
            robot.feed(estimate(0.01 * k), time.monotonic())
        assert receive.until(lambda: len(receive.answers) > 1)
        assert isinstance(receive.answers[0], RobotReady)
        assert receive.states[0].t == 0.49
        assert robot.missed == 49
        robot.ask(RobotCommand("release"))
        robot.feed(estimate(0.5), time.monotonic())
        assert receive.until(lambda: receive.states[-1].t == 0.5)
        assert not receive.states[-1].engaged
        os.kill(robot.pid, signal.SIGKILL)
        assert receive.until(lambda: isinstance(receive.answers[-1], RobotFailed))
        robot.feed(estimate(0.6), time.monotonic())
    finally:
        robot.close()
    assert not [t for t in threading.enumerate() if t.name == "glovetrack-robot"]


def test_a_starting_robot_is_ended_without_waiting_for_it() -> None:
    hand, receive = wearer_model(), Received()
    robot = RobotProcess(RobotSettings(), hand, hand.keypoint_names, receive)
    robot.close()
    assert receive.answers == []
    robot.close()
