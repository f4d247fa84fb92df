"""Help, Check computer and devices: the findings of ``glovetrack doctor`` in a dialog."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHeaderView,
    QLabel,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.platform.tasks import JobProgress, RunningJob, TaskOwner
from app.viewmodels.states import BAD, GOOD, WARN
from app.widgets.measures import APART, NEAR
from app.window.udev_rule import show_rule
from app.words import error_text, notice_text
from tracker.base.errors import GlovetrackError
from tracker.base.files import write_whole
from tracker.doctor.command_runs import report_text
from tracker.doctor.finding import Finding, Result, Verdict, examine
from tracker.doctor.machine import Machine
from tracker.doctor.permissions import RULE_REMEDIES

LOOKS = {Verdict.OK: GOOD, Verdict.WARNING: WARN, Verdict.ERROR: BAD}
SIZE = (980, 560)


def devices_in_use(setup: EngineSetup | None) -> frozenset[str]:
    """Paths of the serial ports and cameras that an engine has open."""
    if setup is None:
        return frozenset()
    gloves = (hand.connection.device for hand in setup.hands)
    ports = {glove.report().port for glove in gloves if glove is not None}
    controls = setup.camera.controls
    return frozenset(ports | {r.path for r in controls.reports()} if controls else ports)


class DoctorDialog(QDialog):
    """Runs all checks in the background, and lists each finding when it arrives."""

    finished_checks = Signal(str)
    """The report's text."""

    def __init__(
        self, machine: Callable[[], Machine], tasks: TaskOwner, parent: QWidget | None = None
    ) -> None:
        """``machine`` is called at the start of each run, since devices come and go."""
        super().__init__(parent)
        self.setWindowTitle(self.tr("Check computer and devices"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(*SIZE)
        self._machine, self._tasks = machine, tasks
        self._results: list[Result] = []
        self._job: RunningJob | None = None
        self.summary = QLabel()
        self.summary.setWordWrap(True)
        self.table = self._make_table()
        self._make_buttons()
        column = QVBoxLayout(self)
        column.setContentsMargins(APART, APART, APART, APART)
        column.setSpacing(NEAR)
        for widget in (self.summary, self.table, self.buttons):
            column.addWidget(widget)
        self.start()

    def _make_table(self) -> QTableWidget:
        table = QTableWidget(0, 3)
        table.setHorizontalHeaderLabels([self.tr("Result"), self.tr("Found"), self.tr("Remedy")])
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        table.setWordWrap(True)
        table.verticalHeader().hide()
        header = table.horizontalHeader()
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        for column in (1, 2):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Stretch)
        table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        return table

    def _make_buttons(self) -> None:
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        action = QDialogButtonBox.ButtonRole.ActionRole
        self.again = self.buttons.addButton(self.tr("Check again"), action)
        self.save = self.buttons.addButton(self.tr("Save report…"), action)
        self.again.clicked.connect(self.start)
        self.save.clicked.connect(self._ask_where_to_save)
        self.rule = self.buttons.addButton(self.tr("Udev rule…"), action)
        self.rule.setToolTip(self.tr("Show the rule that gives access to devices, and install it"))
        self.rule.clicked.connect(lambda: show_rule(self._tasks, self))
        self.rule.hide()
        self.buttons.rejected.connect(self.close)

    def start(self) -> None:
        """Run all checks."""
        machine = self._machine()
        results = self._results = []
        self.table.setRowCount(0)
        self.rule.hide()
        self._set_running(True)
        self.summary.setText(self.tr("Checking… Devices in use by this window are not tested."))

        def job(progress: JobProgress) -> None:
            for result in examine(machine):
                results.append(result)
                progress(-1.0, result.check.title)

        title = self.tr("Checking computer and devices")
        self._job = self._tasks.run(title, job, ended=self._end, progressed=self._show_new)

    def _set_running(self, is_running: bool) -> None:
        for button in (self.again, self.save):
            button.setEnabled(not is_running)

    def _show_new(self, _share: float, _title: str) -> None:
        for result in self._results[self.table.rowCount() :]:
            self._add(result.finding)

    def _add(self, finding: Finding) -> None:
        look = LOOKS[finding.verdict]
        row = self.table.rowCount()
        if finding.remedy is not None and finding.remedy.code in RULE_REMEDIES:
            self.rule.show()
        self.table.insertRow(row)
        texts = (
            f"{look.sign} {self._verdict(finding.verdict)}",
            *finding.texts(notice_text),
        )
        for column, text in enumerate(texts):
            self.table.setItem(row, column, QTableWidgetItem(text))
        first = self.table.item(row, 0)
        assert first is not None
        first.setForeground(QColor(look.colour))
        self.table.scrollToBottom()

    def _verdict(self, verdict: Verdict) -> str:
        return {
            Verdict.OK: self.tr("OK"),
            Verdict.WARNING: self.tr("Warning"),
            Verdict.ERROR: self.tr("Error"),
        }[verdict]

    def _end(self) -> None:
        """Also called after a cancellation, with the results so far."""
        self._job = None
        self._set_running(False)
        verdicts = [r.finding.verdict for r in self._results]
        errors, warnings = verdicts.count(Verdict.ERROR), verdicts.count(Verdict.WARNING)
        if errors or warnings:
            text = self.tr("{} errors, {} warnings.").format(errors, warnings)
        else:
            text = self.tr("No problems found.")
        self.summary.setText(text)
        self.finished_checks.emit(report_text(self._results))

    def _ask_where_to_save(self) -> None:
        name = f"glovetrack-doctor_{datetime.now():%Y-%m-%d_%H-%M-%S}.txt"
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save report"), str(self._machine().folder / name), "*.txt"
        )
        if path:
            self.save_report(Path(path))

    def save_report(self, path: Path) -> None:
        """Write the report as text; a message reports where, or why this failed."""
        try:
            write_whole(path, report_text(self._results), force=True)
        except GlovetrackError as error:
            self.summary.setText(error_text(error))
        else:
            self.summary.setText(self.tr("Report saved: {}.").format(path))

    def done(self, result: int) -> None:
        """Closing cancels checks that are still running."""
        if self._job is not None:
            self._job.cancel()
        super().done(result)
