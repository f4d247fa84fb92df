"""Selection of the wearer's profile, and the commands on the calibration."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFileDialog,
    QInputDialog,
    QLabel,
    QMenu,
    QToolButton,
    QWidget,
)

from app.viewmodels.names import display_name
from app.viewmodels.wearer_profiles import HAND_MM
from app.widgets.one_line import OneLine
from app.widgets.question import answer

PATTERN = "*.toml"
USUAL_MM = 185.0
NEW = 0  # row of the entry for a new wearer


class WearerRow(OneLine):
    """Emits the user's requests; `CalibrationPanel` executes them."""

    chosen = Signal(str)  # a profile's name; empty for a new wearer
    save = Signal(str)  # the name to save under
    remove = Signal(str)
    export = Signal(object)  # the Path of the file to be written
    take_in = Signal(object)  # the Path of a profile to be imported and selected
    measured = Signal(float)  # measured length of the hand, m
    guided = Signal()  # start the guided poses
    reset = Signal(object)  # a list of one segment, or None for all
    freeze = Signal(bool)
    compare = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.choice = QComboBox()
        self.choice.setAccessibleName(self.tr("Wearer of the glove"))
        self.choice.setMinimumContentsLength(14)
        self.choice.activated.connect(lambda _index: self.chosen.emit(self.name))
        self.frozen = QCheckBox(self.tr("Freeze"))
        self.frozen.setToolTip(self.tr("Stop updating the calibration; tracking continues"))
        self.frozen.clicked.connect(self.freeze)
        self.comparing = QCheckBox(self.tr("Compare"))
        self.comparing.setToolTip(self.tr("Show the changes since the last fit"))
        self.comparing.toggled.connect(self.compare)
        self.save_button = self._button(self.tr("Save"), self.tr("Save the calibration"))
        self._fill_save_menu()
        self.reset_button = self._button(self.tr("Reset"), self.tr("Discard the calibration"))
        self.import_button = self._plain(
            self.tr("Import…"), self.tr("Import a calibration profile from a file")
        )
        self.import_button.clicked.connect(self.ask_import)
        self.export_button = self._plain(
            self.tr("Export…"), self.tr("Export the calibration as a text file")
        )
        self.export_button.clicked.connect(self.ask_export)
        self.guided_button = self._plain(
            self.tr("Guided poses…"),
            self.tr("Calibrate your fingers and thumb with half a minute of guided poses"),
        )
        self.guided_button.clicked.connect(self.guided)
        self.length_button = self._plain(
            self.tr("Hand length…"),
            self.tr(
                "Enter the measured length: a single camera cannot determine the size of the hand"
            ),
        )
        self.length_button.clicked.connect(self.ask_length)
        self._segments: tuple[str, ...] = ()
        who = QLabel(self.tr("Wearer"))
        who.setBuddy(self.choice)
        for widget in (
            who,
            self.choice,
            self.save_button,
            self.guided_button,
            self.length_button,
            self.import_button,
            self.export_button,
            self.reset_button,
        ):
            self.add(widget)
        for box in (self.frozen, self.comparing):
            self.add(box)
        self.set_names((), "")

    def _plain(self, text: str, tip: str) -> QToolButton:
        button = QToolButton()
        button.setText(text)
        button.setToolTip(tip)
        return button

    def _button(self, text: str, tip: str) -> QToolButton:
        button = self._plain(text, tip)
        button.setMenu(QMenu(button))
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        return button

    def _fill_save_menu(self) -> None:
        menu = self.save_button.menu()
        self.again = menu.addAction(self.tr("Save"), lambda: self.save.emit(self.name))
        menu.addAction(self.tr("Save as…"), self.ask_name)
        menu.addSeparator()
        self.gone = menu.addAction(self.tr("Remove this profile"), self._remove)

    def _remove(self) -> None:
        self.remove.emit(self.name)

    def ask_name(self) -> None:
        """Ask for the name to save the calibration under."""
        title, words = self.tr("Save the calibration"), self.tr("Who wears the glove?")
        text = answer(self, title, words, self.name)
        if text:
            self.save.emit(text)

    def ask_export(self) -> None:
        """Ask for the file to export the calibration to."""
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Export the wearer's profile"), f"{self.name or 'wearer'}.toml", PATTERN
        )
        if path:
            chosen = Path(path)
            self.export.emit(chosen if chosen.suffix else chosen.with_suffix(".toml"))

    def ask_import(self) -> None:
        """Ask for the profile file to import."""
        path, _ = QFileDialog.getOpenFileName(
            self, self.tr("Import a wearer's profile"), "", PATTERN
        )
        if path:
            self.take_in.emit(Path(path))

    def ask_length(self) -> None:
        """Ask for the length of the hand; the calibration restarts with it."""
        words = self.tr("From the crease of the wrist to the tip of the middle finger, mm")
        length_mm, ok = QInputDialog.getDouble(
            self, self.tr("Hand length"), words, USUAL_MM, *HAND_MM, 0
        )
        if ok:
            self.measured.emit(length_mm / 1000)

    @property
    def name(self) -> str:
        """The selected profile; empty for a new wearer."""
        return self.choice.currentText() if self.choice.currentIndex() > NEW else ""

    def set_names(self, names: Sequence[str], chosen: str) -> None:
        """Offer these profiles and select ``chosen``."""
        self.choice.clear()
        self.choice.addItem(self.tr("New wearer"))
        self.choice.addItems(list(names))
        self.choice.setCurrentIndex(1 + list(names).index(chosen) if chosen in names else NEW)
        self.again.setEnabled(bool(self.name))
        self.gone.setEnabled(bool(self.name))

    def set_segments(self, segments: tuple[str, ...]) -> None:
        """Offer to reset each of these segments."""
        if segments == self._segments:
            return
        self._segments = segments
        menu = self.reset_button.menu()
        menu.clear()
        menu.addAction(self.tr("Everything"), partial(self.reset.emit, None))
        menu.addSeparator()
        for name in segments:
            menu.addAction(display_name(name), partial(self.reset.emit, [name]))

    def set_available(self, on: bool, guided: bool) -> None:
        """Disable the row if the engine takes no commands. ``guided``: it also supports guided
        poses."""
        for widget in (
            self.choice,
            self.length_button,
            self.save_button,
            self.import_button,
            self.export_button,
            self.reset_button,
            self.frozen,
        ):
            widget.setEnabled(on)
        self.guided_button.setEnabled(on and guided)
