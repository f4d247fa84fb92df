"""Other objects in the scene: coloured distractors, an object in the hand, fingertip devices."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.messages import Array, CameraPose
from tracker.simulation.backgrounds import fabric_bgr
from tracker.simulation.smooth import SmoothNoise, rng_for
from tracker.simulation.solids import UNOWNED, Solids, boxes, capsules
from tracker.vision.rig import default_pose

_NO_BALLS = (np.zeros((0, 3)), np.zeros(0), ())
OBJECTS = ("ball", "bottle", "box", "can", "cup", "phone", "pen", "stick")
"""Objects that can be held, eight as in the paper's experiment."""


class Distractors:
    """Balls of the markers' hues and sizes in the room, static or moving, behind the hand."""

    def __init__(
        self,
        seed: int,
        count: int = 60,
        hues: tuple[str, ...] = ("red", "yellow", "green", "blue"),
        moving: float = 0.0,  # m, standard deviation along each axis
        near: float = 0.45,  # m from the camera along its axis
        far: float = 1.0,
        camera: CameraPose | None = None,
    ) -> None:
        rng, pose = rng_for(seed, "distractors"), camera or default_pose()
        z = rng.uniform(near, far, count)
        x, y = rng.uniform(-0.95, 0.95, count) * z, rng.uniform(-0.55, 0.55, count) * z
        self._centre = np.column_stack([x, y, z]) @ pose.R_GC.T + pose.p_GC
        self._radius = rng.uniform(0.006, 0.011, count)
        self._names = tuple(str(n) for n in rng.choice(hues, count))
        self._colour = np.array([fabric_bgr(n) for n in self._names]).reshape(-1, 3)
        self._moving, self._wander = moving, SmoothNoise(rng, (count, 3), 1.0)

    def _positions(self, t: float) -> Array:
        return self._centre + self._moving * self._wander(np.array([t]))[0]

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        positions = self._positions(t)
        unowned = np.full(len(positions), UNOWNED)
        return capsules(positions, positions, self._radius, unowned, self._colour)

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        return self._positions(t), self._radius, self._names


@dataclass(frozen=True)
class HeldObject:
    """An object in the palm of ``hand``, fixed to the dorsum; ``kind`` is one of OBJECTS."""

    hand: HandModel
    kind: str = "ball"

    def __post_init__(self) -> None:
        if self.kind not in OBJECTS:
            raise ConfigError(
                notice("option.choice", option="--object", known=tuple(OBJECTS), value=self.kind)
            )

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        i = self.hand.root
        return self._in_dorsum().moved(R_GB[i], p_GB[i])

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        return _NO_BALLS

    def _in_dorsum(self) -> Solids:
        root = self.hand.segments[self.hand.root]
        grey, reach = np.array([150.0, 160.0, 165.0]), root.length + 0.012
        one = np.array([UNOWNED])
        if self.kind in ("box", "phone"):
            half = np.array(
                [[0.022, 0.055, 0.018] if self.kind == "box" else [0.037, 0.075, 0.005]]
            )
            centre = np.array([[reach, 0.0, -root.radius - half[0, 2] - 0.004]])
            return boxes(np.eye(3)[None], centre, half, one, grey)
        radius, half_length = _ROUND[self.kind]
        middle = np.array([reach, 0.0, -root.radius - radius - 0.003])
        half_axis = half_length * so3.rz(np.deg2rad(12)) @ np.array([0.0, 1.0, 0.0])
        ends = middle - half_axis, middle + half_axis
        return capsules(ends[0][None], ends[1][None], np.array([radius]), one, grey)


_ROUND = {
    "ball": (0.032, 0.0),
    "bottle": (0.030, 0.085),
    "can": (0.033, 0.035),
    "cup": (0.038, 0.030),
    "pen": (0.006, 0.070),
    "stick": (0.012, 0.120),
}
"""Radius and half length of the axis, m."""


@dataclass(frozen=True)
class FingertipDevices:
    """Haptic devices worn on fingertips: boxes that occlude the distal phalanges."""

    hand: HandModel
    fingers: tuple[str, ...] = ("thumb", "index")
    side: float = 0.013  # m, half of width and height
    extra: float = 0.006  # m beyond the tip

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        rows = [self.hand.index[f"{f}_distal"] for f in self.fingers]
        reach = np.array([(self.hand.segments[i].length + self.extra) / 2 for i in rows])
        half = np.column_stack([reach, np.full((len(rows), 2), self.side)])
        centre = p_GB[rows] + R_GB[rows][:, :, 0] * reach[:, None]
        return boxes(
            R_GB[rows], centre, half, np.full(len(rows), UNOWNED), np.array([45.0, 45.0, 50.0])
        )

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        return _NO_BALLS
