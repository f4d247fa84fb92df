"""The process of the robot; loads MuJoCo."""

from __future__ import annotations

from contextlib import suppress
from multiprocessing.connection import Connection

import numpy as np

from extensions.robot.command import RobotCommand
from extensions.robot.driver import RobotDriver
from extensions.robot.process import Answer, Item, RobotFailed, RobotMoved, RobotReady, RobotShown
from extensions.robot.settings import RobotSettings
from extensions.robot.shape import poses, shape_of
from extensions.robot.teleop import Teleop
from tracker.base.errors import GlovetrackError
from tracker.base.notices import failure
from tracker.base.urgency import run_soon
from tracker.hand.model import HandModel
from tracker.messages import Estimate, RobotState


def serve(
    pipe: Connection, settings: RobotSettings, hand: HandModel, keypoint_names: tuple[str, ...]
) -> None:
    """Main function of the process: runs until it is asked to end or the pipe is closed."""
    run_soon()
    try:
        server = _Server(settings, hand, keypoint_names)
    except GlovetrackError as error:
        pipe.send(RobotFailed(error.notice))
        return
    with suppress(EOFError, OSError, KeyboardInterrupt):
        pipe.send(server.ready)
        while True:
            item: Item = pipe.recv()
            if item is None:
                return
            answer = server.do(item)
            if answer is not None:
                pipe.send(answer)


class _Server:
    """The robot itself."""

    def __init__(
        self, settings: RobotSettings, hand: HandModel, keypoint_names: tuple[str, ...]
    ) -> None:
        self._driver = RobotDriver(Teleop(settings), hand, keypoint_names)
        self._world = self._driver.teleop.world
        self.ready = RobotReady(self._driver.model, shape_of(self._world))

    def do(self, item: Estimate | RobotCommand | RobotState) -> Answer | None:
        if isinstance(item, RobotCommand):
            try:
                self._driver.ask(item)
            except GlovetrackError as error:
                return RobotFailed(error.notice)
            return None
        if isinstance(item, RobotState):
            try:
                self._world.show(item.joints, item.palm, item.objects)
            except ValueError:
                return RobotFailed(failure("robot.recorded_model"))
            return RobotShown(item, poses(self._world))
        outputs = self._driver.feed(item)
        errors = self._driver.teleop.fingers.error
        farthest = float(np.nanmax(errors)) if np.isfinite(errors).any() else float("nan")
        return RobotMoved(outputs, poses(self._world), farthest)
