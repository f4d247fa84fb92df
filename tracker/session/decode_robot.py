"""Robot hands of a session, assembled from their topics; the inverse of `encode_robot`."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import RobotMemory, RobotModel, RobotState
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, topics

FELT = 7  # numbers of contact: engaged, holding, five forces
RobotMessage = RobotModel | RobotState | RobotMemory


def robot_names(reader: SessionReader) -> tuple[str, ...]:
    """The robots of a session, by their joint states."""
    found = (topics.robot_of(topic) for topic in reader.topic_names)
    return tuple(sorted({name for name, what in found if what == "joint_states"}))


def read_robot(
    reader: SessionReader, name: str, start: float | None = None
) -> Iterator[RobotMessage]:
    """Yields the messages of one robot in order, from ``start`` (s) on. Raises FileError."""
    decoder = _RobotDecoder(reader, name)
    first = 0 if start is None else max(reader.anchor.wall(start), 0)
    wanted = frozenset(topics.robot(name, what) for what in topics.ROBOT)
    for raw in ordered(reader.source, wanted, first):
        message = None
        with reader.source.left_out.reading(raw.topic, raw.log_time):
            message = decoder.feed(raw)
        if message is not None:
            yield message


def robot_model(reader: SessionReader, name: str) -> RobotModel:
    """Returns the description of a session's robot. Raises FileError if there is none."""
    for message in read_robot(reader, name):
        if isinstance(message, RobotModel):
            return message
    raise FileError(notice("session.robot_unknown", path=reader.path, robot=name))


class _RobotDecoder:
    """Assembles robot states; one is complete with its contacts, which are written last."""

    def __init__(self, reader: SessionReader, name: str) -> None:
        self._name, self._t = name, reader.anchor.monotonic
        self._urdf = ""
        self._commands: motion.JointState | None = None
        self._joints: motion.JointState | None = None
        self._scene: motion.PoseArray | None = None

    def feed(self, raw: RawMessage) -> RobotMessage | None:
        match topics.robot_of(raw.topic)[1]:
            case "robot_description":
                self._urdf = motion.unpack_string(raw.data)
            case "model":
                return self._model(raw)
            case "memory":
                values = motion.unpack_numbers(raw.data)
                return RobotMemory(self._t(raw.publish_time), self._name, values)
            case "joint_commands":
                self._commands = motion.unpack_joints(raw.data)
            case "joint_states":
                self._joints = motion.unpack_joints(raw.data)
            case "scene":
                self._scene = motion.unpack_poses(raw.data)
            case "contact":
                return self._state(motion.unpack_numbers(raw.data), raw.log_time)
        return None

    def _model(self, raw: RawMessage) -> RobotModel:
        try:
            content: Any = json.loads(motion.unpack_string(raw.data))
        except RecursionError as error:
            raise FileError(notice("session.robot_not_json")) from error
        if not isinstance(content, dict):
            raise FileError(notice("session.robot_not_object"))
        return RobotModel(
            self._t(raw.publish_time),
            self._name,
            tuple(str(n) for n in content.get("joints", ())),
            tuple(str(n) for n in content.get("objects", ())),
            self._urdf,
            json.dumps(content.get("settings", {}), sort_keys=True),
        )

    def _state(self, felt: np.ndarray, log_time: int) -> RobotState | None:
        """None if a part is missing, as in a recording that begins within a state."""
        joints, commands, scene = self._joints, self._commands, self._scene
        if joints is None or commands is None or scene is None or len(felt) != FELT:
            return None
        if not joints.stamp == commands.stamp == scene.stamp or len(scene.position) < 1:
            return None
        poses = np.hstack([scene.position, scene.orientation])
        return RobotState(
            self._t(joints.stamp), self._name, np.array(commands.position),
            np.array(joints.position), poses[0], poses[1:], np.array(felt[2:]),
            bool(felt[0]), bool(felt[1]),
            self._t(log_time) if log_time != joints.stamp else math.nan,
        )  # fmt: skip
