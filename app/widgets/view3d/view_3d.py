"""The 3D view: rendered on the graphics card if possible, otherwise in software."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Signal
from PySide6.QtWidgets import QSizePolicy, QVBoxLayout, QWidget

from app.widgets.view3d.orbit import Orbit, OrbitControl
from app.widgets.view3d.painted_view import PaintedView
from app.widgets.view3d.scene import BodyScene, Label, contrast

if TYPE_CHECKING:
    from app.widgets.view3d.gpu_view import GpuView

_log = logging.getLogger(__name__)


LEAST = 4.5  # minimum contrast of text
STEPS = 20


def luminance(colour: str) -> float:
    """Relative luminance of ``#rrggbb`` in sRGB, 0 to 1 (WCAG 2.1)."""
    shares = [share / 255 for share in _channels(colour)]
    linear = [s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast_of(one: str, other: str) -> float:
    """Contrast ratio: 1 for identical colours, 21 for black on white."""
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


@cache
def legible(colour: str, ground: str) -> str:
    """``colour``, made darker or lighter until text is legible on ``ground`` (WCAG 2.1, 1.4.3)."""
    end = max(("#000000", "#FFFFFF"), key=lambda c: contrast_of(c, ground))
    mixed = (_mixed(colour, end, k / STEPS) for k in range(STEPS + 1))
    return next((c for c in mixed if contrast_of(c, ground) >= LEAST), end)


def _mixed(one: str, other: str, share: float) -> str:
    pairs = zip(_channels(one), _channels(other), strict=True)
    return "#" + "".join(f"{round(a + share * (b - a)):02x}" for a, b in pairs)


def _channels(colour: str) -> list[int]:
    return [int(colour[i : i + 2], 16) for i in (1, 3, 5)]


class View3D(QWidget):
    """Owns the orbit and the renderer; ``scene`` is None after shut-down.

    ``scene_changed``: another renderer is in use, with an empty scene.
    """

    scene_changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.orbit = Orbit()
        self._background = "#000000"
        self._labels: tuple[Label, ...] = ()
        self._view: PaintedView | GpuView | None = None
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self.setMinimumSize(200, 48)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.use_painted()

    def sizeHint(self) -> QSize:
        return QSize(480, 400)

    # --- which view

    @property
    def scene(self) -> BodyScene | None:
        return self._view.scene if self._view is not None else None

    @property
    def on_card(self) -> bool:
        """Whether the graphics card renders the view."""
        return self._view is not None and self._view.on_card

    def use_painted(self) -> None:
        """Use software rendering."""
        self._put(PaintedView(self.orbit))

    def use_card(self) -> bool:
        """Use the graphics card; False, without a change, if that fails."""
        try:
            from app.widgets.view3d.gpu_view import (
                GpuView,  # deferred: needs the extra packages of the graphics card's view
            )

            view = GpuView(self.orbit)
        except Exception as error:  # noqa: BLE001  a dead driver fails in its own ways
            _log.warning("The 3D view stays painted: %s", error)
            return False
        self._put(view)
        return True

    def _put(self, view: PaintedView | GpuView) -> None:
        """Replace the current renderer."""
        before, self._view = self._view, view
        if before is not None:
            self._column.removeWidget(before)
            before.shut_down()
            before.deleteLater()
        surface = getattr(view, "surface", view)
        surface.setAccessibleName(self.tr("The hand in 3D"))
        OrbitControl(surface, self.orbit).turned.connect(self.render_scene)
        self.setFocusProxy(surface)
        self._column.addWidget(view, 1)
        if view.scene is not None:
            view.scene.set_background(self._background)
            view.scene.set_ink(contrast(self._background))
        self._write_labels()
        self.scene_changed.emit()

    # --- drawing

    @property
    def caption(self) -> str:
        return self._caption

    @caption.setter
    def caption(self, text: str) -> None:
        self._caption = text
        if self._view is not None:
            self._view.set_caption(text)

    _caption = ""

    def set_background(self, colour: str) -> None:
        self._background = colour
        if self.scene is not None:
            self.scene.set_background(colour)
            self.scene.set_ink(contrast(colour))
        self._write_labels()

    def set_labels(self, labels: Sequence[Label]) -> None:
        """Set short texts next to points of G, drawn over everything."""
        if tuple(labels) != self._labels:  # by identity
            self._labels = tuple(labels)
            self._write_labels()

    def _write_labels(self) -> None:
        if self._view is not None:
            ground = self._background
            legible_labels = (replace(w, colour=legible(w.colour, ground)) for w in self._labels)
            self._view.set_labels(tuple(legible_labels))

    def render_scene(self) -> None:
        """Render the scene; if the graphics card fails, switch to software rendering."""
        if self._view is None:
            return
        try:
            self._view.render_scene()
        except Exception as error:
            if not self.on_card:
                raise
            _log.warning("The graphics card gave up, the 3D view is painted from now on: %s", error)
            self.use_painted()

    def shut_down(self) -> None:
        """Release the renderer's resources before its window is deleted."""
        if self._view is not None:
            self._view.shut_down()
            self._view = None
