"""The Applications panel: which application runs, its settings, and its drawing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Protocol

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.host_parts import ErrorSignal, HandSwitch
from app.engines.snapshot import Snapshot
from app.panels.hand.legend import ValidityLegend
from app.panels.hand_choice import HandChoice
from app.panels.panel import Panel, PanelColours
from app.widgets.measures import NEAR
from app.widgets.one_line import OneLine
from extensions.applications.window.drawing import ApplicationView
from extensions.applications.window.view_model import ApplicationsModel, SettingRow, parsed, written
from tracker.messages import Shed

FORM_WIDTH = 230  # px
DECIMALS = 4
LARGEST = 1e6


class ApplicationsHost(ErrorSignal, HandSwitch, Protocol):
    """What the panel uses of the engine host."""


class ApplicationsPanel(Panel):
    period = 1 / 30
    spared_at = Shed.VIEW_RATE

    def __init__(self, host: ApplicationsHost, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.host = host
        self.view = ApplicationView()
        self.view.failed.connect(host.error)
        self.model: ApplicationsModel | None = None
        self.form = SettingsForm()
        self.form.setFixedWidth(FORM_WIDTH)
        self.form.hide()
        self.controls = ApplicationControls()
        self.instruction, self.result = QLabel(), QLabel()
        self.instruction.setProperty("role", "figure")
        for label in (self.instruction, self.result):
            label.setWordWrap(True)
        self.legend = ValidityLegend()
        self.legend.row.addStretch(1)
        self._lay_out()
        self._connect()
        self._clear()

    def _lay_out(self) -> None:
        middle = QHBoxLayout()
        middle.addWidget(self.view, 1)
        middle.addWidget(self.form)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(NEAR)
        self.hand_choice = HandChoice(self.host)
        head = QHBoxLayout()
        head.addWidget(self.hand_choice)
        head.addWidget(self.controls, 1)
        column.addLayout(head)
        column.addWidget(self.instruction)
        column.addLayout(middle, 1)
        column.addWidget(self.legend)
        column.addWidget(self.result)

    def _connect(self) -> None:
        row = self.controls
        row.choice.currentIndexChanged.connect(lambda _i: self._run(row.chosen, self._initial()))
        row.again.clicked.connect(self._restart)
        row.fit.clicked.connect(self.view.fit_next)
        row.settings.toggled.connect(self.form.setVisible)
        row.page.toggled.connect(self._show_page)
        self.form.changed.connect(self._set)
        self.host.opened.connect(self._open)
        self.host.closed.connect(self._clear)
        self.host.hand_changed.connect(self._follow_hand)

    # --- commands

    def choose(self, name: str, settings: dict[str, Any] | None = None) -> None:
        """Run an application by its name; empty for none."""
        self.controls.choose(name)
        self._run(name, settings)

    @property
    def runs(self) -> bool:
        """Whether there is an application."""
        return self.model is not None and self.model.runs

    def _run(self, name: str, settings: dict[str, Any] | None) -> None:
        if self.model is None:
            return
        problem = self.model.show(name, settings)
        self.form.show_rows(self.model.rows())
        self.view.fit_next()
        self._report(problem)
        for button in (self.controls.again, self.controls.settings):
            button.setEnabled(bool(name) and not problem)
        self.view.setAccessibleDescription(self.controls.choice.currentText())

    def _initial(self) -> dict[str, Any] | None:
        """The initial settings of the chosen application; None: its defaults."""
        name, settings = self.model.expected if self.model is not None else ("", {})
        return settings if name == self.controls.chosen else None

    def _restart(self) -> None:
        if self.model is not None and self.model.stage is not None:
            self.model.stage.restart()

    def _set(self, key: str, value: object) -> None:
        self._report(self.model.set(key, value) if self.model is not None else "")

    def _show_page(self, on: bool) -> None:
        self._report(self.model.show_page(on) if self.model is not None else "")

    def _report(self, text: str) -> None:
        self._problem = text
        self.result.setText(text)
        self._instruct()

    def _instruct(self) -> None:
        """Show what to do now, if there is something to do."""
        text = self.model.instruction() if self.model is not None and not self._problem else ""
        self.instruction.setText(text)
        self.instruction.setVisible(bool(text))

    @property
    def needs_low_latency(self) -> bool:
        stage = self.model.stage if self.model is not None else None
        return stage is not None and bool(stage.name) and stage.delays_window

    def show_theme(self, colours: PanelColours) -> None:
        self.view.set_background(colours.scene)

    # --- the engine

    def _open(self, setup: EngineSetup) -> None:
        self._clear()
        self.model = ApplicationsModel(setup)
        self.controls.offer(self.model.titles, self.model.stage is not None)
        self.view.open(setup)
        name, settings = self.model.expected
        if name in self.model.titles:
            self.choose(name, settings)

    def _follow_hand(self, setup: EngineSetup) -> None:
        """Run the application with the hand that is shown now, with its page."""
        name, settings = self.model.leave() if self.model is not None else ("", {})
        page = self.controls.page.isChecked()
        self._open(setup)
        if name:
            self.choose(name, settings)
            self.controls.page.setChecked(page)

    def _clear(self) -> None:
        self.model = None
        self.view.clear()
        self.controls.clear()
        self.form.show_rows([])
        self._report("")

    # --- drawing

    def refresh(self, view: Snapshot | None) -> None:
        if self.model is None:
            self.view.draw(None, (), False)
            return
        self.view.draw(view, self.model.drawing, self.model.runs)
        if view is not None and not self._problem:
            self.result.setText(self.model.line())
        self._instruct()

    def shut_down(self) -> None:
        self.view.shut_down()


class ApplicationControls(OneLine):
    """The line of controls, used by `ApplicationsPanel`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.choice = QComboBox()
        self.choice.setAccessibleName(self.tr("Application"))
        self.again = QPushButton(self.tr("Restart"))
        self.fit = QPushButton(self.tr("Show all"))
        self.fit.setToolTip(self.tr("Move the viewpoint until the whole drawing is visible"))
        self.settings, self.page = QToolButton(), QToolButton()
        self.settings.setText(self.tr("Settings"))
        self.page.setText(self.tr("Page"))
        self.page.setToolTip(self.tr("Show it in browsers on this computer, including a headset's"))
        for button in (self.settings, self.page):
            button.setCheckable(True)
        for widget in (self.choice, self.again, self.fit, self.settings, self.page):
            self.add(widget)

    @property
    def chosen(self) -> str:
        """The name of the selected application; empty for none."""
        return str(self.choice.currentData() or "")

    def choose(self, name: str) -> None:
        """Select this application without emitting a signal."""
        with QSignalBlocker(self.choice):
            self.choice.setCurrentIndex(max(0, self.choice.findData(name)))

    def offer(self, titles: Mapping[str, str], has_page: bool) -> None:
        """Offer applications, by name."""
        with QSignalBlocker(self.choice):
            self.choice.addItem(self.tr("No application"), "")
            for name, title in titles.items():
                self.choice.addItem(title, name)
        self.choice.setEnabled(True)
        self.page.setEnabled(has_page)

    def clear(self) -> None:
        """Offer nothing."""
        with QSignalBlocker(self.choice), QSignalBlocker(self.page):
            self.choice.clear()
            self.page.setChecked(False)
        for widget in (self.choice, self.again, self.settings, self.page):
            widget.setEnabled(False)


class SettingsForm(QWidget):
    """A form of settings; emits each change of the user."""

    changed = Signal(str, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._lines = QFormLayout(self)
        self._lines.setContentsMargins(0, 0, 0, 0)
        self.fields: dict[str, QWidget] = {}

    def show_rows(self, rows: Sequence[SettingRow]) -> None:
        """Replace the rows."""
        while self._lines.rowCount():
            self._lines.removeRow(0)
        self.fields.clear()
        for row in rows:
            field = self._field(row)
            field.setAccessibleName(row.key)
            self.fields[row.key] = field
            self._lines.addRow(row.key.replace("_", " "), field)

    def _field(self, row: SettingRow) -> QWidget:
        if isinstance(row.value, bool):
            box = QCheckBox()
            box.setChecked(row.value)
            box.toggled.connect(lambda on: self.changed.emit(row.key, bool(on)))
            return box
        if isinstance(row.value, int | float):
            return self._number(row)
        edit = QLineEdit(written(row.value))
        edit.editingFinished.connect(lambda: self._written(row, edit))
        return edit

    def _number(self, row: SettingRow) -> QWidget:
        whole = isinstance(row.value, int)
        number = QDoubleSpinBox()
        number.setDecimals(0 if whole else DECIMALS)
        number.setRange(-LARGEST, LARGEST)
        number.setSingleStep(1.0 if whole else max(abs(row.value) / 10, 10.0**-DECIMALS))
        number.setValue(row.value)
        number.setKeyboardTracking(False)
        kind = int if whole else float
        number.valueChanged.connect(lambda value: self.changed.emit(row.key, kind(value)))
        return number

    def _written(self, row: SettingRow, edit: QLineEdit) -> None:
        try:
            value: Any = parsed(edit.text(), row.value)
        except ValueError:
            edit.setText(written(row.value))
            return
        self.changed.emit(row.key, value)
