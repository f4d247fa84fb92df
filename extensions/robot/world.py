"""The scene in time: motors pull, things fall and are grasped, fingertips feel."""

from __future__ import annotations

import mujoco
import numpy as np

from extensions.robot.hand import RobotHand
from extensions.robot.scene import build_scene
from extensions.robot.settings import RobotSettings
from extensions.robot.worn import FINGERS
from tracker.geometry import so3
from tracker.messages import Array

_STATE = mujoco.mjtState.mjSTATE_INTEGRATION


class RobotWorld:
    """Steps of `TIMESTEP` s. The hand begins where `reset` puts it."""

    def __init__(self, hand: RobotHand, settings: RobotSettings) -> None:
        self.scene = build_scene(hand, settings.things)
        self.model, self.data = self.scene.model, mujoco.MjData(self.scene.model)
        self._rest = np.clip(0.0, *hand.limits.T)
        self._force = np.zeros(6)
        body_of = {int(b): i for i, b in enumerate(self.scene.tip_bodies) if b >= 0}
        self._tip_of = [body_of.get(int(b), -1) for b in self.model.geom_bodyid]
        self._solid = [self._is_thing(g) for g in range(self.model.ngeom)]

    def _is_thing(self, geom: int) -> bool:
        """Whether a geom is no part of the hand."""
        body = int(self.model.geom_bodyid[geom])
        return body == 0 or body in self.scene.object_bodies

    def reset(self, R: Array, p: Array) -> None:
        """Everything at its beginning, the palm at R (3, 3), p (3,) m in W."""
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
        """``steps`` of `TIMESTEP` with the palm carried to R, p and motors told ``angles`` (n,).

        Returns (5,) N, the largest force on each fingertip by a thing meanwhile.
        """
        self._carry(R, p)
        self.data.ctrl[self.scene.motors] = angles
        most = np.zeros(len(FINGERS))
        for _ in range(steps):
            mujoco.mj_step(self.model, self.data)
            np.maximum(most, self.tip_forces(), out=most)
        return most

    def tip_forces(self) -> Array:
        """(5,) N by which things press on each fingertip now; other fingers do not count."""
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
        """s that were stepped since the reset."""
        return float(self.data.time)

    @property
    def angles(self) -> Array:
        """(n,) rad of the finger joints."""
        return np.array(self.data.qpos[self.scene.joint_rows])

    def palm(self) -> Array:
        """(7,) where the palm frame is in W: m, and xyzw."""
        return self._pose(self.scene.mount)

    def objects(self) -> Array:
        """(m, 7) where the things are, likewise."""
        rows = [self._pose(row) for row in self.scene.object_rows]
        return np.array(rows).reshape(-1, 7)

    def _pose(self, row: int) -> Array:
        q = self.data.qpos[row : row + 7]
        return np.array([*q[:3], *q[4:7], q[3]])

    def place(self, name: str, p: Array, yaw: float = 0.0) -> None:
        """Put a thing at p (3,) m, turned by ``yaw`` rad, at rest."""
        row = self.scene.object_rows[self.scene.objects.index(name)]
        self.data.qpos[row : row + 7] = [*p, np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)]
        mujoco.mj_forward(self.model, self.data)

    def show(self, angles: Array, palm: Array, objects: Array) -> None:
        """As a recorded state has it, without a step: angles (n,), palm (7,), objects (m, 7).

        Of another scene's things those are shown that there are.
        """
        data, mount = self.data, self.scene.mount
        data.qpos[self.scene.joint_rows] = angles
        for row, pose in zip((mount, *self.scene.object_rows), (palm, *objects), strict=False):
            data.qpos[row : row + 7] = [*pose[:3], pose[6], *pose[3:6]]
        mujoco.mj_kinematics(self.model, data)

    @property
    def memory(self) -> Array:
        """All that the next step depends on."""
        out = np.zeros(mujoco.mj_stateSize(self.model, _STATE))
        mujoco.mj_getState(self.model, self.data, out, _STATE)
        return out

    def remember(self, memory: Array) -> None:
        """As it was when ``memory`` was asked for. Raises ValueError for another scene's."""
        if memory.shape != (mujoco.mj_stateSize(self.model, _STATE),):
            raise ValueError("the state is that of another robot")
        mujoco.mj_setState(self.model, self.data, memory, _STATE)
        mujoco.mj_forward(self.model, self.data)
