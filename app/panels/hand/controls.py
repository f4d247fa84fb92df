"""What the user chooses about the 3D hand: where it is seen from, and what is shown beside it."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QToolButton, QWidget

from app.viewmodels.hand_scene import ShownParts
from app.viewmodels.names import engine_name, spoken
from app.widgets.one_line import OneLine
from tracker.engine.kinds import engine_kinds

NO_REFERENCE, OTHER = "", "other"


class HandControls(OneLine):
    """The row over the 3D view; says what is wanted."""

    look_from = Signal(str)  # "back", "palm", "side" or "camera"
    reference_chosen = Signal(str)  # an engine to run beside the first; empty for none
    trail_chosen = Signal(str)  # a fingertip; empty for none

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._add_presets()
        self.reference = self._reference()
        self.name_other("")
        self.add(self.reference)
        self._add_boxes()
        self.trail = self._trail()
        self.add(self.trail)

    def _add_presets(self) -> None:
        """Buttons that look from somewhere."""
        presets = {
            "back": self.tr("Back"),
            "palm": self.tr("Palm"),
            "side": self.tr("Side"),
            "camera": self.tr("Camera"),
        }
        self.presets: dict[str, QToolButton] = {}
        for name, text in presets.items():
            button = self.presets[name] = QToolButton()
            button.setText(text)
            button.setToolTip(self.tr("Look from there"))
            button.clicked.connect(lambda _on, name=name: self.look_from.emit(name))
            self.add(button)

    def _add_boxes(self) -> None:
        """What is shown beside the hand."""
        boxes = (
            (
                "markers",
                self.tr("Markers"),
                self.tr("Large: seen now. Small: lately. Ring: never"),
            ),
            (
                "uncertainty",
                self.tr("2σ"),
                self.tr(
                    "A ring round each fingertip, of two standard deviations; "
                    "broken: more than its 15 mm"
                ),
            ),
            ("camera", self.tr("Camera"), self.tr("The left camera's field of view")),
            ("axes", self.tr("Axes"), self.tr("The frame of each segment at its joint: x, y, z")),
        )
        self.boxes: dict[str, QCheckBox] = {}
        for name, text, tip in boxes:
            box = self.boxes[name] = QCheckBox(text)
            box.setToolTip(tip)
            box.setChecked(name != "axes")
            self.add(box)

    def _reference(self) -> QComboBox:
        choice = QComboBox()
        choice.setAccessibleName(self.tr("Hand to compare with"))
        choice.setToolTip(
            self.tr(
                "The outline of another hand: the truth of a simulated one, the second tracking "
                "of a replay, or another engine on the same data"
            )
        )
        choice.addItem(self.tr("No reference"), NO_REFERENCE)
        choice.addItem("", OTHER)
        for name in engine_kinds():
            choice.addItem(self.tr("Reference: {}").format(engine_name(name)), name)
        choice.currentIndexChanged.connect(lambda _i: self.reference_chosen.emit(self.engine))
        return choice

    def _trail(self) -> QComboBox:
        choice = QComboBox()
        choice.setAccessibleName(self.tr("Fingertip whose way is drawn"))
        choice.setToolTip(self.tr("The way of a fingertip over the last three seconds"))
        choice.addItem(self.tr("No trail"), "")
        choice.currentIndexChanged.connect(
            lambda _i: self.trail_chosen.emit(str(choice.currentData() or ""))
        )
        return choice

    @property
    def engine(self) -> str:
        """The engine to be compared with; empty where none is chosen."""
        chosen = str(self.reference.currentData())
        return "" if chosen == OTHER else chosen

    def shown(self) -> ShownParts:
        ticked = {name: box.isChecked() for name, box in self.boxes.items()}
        reference = self.reference.currentData() != NO_REFERENCE
        return ShownParts(**ticked, reference=reference, trail=bool(self.trail.currentData()))

    def show_reference(self, name: str) -> None:
        """Draw the other hand, now that there is one: the tracking ``name``."""
        self.name_other(name)
        self.reference.setCurrentIndex(self.reference.findData(OTHER))

    def name_other(self, name: str) -> None:
        """What the other hand is; empty where there is none, which cannot be chosen then."""
        row = self.reference.findData(OTHER)
        words = (
            self.tr("Reference: {}").format(engine_name(name))
            if name
            else self.tr("No second tracking")
        )
        self.reference.setItemText(row, words)
        self.reference.model().item(row).setEnabled(bool(name))  # type: ignore[attr-defined]

    def offer(self, tips: Sequence[str], engines: bool) -> None:
        """The fingertips of another hand, and (``engines``) whether a second engine can run."""
        chosen = self.trail.currentData()
        self.trail.clear()
        self.trail.addItem(self.tr("No trail"), "")
        for name in tips:
            self.trail.addItem(self.tr("Trail: {}").format(spoken(name)), name)
        self.trail.setCurrentIndex(max(0, self.trail.findData(chosen)))
        for i in range(self.reference.count()):
            able = self.reference.itemData(i) in (NO_REFERENCE, OTHER) or engines
            self.reference.model().item(i).setEnabled(able)  # type: ignore[attr-defined]
