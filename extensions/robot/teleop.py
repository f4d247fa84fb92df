"""A robot hand that follows a wearer's: hands in, joint commands, contacts and states out.

It knows neither clocks nor sockets: each hand brings its time, and the scene is stepped up to it.
Fed with the same hands and commands from the same memory it does the same to the last bit.
"""

from __future__ import annotations

import json
from dataclasses import asdict

import numpy as np

from extensions.robot.carrier import PalmCarrier
from extensions.robot.command import ENGAGE, RELEASE, SCALE, RobotCommand
from extensions.robot.hand import RobotHand, load_hand
from extensions.robot.retarget import Retargeter
from extensions.robot.scene import TIMESTEP
from extensions.robot.settings import RobotSettings
from extensions.robot.targets import TargetMap
from extensions.robot.urdf import robot_urdf
from extensions.robot.world import RobotWorld
from extensions.robot.worn import FINGERS, WornHand
from tracker.base.clock import nanoseconds, seconds
from tracker.base.errors import ConfigError
from tracker.messages import Array, RobotMemory, RobotModel, RobotState

LONGEST = 0.05  # s that the scene goes on at most for one hand: after a gap it does not leap


class Teleop:
    """One robot hand in its scene."""

    def __init__(self, settings: RobotSettings, hand: RobotHand | None = None) -> None:
        """Raises ConfigError in words where there is no such hand."""
        self.settings = settings
        self.hand = hand or load_hand(settings)
        self.world = RobotWorld(self.hand, settings)
        self.fingers = Retargeter(self.hand, settings.joint_speed)
        self.carrier = PalmCarrier(settings)
        self._map = target_map(self.hand, settings.reach_scale)
        self._scale = settings.motion_scale
        self._engaged = True
        self._stamp = -1  # ns, of the last hand: what recordings keep of a time
        self._owed = 0.0  # s that the scene is behind
        self.world.reset(self.carrier.R, self.carrier.p)

    @property
    def model(self) -> RobotModel:
        """What it is, for recordings."""
        return RobotModel(
            seconds(self._stamp),
            self.hand.name,
            self.hand.joint_names,
            self.world.scene.objects,
            robot_urdf(self.hand),
            json.dumps(asdict(self.settings), sort_keys=True),
        )

    def command(self, command: RobotCommand) -> None:
        """Do what is asked, before the next hand. Raises ConfigError for what is not known."""
        command.check()
        if command.word == ENGAGE:
            self._engaged = True
            self.carrier.let_go()
        elif command.word == RELEASE:
            self._engaged = False
        elif command.word == SCALE:
            self._scale = command.value
            self.carrier.let_go()
        else:
            self.carrier.reset()
            self.fingers.reset()
            self.world.reset(self.carrier.R, self.carrier.p)

    @property
    def engaged(self) -> bool:
        """Whether it follows; else it holds."""
        return self._engaged

    def feed(self, worn: WornHand) -> RobotState:
        """One hand more, later than the one before. Lost or released, the robot holds as it is."""
        dt = self._elapsed(worn.t)
        holding = not (self._engaged and worn.located)
        if holding:
            self.carrier.let_go()  # it goes on from where it stands, not with a leap
        else:
            self.carrier.step(worn, self._scale, dt)
            targets, known = self._map.targets(worn)
            self.fingers.step(targets, known, dt)
        force = self._advance(dt)
        return RobotState(
            worn.t, self.hand.name, self.fingers.angles.copy(), self.world.angles,
            self.world.palm(), self.world.objects(), force, self._engaged, holding,
        )  # fmt: skip

    def _elapsed(self, t: float) -> float:
        """s since the last hand, 0 of the first; at most `LONGEST`."""
        before, self._stamp = self._stamp, nanoseconds(t)
        return min(max(seconds(self._stamp - before), 0.0), LONGEST) if before >= 0 else 0.0

    def _advance(self, dt: float) -> Array:
        self._owed += dt
        steps = int(self._owed / TIMESTEP + 1e-6)
        self._owed -= steps * TIMESTEP
        return self.world.step(self.carrier.R, self.carrier.p, self.fingers.angles, steps)

    @property
    def memory(self) -> RobotMemory:
        """All that the next step depends on."""
        own = [self._stamp, self._owed, self._scale, float(self._engaged)]
        parts = [np.array(own), self.carrier.memory, self.fingers.memory, self.world.memory]
        return RobotMemory(seconds(self._stamp), self.hand.name, np.concatenate(parts))

    def remember(self, memory: RobotMemory) -> None:
        """Go on from there. Raises ConfigError where it is not this robot's."""
        values, k = memory.values, 4
        carrier, fingers = len(self.carrier.memory), len(self.fingers.memory)
        try:
            self.world.remember(values[k + carrier + fingers :].copy())
            self.fingers.remember(values[k + carrier : k + carrier + fingers])
            self.carrier.remember(values[k : k + carrier])
        except (ValueError, IndexError) as error:
            raise ConfigError(f"The recorded robot is another one: {error}.") from error
        self._stamp = int(values[0])
        self._owed, self._scale = float(values[1]), float(values[2])
        self._engaged = bool(values[3])


def target_map(hand: RobotHand, scale: float) -> TargetMap:
    """Onto the fingers of a robot hand."""
    knuckle = np.full((len(FINGERS), 3), np.nan)
    length, radius = np.full(len(FINGERS), np.nan), np.full(len(FINGERS), np.nan)
    for finger in hand.anatomy.fingers:
        row = FINGERS.index(finger.name)
        knuckle[row], length[row], radius[row] = finger.knuckle, finger.length, finger.radius
    return TargetMap(knuckle, length, radius, scale)
