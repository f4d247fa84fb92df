"""Distance of a robot's fingertips from the targets given by a simulated wearer.

Whether a target is reachable is determined by the same search from many initial poses without a
speed limit: if none comes within `REACHED`, the robot's fingers are too short or bend differently.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from extensions.robot.hand import RobotHand
from extensions.robot.pick_and_place import hand_at, wearer_model
from extensions.robot.retarget import Retargeter
from extensions.robot.settings import RobotSettings
from extensions.robot.teleop import target_map
from tracker.base.clock import monotonic
from tracker.messages import Array
from tracker.simulation.motion import Poses
from tracker.simulation.random_postures import RandomPostures

PACKET = 0.01  # s
REACHED = 0.002  # m
BEGINNINGS = 25  # initial poses per target
EVERY = 10  # hands between two that are checked for reachability


class TipScore(NamedTuple):
    """Score of one wearer: errors_mm (n, 5) of tips, reachable (n, 5), times_ms (n,) per step."""

    errors_mm: Array
    reachable: NDArray[np.bool_]
    times_ms: Array


def tip_score(robot: RobotHand, settings: RobotSettings, seed: int, seconds: float) -> TipScore:
    """Score of a wearer who moves at random for ``seconds``."""
    hand = wearer_model(settings.side)
    t = np.arange(0.0, seconds, PACKET)
    poses = RandomPostures(hand, seed, duration=seconds + 1.0).poses(t)
    fingers, mapped = Retargeter(robot, settings.joint_speed), target_map(robot, 1.0)
    errors, reachable, times = [], [], []
    for k in range(len(t)):
        wearer = hand_at(hand, Poses(*(part[k] for part in poses)), float(t[k]))
        targets, known = mapped.targets(wearer)
        began = monotonic()
        command = fingers.step(targets, known, PACKET)
        times.append(1e3 * (monotonic() - began))
        if k % EVERY == EVERY - 1:
            errors.append(1e3 * np.linalg.norm(fingers.tips(command) - targets, axis=1))
            reachable.append(_reachable(robot, targets, known, command))
    return TipScore(np.array(errors), np.array(reachable), np.array(times))


def _reachable(
    robot: RobotHand, targets: Array, known: NDArray[np.bool_], near: Array
) -> NDArray[np.bool_]:
    """(5,) whether a posture within the joint limits reaches each target."""
    free = Retargeter(robot, joint_speed=1e6)
    free.reset(near)
    best = np.full(len(targets), np.inf)
    for _ in range(BEGINNINGS):
        free.step(targets, known, PACKET)
        best = np.fmin(best, free.error)
        if (best < REACHED).all():
            break
    return np.asarray(best < REACHED)
