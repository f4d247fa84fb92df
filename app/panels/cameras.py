"""Both camera images, with detections and predicted markers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QSplitter, QToolButton, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.engines.host_parts import HandChanges
from app.engines.snapshot import Snapshot
from app.panels.panel import Panel
from app.storage.image_folder import Image
from app.viewmodels.camera_overlay import NO_LAYERS, Layers, hand_box, overlay
from app.viewmodels.colour_images import masks_image
from app.viewmodels.colours import hue_colours
from app.viewmodels.names import display_name
from app.widgets.icons import dress, text_by_icon
from app.widgets.image_view import ImageView
from app.widgets.measures import NEAR, TIGHT
from app.widgets.more_button import MoreButton
from app.widgets.one_line import OneLine
from app.words import notice_text
from tracker.messages import Shed, StereoFrame

BOTH, LEFT_ONLY, RIGHT_ONLY = range(3)


class CamerasPanel(Panel):
    period = 1 / 60
    set_up_requested = Signal()

    def __init__(self, host: HandChanges, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._waiting = self.tr("No image yet")
        self.left = ImageView(self.tr("Left"), self._waiting)
        self.right = ImageView(self.tr("Right"), self._waiting)
        self._shown: object = None
        self._alone = False
        self._view: Snapshot | None = None  # displayed snapshot; constant while frozen
        self.hue_boxes: dict[str, QToolButton] = {}
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, TIGHT, NEAR, NEAR)
        column.setSpacing(TIGHT)
        self._controls = OneLine()
        self._add_views()
        self._add_layers()
        column.addWidget(self._controls)
        splitter = QSplitter(Qt.Orientation.Horizontal)
        splitter.setChildrenCollapsible(False)
        for image in (self.left, self.right):
            splitter.addWidget(image)
        column.addWidget(splitter, 1)
        self.left.handled.connect(lambda: self._handled(self.left, self.right))
        self.right.handled.connect(lambda: self._handled(self.right, self.left))
        host.opened.connect(self._open)
        host.hand_changed.connect(self._open)

    # --- controls

    def _add_layers(self) -> None:
        """Add a check box for each layer of the overlay, behind one button."""
        self.more = MoreButton(self.tr("Layers"), "layers")
        self.more.setToolTip(self.tr("Choose what is drawn over the images"))
        self._controls.add(self.more)
        names = (
            (
                "blobs",
                self.tr("Blobs"),
                self.tr("A ring around each blob; dashed if no marker is assigned to it"),
            ),
            (
                "pairs",
                self.tr("Pairs"),
                self.tr("Filled rings: markers matched in both images"),
            ),
            (
                "rejected",
                self.tr("Rejected"),
                self.tr("Regions of the right colour but the wrong shape, with the reason"),
            ),
            (
                "predicted",
                self.tr("Predicted"),
                self.tr("Predicted marker positions, with ids and 2σ ellipses"),
            ),
            (
                "residuals",
                self.tr("Residuals"),
                self.tr("Lines from the predicted positions to the blobs"),
            ),
            ("skeleton", self.tr("Skeleton"), self.tr("The tracked hand")),
        )
        self._layer_boxes: dict[str, QCheckBox] = {}
        for name, text, tip in names:
            box = self._layer_boxes[name] = QCheckBox(text)
            box.setToolTip(tip)
            box.setChecked(True)
            box.toggled.connect(self._redraw)
            self.more.add(box)

    def _add_views(self) -> None:
        """Add the image views and their options."""
        self.masks = QCheckBox(self.tr("Masks"))
        self.masks.setToolTip(
            self.tr("Show the pixels of each marker colour; each colour has its own switch")
        )
        self.masks.toggled.connect(self._toggle_masks)
        self.follow = QCheckBox(self.tr("Follow hand"))
        self.follow.setChecked(True)
        self.follow.setToolTip(self.tr("Zoom both images to the hand"))
        self.follow.toggled.connect(self._fit_unless)
        self.freeze = QCheckBox(self.tr("Freeze"))
        self.freeze.setToolTip(self.tr("Freeze the images; tracking continues"))
        self.sides = QComboBox()
        self.sides.setAccessibleName(self.tr("Cameras shown"))
        self.sides.addItems([self.tr("Both cameras"), self.tr("Left only"), self.tr("Right only")])
        self.sides.currentIndexChanged.connect(self._choose_sides)
        self.set_up = QToolButton()
        self.set_up.setText(text_by_icon(self.tr("Exposure…")))
        self.set_up.setToolTip(self.tr("Lock exposure, gain and white balance; choose the camera"))
        self.set_up.clicked.connect(self.set_up_requested)
        self.set_up.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        dress(self.set_up, "settings-2")
        for widget in (self.sides, self.follow, self.freeze, self.masks, self.set_up):
            self._controls.add(widget)

    def _open(self, setup: EngineSetup) -> None:
        """Add a switch for each hue of the profile."""
        self._view = None
        self.freeze.setChecked(False)
        for box in self.hue_boxes.values():
            self._controls.take_out(box)
            box.deleteLater()
        self.hue_boxes = {}
        for name in setup.profile.hue_names:
            box = self.hue_boxes[name] = QToolButton()
            box.setText(display_name(name))
            box.setCheckable(True)
            box.setChecked(True)
            box.setToolTip(self.tr("Show the mask of {}").format(display_name(name)))
            box.toggled.connect(self._redraw)
            self._controls.add(box)
        self._toggle_masks(self.masks.isChecked())
        self._waiting = self.tr("No image yet") if setup.camera.present else self.tr("No camera")
        self._show_sides(setup.camera.is_single() or not setup.camera.present)

    def _toggle_masks(self, on: bool) -> None:
        for box in self.hue_boxes.values():
            box.setVisible(on)
        self._redraw()

    def layers(self) -> Layers:
        return Layers(**{name: box.isChecked() for name, box in self._layer_boxes.items()})

    def _drawn_layers(self, view: Snapshot) -> Layers:
        """The selected layers; none while the system is overloaded."""
        return NO_LAYERS if view.shed >= Shed.OVERLAYS else self.layers()

    def _shown_hues(self) -> tuple[str, ...] | None:
        """Names of the hues whose masks are shown; None to show the image."""
        if not self.masks.isChecked():
            return None
        return tuple(name for name, box in self.hue_boxes.items() if box.isChecked())

    def _handled(self, by_hand: ImageView, other: ImageView) -> None:
        """Stop following the hand after the user moved an image; apply the move to the other
        one."""
        other.show_like(by_hand)
        with QSignalBlocker(self.follow):
            self.follow.setChecked(False)

    def _fit_unless(self, following: bool) -> None:
        if not following:
            self.left.fit()
            self.right.fit()

    def _choose_sides(self, _choice: int) -> None:
        self._show_sides(self._alone)
        self._redraw()

    def _show_sides(self, alone: bool) -> None:
        """Show the selected images. With a single camera (``alone``) there is no selection."""
        choice = self.sides.currentIndex()
        self._alone = alone
        self.sides.setVisible(not alone)
        self.left.set_title(self.tr("Camera") if alone else self.tr("Left"))
        self.left.setVisible(alone or choice != RIGHT_ONLY)
        self.right.setVisible(not alone and choice != LEFT_ONLY)

    # --- displayed data

    def refresh(self, view: Snapshot | None) -> None:
        if view is None or view.frame is None:
            self._view = self._shown = None
            unfit = view.unfit if view is not None else None
            for image in (self.left, self.right):
                image.set_placeholder(
                    notice_text(unfit.why) if unfit is not None else self._waiting
                )
                image.show_image(None)
            return
        if not self.freeze.isChecked() or self._view is None:
            self._view = view
        else:  # masks of a frozen image use the current colours
            self._view = replace(self._view, setup=view.setup)
        alone = view.setup.camera.is_single(view.frame)
        if alone != self._alone:
            self._show_sides(alone)
        self._redraw()

    def _redraw(self) -> None:
        """Draw the latest or the frozen image, unless it is already displayed."""
        view = self._view
        if view is None or view.frame is None:
            return
        colours, side = view.setup.profile.hues, self.sides.currentIndex()
        key = (view.frame, self._drawn_layers(view), self._shown_hues(), colours, side)
        if key != self._shown:
            self._shown = key
            self._show(view, view.frame)

    def _show(self, view: Snapshot, frame: StereoFrame) -> None:
        layers, colours = self._drawn_layers(view), hue_colours(view.setup.profile)
        for widget, image, right in (
            (self.left, frame.left, False),
            (self.right, frame.right, True),
        ):
            if widget.isHidden():
                continue
            shapes = overlay(view, layers, colours, right)
            widget.show_image(self._image(view, image, right), shapes)
            if self.follow.isChecked():
                box = hand_box(view, right)
                if box is not None:
                    widget.follow(*box)
                else:
                    widget.fit()

    def _image(self, view: Snapshot, image: Image | None, right: bool) -> Image:
        """The image or its masks; black if the file contains no image."""
        hues = self._shown_hues()
        if image is None:
            camera = view.setup.camera.rig.right if right else view.setup.camera.rig.left
            return np.zeros((camera.height, camera.width), np.uint8)
        if hues is None:
            return image
        colours = hue_colours(view.setup.profile)
        wanted = {h: colours[h.name] for h in view.setup.profile.hues if h.name in hues}
        return masks_image(image, wanted)
