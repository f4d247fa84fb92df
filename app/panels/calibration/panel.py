"""What the tracker has learnt of the wearer and of the sensors."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.panels.calibration.profiles import WearerProfiles
from app.panels.calibration.table import CalibrationTable
from app.panels.calibration.wearer_row import WearerRow
from app.panels.hand_choice import HandChoice
from app.panels.panel import Panel
from app.storage.settings import SettingsStore
from app.viewmodels.calibration import by_one_camera, camera_time
from app.viewmodels.status import images_alone
from app.widgets.elided_label import ElidedLabel
from app.widgets.measures import APART, NEAR


class CalibrationPanel(Panel):
    period = 0.5
    guided_asked = Signal()

    def __init__(
        self, host: EngineHost, store: SettingsStore, parent: QWidget | None = None
    ) -> None:
        super().__init__(host, parent)
        self._drawn_frozen = False
        self._alone = False  # one camera shows the hand
        self._make_widgets()
        self.profiles = WearerProfiles(host, store, self.wearer)
        self._lay_out()
        self._connect()

    # --- widgets

    def _make_widgets(self) -> None:
        self.length = QLabel()
        self.length.setProperty("role", "figure")
        self.camera_time = ElidedLabel()
        self.camera_time.setToolTip(
            self.tr("How late images are stamped, from the motion of the hand and its gyroscope")
        )
        self.overall = QProgressBar()
        self.overall.setRange(0, 100)
        self.overall.setFormat(self.tr("settled: %p %"))
        self.advice = QLabel()
        self.advice.setWordWrap(True)
        self.wearer = WearerRow()
        self.table = CalibrationTable()
        self._show_nothing()

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setSpacing(APART)
        self.camera_time.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        name = ElidedLabel(self.tr("Hand length"))
        name.firm = True
        head.addWidget(name)
        head.addWidget(self.length)
        head.addWidget(ElidedLabel(self.tr("Camera delay")))
        head.addWidget(self.camera_time, 1)
        head.addWidget(self.overall)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(NEAR)
        self.hand_choice = HandChoice(self.host)
        column.addWidget(self.hand_choice, 0, Qt.AlignmentFlag.AlignLeft)
        column.addLayout(head)
        column.addWidget(self.wearer)
        column.addWidget(self.advice)
        column.addWidget(self.table, 1)

    def _connect(self) -> None:
        self.wearer.guided.connect(self.guided_asked)
        self.wearer.compare.connect(lambda _on: self._draw())
        self.profiles.kept.connect(self._draw)
        self.host.opened.connect(self._open)
        self.host.hand_changed.connect(self._show_hand)
        self.host.running_changed.connect(lambda _on: self._enable())
        self.host.closed.connect(self._enable)
        self._enable()

    def _enable(self) -> None:
        setup = self.host.setup
        guided = setup is not None and setup.guide is not None
        self.wearer.set_available(self.profiles.link.available, guided)

    def _open(self, setup: EngineSetup) -> None:
        self.profiles.open(setup)
        self._draw()

    def _show_hand(self, setup: EngineSetup) -> None:
        """Who wears this glove, and what was learnt of the hand."""
        self.profiles.show_hand(setup)
        self._draw()

    # --- what it shows

    def refresh(self, view: Snapshot | None) -> None:
        if view is None:
            self.profiles.worn.latest = None
            self._draw()
        if view is None or view.calibration is None:
            return
        if view.status is not None and images_alone(view.status):
            return  # of a camera alone nothing is estimated
        self.camera_time.setText(camera_time(view.status))
        frozen = self.wearer.frozen.isChecked()
        if view.calibration is self.profiles.worn.latest and frozen == self._drawn_frozen:
            return  # it is new once a second, and to write all its figures takes 10 ms
        self.profiles.worn.latest = view.calibration
        self._alone = by_one_camera(view)
        self.wearer.set_segments(view.calibration.segments)
        self._draw()

    def _show_nothing(self) -> None:
        """There is no calibration."""
        self.length.setText("–")
        self.camera_time.setText("–")
        self.overall.setValue(0)
        self.advice.setText(self.tr("Start tracking to see what is estimated."))
        self.table.show_rows(())

    def _draw(self) -> None:
        comparing, frozen = self.wearer.comparing.isChecked(), self.wearer.frozen.isChecked()
        self._drawn_frozen = frozen
        shown = self.profiles.worn.shown(comparing, frozen, self._alone)
        if shown is None:
            self._show_nothing()
            return
        self.length.setText(shown.hand_length)
        share = shown.convergence
        self.overall.setValue(0 if share != share else round(100 * share))
        self.advice.setText(shown.advice)
        self.table.show_rows(shown.rows)
