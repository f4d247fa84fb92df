"""What the tracker has learnt of the wearer and of the sensors."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Signal
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
from app.jobs.calibration_commands import CalibrationCommands
from app.panels.calibration.table import CalibrationTable
from app.panels.calibration.wearer_row import WearerRow
from app.panels.panel import Panel
from app.storage.bound_gloves import bound, with_bound
from app.storage.settings import SettingsStore
from app.storage.wearers import WearerFile, WearerStore
from app.viewmodels.calibration import camera_time
from app.viewmodels.worn_calibration import WornCalibration
from app.widgets.measures import APART, NEAR
from tracker.errors import GlovetrackError

PROFILE_ENGINE = "chain"


class CalibrationPanel(Panel):
    name = "calibration"
    period = 0.5
    guided_asked = Signal()

    def __init__(
        self, host: EngineHost, store: SettingsStore, parent: QWidget | None = None
    ) -> None:
        super().__init__(host, parent)
        self._store = store
        self._first: Path | None = None
        self._wearers = WearerStore(store.path.parent / "wearers")
        self._worn = WornCalibration(self._wearers)
        self._worn_by: dict[str, WornCalibration] = {}  # of each hand, by its side
        self._link = CalibrationCommands(host, self)
        self._link.learned.connect(self._learned)
        self._make_widgets()
        self._lay_out()
        self._connect()

    def title(self) -> str:
        return self.tr("Calibration")

    # --- widgets

    def _make_widgets(self) -> None:
        self.length = QLabel("–")
        self.length.setProperty("role", "figure")
        self.camera_time = QLabel("–")
        self.camera_time.setToolTip(
            self.tr("How late images are stamped, from the motion of the hand and its gyroscope")
        )
        self.overall = QProgressBar()
        self.overall.setRange(0, 100)
        self.overall.setFormat(self.tr("settled: %p %"))
        self.advice = QLabel(self.tr("Start tracking to see what is estimated."))
        self.advice.setWordWrap(True)
        self.wearer = WearerRow()
        self.table = CalibrationTable()

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setSpacing(APART)
        self.camera_time.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        head.addWidget(QLabel(self.tr("Hand length")))
        head.addWidget(self.length)
        head.addWidget(QLabel(self.tr("Camera delay")))
        head.addWidget(self.camera_time, 1)
        head.addWidget(self.overall)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(NEAR)
        column.addLayout(head)
        column.addWidget(self.wearer)
        column.addWidget(self.advice)
        column.addWidget(self.table, 1)

    def _connect(self) -> None:
        row = self.wearer
        row.chosen.connect(self.wear)
        row.save.connect(self.save)
        row.remove.connect(self.remove)
        row.export.connect(self.export)
        row.take_in.connect(self.take_in)
        row.guided.connect(self.guided_asked)
        row.measured.connect(self._link.measured)
        row.reset.connect(self.reset)
        row.freeze.connect(self._link.freeze)
        row.compare.connect(lambda _on: self._draw())
        self.host.opened.connect(self._open)
        self.host.hand_changed.connect(self._show_hand)
        self.host.engine_changed.connect(self._engine_changed)
        self.host.running_changed.connect(lambda _on: self._enable())
        self.host.closed.connect(self._enable)
        self._enable()

    def _enable(self) -> None:
        setup = self.host.setup
        guided = setup is not None and setup.guide is not None
        self.wearer.set_available(self._link.available, guided)

    # --- the wearer

    def _open(self, setup: EngineSetup) -> None:
        """Put on what was worn last, before the engine starts; on the hand that is shown last."""
        self.wearer.frozen.setChecked(False)
        hands = [setup] if setup.other is None else [setup.other, setup]
        self._worn_by = {hand.side: WornCalibration(self._wearers) for hand in hands}
        first, self._first = self._first, None
        for hand in hands:
            self._show_hand(hand)
            if first is not None and hand is setup and setup.command is not None:
                self.take_in(first)
            elif self.wearer.name and hand.command is not None:
                self._put_on(self.wearer.name, hand)

    def begin_with(self, profile: Path) -> None:
        """A profile that is kept and put on by whoever is tracked next."""
        self._first = profile

    def _show_hand(self, setup: EngineSetup) -> None:
        """Who wears this glove, and what was learnt of the hand."""
        self._worn = self._worn_by[setup.side]
        self.wearer.set_names(self._worn.names(), self._last_wearer(setup))
        self._draw()

    def _last_wearer(self, setup: EngineSetup) -> str:
        """Of a glove that is known again its own."""
        settings = self._store.value
        own = bound(settings, setup.glove_id)
        if own is not None:
            return own.wearer
        return settings.left_wearer if _is_left_of_two(setup) else settings.wearer

    def _remember(self, name: str) -> None:
        """Whose calibration the hand that is shown has at the next start."""
        setup, settings = self.host.setup, self._store.value
        own = bound(settings, setup.glove_id) if setup is not None else None
        if setup is not None and setup.glove_id is not None and own is not None:
            own = replace(own, wearer=name)
            self._store.update(gloves=with_bound(settings, setup.glove_id, own))
        if setup is not None and _is_left_of_two(setup):
            self._store.update(left_wearer=name)
        else:
            self._store.update(wearer=name)

    def _put_on(self, name: str, setup: EngineSetup) -> None:
        layout = self._link.layout_of(setup)
        try:
            self._worn.put_on(name, layout)
        except GlovetrackError as error:
            self.host.error.emit(str(error))
            self.wearer.set_names(self._worn.names(), "")
            return
        self._give_profile(self._store.value.engine, self._worn, setup.side)

    def _give_profile(self, engine: str, worn: WornCalibration, side: str) -> None:
        """What the wearer's profile holds, to an engine that can take it."""
        if engine == PROFILE_ENGINE and worn.profile is not None:
            self._link.put_on(worn.profile, side)

    def _engine_changed(self, name: str) -> None:
        """A new engine knows nobody."""
        self.wearer.frozen.setChecked(False)
        for side, worn in self._worn_by.items():
            self._give_profile(name, worn, side)

    def wear(self, name: str) -> None:
        """Put on a kept profile; without a name somebody new wears the glove."""
        self._remember(name)
        self._worn.take_off()
        if name and self.host.setup is not None:
            self._put_on(name, self.host.setup)
        else:
            self.reset(None)
        self.wearer.set_names(self._worn.names(), self.wearer.name)

    def save(self, name: str) -> None:
        """Keep what has been learned under a name; the engine is asked for it first."""
        self._worn.ask_to_save(name)
        self._link.ask()

    def keep_learned(self) -> bool:
        """Keep what poses have taught in the wearer's profile; False where nobody was chosen."""
        if self.wearer.name:
            self.save(self.wearer.name)
        return bool(self.wearer.name)

    def export(self, path: Path) -> None:
        """Write what has been learned to a file; the engine is asked for it first."""
        self._worn.ask_to_export(path)
        self._link.ask()

    def take_in(self, path: Path) -> None:
        """Keep a profile that was written elsewhere, and put it on."""
        layout = self._link.layout()
        if layout is None:
            return
        try:
            name = self._worn.take_in(path, layout)
        except GlovetrackError as error:
            self.host.error.emit(str(error))
            return
        self.wearer.set_names(self._worn.names(), name)
        self.wear(name)

    def _learned(self, wearer: WearerFile) -> None:
        try:
            kept = self._worn.learned(wearer)
        except GlovetrackError as error:
            self.host.error.emit(str(error))
            return
        if kept:
            self._remember(kept)
            self.wearer.set_names(self._worn.names(), kept)
            self._draw()

    def remove(self, name: str) -> None:
        """Remove a profile; what the engine has learned stays."""
        try:
            self._worn.remove(name)
        except GlovetrackError as error:
            self.host.error.emit(str(error))
        self._remember("")
        self.wearer.set_names(self._worn.names(), "")

    def reset(self, segments: list[str] | None) -> None:
        """Forget; what was there can be compared with."""
        if self._link.reset(segments):
            self._worn.forgotten()

    # --- what it shows

    def refresh(self, view: Snapshot | None) -> None:
        if view is None or view.calibration is None:
            return
        self.camera_time.setText(camera_time(view.status))
        self._worn.latest = view.calibration
        self.wearer.set_segments(view.calibration.segments)
        self._draw()

    def _draw(self) -> None:
        comparing, frozen = self.wearer.comparing.isChecked(), self.wearer.frozen.isChecked()
        shown = self._worn.shown(comparing, frozen)
        if shown is None:
            return
        self.length.setText(shown.hand_length)
        share = shown.convergence
        self.overall.setValue(0 if share != share else round(100 * share))
        self.advice.setText(shown.advice)
        self.table.show_rows(shown.rows)


def _is_left_of_two(setup: EngineSetup) -> bool:
    return setup.other is not None and setup.side == "left"
