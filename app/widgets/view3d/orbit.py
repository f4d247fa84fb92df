"""An eye that turns about a point; z is up."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
STEEPEST = np.deg2rad(89.0)
VIEW_ANGLE_DEG = 32.0
"""From the lower to the upper side of the image that the eye sees."""


class Orbit:
    """Azimuth and elevation (rad) and distance (m) of the eye from ``target`` (3,) m."""

    def __init__(self) -> None:
        self.target: Vector = np.zeros(3)
        self.azimuth = np.deg2rad(200.0)
        self.elevation = np.deg2rad(35.0)
        self.distance = 0.42

    @property
    def direction(self) -> Vector:
        """Unit vector (3,) from the target to the eye."""
        c = np.cos(self.elevation)
        return np.array(
            [c * np.cos(self.azimuth), c * np.sin(self.azimuth), np.sin(self.elevation)]
        )

    @property
    def eye(self) -> Vector:
        return self.target + self.distance * self.direction

    @property
    def up(self) -> Vector:
        """(3,) the image's upward direction, defined straight above too."""
        s = np.sin(self.elevation)
        c = np.cos(self.elevation)
        return np.array([-s * np.cos(self.azimuth), -s * np.sin(self.azimuth), c])

    def turn(self, azimuth: float, elevation: float) -> None:
        self.azimuth += azimuth
        self.elevation = float(np.clip(self.elevation + elevation, -STEEPEST, STEEPEST))

    def zoom(self, factor: float) -> None:
        self.distance = float(np.clip(self.distance * factor, 0.08, 5.0))

    def pan(self, right: float, up: float) -> None:
        """Move the target by fractions of what the view shows."""
        across = np.cross(self.up, self.direction)
        self.target = self.target + self.distance * 0.57 * (right * across + up * self.up)

    def look_from(self, direction: Vector) -> None:
        """Put the eye on the ray from the target along ``direction`` (3,)."""
        d = direction / np.linalg.norm(direction)
        self.elevation = float(np.clip(np.arcsin(d[2]), -STEEPEST, STEEPEST))
        self.azimuth = float(np.arctan2(d[1], d[0]))

    def sees(self, points: Vector) -> bool:
        """Whether all points (N, 3) m lie well before the eye and within the height of its view."""
        away = points - self.eye
        depth = away @ -self.direction
        across = away - depth[:, None] * -self.direction
        edge = np.tan(np.deg2rad(VIEW_ANGLE_DEG / 2)) * depth
        return bool((depth > 0.1).all() and (np.linalg.norm(across, axis=1) < edge).all())
