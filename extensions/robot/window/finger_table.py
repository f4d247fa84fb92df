"""The table of a robot hand's fingertips, which the user can correct."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.platform.tasks import JobProgress, LatestJob
from app.widgets.measures import NEAR
from app.words import error_text, notice_text
from extensions.robot.finger_map import PALM, ROWS, FingerMap, map_from_text, read_map, write_map
from extensions.robot.library import need_mujoco
from extensions.robot.settings import RobotSettings
from extensions.robot.window.job import RobotLink
from extensions.robot.window.view_model import finger_title, found_by
from tracker.base.errors import GlovetrackError

LINK, HOW, JOINTS, LENGTH = range(1, 5)  # columns


class FingerTable(QWidget):
    """Reads the robot hand's file in a thread whenever another one, or another link, is chosen."""

    refused = Signal(str)

    def __init__(self, link: RobotLink, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._link = link
        self._shown: tuple[str, str] | None = None  # model and links that were read
        self._map = FingerMap()
        self._reading = LatestJob(self.tr("Read robot hand"), self)
        self._reading.failed.connect(self._cannot)
        self.boxes: dict[str, QComboBox] = {}
        self._cells: dict[str, dict[int, QLabel]] = {}
        self.message = QLabel()
        self.message.setWordWrap(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(NEAR)
        column.addLayout(self._grid())
        column.addWidget(self.message)
        column.addLayout(self._buttons())
        link.changed.connect(self._look)

    # --- making

    def _grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(NEAR)
        grid.setColumnStretch(LINK, 1)
        headings = (
            self.tr("Finger"), self.tr("Link of the fingertip"), self.tr("Found by"),
            self.tr("Joints"), self.tr("Length"),
        )  # fmt: skip
        for j, text in enumerate(headings):
            heading = QLabel(text)
            heading.setProperty("role", "faint")
            grid.addWidget(heading, 0, j)
        for i, name in enumerate(ROWS, start=1):
            grid.addWidget(QLabel(finger_title(name)), i, 0)
            box = self.boxes[name] = QComboBox()
            box.setAccessibleName(finger_title(name))
            box.activated.connect(partial(self._choose, name))
            grid.addWidget(box, i, LINK)
            self._cells[name] = {j: QLabel() for j in (HOW, JOINTS, LENGTH)}
            for j, label in self._cells[name].items():
                if j != HOW:
                    label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                grid.addWidget(label, i, j)
        return grid

    def _buttons(self) -> QHBoxLayout:
        self.automatic = QPushButton(self.tr("Find automatically"))
        self.automatic.setToolTip(self.tr("Discard your choices for this robot hand"))
        self.automatic.clicked.connect(lambda: self._try(lambda: self._change(FingerMap())))
        self.load = QPushButton(self.tr("Load…"))
        self.load.setToolTip(self.tr("Read links from a file"))
        self.load.clicked.connect(self._load)
        self.save = QPushButton(self.tr("Save…"))
        self.save.setToolTip(self.tr("Write the links to a file, for other computers and teleop"))
        self.save.clicked.connect(self._save)
        row = QHBoxLayout()
        for button in (self.automatic, self.load, self.save):
            row.addWidget(button)
        row.addStretch(1)
        return row

    # --- reading the hand

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._look()

    def _look(self) -> None:
        """Read the hand if it is not the one that is shown."""
        settings = self._link.settings
        wanted = settings.model, settings.fingers
        if not self.isVisible() or wanted == self._shown:
            return
        self._shown = wanted
        self.message.setText(self.tr("Reading the robot hand…"))
        self._reading.run(lambda progress: _survey(settings, progress), self._show)

    def _cannot(self, text: str) -> None:
        self.message.setText(text)
        for box in self.boxes.values():
            box.clear()

    def _show(self, found: object) -> None:
        from extensions.robot.survey import HandSurvey  # deferred: needs an extra

        assert isinstance(found, HandSurvey)
        self._map = found.map
        chosen = map_from_text(self._link.settings.fingers).links
        for row in found.fingers:
            self._fill(row.finger, found.tips, row.link)
            cells = self._cells[row.finger]
            cells[HOW].setText(found_by(row.how))
            cells[JOINTS].setText(str(len(row.joints) or ""))
            cells[JOINTS].setToolTip(", ".join(row.joints))
            known = not math.isnan(row.length)
            length = self.tr("{} mm").format(f"{1e3 * row.length:.0f}")
            cells[LENGTH].setText(length if known else "")
        self._fill(PALM, found.palms, found.palm)
        how = "user" if chosen.get(PALM) else "position"
        self._cells[PALM][HOW].setText(found_by(how if found.palm else ""))
        self.message.setText("" if found.problem is None else notice_text(found.problem))
        self.message.setVisible(found.problem is not None)

    def _fill(self, name: str, links: tuple[str, ...], link: str) -> None:
        box = self.boxes[name]
        with QSignalBlocker(box):
            box.clear()
            box.addItem(self.tr("none") if name != PALM else self.tr("automatic"), "")
            for each in links:
                box.addItem(each, each)
            box.setCurrentIndex(max(0, box.findData(link)))

    # --- choices

    def _choose(self, name: str, _row: int) -> None:
        link = str(self.boxes[name].currentData() or "")
        self._try(
            lambda: self._change(map_from_text(self._link.settings.fingers).with_link(name, link))
        )

    def _change(self, fingers: FingerMap) -> None:
        self._link.change(fingers=fingers.text)

    def _load(self) -> None:
        title, kinds = self.tr("Load links"), self.tr("Links of fingers (*.toml)")
        path, _ = QFileDialog.getOpenFileName(self, title, str(Path.home()), kinds)
        if path:
            self._try(lambda: self._link.change(fingers=read_map(Path(path)).text))

    def _save(self) -> None:
        title, kinds = self.tr("Save links"), self.tr("Links of fingers (*.toml)")
        first = Path.home() / f"{Path(self._link.settings.model).stem}.toml"
        path, _ = QFileDialog.getSaveFileName(self, title, str(first), kinds)
        if path:
            self._try(lambda: write_map(Path(path), self._map, force=True))

    def _try(self, work: Callable[[], None]) -> None:
        try:
            work()
        except GlovetrackError as error:
            self.refused.emit(error_text(error))
            self._shown = None
            self._look()


def _survey(settings: RobotSettings, _progress: JobProgress) -> object:
    """In a thread of its own: MuJoCo is imported there, too."""
    need_mujoco()
    from extensions.robot.survey import survey_hand  # deferred: needs an extra

    return survey_hand(settings)
