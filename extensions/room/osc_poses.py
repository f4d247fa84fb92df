"""Poses from packets of Open Sound Control.

VMC, as Virtual Motion Capture sends SteamVR's devices: ``/VMC/Ext/Tra/Pos serial x y z qx qy qz
qw`` (``Con`` and ``Hmd`` likewise), in Unity's axes. VRChat's trackers, as SlimeVR sends them:
``/tracking/trackers/N/position`` and ``/rotation``, in Unity's axes and degrees. Other programs:
``/glovetrack/wrist name x y z qx qy qz qw`` in m, right-handed, z up; a position alone is allowed.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from extensions.osc import decode
from extensions.osc.decode import BUNDLE, OscError
from extensions.room.frames import from_unity, from_unity_euler
from tracker.base.notices import notice
from tracker.messages import Array

OURS = "/glovetrack/wrist"
VMC = re.compile(r"/VMC/Ext/(?:Tra|Con|Hmd)/Pos$")
VRCHAT = re.compile(r"/tracking/trackers/(\w+)/(position|rotation)$")
NO_ROTATION = np.full(4, np.nan)
_HEAD = len(BUNDLE) + 8
MOST_DEEP = 4  # bundles in bundles


class RoomPose(NamedTuple):
    """A tracker's pose in G: p (3,) m and q (4,) xyzw, NaN where no rotation is measured."""

    name: str
    p: Array
    q: Array


class PoseReader:
    """Reads packets of one sender; VRChat's trackers come as two messages."""

    def __init__(self) -> None:
        self._angles: dict[str, Array] = {}

    def poses(self, data: bytes) -> list[RoomPose]:
        """The poses in a packet, which may have none. Raises OscError."""
        found = list(messages(data))
        for address, values in found:  # a rotation may follow its position in a bundle
            self._keep_rotation(address, values)
        return [pose for m in found if (pose := self._pose(*m)) is not None]

    def _keep_rotation(self, address: str, values: list[str | int | float | bool]) -> None:
        match = VRCHAT.match(address)
        if match is not None and match[2] == "rotation":
            self._angles[match[1]] = _numbers(values, 3)

    def _pose(self, address: str, values: list[str | int | float | bool]) -> RoomPose | None:
        if VMC.match(address):
            numbers = _numbers(values[1:], 7)
            return RoomPose(str(values[0]), *from_unity(numbers[:3], _unit(numbers[3:])))
        if address == OURS and len(values) == 4:
            return RoomPose(str(values[0]), _numbers(values[1:], 3), NO_ROTATION)
        if address == OURS:
            numbers = _numbers(values[1:], 7)
            return RoomPose(str(values[0]), numbers[:3], _unit(numbers[3:]))
        match = VRCHAT.match(address)
        if match is None or match[2] == "rotation":
            return None
        p, angles = _numbers(values, 3), self._angles.get(match[1])
        if angles is None:
            return RoomPose(match[1], from_unity(p, np.array([0.0, 0, 0, 1]))[0], NO_ROTATION)
        return RoomPose(match[1], *from_unity(p, from_unity_euler(angles)))


def messages(data: bytes, depth: int = 0) -> Iterator[tuple[str, list[str | int | float | bool]]]:
    """The messages of a packet, of bundles too. Raises OscError."""
    if not data.startswith(BUNDLE):
        yield decode.message(data)
        return
    if depth == MOST_DEEP:
        raise OscError(notice("osc.nested"))
    at = _HEAD
    while at < len(data):
        if at + 4 > len(data):
            raise OscError(notice("osc.truncated"))
        (size,) = struct.unpack_from(">i", data, at)
        if not 0 < size <= len(data) - at - 4:
            raise OscError(notice("osc.truncated"))
        yield from messages(data[at + 4 : at + 4 + size], depth + 1)
        at += 4 + size


def _numbers(values: list[str | int | float | bool], count: int) -> Array:
    if len(values) != count or any(isinstance(v, str) for v in values):
        raise OscError(notice("osc.pose_numbers", count=count))
    out = np.array(values, float)
    if not np.isfinite(out).all():
        raise OscError(notice("osc.pose_finite"))
    return out


def _unit(q: Array) -> Array:
    """Raises OscError for a quaternion (4,) of zeros."""
    length = float(np.linalg.norm(q))
    if length < 0.5:
        raise OscError(notice("osc.pose_norm"))
    out: Array = q / length
    return out
