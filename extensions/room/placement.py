"""From a tracker's pose in the room to the message that the engine is fed with."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Protocol

import numpy as np

from extensions.room import alignment_file
from extensions.room.alignment import Alignment
from extensions.room.osc_poses import RoomPose
from tracker.geometry import so3
from tracker.hand.names import SIDES
from tracker.messages import WristPose

ANY = "any"


class SharedOptions(Protocol):
    """What the options of all doors have, in their units."""

    @property
    def right(self) -> str: ...
    @property
    def left(self) -> str: ...
    @property
    def alignment(self) -> str: ...
    @property
    def yaw_deg(self) -> float: ...
    @property
    def delay_ms(self) -> float: ...
    @property
    def position_mm(self) -> float: ...
    @property
    def rotation_deg(self) -> float: ...


@dataclass(frozen=True)
class PoseOptions:
    """What the options of all doors have in common. ``names``: the tracker of each side."""

    names: Mapping[str, str]
    alignments: Mapping[str, Alignment] = field(default_factory=dict)
    yaw: float = 0.0  # rad by which the room is turned about the vertical
    delay: float = 0.0  # s by which poses are late, beyond the alignment's
    position_sd: float = 0.002  # m
    rotation_sd: float = 0.02  # rad


def is_named(wanted: str, name: str) -> bool:
    """Whether a tracker of this name is the one that is wanted."""
    return bool(name) and wanted in (name, ANY)


class Placement:
    """Chooses the trackers that are on hands, and makes the messages of their poses."""

    def __init__(self, options: PoseOptions) -> None:
        self._options = options
        self._R = so3.rz(options.yaw)

    def of(self, pose: RoomPose, t: float) -> list[WristPose]:
        """The messages of a pose that was measured at ``t`` (s), before delays are taken off."""
        return [self._message(pose, side, t) for side in SIDES if self._is_on(side, pose.name)]

    def _is_on(self, side: str, name: str) -> bool:
        return is_named(self._options.names.get(side, ""), name)

    def _message(self, pose: RoomPose, side: str, t: float) -> WristPose:
        o = self._options
        aligned = o.alignments.get(side) or Alignment.identity()
        q = pose.q
        if np.isfinite(q).all():
            q = so3.quat_from_matrix(self._R @ so3.matrix_from_quat(q))
        return WristPose(
            t=t - o.delay - aligned.delay,
            t_arrival=t,
            side=side,
            p_GT=self._R @ pose.p,
            q_GT=q.copy(),
            p_BT=aligned.p_BT.copy(),
            q_BT=aligned.q_BT.copy(),
            position_variance=o.position_sd**2,
            rotation_variance=o.rotation_sd**2,
        )


def with_file(options: PoseOptions, path: str) -> PoseOptions:
    """The options with the alignments of a file, if a path is given. Raises FileError and
    ConfigError."""
    return replace(options, alignments=alignment_file.read(Path(path))) if path else options


def placement_of(options: SharedOptions) -> Placement:
    """The placement that the options of a door describe."""
    plain = PoseOptions(
        names={"right": options.right, "left": options.left},
        yaw=math.radians(options.yaw_deg),
        delay=options.delay_ms / 1e3,
        position_sd=max(options.position_mm, 0.01) / 1e3,
        rotation_sd=math.radians(max(options.rotation_deg, 0.01)),
    )
    return Placement(with_file(plain, options.alignment))
