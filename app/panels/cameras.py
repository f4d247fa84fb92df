"""Both pictures, with what was found in them and where markers were expected."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QSplitter, QVBoxLayout, QWidget

from app.panels.panel import Panel
from app.session import Session
from app.viewmodels.colours import hue_colours
from app.viewmodels.overlay import Layers, hand_box, overlay
from app.viewmodels.snapshot import Snapshot
from app.widgets.picture_view import PictureView
from tracker.messages import StereoFrame


class CamerasPanel(Panel):
    name = "cameras"
    period = 1 / 60

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(session, parent)
        waiting = self.tr("No picture yet")
        self.left = PictureView(self.tr("Left"), waiting)
        self.right = PictureView(self.tr("Right"), waiting)
        self._shown: tuple[StereoFrame | None, Layers, int] | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        column.setSpacing(6)
        column.addLayout(self._controls())
        splitter = QSplitter(Qt.Orientation.Horizontal)
        splitter.setChildrenCollapsible(False)
        splitter.addWidget(self.left)
        splitter.addWidget(self.right)
        column.addWidget(splitter, 1)

    def title(self) -> str:
        return self.tr("Cameras")

    def _controls(self) -> QHBoxLayout:
        self._layer_boxes = {
            "blobs": QCheckBox(self.tr("Blobs")),
            "rejected": QCheckBox(self.tr("Rejected")),
            "predicted": QCheckBox(self.tr("Expected")),
            "residuals": QCheckBox(self.tr("Residuals")),
            "skeleton": QCheckBox(self.tr("Skeleton")),
        }
        self.freeze = QCheckBox(self.tr("Freeze"))
        self.follow = QCheckBox(self.tr("Follow hand"))
        self.follow.setChecked(True)
        self.follow.setToolTip(self.tr("Keep the hand large in both pictures"))
        self.follow.toggled.connect(self._fit_unless)
        self.freeze.setToolTip(self.tr("Hold the pictures; tracking goes on"))
        self.sides = QComboBox()
        self.sides.addItems([self.tr("Both cameras"), self.tr("Left only"), self.tr("Right only")])
        self.sides.currentIndexChanged.connect(self._choose_sides)
        row = QHBoxLayout()
        row.setSpacing(12)
        for box in self._layer_boxes.values():
            box.setChecked(True)
            row.addWidget(box)
        row.addStretch(1)
        row.addWidget(self.follow)
        row.addWidget(self.freeze)
        row.addWidget(self.sides)
        return row

    def layers(self) -> Layers:
        return Layers(**{name: box.isChecked() for name, box in self._layer_boxes.items()})

    def _fit_unless(self, following: bool) -> None:
        if not following:
            self.left.fit()
            self.right.fit()

    def _choose_sides(self, choice: int) -> None:
        self.left.setVisible(choice != 2)
        self.right.setVisible(choice != 1)
        self._shown = None

    def refresh(self, view: Snapshot | None) -> None:
        if self.freeze.isChecked():
            return
        if view is None or view.frame is None:
            self.left.show_picture(None)
            self.right.show_picture(None)
            return
        key = (view.frame, self.layers(), self.sides.currentIndex())
        if key == self._shown:
            return  # the same picture again costs nothing
        self._shown = key
        self._show(view, view.frame)

    def _show(self, view: Snapshot, frame: StereoFrame) -> None:
        layers, colours = self.layers(), hue_colours(view.setup.profile)
        for widget, picture, right in (
            (self.left, frame.left, False),
            (self.right, frame.right, True),
        ):
            if widget.isHidden():
                continue
            if picture is None:
                camera = view.setup.rig.right if right else view.setup.rig.left
                picture = np.zeros((camera.height, camera.width), np.uint8)
            widget.show_picture(picture, overlay(view, layers, colours, right))
            box = hand_box(view, right) if self.follow.isChecked() else None
            if box is not None:
                widget.follow(*box)
            elif self.follow.isChecked():
                widget.fit()
