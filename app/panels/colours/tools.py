"""The tools of the Colours panel: eyedropper, fits, undo and redo, import and export."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal, SignalInstance
from PySide6.QtWidgets import QFileDialog, QMenu, QToolButton, QWidget

from app.viewmodels.colour_picks import Eyedropper
from app.viewmodels.colour_tuning import ColourTuning
from app.widgets.one_line import OneLine
from app.words import error_text
from tracker.base.errors import GlovetrackError


class ColoursTools(OneLine):
    """Buttons; `ColoursPanel` executes the requests."""

    picking = Signal(bool)
    undo = Signal()
    redo = Signal()
    fit_live = Signal()
    fit_image = Signal()
    fit_markers = Signal()
    load = Signal()
    save = Signal()
    shipped = Signal()
    factory = Signal()
    room = Signal()
    take_over = Signal(str)  # the name of a camera

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.take = self._toggle(
            self.tr("Pick ="),
            self.tr(
                "Eyedropper: click a marker to set the ranges of the selected hue to its colour"
            ),
        )
        self.pick = self._toggle(
            self.tr("Pick +"),
            self.tr(
                "Eyedropper: click a pixel to include it in the ranges, Ctrl+click to exclude it. "
                "Once a marker of each colour has been clicked, the colours are learned."
            ),
        )
        self.drop = self._toggle(
            self.tr("Pick −"), self.tr("Eyedropper: click a pixel to exclude it from the ranges")
        )
        self._droppers = {
            Eyedropper.SET: self.take,
            Eyedropper.ADD: self.pick,
            Eyedropper.REMOVE: self.drop,
        }
        for dropper in self._droppers.values():
            dropper.toggled.connect(lambda on, me=dropper: self._toggled(me, on))
        for widget in (*self._droppers.values(), self._fit_button()):
            self.add(widget)
        self.add(self._button(self.tr("Undo"), self.undo))
        self.add(self._button(self.tr("Redo"), self.redo))
        self.add(self._profile_button())

    @property
    def dropper(self) -> Eyedropper | None:
        """The selected eyedropper."""
        return next((how for how, button in self._droppers.items() if button.isChecked()), None)

    def _toggled(self, button: QToolButton, on: bool) -> None:
        """Deselect the other eyedroppers."""
        if on:
            for other in self._droppers.values():
                if other is not button:
                    other.setChecked(False)
        self.picking.emit(self.is_picking)

    @property
    def is_picking(self) -> bool:
        """Whether an eyedropper is selected."""
        return self.dropper is not None

    @staticmethod
    def _toggle(text: str, tip: str) -> QToolButton:
        button = QToolButton()
        button.setText(text)
        button.setCheckable(True)
        button.setToolTip(tip)
        return button

    @staticmethod
    def _button(text: str, signal: SignalInstance) -> QToolButton:
        button = QToolButton()
        button.setText(text)
        button.clicked.connect(lambda _checked=False: signal.emit())
        return button

    def _menu_button(self, text: str) -> tuple[QToolButton, QMenu]:
        button = QToolButton()
        button.setText(text)
        menu = QMenu(button)
        menu.setToolTipsVisible(True)
        button.setMenu(menu)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        return button, menu

    def _fit_button(self) -> QToolButton:
        button, menu = self._menu_button(self.tr("Fit"))
        live = menu.addAction(self.tr("From live images"), self.fit_live.emit)
        live.setToolTip(self.tr("Hold the hand in view: the IMUs help to find it in any light"))
        image = menu.addAction(self.tr("From this image only"), self.fit_image.emit)
        image.setToolTip(
            self.tr("Searches the image for a group of patches in the glove's colours")
        )
        markers = menu.addAction(self.tr("From the tracked markers"), self.fit_markers.emit)
        markers.setToolTip(self.tr("Measures the colours of the markers that are tracked"))
        menu.addSeparator()
        room = menu.addAction(self.tr("Check the background"), self.room.emit)
        room.setToolTip(self.tr("Move the hand out of the image first"))
        return button

    def _profile_button(self) -> QToolButton:
        button, menu = self._menu_button(self.tr("Profile"))
        menu.addAction(self.tr("Import…"), self.load.emit)
        menu.addAction(self.tr("Export…"), self.save.emit)
        self._others = menu.addMenu(self.tr("Copy from another camera"))
        menu.addSeparator()
        start = menu.addAction(self.tr("Restore the initial colours"), self.shipped.emit)
        start.setToolTip(self.tr("The colours at the start of this session"))
        factory = menu.addAction(self.tr("Factory colours"), self.factory.emit)
        factory.setToolTip(self.tr("The colours shipped with Glovetrack"))
        return button

    def set_cameras(self, cameras: Sequence[str]) -> None:
        """Offer the colours of other cameras."""
        self._others.clear()
        self._others.setEnabled(bool(cameras))
        for camera in cameras:
            self._others.addAction(camera, partial(self.take_over.emit, camera))


class ColoursFiles(QObject):
    """Imports into ``tuning`` (``loaded``) and exports from it (``saved``)."""

    loaded = Signal()
    saved = Signal()
    failed = Signal(str)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._parent = parent
        self.tuning: ColourTuning | None = None

    def ask_load(self) -> None:
        title = self.tr("Colour profile")
        path, _ = QFileDialog.getOpenFileName(self._parent, title, "", "*.toml")
        if path:
            self.load(Path(path))

    def ask_save(self) -> None:
        title = self.tr("Export the colours")
        path, _ = QFileDialog.getSaveFileName(self._parent, title, "colours.toml", "*.toml")
        if path:
            chosen = Path(path)
            self.save(chosen if chosen.suffix else chosen.with_suffix(".toml"))

    def load(self, path: Path) -> None:
        if self.tuning is None:
            return
        try:
            self.tuning.load(path)
        except GlovetrackError as error:
            self.failed.emit(error_text(error))
        else:
            self.loaded.emit()

    def save(self, path: Path) -> None:
        if self.tuning is None:
            return
        try:
            self.tuning.save(path)
        except GlovetrackError as error:
            self.failed.emit(error_text(error))
        else:
            self.saved.emit()
