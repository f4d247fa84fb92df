"""Simulated six-axis arm in MuJoCo with a gripper and a block.

Like a real arm, it only receives `JointCommand` and `PoseCommand`; poses are converted to angles by
damped least squares (Buss 2004, Introduction to inverse kinematics, section 6).
"""

from __future__ import annotations

from typing import NamedTuple

import mujoco
import numpy as np

from extensions.applications.interface import JointCommand, PoseCommand
from extensions.applications.solids import Solid, box, capsule, cylinder
from resources import folder
from tracker.geometry import so3
from tracker.messages import Array

AXES = ("yaw", "shoulder", "elbow", "forearm_roll", "wrist_pitch", "wrist_roll")
FINGERS = ("left", "right")
REST = np.array([0.0, 0.05, 1.75, 0.0, 1.34, 0.0])  # rad: the gripper looks down before the base
OPEN = 0.03  # m of each finger from the centre when open
DAMPING = 0.03  # of the least squares
ROUNDS = 4  # iterations of the inverse kinematics per step
FASTEST = 2.5  # rad/s of any joint
RAD_PER_M = 4.0  # weight of rotation relative to translation


class ToolPose(NamedTuple):
    """Pose of the gripper: R (3, 3), p (3,) m, in the base's frame."""

    R: Array
    p: Array


class Part(NamedTuple):
    """One solid of the arm or the scene, and its pose in the base's frame."""

    name: str
    solid: Solid
    R: Array
    p: Array


class SixAxisArm:
    """The arm at the origin of its frame, x away from the wearer, z up."""

    def __init__(self) -> None:
        text = (folder("arms") / "six-axis.xml").read_text("utf-8")
        self._model = mujoco.MjModel.from_xml_string(text)
        self._data = mujoco.MjData(self._model)
        self._ghost = mujoco.MjData(self._model)  # for the inverse kinematics
        self._columns = [int(self._model.joint(name).dofadr[0]) for name in AXES]
        self._rows = [int(self._model.joint(name).qposadr[0]) for name in AXES]
        self._limits = np.array([self._model.joint(name).range for name in AXES])
        self._motors = [self._model.actuator(name).id for name in (*AXES, *FINGERS)]
        self._tool = self._model.site("tool").id
        self._wanted, self._goal, self._grip = REST.copy(), REST.copy(), 0.0
        self._data.qpos[self._rows] = REST
        for finger in FINGERS:
            self._data.qpos[self._model.joint(finger).qposadr[0]] = OPEN
        self._left = 0.0
        self._solids = self._make_solids()
        self._drive()
        mujoco.mj_forward(self._model, self._data)

    # --- commands

    def take(self, command: JointCommand | PoseCommand) -> None:
        """Set the target; ``stop``: hold the current pose."""
        if command.stop:
            self._goal = self.angles
            self._wanted = self.angles
            return
        self._grip = float(np.clip(command.grip, 0.0, 1.0))
        if isinstance(command, PoseCommand):
            R = so3.matrix_from_quat(np.array(command.q))
            self._goal = self.solve(ToolPose(R, np.array(command.p)), self._goal)
        else:
            angles = dict(zip(command.names, command.angles, strict=True))
            wanted = [angles.get(n, a) for n, a in zip(AXES, self._goal.tolist(), strict=True)]
            self._goal = np.clip(wanted, *self._limits.T)

    def advance(self, dt: float) -> None:
        """Simulate ``dt`` s in whole steps; the remainder is added to the next call."""
        self._left += dt
        step = self._model.opt.timestep
        most = FASTEST * step
        while self._left >= step - 1e-9:
            self._left -= step
            self._wanted = self._wanted + np.clip(self._goal - self._wanted, -most, most)
            self._drive()
            mujoco.mj_step(self._model, self._data)

    def _drive(self) -> None:
        finger = OPEN * (1.0 - self._grip)
        self._data.ctrl[self._motors] = [*self._wanted, finger, finger]

    def solve(self, pose: ToolPose, start: Array) -> Array:
        """Angles (6,) rad that bring the tool to a pose, or as near as possible from ``start``."""
        q = np.array(start)
        J_p, J_r = np.empty((3, self._model.nv)), np.empty((3, self._model.nv))
        for _ in range(ROUNDS):
            here = self.pose_of(q)
            turn = so3.log(pose.R @ here.R.T) / RAD_PER_M
            error = np.concatenate([pose.p - here.p, turn])
            mujoco.mj_jacSite(self._model, self._ghost, J_p, J_r, self._tool)
            J = np.concatenate([J_p, J_r / RAD_PER_M])[:, self._columns]
            damped = J @ J.T + DAMPING**2 * np.eye(6)
            q = np.clip(q + J.T @ np.linalg.solve(damped, error), *self._limits.T)
        return q

    # --- state

    @property
    def angles(self) -> Array:
        """Current angles (6,) rad."""
        return np.array(self._data.qpos[self._rows])

    @property
    def tool(self) -> ToolPose:
        """Current pose of the gripper."""
        R = np.array(self._data.site_xmat[self._tool]).reshape(3, 3)
        return ToolPose(R, np.array(self._data.site_xpos[self._tool]))

    @property
    def block(self) -> Array:
        """Centre of the block (3,) m."""
        return np.array(self._data.body("block").xpos)

    def pose_of(self, angles: Array) -> ToolPose:
        """Pose of the gripper for other angles (6,) rad."""
        self._ghost.qpos[:] = self._data.qpos
        self._ghost.qpos[self._rows] = angles
        mujoco.mj_kinematics(self._model, self._ghost)
        mujoco.mj_comPos(self._model, self._ghost)
        R = np.array(self._ghost.site_xmat[self._tool]).reshape(3, 3)
        return ToolPose(R, np.array(self._ghost.site_xpos[self._tool]))

    def parts(self) -> list[Part]:
        """All solids except the floor."""
        out = []
        for i, solid in self._solids.items():
            R = np.array(self._data.geom_xmat[i]).reshape(3, 3)
            out.append(Part(self._model.geom(i).name, solid, R, np.array(self._data.geom_xpos[i])))
        return out

    def _make_solids(self) -> dict[int, Solid]:
        kinds = mujoco.mjtGeom
        out: dict[int, Solid] = {}
        for i in range(self._model.ngeom):
            kind, size = self._model.geom_type[i], np.array(self._model.geom_size[i])
            if kind == kinds.mjGEOM_BOX:
                out[i] = box(size)
            elif kind == kinds.mjGEOM_CAPSULE:
                out[i] = capsule(float(size[0]), float(size[1]))
            elif kind == kinds.mjGEOM_CYLINDER:
                out[i] = cylinder(float(size[0]), float(size[1]))
        return out
