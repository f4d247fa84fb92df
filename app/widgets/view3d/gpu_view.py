"""The 3D view rendered by VTK on a graphics card.

Only pyvistaqt's QtInteractor is used. It is imported on use because that takes two seconds.
"""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from app.platform.graphics import gl_renderer, is_card
from app.widgets.view3d.orbit import Orbit
from app.widgets.view3d.scene import Label
from app.widgets.view3d.vtk_scene import VtkScene

SMOOTH_SAMPLES = 4
"""Multisampling on a graphics card; a software renderer would take four times as long."""


class GpuView(QWidget):
    """Raises ImportError without pyvistaqt, and exceptions of VTK and Qt without OpenGL."""

    on_card = True

    def __init__(self, orbit: Orbit, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        import pyvistaqt  # deferred: VTK takes a second

        self._orbit = orbit
        make_surface: Any = pyvistaqt.QtInteractor
        self.surface: Any = make_surface(self, auto_update=False, lighting="none")
        software = not is_card(gl_renderer())
        self.surface.render_window.SetMultiSamples(0 if software else SMOOTH_SAMPLES)
        self.surface.disable()  # disables its own mouse control; `OrbitControl` is used
        self.scene: VtkScene | None = VtkScene(self.surface.renderer)
        self._label = QLabel()
        self._label.setStyleSheet("color: #E69F00")
        self._label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._label.setWordWrap(True)
        self._label.hide()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.surface, 1)
        column.addWidget(self._label)

    def set_caption(self, text: str) -> None:
        self._label.setText(text)
        self._label.setVisible(bool(text))

    def set_labels(self, labels: tuple[Label, ...]) -> None:
        if self.scene is not None:
            self.scene.set_labels(labels)

    def render_scene(self) -> None:
        """Render the scene. RuntimeError if the driver draws nothing."""
        if self.scene is None or not self.surface.isVisible():
            return
        self.scene.look_from(self._orbit)
        self.surface.render()
        context = self.surface.context()
        if context is None or not context.isValid():
            raise RuntimeError("the OpenGL context is gone")

    def shut_down(self) -> None:
        """Release resources of the graphics card."""
        if self.scene is not None:
            self.scene = None
            self.surface.close()
