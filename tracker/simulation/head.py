"""A head-mounted camera: it moves, and reports its pose with errors."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.geometry import so3
from tracker.messages import Array, CameraPose
from tracker.simulation.smooth import SmoothNoise, rng_for


@dataclass(frozen=True)
class HeadParams:
    """Standard deviations along or about each axis; all zero for a static camera.

    ``turn_deg`` (°/s) is the peak rate of a head that turns from side to side with ``turn_hz`` Hz.
    ``tells``: what it reports: its "pose" with each image, the measurements of its "imu", or
    "nothing".
    """

    sway_mm: float = 0.0
    sway_deg: float = 0.0
    sway_time: float = 1.5  # s, correlation
    error_mm: float = 0.0  # of the reported pose
    error_deg: float = 0.0
    error_time: float = 1.5
    turn_deg: float = 0.0
    turn_hz: float = 1.5
    tells: str = "pose"


MOVING = HeadParams(sway_mm=15.0, sway_deg=3.0, error_mm=3.0, error_deg=0.5)
"""A seated person's head with a visual odometry of ordinary quality."""


class Head:
    """The true and the reported pose of the camera."""

    def __init__(self, stand: CameraPose, seed: int, params: HeadParams | None = None) -> None:
        self._stand, self._params = stand, params or HeadParams()
        rng = rng_for(seed, "head")
        self._sway = SmoothNoise(rng, (2, 3), self._params.sway_time)
        self._error = SmoothNoise(rng, (2, 3), self._params.error_time)

    @property
    def moves(self) -> bool:
        """Whether a pose is reported with each frame."""
        p = self._params
        return any((p.sway_mm, p.sway_deg, p.error_mm, p.error_deg, p.turn_deg))

    def pose(self, t: float) -> CameraPose:
        """The true pose of the left camera in G at the time t (s)."""
        p = self._params
        pose = _moved(self._stand, self._sway(np.array([t]))[0], p.sway_mm, p.sway_deg)
        if p.turn_deg == 0:
            return pose
        omega = 2 * np.pi * p.turn_hz
        turned = np.deg2rad(p.turn_deg) / omega * np.sin(omega * t)
        return CameraPose(pose.R_GC @ so3.exp(np.array([0.0, turned, 0.0])), pose.p_GC)

    def reported(self, t: float) -> CameraPose | None:
        """The pose from the camera's odometry; None for a static camera or without odometry."""
        if not self.moves or self._params.tells != "pose":
            return None
        p = self._params
        return _moved(self.pose(t), self._error(np.array([t]))[0], p.error_mm, p.error_deg)


def _moved(pose: CameraPose, unit: Array, mm: float, degrees: float) -> CameraPose:
    """``pose`` shifted in G by unit[0] and rotated about its own axes by unit[1]."""
    if mm == 0 and degrees == 0:
        return pose
    turn = so3.exp(np.deg2rad(degrees) * unit[1])
    return CameraPose(pose.R_GC @ turn, pose.p_GC + 1e-3 * mm * unit[0])
