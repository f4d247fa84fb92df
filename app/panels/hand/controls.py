"""Options of the 3D hand view: the viewpoint, the parts shown, and the renderer."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Sequence
from typing import Protocol

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QToolButton, QWidget

from app.platform.graphics import GraphicsQuery, is_card
from app.platform.tasks import JobProgress, TaskOwner
from app.storage.settings import SettingsOf
from app.viewmodels.hand_scene import ShownParts
from app.viewmodels.names import display_name, engine_name
from app.widgets.one_line import OneLine
from app.widgets.view3d.view_3d import View3D
from tracker.engine.kinds import engine_kinds

NO_REFERENCE, OTHER = "", "other"


AUTO, CARD, PAINTED = "auto", "card", "painted"
PROVEN = 30
"""Number of images after which rendering on the graphics card is considered stable."""


class HandControls(OneLine):
    """The row above the 3D view; emits the user's requests."""

    look_from = Signal(str)  # "back", "palm", "side" or "camera"
    reference_chosen = Signal(str)  # engine to run as a reference; empty for none
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
        """Add a button for each viewpoint."""
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
            button.setToolTip(self.tr("View from this side"))
            button.clicked.connect(lambda _on, name=name: self.look_from.emit(name))
            self.add(button)

    def _add_boxes(self) -> None:
        """Add check boxes for the optional parts."""
        boxes = (
            (
                "markers",
                self.tr("Markers"),
                self.tr("Large: visible now. Small: visible recently. Ring: never seen"),
            ),
            (
                "uncertainty",
                self.tr("2σ"),
                self.tr(
                    "A ring of two standard deviations around each fingertip; dashed at "
                    "the maximum of 15 "
                    "mm"
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
        choice.setAccessibleName(self.tr("Reference hand"))
        choice.setToolTip(
            self.tr(
                "Outline of a reference hand: the true pose of the simulated hand, the second "
                "tracking of a replay, or another engine on the same data"
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
        choice.setAccessibleName(self.tr("Fingertip trail"))
        choice.setToolTip(self.tr("Path of a fingertip over the last three seconds"))
        choice.addItem(self.tr("No trail"), "")
        choice.currentIndexChanged.connect(
            lambda _i: self.trail_chosen.emit(str(choice.currentData() or ""))
        )
        return choice

    @property
    def engine(self) -> str:
        """The selected reference engine; empty for none."""
        chosen = str(self.reference.currentData())
        return "" if chosen == OTHER else chosen

    def shown(self) -> ShownParts:
        ticked = {name: box.isChecked() for name, box in self.boxes.items()}
        reference = self.reference.currentData() != NO_REFERENCE
        return ShownParts(**ticked, reference=reference, trail=bool(self.trail.currentData()))

    def show_reference(self, name: str) -> None:
        """Show that the reference ``name`` is available."""
        self.name_other(name)
        self.reference.setCurrentIndex(self.reference.findData(OTHER))

    def name_other(self, name: str) -> None:
        """Name the reference of a replay; an empty name disables it."""
        row = self.reference.findData(OTHER)
        words = (
            self.tr("Reference: {}").format(engine_name(name))
            if name
            else self.tr("No second tracking")
        )
        self.reference.setItemText(row, words)
        self.reference.model().item(row).setEnabled(bool(name))  # type: ignore[attr-defined]

    def offer(self, tips: Sequence[str], engines: bool) -> None:
        """Offer the fingertips of another hand; ``engines``: whether a reference engine can run."""
        chosen = self.trail.currentData()
        self.trail.clear()
        self.trail.addItem(self.tr("No trail"), "")
        for name in tips:
            self.trail.addItem(self.tr("Trail: {}").format(display_name(name)), name)
        self.trail.setCurrentIndex(max(0, self.trail.findData(chosen)))
        for i in range(self.reference.count()):
            able = self.reference.itemData(i) in (NO_REFERENCE, OTHER) or engines
            self.reference.model().item(i).setEnabled(able)  # type: ignore[attr-defined]


def is_there() -> bool:
    """Whether the packages of the GPU renderer are installed."""
    return all(importlib.util.find_spec(name) is not None for name in ("pyvistaqt", "vtkmodules"))


class View3DSettings(Protocol):
    """The settings of the 3D view."""

    @property
    def view_3d(self) -> str: ...

    @property
    def card_trial(self) -> bool: ...


class ViewChooser(QObject):
    """Follows the setting ``view_3d``. A graphics driver that crashes the program is tried only
    once."""

    refused = Signal(str)

    def __init__(
        self,
        view: View3D,
        store: SettingsOf[View3DSettings],
        tasks: TaskOwner,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._view, self._store, self._tasks = view, store, tasks
        self._query = GraphicsQuery(self)
        self._query.answered.connect(self._answered)
        self._started = False
        self._drawn = 0

    def start(self) -> None:
        """Select the renderer when the view is shown for the first time."""
        if self._started:
            return
        self._started = True
        if (
            self._store.value.card_trial
        ):  # the program crashed before the renderer was considered stable
            self._store.update(card_trial=False, view_3d=PAINTED)
            self.refused.emit(
                self.tr(
                    "The graphics driver crashed the program last time, so the 3D view "
                    "uses software "
                    "rendering. To try the graphics card again, choose it in the View menu."
                )
            )
        self._follow()

    def choose(self, setting: str) -> None:
        """Apply a new setting."""
        self._store.update(view_3d=setting)
        self._started = True
        self._follow()

    def _follow(self) -> None:
        setting = self._store.value.view_3d
        if setting == CARD:
            self._prepare()
        elif setting == AUTO and is_there():
            self._query.start()
        elif self._view.on_card:
            self._view.use_painted()

    def _answered(self, renderer: str) -> None:
        if is_card(renderer):
            self._prepare()

    def _prepare(self) -> None:
        """Import the packages of the GPU renderer in the background, which takes two seconds."""
        if not is_there():
            self._stay_painted(
                self.tr(
                    "Rendering on the graphics card is not part of this installation. The "
                    "3D view uses "
                    "software rendering."
                )
            )
            return

        def load(_progress: JobProgress) -> bool:
            try:
                importlib.import_module("pyvistaqt")
            except ImportError:
                return False
            return True

        self._tasks.run(self.tr("Preparing the 3D view"), load, self._use)

    def _use(self, there: bool) -> None:
        if self._view.on_card or self._store.value.view_3d == PAINTED:
            return
        self._drawn = 0
        self._store.update(card_trial=True)
        if not there or not self._view.use_card():
            self._store.update(card_trial=False)
            self._stay_painted(
                self.tr("The 3D view cannot use the graphics card and uses software rendering.")
            )

    def _stay_painted(self, reason: str) -> None:
        """Use software rendering and, if the user selected the graphics card, report why."""
        if self._store.value.view_3d == CARD:
            self.refused.emit(reason)

    def drawn(self) -> None:
        """Count the images that were drawn."""
        if self._store.value.card_trial:
            self._drawn += 1
            if self._drawn >= PROVEN or not self._view.on_card:
                self._store.update(card_trial=False)

    def shut_down(self) -> None:
        self._query.stop()
        if self._store.value.card_trial:
            self._store.update(card_trial=False)
