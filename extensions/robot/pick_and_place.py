"""A scripted wearer grasps a cube with three fingers, carries it and puts it down elsewhere.

The postures of the reference hand are solved so that the robot's fingertips surround the cube. The
hand sways and misses its target by a few millimetres.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import accumulate
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from extensions.robot.carrier import HOME
from extensions.robot.command import RESET, RobotCommand
from extensions.robot.hand import RobotHand
from extensions.robot.scene import CUBE
from extensions.robot.teleop import Teleop
from extensions.robot.wearer_hand import WearerHand, hand_from_keypoints
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.glove.library import text
from tracker.hand.files import parse_hand
from tracker.hand.model import HandModel
from tracker.messages import Array, RobotState, Validity
from tracker.simulation.motion import Poses
from tracker.simulation.smooth import SmoothNoise, minimum_jerk, rng_for

CENTRE = np.array([0.02, 0.011, -0.06])
"""m in the robot's P: centre of the grasped cube (right hand)."""
OPEN, CLOSED = CUBE + 0.025, CUBE - 0.012  # m from the centre to the tips
LIFT = 0.12  # m
SWAY, SWAY_ANGLE = 0.001, 0.01  # m and rad
OFF = 0.003  # m, standard deviation of the grasp position
START = np.array([0.05, 0.0, 0.30])
"""m in G: the wearer's palm while the robot's is at home."""
PACKET = 0.01  # s
NEAR = 0.03  # m from the goal that count as placed
Count = Callable[[RobotState, Array, float], None]


class Move(NamedTuple):
    """One move: ``seconds`` to the palm's p (3,) m in W, with fingers closed by ``grip`` 0 to 1."""

    seconds: float
    p_W: Array
    grip: float


class Picking:
    """Motion of the wearer's hand that moves a cube in W to ``goal`` (2,) m."""

    follows_synergies = True

    def __init__(
        self, hand: HandModel, robot: RobotHand, cube: Array, goal: Array, seed: int
    ) -> None:
        """``cube`` (3,): x and y in m, yaw in rad."""
        self.hand = hand
        rng = rng_for(seed, "picking")
        off = rng.normal(0.0, OFF, 2)
        turn = so3.rz(float(cube[2]))
        grasp = np.array([*(cube[:2] + off), CUBE]) - turn @ _centre(hand)
        put = np.array([*goal, CUBE + 0.002]) - turn @ _centre(hand)
        up = np.array([0.0, 0.0, LIFT])
        self._moves = (
            Move(1.2, grasp + up, 0.0),
            Move(0.9, grasp, 0.0),
            Move(0.5, grasp, 1.0),
            Move(0.3, grasp, 1.0),
            Move(0.8, grasp + up, 1.0),
            Move(1.2, put + up, 1.0),
            Move(0.9, put, 1.0),
            Move(0.6, put, 0.0),
            Move(0.8, put + up, 0.0),
            Move(0.4, put + up, 0.0),
        )
        self._ends = list(accumulate(move.seconds for move in self._moves))
        self.duration = self._ends[-1]
        self._yaw = float(cube[2])
        self._open = grasp_posture(hand, robot, OPEN)
        self._closed = grasp_posture(hand, robot, CLOSED)
        self._sway = SmoothNoise(rng_for(seed, "sway"), (6,), 0.5)

    def poses(self, t: Array) -> Poses:
        """Poses of the hand at t (n,) s."""
        p, grip, turned = np.tile(HOME, (len(t), 1)), np.zeros(len(t)), np.zeros(len(t))
        last, grip_before, start = HOME, 0.0, 0.0
        for move, end in zip(self._moves, self._ends, strict=True):
            share = minimum_jerk((t - start) / (end - start))
            p += share[:, None] * (move.p_W - last)
            grip += share * (move.grip - grip_before)
            last, grip_before, start = move.p_W, move.grip, end
        turned = self._yaw * minimum_jerk(t / self._ends[0])
        sway = self._sway(t)
        R = so3.exp(np.outer(turned, [0.0, 0.0, 1.0]) + SWAY_ANGLE * sway[:, :3])
        angles = self._open + grip[:, None] * (self._closed - self._open)
        middle = self.hand.segments[self.hand.index["middle_proximal"]].origin
        p_G = START + (p - HOME) + SWAY * sway[:, 3:]
        return Poses(angles, R, p_G - R @ middle)

    def hands(self, t: Array) -> list[WearerHand]:
        """The wearer's hand at t (n,) s, as input of a robot."""
        poses = self.poses(t)
        return [
            hand_at(self.hand, Poses(*(part[k] for part in poses)), float(t[k]))
            for k in range(len(t))
        ]


def hand_at(hand: HandModel, pose: Poses, t: float) -> WearerHand:
    """The true hand at one instant of a motion; the arrays of ``pose`` have no time axis."""
    R, p = hand.forward(pose.angles, pose.R_GB, pose.p_GB)
    state = np.full(len(hand.keypoint_names), int(Validity.MEASURED), np.int64)
    q = so3.quat_from_matrix(pose.R_GB)
    return hand_from_keypoints(t, True, hand.keypoints(R, p), state, q)


def grasp_posture(hand: HandModel, robot: RobotHand, half: float) -> Array:
    """Joint angles (J,) rad of the wearer for which the robot's thumb is ``half`` m behind the
    cube's centre and its index and middle fingers are as far in front of it."""
    free = [i for i, n in enumerate(hand.joint_names) if n.startswith(("thumb", "index", "middle"))]
    limits = hand.angle_limits[free]
    wanted = _wanted(hand, robot, half)

    def whole(x: Array) -> Array:
        angles = np.zeros(len(hand.joint_names))
        angles[free] = x
        for name, row in hand.angle_index.items():
            if name.startswith(("ring", "little")) and name.endswith("flexion"):
                angles[row] = angles[hand.angle_index[name.replace(name.split("_")[0], "middle")]]
        return angles

    def residual(x: Array) -> Array:
        wearer = hand_at(hand, Poses(whole(x), np.eye(3), np.zeros(3)), 0.0)
        miss = (wearer.tip - wearer.knuckle)[:3] / wearer.length[:3, None] - wanted
        return np.concatenate([20.0 * miss.ravel(), 0.05 * (x - start)])

    start = np.clip(np.full(len(free), 0.4), *limits.T)
    start[[hand.joint_names[i].endswith("abduction") for i in free]] = 0.0
    start = np.clip(start, limits[:, 0] + 1e-6, limits[:, 1] - 1e-6)
    return whole(np.asarray(least_squares(residual, start, bounds=limits.T).x))


def _centre(hand: HandModel) -> Array:
    return CENTRE if hand.side == "right" else CENTRE * [1, -1, 1]


def _wanted(hand: HandModel, robot: RobotHand, half: float) -> Array:
    """(3, 3) from the knuckles of thumb, index and middle finger to their tips, in units of the
    finger's length."""
    apart = 0.012 if hand.side == "right" else -0.012
    offsets = {"thumb": (-half, 0.0, 0.0), "index": (half, apart, 0), "middle": (half, -apart, 0)}
    rows = []
    for finger in robot.anatomy.fingers:
        if finger.name in offsets:
            at = _centre(hand) + np.array(offsets[finger.name])
            rows.append((at - finger.knuckle) / finger.length)
    return np.array(rows)


class PickTrial(NamedTuple):
    """``placed``: the cube was lifted and is at rest within `NEAR` of its goal."""

    seed: int
    placed: bool
    off_mm: float
    lifted_mm: float


def wearer_model(side: str) -> HandModel:
    """The reference hand of a side."""
    name = f"reference-{side}"
    return parse_hand(text("hands", name), name)


def pick_and_place(
    teleop: Teleop,
    seed: int,
    count: Count = lambda state, errors, took: None,
    watch: Callable[[RobotState], None] = lambda state: None,
) -> PickTrial:
    """Run one trial in the robot's scene, which is reset. Raises ConfigError without a cube."""
    things = teleop.world.scene.objects
    if "cube" not in things:
        raise ConfigError(notice("robot.needs_cube"))
    rng = rng_for(seed, "pick and place")
    cube = np.array([rng.uniform(0.02, 0.08), rng.uniform(-0.13, -0.07), rng.uniform(-0.4, 0.4)])
    goal = np.array([rng.uniform(0.02, 0.08), rng.uniform(-0.32, -0.26)])
    teleop.command(RobotCommand(RESET))
    teleop.world.place("cube", np.array([cube[0], cube[1], CUBE]), float(cube[2]))
    picking = Picking(wearer_model(teleop.settings.side), teleop.hand, cube, goal, seed)
    row, highest = things.index("cube"), 0.0
    for wearer in picking.hands(np.arange(0.0, picking.duration, PACKET)):
        began = monotonic()
        state = teleop.feed(wearer)
        count(state, teleop.fingers.error, monotonic() - began)
        watch(state)
        highest = max(highest, float(state.objects[row, 2]) - CUBE)
    place = state.objects[row, :3]
    off = float(np.linalg.norm(place[:2] - goal))
    on_table = abs(float(place[2]) - CUBE) < 0.01
    done = off < NEAR and on_table and highest > 0.5 * LIFT
    return PickTrial(seed, done, 1e3 * off, 1e3 * highest)
