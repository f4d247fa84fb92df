"""Tuning the colour profile on the live or a held picture."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QFileDialog,
    QGridLayout,
    QHBoxLayout,
    QPushButton,
    QRadioButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.engine import EngineSetup
from app.panels.panel import Panel
from app.session import Session
from app.settings import SettingsStore
from app.viewmodels.colours import (
    ProfileHistory,
    hue_histogram,
    hue_rows,
    mask_picture,
    pixel_hsv,
    stretched,
    with_channel,
    with_range,
    without_pixel,
)
from app.viewmodels.snapshot import Snapshot
from app.widgets.chip import Chip
from app.widgets.hue_strip import HueStrip
from app.widgets.picture_view import PictureView
from app.widgets.range_row import RangeRow
from tracker.errors import GlovetrackError
from tracker.vision.colours import ColourProfile, HueRange, load_profile, profile_to_toml

MASK_STEP = 2
CHANNELS = ("hue", "saturation", "value")


class ColoursPanel(Panel):
    name = "colours"
    period = 1 / 8

    def __init__(
        self, session: Session, store: SettingsStore, parent: QWidget | None = None
    ) -> None:
        super().__init__(session, parent)
        self._store = store
        self._history: ProfileHistory | None = None
        self._picture: NDArray[np.uint8] | None = None
        self._hue = 0
        self._holding = False
        self._hues = QGridLayout()
        self._hues.setHorizontalSpacing(8)
        self._group = QButtonGroup(self)
        self._group.idClicked.connect(self.choose_hue)
        self._chips: list[Chip] = []
        self.strip = HueStrip()
        self.mask_view = PictureView(self.tr("Mask"), self.tr("No picture yet"))
        self.mask_view.picked.connect(self._picked)
        self.rows = {
            "hue": RangeRow(self.tr("Hue"), 179, wraps=True),
            "saturation": RangeRow(self.tr("Saturation"), 255),
            "value": RangeRow(self.tr("Value"), 255),
        }
        for key, row in self.rows.items():
            row.changed.connect(lambda a, b, held, key=key: self._set(key, a, b, held))
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 8, 8, 8)
        column.setSpacing(6)
        column.addLayout(self._hues)
        for row in self.rows.values():
            column.addWidget(row)
        column.addWidget(self.strip)
        column.addWidget(self.mask_view, 1)
        column.addLayout(self._buttons())
        session.opened.connect(self._open)

    def title(self) -> str:
        return self.tr("Colours")

    def _buttons(self) -> QHBoxLayout:
        self.pick = QToolButton()
        self.pick.setText(self.tr("Eyedropper"))
        self.pick.setCheckable(True)
        self.pick.setToolTip(self.tr("Click takes a pixel in, Ctrl+click leaves it out"))
        self.pick.toggled.connect(self.mask_view.set_picking)
        self.hold = QCheckBox(self.tr("Hold picture"))
        row = QHBoxLayout()
        row.addWidget(self.pick)
        row.addWidget(self.hold)
        row.addStretch(1)
        for text, slot in (
            (self.tr("Undo"), self.undo),
            (self.tr("Redo"), self.redo),
            (self.tr("Load…"), self.load),
            (self.tr("Save…"), self.save),
        ):
            button = QPushButton(text)
            button.clicked.connect(slot)
            row.addWidget(button)
        return row

    # --- the profile

    @property
    def profile(self) -> ColourProfile | None:
        return self._history.profile if self._history is not None else None

    def _open(self, setup: EngineSetup) -> None:
        self._history = ProfileHistory(setup.profile)
        self._hue = 0
        for button in self._group.buttons():
            self._group.removeButton(button)
            button.deleteLater()
        for chip in self._chips:
            chip.deleteLater()
        self._chips = []
        for i, hue in enumerate(setup.profile.hues):
            button = QRadioButton(hue.name)
            self._group.addButton(button, i)
            chip = Chip()
            self._chips.append(chip)
            self._hues.addWidget(button, i // 2, 2 * (i % 2))
            self._hues.addWidget(chip, i // 2, 2 * (i % 2) + 1)
        self.choose_hue(0)

    def choose_hue(self, index: int) -> None:
        self._hue = index
        self._group.button(index).setChecked(True)
        self._show_ranges()

    def _range(self) -> HueRange | None:
        return self.profile.hues[self._hue] if self.profile is not None else None

    def _show_ranges(self) -> None:
        current = self._range()
        if current is not None:
            for key in CHANNELS:
                self.rows[key].set_values(*getattr(current, key))

    def _set(self, key: str, low: int, high: int, held: bool) -> None:
        current = self._range()
        if current is None:
            return
        self._change(with_channel(current, key, (low, high)), self._holding)
        self._holding = held

    def _change(self, changed: HueRange, merge: bool = False) -> None:
        assert self._history is not None
        self._history.change(with_range(self._history.profile, changed), merge)
        self._apply()

    def _apply(self) -> None:
        """Give the profile to the engine: the next picture is searched with it."""
        if self._history is not None:
            self.session.set_profile(self._history.profile)
            self._show_ranges()
            self._draw(None)

    def undo(self) -> None:
        if self._history is not None and self._history.undo():
            self._apply()

    def redo(self) -> None:
        if self._history is not None and self._history.redo():
            self._apply()

    def _picked(self, u: float, v: float, modifiers: Qt.KeyboardModifier) -> None:
        current = self._range()
        if current is None or self._picture is None:
            return
        hsv = pixel_hsv(self._picture, u * MASK_STEP, v * MASK_STEP)
        leave_out = bool(modifiers & Qt.KeyboardModifier.ControlModifier)
        self._change(without_pixel(current, hsv) if leave_out else stretched(current, hsv))

    def load(self) -> None:
        path, _ = QFileDialog.getOpenFileName(self, self.tr("Colour profile"), "", "*.toml")
        if path:
            self.load_file(Path(path))

    def load_file(self, path: Path) -> None:
        if self._history is None:
            return
        try:
            loaded = load_profile(path)
        except GlovetrackError as error:
            self.session.error.emit(str(error))
            return
        if loaded.hue_names != self._history.profile.hue_names:
            names = ", ".join(self._history.profile.hue_names)
            self.session.error.emit(
                self.tr("{} must have the hues {} for this glove.").format(path.name, names)
            )
            return
        self._history.change(loaded)
        self._apply()
        self._store.update(profile=str(path))

    def save(self) -> None:
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save the profile"), "colours.toml", "*.toml"
        )
        if path:
            self.save_file(Path(path))

    def save_file(self, path: Path) -> None:
        if self.profile is None:
            return
        try:
            path.write_text(profile_to_toml(self.profile), "utf-8")
        except OSError as error:
            reason = error.strerror or str(error)
            self.session.error.emit(
                self.tr("The profile was not saved to {}: {}.").format(path, reason)
            )
            return
        self._store.update(profile=str(path))

    # --- what it shows

    def refresh(self, view: Snapshot | None) -> None:
        if view is None or self._history is None:
            return
        if view.frame is not None and not self.hold.isChecked():
            self._picture = view.frame.left
        self._draw(view)

    def _draw(self, view: Snapshot | None) -> None:
        current, profile = self._range(), self.profile
        if current is None or profile is None:
            return
        rows = hue_rows(view, profile)
        if view is not None:
            for chip, row in zip(self._chips, rows, strict=True):
                look, text = row.look, row.count
                chip.show_state(look.colour, look.sign, row.clash or text, text)
        if self._picture is not None:
            self.mask_view.show_picture(mask_picture(self._picture, current, MASK_STEP))
            intervals = [(*h.hue, row.colour) for h, row in zip(profile.hues, rows, strict=True)]
            self.strip.show_hues(hue_histogram(self._picture), intervals)
