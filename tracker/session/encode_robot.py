"""A robot hand as topics of a session; the inverse of `decode_robot`."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator

import numpy as np

from tracker.messages import Array, RobotMemory, RobotModel, RobotState
from tracker.session.ros import motion, topics
from tracker.session.ros.motion import JointState, PoseArray

WORLD = "robot_world"
"""The frame of scenes: z up, the table at 0, x away from the wearer."""

Part = tuple[str, str, bytes]
"""Topic, type and bytes of a message."""


class RobotEncoder:
    """Writes the description of each robot once; a state before its description has no names and is
    left out."""

    def __init__(self, wall: Callable[[float], int]) -> None:
        self._wall = wall
        self._models: dict[str, RobotModel] = {}

    def parts(self, message: RobotModel | RobotState | RobotMemory) -> Iterator[Part]:
        """The topics of a message."""
        if isinstance(message, RobotModel):
            yield from self._model(message)
        elif message.name in self._models:
            if isinstance(message, RobotState):
                yield from self._state(message)
            else:
                data = motion.pack_numbers(message.values)
                yield topics.robot(message.name, "memory"), motion.NUMBERS, data

    def _model(self, m: RobotModel) -> Iterator[Part]:
        known, self._models[m.name] = self._models.get(m.name), m
        if known is not None and known.settings == m.settings:
            return
        about = {
            "joints": m.joint_names,
            "objects": m.objects,
            "settings": json.loads(m.settings),
        }
        urdf, text = motion.pack_string(m.urdf), motion.pack_string(json.dumps(about))
        yield topics.robot(m.name, "robot_description"), motion.STRING, urdf
        yield topics.robot(m.name, "model"), motion.STRING, text

    def _state(self, m: RobotState) -> Iterator[Part]:
        stamp, names = self._wall(m.t), self._models[m.name].joint_names
        yield self._joints(m, "joint_commands", stamp, names, m.command)
        yield self._joints(m, "joint_states", stamp, names, m.joints)
        scene = np.vstack([m.palm, m.objects.reshape(-1, 7)])
        poses = PoseArray(stamp, WORLD, scene[:, :3], scene[:, 3:])
        yield topics.robot(m.name, "scene"), motion.POSES, motion.pack_poses(poses)
        felt = np.array([float(m.engaged), float(m.holding), *m.force])
        yield topics.robot(m.name, "contact"), motion.NUMBERS, motion.pack_numbers(felt)

    def _joints(
        self, m: RobotState, what: str, stamp: int, names: tuple[str, ...], values: Array
    ) -> Part:
        data = motion.pack_joints(JointState(stamp, list(names), values))
        return topics.robot(m.name, what), motion.JOINTS, data
