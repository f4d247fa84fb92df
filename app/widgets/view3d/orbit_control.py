"""Mouse, wheel and keys that turn, move and zoom an `Orbit`, on any widget."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from app.widgets.view3d.orbit import Orbit

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


class OrbitControl(QObject):
    """Filters the events of ``widget``. Left button turns, another one moves, the wheel zooms."""

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
