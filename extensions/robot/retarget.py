"""Inverse kinematics of a robot hand: joint angles for given fingertip positions.

Damped Gauss-Newton on MuJoCo's Jacobians, within joint limits and speeds by an active set: a joint
that is pushed beyond its bound stays at the bound and the others compensate. Of the libraries for
this, mink takes 13 ms for one step in a hundred where this takes 1 ms; see docs/robot.md.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import mujoco
import numpy as np
from numpy.typing import NDArray

from extensions.robot.hand import RobotHand
from extensions.robot.wearer_hand import FINGERS
from tracker.messages import Array

STEPS = 4  # iterations per hand; the next hand continues from the result
SMALL = 1e-3  # rad: iteration ends with a step smaller than this
STUCK = 2e-3  # m: with a larger error another initial pose is tried
EVERY = 4  # hands between two tries of another initial pose
BETTER = 0.8  # share of the error that another solution must stay below to be accepted
STARTS = 0.1 + 0.8 * np.random.default_rng(1).random((8, 6))
"""Initial poses that are tried in turn, as shares of the joints' ranges."""
CLOSE = 2e-4  # m: iteration ends below this error
TIP_SD = 1e-3  # m
COUPLED_SD = 0.02  # rad
REST_SD = 3.0  # rad: joints that the tip does not determine stay near the rest pose
DAMPING_SD = 0.5  # rad, of one step
PASSES = 4  # of the active set


class Retargeter:
    """Holds the joint angles, in the order of the hand's joint names."""

    def __init__(self, hand: RobotHand, joint_speed: float) -> None:
        """``joint_speed`` rad/s."""
        self._hand, self._speed = hand, joint_speed
        self._data = mujoco.MjData(hand.model)
        self._rest = np.clip(0.0, *hand.limits.T)
        self._rows = [FINGERS.index(f.name) for f in hand.anatomy.fingers]
        self._jacobian = np.zeros((3 * len(FINGERS), hand.model.nv))
        couplings = hand.anatomy.couplings
        weight = 1.0 / COUPLED_SD**2
        self._coupling = weight * couplings.T @ couplings
        self._diagonal = np.eye(hand.model.nv) * (1.0 / REST_SD**2 + 1.0 / DAMPING_SD**2)
        self._coupled_to = weight * couplings.T @ hand.anatomy.coupled_to
        self.angles = self._rest.copy()
        self._goal, self._tries = self._rest.copy(), 0
        self.error = np.full(len(FINGERS), np.nan)
        """(5,) m from each tip to its target, speed limits ignored; NaN without a target."""

    def reset(self, angles: Array | None = None) -> None:
        """Start again from the rest pose or from the given angles."""
        self.angles = self._rest.copy() if angles is None else np.array(angles, float)
        self._goal, self._tries = self.angles.copy(), 0

    def step(self, targets: Array, known: NDArray[np.bool_], dt: float) -> Array:
        """Angles ``dt`` s later; targets (5, 3) m in P. Fingers without a target do not move."""
        moved = self._moved(known)
        self._goal = np.where(moved, self._goal, self.angles)
        goal = self._solve(self._goal, targets, known, moved)
        if self._worst(known) > STUCK and self._tries_now():
            goal = self._elsewhere(goal, targets, known, moved)
        self._goal = goal
        reach = self._speed * dt
        self.angles = self.angles + np.clip(goal - self.angles, -reach, reach)
        return self.angles

    def _solve(
        self, q: Array, targets: Array, known: NDArray[np.bool_], moved: NDArray[np.bool_]
    ) -> Array:
        """The local optimum from ``q``; sets `error`."""
        low = np.where(moved, self._hand.limits[:, 0], q)
        high = np.where(moved, self._hand.limits[:, 1], q)
        for _ in range(STEPS):
            H, g = self._normal(q, targets, known)
            if self._worst(known) < CLOSE:
                return q
            x = bounded_step(H, g, low - q, high - q)
            q = q + x
            if np.abs(x).max() < SMALL:
                break
        self._normal(q, targets, known)
        return q

    def _tries_now(self) -> bool:
        self._tries += 1
        return self._tries % EVERY == 0

    def _elsewhere(
        self, goal: Array, targets: Array, known: NDArray[np.bool_], moved: NDArray[np.bool_]
    ) -> Array:
        """Solve again from another initial pose for fingers that do not reach their targets, since
        there may be another solution. The better of the two is returned."""
        errors = self.error.copy()
        share = STARTS[self._tries // EVERY % len(STARTS)]
        start = goal.copy()
        low, high = self._hand.limits.T
        for joints, row in self._fingers():
            if errors[row] > STUCK:
                start[joints] = low[joints] + share[: len(joints)] * (high - low)[joints]
        other = self._solve(np.where(moved, start, goal), targets, known, moved)
        for joints, row in self._fingers():
            if not self.error[row] < BETTER * errors[row]:
                other[joints] = goal[joints]
        self._normal(other, targets, known)
        return other

    def _fingers(self) -> Iterator[tuple[list[int], int]]:
        """Joints and row of each finger."""
        for finger, row in zip(self._hand.anatomy.fingers, self._rows, strict=True):
            yield list(finger.joints), row

    def _moved(self, known: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """(n,) joints of fingers whose target is known."""
        out = np.zeros(len(self.angles), bool)
        for joints, row in self._fingers():
            out[joints] |= known[row]
        return out

    @property
    def memory(self) -> Array:
        """(2 n + 1,) everything that the next step depends on."""
        return np.concatenate([self.angles, self._goal, [float(self._tries)]])

    def remember(self, memory: Array) -> None:
        """Restore a state returned by ``memory``."""
        n = len(self._rest)
        self.angles, self._goal = memory[:n].copy(), memory[n : 2 * n].copy()
        self._tries = int(memory[2 * n])

    def tips(self, angles: Array) -> Array:
        """Fingertips (5, 3) m in P; NaN for fingers that the robot does not have."""
        self._pose(angles)
        out = np.full((len(FINGERS), 3), np.nan)
        anatomy = self._hand.anatomy
        for finger, row in zip(anatomy.fingers, self._rows, strict=True):
            out[row] = anatomy.R_WP.T @ (self._tip(finger.body, finger.tip) - anatomy.p_WP)
        return out

    def _worst(self, known: NDArray[np.bool_]) -> float:
        return float(np.nanmax(self.error, initial=0.0, where=known))

    def _pose(self, q: Array) -> None:
        self._data.qpos[:] = q
        mujoco.mj_kinematics(self._hand.model, self._data)
        mujoco.mj_comPos(self._hand.model, self._data)

    def _tip(self, body: int, point: Array) -> Array:
        data = self._data
        return np.asarray(data.xpos[body] + data.xmat[body].reshape(3, 3) @ point)

    def _normal(self, q: Array, targets: Array, known: NDArray[np.bool_]) -> tuple[Array, Array]:
        """Normal matrix (n, n) and right side (n,) at ``q``; sets `error`."""
        self._pose(q)
        anatomy, J = self._hand.anatomy, self._jacobian
        weight = 1.0 / TIP_SD**2
        H = self._coupling + self._diagonal
        g = self._coupled_to - self._coupling @ q + (self._rest - q) / REST_SD**2
        self.error[:] = np.nan
        wanted = targets @ anatomy.R_WP.T + anatomy.p_WP
        rows, miss = 0, np.zeros(J.shape[0])
        for finger, row in zip(anatomy.fingers, self._rows, strict=True):
            if not known[row]:
                continue
            at = self._tip(finger.body, finger.tip)
            part = slice(rows, rows + 3)
            miss[part] = wanted[row] - at
            self.error[row] = math.sqrt(miss[part] @ miss[part])
            mujoco.mj_jac(self._hand.model, self._data, J[part], None, at, finger.body)
            rows += 3
        return H + weight * (J[:rows].T @ J[:rows]), g + weight * (J[:rows].T @ miss[:rows])


def bounded_step(H: Array, g: Array, low: Array, high: Array) -> Array:
    """(n,) approximate minimiser of x'Hx/2 - g'x in low..high; a reached bound stays active."""
    x = np.zeros(len(g))
    free = ~((low >= 0) & (g < 0)) & ~((high <= 0) & (g > 0)) & (high > low)
    for _ in range(PASSES):
        if not free.any():
            break
        held = np.where(free, 0.0, x)
        part = np.where(free, g - H @ held, 0.0)
        square = np.where(free[:, None] & free, H, 0.0)
        square[np.arange(len(g)), np.arange(len(g))] += ~free
        x = held + np.linalg.solve(square, part)
        out = free & ((x < low) | (x > high))
        if not out.any():
            break
        x = np.clip(x, low, high)
        free &= ~out
    return np.asarray(np.clip(x, low, high))
