"""The set-up checklist."""

from __future__ import annotations

from typing import Protocol

from PySide6.QtCore import Qt, Signal, SignalInstance
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from app.engines.host_parts import HandSwitch
from app.engines.snapshot import Snapshot
from app.panels.hand_choice import HandChoice
from app.panels.panel import Panel
from app.platform.tasks import LatestJob
from app.storage.settings import SettingsOf
from app.viewmodels.checklist import hues_seen, steps
from app.viewmodels.light import LightWatch
from app.viewmodels.set_up_steps import SettledSteps, SetUpStep, images_arrive, is_lost, summary
from app.widgets.measures import APART, NEAR

TOP = Qt.AlignmentFlag.AlignTop
REASON = 30  # minimum number of characters in a line of a reason next to a button
HUE_MEMORY = 4.0  # s for which a hue counts as seen


class ChecklistSettings(Protocol):
    """The settings of this panel."""

    @property
    def calibration(self) -> str: ...


class ChecklistPanel(Panel):
    period = 0.5
    action = Signal(str)

    def __init__(
        self, host: HandSwitch, store: SettingsOf[ChecklistSettings], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._store = store
        self._rows: list[_Row] = []
        self.light, self._settled = LightWatch(), SettledSteps()
        self._light_job = LatestJob(self.tr("Measuring the light"), self)
        self._hue_seen: dict[str, float] = {}  # time at which each was last detected, s
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(APART)
        self._grid.setVerticalSpacing(NEAR)
        self._grid.setColumnStretch(2, 1)
        self.summary = QLabel()
        self.summary.setProperty("role", "figure")
        column = QVBoxLayout(self)
        column.setContentsMargins(APART, APART, APART, APART)
        column.setSpacing(APART)
        self.hand_choice = HandChoice(host)
        column.addWidget(self.hand_choice, 0, Qt.AlignmentFlag.AlignLeft)
        column.addWidget(self.summary)
        column.addLayout(self._grid)
        column.addStretch(1)
        host.opened.connect(lambda _setup: self._hue_seen.clear())
        for i in range(len(steps(None))):
            self._rows.append(_Row(self._grid, i, self.action))
        self.refresh(None)

    def refresh(self, view: Snapshot | None) -> None:
        self._read_light(view)
        shown = steps(
            view,
            self._store.value.calibration,
            self._recent_hues(view),
            self.light,
            self._settled,
        )
        self.summary.setText(summary(shown))
        first = next((i for i, s in enumerate(shown) if not s.passes), len(shown))
        for i, (row, step) in enumerate(zip(self._rows, shown, strict=True)):
            row.show(step, reachable=i == first)
        self._place()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place()

    def _place(self) -> None:
        """Place the buttons next to the reasons, or below them if the reasons would be too
        narrow."""
        least = self.fontMetrics().horizontalAdvance("x") * REASON
        names = max((row.name_width for row in self._rows), default=0)
        buttons = max((row.button_width for row in self._rows), default=0)
        room = self.width() - 4 * APART - 2 * self._grid.horizontalSpacing()
        for row in self._rows:
            row.place(below=names + buttons + least > room)

    def shut_down(self) -> None:
        self._light_job.shut_down()

    def _read_light(self, view: Snapshot | None) -> None:
        """Measure the newest image in the background, once a second."""
        if is_lost(view, "camera"):
            self.light = LightWatch()  # measurements of another camera or light do not apply
        if view is None or view.frame is None or not images_arrive(view):
            return
        if self._light_job.is_busy:  # a newer job would discard its result
            return
        frame, setup = view.frame, view.setup
        image = frame.left if frame.left is not None else frame.right
        work = self.light.work(image, setup.profile, setup.camera.rig.fx, frame.t)
        if work is not None:
            self._light_job.run(lambda _progress: work(), self.light.took)

    def _recent_hues(self, view: Snapshot | None) -> set[str]:
        """Hues detected recently; not every patch faces the camera in every image."""
        if view is None or view.frame is None:
            self._hue_seen.clear()
            return set()
        now = view.frame.t
        for name in hues_seen(view):
            self._hue_seen[name] = now
        return {name for name, t in self._hue_seen.items() if abs(now - t) < HUE_MEMORY}


class _Row:
    """One step's widgets in two rows of the grid, of which the second is for its button."""

    def __init__(self, grid: QGridLayout, index: int, action: SignalInstance) -> None:
        self._grid, self._at = grid, 2 * index
        self._sign, self._name, self._reason = QLabel(), QLabel(), QLabel()
        self._reason.setWordWrap(True)
        self._reason.setProperty("role", "faint")
        self._reason.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._button = QPushButton()
        self._command = ""
        self._placed: tuple[bool, bool] | None = None
        self._button.clicked.connect(lambda: action.emit(self._command))
        for column, widget in enumerate((self._sign, self._name)):
            grid.addWidget(widget, self._at, column, TOP)

    @property
    def name_width(self) -> int:
        return self._name.sizeHint().width()

    @property
    def button_width(self) -> int:
        """Width of the button, px; 0 without one."""
        return 0 if self._button.isHidden() else self._button.sizeHint().width()

    def show(self, step: SetUpStep, reachable: bool) -> None:
        look = step.look(reachable)
        self._sign.setText(look.sign)
        self._sign.setStyleSheet(f"color: {look.colour}")
        self._name.setText(step.name)
        self._reason.setText(step.reason)
        self._command = step.command
        self._button.setText(step.button)
        self._button.setVisible(bool(step.command) and not step.done)

    def place(self, below: bool) -> None:
        """Place the button ``below`` the reason or next to it; without a button the reason takes
        its column, too."""
        alone = below or self._button.isHidden()
        if self._placed == (below, alone):
            return
        self._placed = below, alone
        self._grid.addWidget(self._reason, self._at, 2, 1, 2 if alone else 1, TOP)
        if below:
            start = Qt.AlignmentFlag.AlignLeft
            self._grid.addWidget(self._button, self._at + 1, 2, 1, 2, TOP | start)
        else:
            self._grid.addWidget(self._button, self._at, 3, TOP)
