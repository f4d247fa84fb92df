"""Simulation of the scene: servos, objects, grasps and contact forces."""

from __future__ import annotations

import mujoco
import numpy as np

from extensions.robot.hand import RobotHand
from extensions.robot.scene import build_scene
from extensions.robot.settings import RobotSettings
from extensions.robot.wearer_hand import FINGERS
from tracker.geometry import so3
from tracker.messages import Array

_STATE = mujoco.mjtState.mjSTATE_INTEGRATION


class RobotWorld:
    """Simulates in steps of `TIMESTEP` s, starting from the pose given to `reset`."""

    def __init__(self, hand: RobotHand, settings: RobotSettings) -> None:
        self.scene = build_scene(hand, settings.things)
        self.model, self.data = self.scene.model, mujoco.MjData(self.scene.model)
        self._rest = np.clip(0.0, *hand.limits.T)
        self._force = np.zeros(6)
        body_of = {int(b): i for i, b in enumerate(self.scene.tip_bodies) if b >= 0}
        moving = self.model.body_weldid[self.model.geom_bodyid]
        self._tip_of = [body_of.get(int(b), -1) for b in moving]
        self._solid = [self._is_thing(g) for g in range(self.model.ngeom)]

    def _is_thing(self, geom: int) -> bool:
        """Whether a geom is the table or an object."""
        body = int(self.model.geom_bodyid[geom])
        return body == 0 or body in self.scene.object_bodies

    def reset(self, R: Array, p: Array) -> None:
        """Return to the initial state with the palm at R (3, 3), p (3,) m in W."""
        mujoco.mj_resetData(self.model, self.data)
        self._carry(R, p)
        mount = self.scene.mount
        self.data.qpos[mount : mount + 3] = self.data.mocap_pos[0]
        self.data.qpos[mount + 3 : mount + 7] = self.data.mocap_quat[0]
        self.data.qpos[self.scene.joint_rows] = self._rest
        self.data.ctrl[self.scene.motors] = self._rest
        mujoco.mj_forward(self.model, self.data)

    def _carry(self, R: Array, p: Array) -> None:
        x, y, z, w = so3.quat_from_matrix(R)
        self.data.mocap_pos[0] = p
        self.data.mocap_quat[0] = w, x, y, z

    def step(self, R: Array, p: Array, angles: Array, steps: int) -> Array:
        """Simulate ``steps`` steps with the palm carried to R, p and joint targets ``angles`` (n,).

        Returns (5,) N: the largest force of an object on each fingertip.
        """
        self._carry(R, p)
        self.data.ctrl[self.scene.motors] = angles
        most = np.zeros(len(FINGERS))
        for _ in range(steps):
            mujoco.mj_step(self.model, self.data)
            np.maximum(most, self.tip_forces(), out=most)
        return most

    def tip_forces(self) -> Array:
        """(5,) N: current force of the objects on each fingertip, without other fingers."""
        out = np.zeros(len(FINGERS))
        data = self.data
        for c in range(data.ncon):
            one, other = data.contact.geom[c]
            tip, thing = self._tip_of[one], self._solid[other]
            if tip < 0 or not thing:
                tip, thing = self._tip_of[other], self._solid[one]
            if tip >= 0 and thing:
                mujoco.mj_contactForce(self.model, data, c, self._force)
                out[tip] += abs(self._force[0])
        return out

    @property
    def t(self) -> float:
        """Simulated time in s since the reset."""
        return float(self.data.time)

    @property
    def angles(self) -> Array:
        """Angles (n,) rad of the finger joints."""
        return np.array(self.data.qpos[self.scene.joint_rows])

    def palm(self) -> Array:
        """Pose (7,) of the palm frame in W: position in m and quaternion xyzw."""
        return self._pose(self.scene.mount)

    def objects(self) -> Array:
        """Poses (m, 7) of the objects in W."""
        rows = [self._pose(row) for row in self.scene.object_rows]
        return np.array(rows).reshape(-1, 7)

    def _pose(self, row: int) -> Array:
        q = self.data.qpos[row : row + 7]
        return np.array([*q[:3], *q[4:7], q[3]])

    def place(self, name: str, p: Array, yaw: float = 0.0) -> None:
        """Put an object at p (3,) m, turned by ``yaw`` rad, at rest."""
        row = self.scene.object_rows[self.scene.objects.index(name)]
        self.data.qpos[row : row + 7] = [*p, np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)]
        mujoco.mj_forward(self.model, self.data)

    def show(self, angles: Array, palm: Array, objects: Array) -> None:
        """Set a recorded state without simulating: angles (n,), palm (7,), objects (m, 7).

        Surplus objects of another scene are ignored.
        """
        data, mount = self.data, self.scene.mount
        data.qpos[self.scene.joint_rows] = angles
        for row, pose in zip((mount, *self.scene.object_rows), (palm, *objects), strict=False):
            data.qpos[row : row + 7] = [*pose[:3], pose[6], *pose[3:6]]
        mujoco.mj_kinematics(self.model, data)

    @property
    def memory(self) -> Array:
        """Everything that the next step depends on."""
        out = np.zeros(mujoco.mj_stateSize(self.model, _STATE))
        mujoco.mj_getState(self.model, self.data, out, _STATE)
        return out

    def remember(self, memory: Array) -> None:
        """Restore a state returned by ``memory``. Raises ValueError if it is of another scene."""
        if memory.shape != (mujoco.mj_stateSize(self.model, _STATE),):
            raise ValueError("the state belongs to another robot")
        mujoco.mj_setState(self.model, self.data, memory, _STATE)
        mujoco.mj_forward(self.model, self.data)
