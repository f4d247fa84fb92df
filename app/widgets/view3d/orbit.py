"""An orbit camera, and its control by mouse and keys; z is up."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

Vector = NDArray[np.float64]
STEEPEST = np.deg2rad(89.0)
VIEW_ANGLE_DEG = 32.0
"""Vertical field of view."""


RAD_PER_PX = 0.008
KEY_TURN = 0.12  # rad
KEY_ZOOM = 0.85
TURNS = {
    Qt.Key.Key_Left: (1, 0),
    Qt.Key.Key_Right: (-1, 0),
    Qt.Key.Key_Up: (0, 1),
    Qt.Key.Key_Down: (0, -1),
}
ZOOMS = {Qt.Key.Key_Plus: KEY_ZOOM, Qt.Key.Key_Equal: KEY_ZOOM, Qt.Key.Key_Minus: 1 / KEY_ZOOM}


class Orbit:
    """Azimuth and elevation (rad) and distance (m) of the camera from ``target`` (3,) m."""

    def __init__(self) -> None:
        self.target: Vector = np.zeros(3)
        self.azimuth = np.deg2rad(200.0)
        self.elevation = np.deg2rad(35.0)
        self.distance = 0.42

    @property
    def direction(self) -> Vector:
        """Unit vector (3,) from the target to the camera."""
        c = np.cos(self.elevation)
        return np.array(
            [c * np.cos(self.azimuth), c * np.sin(self.azimuth), np.sin(self.elevation)]
        )

    @property
    def eye(self) -> Vector:
        return self.target + self.distance * self.direction

    @property
    def up(self) -> Vector:
        """(3,) upward direction of the image; also defined for a vertical view."""
        s = np.sin(self.elevation)
        c = np.cos(self.elevation)
        return np.array([-s * np.cos(self.azimuth), -s * np.sin(self.azimuth), c])

    @property
    def axes(self) -> Vector:
        """(3, 3): columns right, up, and towards the viewer."""
        s, c = math.sin(self.elevation), math.cos(self.elevation)
        sin, cos = math.sin(self.azimuth), math.cos(self.azimuth)
        return np.array([[-sin, -s * cos, c * cos], [cos, -s * sin, c * sin], [0.0, c, s]])

    def turn(self, azimuth: float, elevation: float) -> None:
        self.azimuth += azimuth
        self.elevation = float(np.clip(self.elevation + elevation, -STEEPEST, STEEPEST))

    def zoom(self, factor: float) -> None:
        self.distance = float(np.clip(self.distance * factor, 0.08, 5.0))

    def pan(self, right: float, up: float) -> None:
        """Move the target by fractions of the visible area."""
        across = np.cross(self.up, self.direction)
        self.target = self.target + self.distance * 0.57 * (right * across + up * self.up)

    def look_from(self, direction: Vector) -> None:
        """Move the camera to the ray from the target along ``direction`` (3,)."""
        d = direction / np.linalg.norm(direction)
        self.elevation = float(np.clip(np.arcsin(d[2]), -STEEPEST, STEEPEST))
        self.azimuth = float(np.arctan2(d[1], d[0]))

    def sees(self, points: Vector) -> bool:
        """Whether all points (N, 3) m are well in front of the camera and within its vertical field
        of view."""
        away = points - self.eye
        depth = away @ -self.direction
        across = away - depth[:, None] * -self.direction
        edge = np.tan(np.deg2rad(VIEW_ANGLE_DEG / 2)) * depth
        return bool((depth > 0.1).all() and (np.linalg.norm(across, axis=1) < edge).all())


class OrbitControl(QObject):
    """Event filter of ``widget``. The left button rotates, other buttons pan, the wheel zooms."""

    turned = Signal()

    def __init__(self, widget: QWidget, orbit: Orbit) -> None:
        super().__init__(widget)
        self._widget, self._orbit = widget, orbit
        self._drag: QPointF | None = None
        widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QMouseEvent):
            return self._mouse(event)
        if isinstance(event, QWheelEvent):
            self._orbit.zoom(0.999 ** event.angleDelta().y())
            self.turned.emit()
            return True
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            return self._key(Qt.Key(event.key()))
        return False

    def _mouse(self, event: QMouseEvent) -> bool:
        kind = event.type()
        if kind == QEvent.Type.MouseButtonPress:
            self._drag = event.position()
            self._widget.setFocus()
        elif kind == QEvent.Type.MouseButtonRelease:
            self._drag = None
        elif kind == QEvent.Type.MouseMove and self._drag is not None:
            step, self._drag = event.position() - self._drag, event.position()
            self._move(step, event.buttons())
        return True

    def _move(self, step: QPointF, buttons: Qt.MouseButton) -> None:
        if buttons & Qt.MouseButton.LeftButton:
            self._orbit.turn(-step.x() * RAD_PER_PX, step.y() * RAD_PER_PX)
        else:
            height = max(1, self._widget.height())
            self._orbit.pan(-step.x() / height, step.y() / height)
        self.turned.emit()

    def _key(self, key: Qt.Key) -> bool:
        if key in TURNS:
            across, up = TURNS[key]
            self._orbit.turn(across * KEY_TURN, up * KEY_TURN)
        elif key in ZOOMS:
            self._orbit.zoom(ZOOMS[key])
        else:
            return False
        self.turned.emit()
        return True
