"""One trial: a scripted wearer takes a cube that lies somewhere and puts it down elsewhere."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from extensions.robot.command import RESET, RobotCommand
from extensions.robot.picking import LIFT, Picking
from extensions.robot.scene import CUBE
from extensions.robot.teleop import Teleop
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.glove.library import text
from tracker.hand.files import parse_hand
from tracker.hand.model import HandModel
from tracker.messages import Array, RobotState
from tracker.simulation.smooth import rng_for

PACKET = 0.01  # s
NEAR = 0.03  # m from the goal: put down where it should be
Count = Callable[[RobotState, Array, float], None]


class PickTrial(NamedTuple):
    """``placed``: it was lifted, and lies at rest within `NEAR` of its goal."""

    seed: int
    placed: bool
    off_mm: float
    lifted_mm: float


def worn_hand_of(side: str) -> HandModel:
    """The reference hand of a side."""
    name = f"reference-{side}"
    return parse_hand(text("hands", name), name)


def pick_and_place(
    teleop: Teleop,
    seed: int,
    count: Count = lambda state, errors, took: None,
    watch: Callable[[RobotState], None] = lambda state: None,
) -> PickTrial:
    """Within the robot's own scene, which is begun anew. Raises ConfigError without a cube."""
    things = teleop.world.scene.objects
    if "cube" not in things:
        raise ConfigError("To be picked up a cube must be among the objects.")
    rng = rng_for(seed, "pick and place")
    cube = np.array([rng.uniform(0.02, 0.08), rng.uniform(-0.13, -0.07), rng.uniform(-0.4, 0.4)])
    goal = np.array([rng.uniform(0.02, 0.08), rng.uniform(-0.32, -0.26)])
    teleop.command(RobotCommand(RESET))
    teleop.world.place("cube", np.array([cube[0], cube[1], CUBE]), float(cube[2]))
    picking = Picking(worn_hand_of(teleop.settings.side), teleop.hand, cube, goal, seed)
    row, highest = things.index("cube"), 0.0
    for worn in picking.worn(np.arange(0.0, picking.duration, PACKET)):
        began = monotonic()
        state = teleop.feed(worn)
        count(state, teleop.fingers.error, monotonic() - began)
        watch(state)
        highest = max(highest, float(state.objects[row, 2]) - CUBE)
    place = state.objects[row, :3]
    off = float(np.linalg.norm(place[:2] - goal))
    lies = abs(float(place[2]) - CUBE) < 0.01
    done = off < NEAR and lies and highest > 0.5 * LIFT
    return PickTrial(seed, done, 1e3 * off, 1e3 * highest)
