"""Teleoperation of a robot hand: wearer's hands in; joint commands, contacts and states out.

It uses neither clocks nor sockets: each hand carries its time, and the scene is stepped up to it.
The same hands and commands from the same memory give the same states, bit for bit.
"""

from __future__ import annotations

import json
from dataclasses import asdict

import numpy as np
from numpy.typing import NDArray

from extensions.robot.carrier import PalmCarrier
from extensions.robot.command import ENGAGE, RELEASE, SCALE, RobotCommand
from extensions.robot.hand import RobotHand, load_hand
from extensions.robot.retarget import Retargeter
from extensions.robot.scene import TIMESTEP
from extensions.robot.settings import RobotSettings
from extensions.robot.urdf import robot_urdf
from extensions.robot.wearer_hand import FINGERS, WearerHand
from extensions.robot.world import RobotWorld
from tracker.base.clock import nanoseconds, seconds
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array, RobotMemory, RobotModel, RobotState

LONGEST = 0.05  # s simulated at most for one hand: after a gap in the input nothing jumps
NEAR, FAR = 0.020, 0.060  # m between the wearer's tips: full and zero weight of the pinch
TOUCH = 0.013  # m between the wearer's tips when their pads touch
PRESS = 0.003  # m by which the robot's tips then overlap, so that a grip has force


class TargetMap:
    """Maps the wearer's fingertips to targets of the robot's fingertips.

    Each finger's reach from its knuckle is scaled by the ratio of the fingers' lengths. Near a
    pinch, the vector between the two tips is matched instead, so that a pinch of any wearer is a
    pinch of the robot (the vectors of DexPilot, Handa et al. 2020, section IV).

    The robot's fingers are given by knuckle (5, 3) m in P, length (5,) m and radius (5,) m; NaN
    for a finger that it does not have.
    """

    def __init__(self, knuckle: Array, length: Array, radius: Array, scale: float = 1.0) -> None:
        self._knuckle, self._length, self._radius = knuckle, length, radius
        self.scale = scale

    def targets(self, wearer: WearerHand) -> tuple[Array, NDArray[np.bool_]]:
        """Targets (5, 3) m in P, and which of them are known (5,)."""
        known = wearer.known & np.isfinite(self._length)
        share = self.scale * self._length / wearer.length
        tips = self._knuckle + share[:, None] * (wearer.tip - wearer.knuckle)
        if known[0]:
            self._close(tips, wearer, known)
        return tips, known

    def _close(self, tips: Array, wearer: WearerHand, known: NDArray[np.bool_]) -> None:
        """Match the distance of thumb and fingers that are near each other to the wearer's."""
        weights, errors = np.zeros(len(FINGERS)), np.zeros((len(FINGERS), 3))
        for f in range(1, len(FINGERS)):
            if not known[f]:
                continue
            gap = wearer.tip[f] - wearer.tip[0]
            distance = float(np.linalg.norm(gap))
            weights[f] = np.clip((FAR - distance) / (FAR - NEAR), 0.0, 1.0)
            touch = self._radius[f] + self._radius[0] - PRESS
            wanted = touch + max(distance - TOUCH, 0.0)
            errors[f] = tips[f] - tips[0] - gap * (wanted / max(distance, 1e-6))
        thumb = weights @ errors / (1.0 + weights.sum())
        tips[0] += thumb
        tips[1:] -= weights[1:, None] * (errors[1:] - thumb)


class Teleop:
    """One robot hand in its scene."""

    def __init__(self, settings: RobotSettings, hand: RobotHand | None = None) -> None:
        """Raises ConfigError if the hand does not exist."""
        self.settings = settings
        self.hand = hand or load_hand(settings)
        self.world = RobotWorld(self.hand, settings)
        self.fingers = Retargeter(self.hand, settings.joint_speed)
        self.carrier = PalmCarrier(settings)
        self._map = target_map(self.hand, settings.reach_scale)
        self._scale = settings.motion_scale
        self._engaged = True
        self._stamp = -1  # ns, time of the last hand, in the resolution of recordings
        self._owed = 0.0  # s that the scene lags behind
        self.world.reset(self.carrier.R, self.carrier.p)

    @property
    def model(self) -> RobotModel:
        """Description of the robot for recordings."""
        return RobotModel(
            seconds(self._stamp),
            self.hand.name,
            self.hand.joint_names,
            self.world.scene.objects,
            robot_urdf(self.hand),
            json.dumps(asdict(self.settings), sort_keys=True),
        )

    def command(self, command: RobotCommand) -> None:
        """Execute a command before the next hand. Raises ConfigError if it is unknown."""
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
        """Whether the robot follows the wearer; otherwise it holds its pose."""
        return self._engaged

    def feed(self, wearer: WearerHand) -> RobotState:
        """Step to the time of the next hand. Lost or released, the robot holds its pose."""
        dt = self._elapsed(wearer.t)
        holding = not (self._engaged and wearer.located)
        if holding:
            self.carrier.let_go()  # it continues from its position without a jump
        else:
            self.carrier.step(wearer, self._scale, dt)
            targets, known = self._map.targets(wearer)
            self.fingers.step(targets, known, dt)
        force = self._advance(dt)
        return RobotState(
            wearer.t, self.hand.name, self.fingers.angles.copy(), self.world.angles,
            self.world.palm(), self.world.objects(), force, self._engaged, holding,
        )  # fmt: skip

    def _elapsed(self, t: float) -> float:
        """s since the last hand, 0 for the first; at most `LONGEST`."""
        before, self._stamp = self._stamp, nanoseconds(t)
        return min(max(seconds(self._stamp - before), 0.0), LONGEST) if before >= 0 else 0.0

    def _advance(self, dt: float) -> Array:
        self._owed += dt
        steps = int(self._owed / TIMESTEP + 1e-6)
        self._owed -= steps * TIMESTEP
        return self.world.step(self.carrier.R, self.carrier.p, self.fingers.angles, steps)

    @property
    def memory(self) -> RobotMemory:
        """Everything that the next step depends on."""
        own = [self._stamp, self._owed, self._scale, float(self._engaged)]
        parts = [np.array(own), self.carrier.memory, self.fingers.memory, self.world.memory]
        return RobotMemory(seconds(self._stamp), self.hand.name, np.concatenate(parts))

    def remember(self, memory: RobotMemory) -> None:
        """Continue from a stored state. Raises ConfigError if it belongs to another robot."""
        values, k = memory.values, 4
        carrier, fingers = len(self.carrier.memory), len(self.fingers.memory)
        try:
            self.world.remember(values[k + carrier + fingers :].copy())
            self.fingers.remember(values[k + carrier : k + carrier + fingers])
            self.carrier.remember(values[k : k + carrier])
        except (ValueError, IndexError) as error:
            raise ConfigError(notice("robot.recorded_other", why=error)) from error
        self._stamp = int(values[0])
        self._owed, self._scale = float(values[1]), float(values[2])
        self._engaged = bool(values[3])


def target_map(hand: RobotHand, scale: float) -> TargetMap:
    """The map onto the fingers of a robot hand."""
    knuckle = np.full((len(FINGERS), 3), np.nan)
    length, radius = np.full(len(FINGERS), np.nan), np.full(len(FINGERS), np.nan)
    for finger in hand.anatomy.fingers:
        row = FINGERS.index(finger.name)
        knuckle[row], length[row], radius[row] = finger.knuckle, finger.length, finger.radius
    return TargetMap(knuckle, length, radius, scale)
