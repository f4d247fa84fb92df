"""Gyroscope, accelerometer and joint angles as scrolling curves, and the state of the glove and
each IMU."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.host_parts import HandSwitch
from app.engines.snapshot import Snapshot
from app.panels.graphs.looks import COLOURS, curve_looks
from app.panels.hand_choice import HandChoice
from app.panels.panel import Panel, PanelColours
from app.storage.settings import SettingsOf
from app.viewmodels.graphs import value_at
from app.viewmodels.names import display_name
from app.viewmodels.sensors import finger_angles, glove_figures, imu_states, link_tip
from app.viewmodels.signal_curves import Curve, LiveCurves
from app.viewmodels.signals import AXES, Signal, angle_signal, imu_signals
from app.viewmodels.states import GOOD, IDLE
from app.widgets.chip import Chip
from app.widgets.curve_plot import ScrollPlot
from app.widgets.measures import NEAR, TIGHT
from app.widgets.one_line import OneLine
from app.words import local

SPAN = 8.0  # s
RANGES = {"gyro": (-400.0, 400.0), "accel": (-2.5, 2.5)}
UNITS = {"gyro": "°/s", "accel": "g", "angles": "°"}


class SensorSettings(Protocol):
    """The settings of this panel."""

    @property
    def curves(self) -> str: ...


class SensorsPanel(Panel):
    period = 1 / 20

    def __init__(
        self, host: HandSwitch, store: SettingsOf[SensorSettings], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._store = store
        self.chips: list[Chip] = []
        self.toggles: list[QCheckBox] = []
        self._curves = LiveCurves(SPAN)
        self._signals: dict[str, list[Signal]] = {}  # by plot
        self._fingers: dict[str, list[int]] = {}
        self._angle_names: tuple[str, ...] = ()
        self._shown: dict[str, list[Curve]] = {}  # by plot
        self._now = 0.0  # s at 0 of the plots' axes
        self._pointed: float | None = None
        self._figures = ""
        self._setup: EngineSetup | None = None
        self._make_plots()
        self._lay_out()
        host.opened.connect(self._open)
        host.hand_changed.connect(self._open)

    # --- widgets

    def _make_plots(self) -> None:
        titles = {
            "gyro": self.tr("Angular rate / °/s"),
            "accel": self.tr("Acceleration / g"),
            "angles": self.tr("Joint angle / °"),
        }
        self.plots: dict[str, ScrollPlot] = {}
        for kind, title in titles.items():
            plot = self.plots[kind] = ScrollPlot(title, SPAN, RANGES.get(kind))
            plot.pointed.connect(self._point)
            plot.left.connect(lambda: self._point(None))

    def _lay_out(self) -> None:
        self.choice = QComboBox()
        self.choice.setAccessibleName(self.tr("Curves"))
        self.choice.currentIndexChanged.connect(self._choose)
        self.choice.activated.connect(self._remember)
        self.hold = QCheckBox(self.tr("Pause"))
        self.hold.setToolTip(self.tr("Pause the curves; tracking continues"))
        self.hold.toggled.connect(self._hold)
        self._head = OneLine()
        self._head.add(self.choice)
        self._head.add(self.hold)
        self.figures = QLabel()
        self.figures.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(TIGHT)
        head = QHBoxLayout()
        self.hand_choice = HandChoice(self.host)
        head.addWidget(self.hand_choice)
        head.addWidget(self._head, 1)
        column.addLayout(head)
        row = QHBoxLayout()
        for plot in self.plots.values():
            row.addWidget(plot)
        column.addLayout(row, 1)
        column.addWidget(self.figures)
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(TIGHT)
        column.addLayout(self._grid)

    def show_theme(self, colours: PanelColours) -> None:
        for plot in self.plots.values():
            plot.set_colours(colours.base, colours.text)

    def _open(self, setup: EngineSetup) -> None:
        """List the IMUs of this glove and the angles of this hand."""
        self._curves = LiveCurves(SPAN)
        self._setup = setup
        self._angle_names = setup.hand.joint_names
        self._fingers = finger_angles(self._angle_names)
        self.choice.blockSignals(True)
        self.choice.clear()
        for name in setup.glove.imu_names:
            self.choice.addItem(self.tr("IMU: {}").format(display_name(name)), f"imu {name}")
        self.choice.insertSeparator(self.choice.count())
        for finger in self._fingers:
            self.choice.addItem(self.tr("Angles: {}").format(display_name(finger)), finger)
        self.choice.setCurrentIndex(max(0, self.choice.findData(self._store.value.curves)))
        self.choice.blockSignals(False)
        for chip in self.chips:
            chip.deleteLater()
        self.chips = [Chip() for _ in setup.glove.imus]
        for i, chip in enumerate(self.chips):
            self._grid.addWidget(chip, i // 4, i % 4)
        self._choose()

    # --- which curves

    def _remember(self) -> None:
        """Store the selection for the next glove and the next start."""
        self._store.update(curves=str(self.choice.currentData() or ""))

    def _choose(self) -> None:
        """Show the plots of the selection, and a check box for each of their curves."""
        columns = self._chosen_angles()
        names: Sequence[str] = AXES
        if columns is not None:
            names = [display_name(self._angle_names[c].split("_", 1)[-1]) for c in columns]
        self._signals = self._signals_of(columns)
        self._curves.choose(signal for chosen in self._signals.values() for signal in chosen)
        for name, plot in self.plots.items():
            plot.setVisible(name in self._signals)
            plot.set_looks(curve_looks([""] * len(self._signals.get(name, ()))))
        self._make_toggles(names)
        self._shown = {}

    def _signals_of(self, columns: list[int] | None) -> dict[str, list[Signal]]:
        """The signals of each plot of the selection; ``columns`` of angles, None for an IMU."""
        if self._setup is None:
            return {}
        side = self._setup.side
        if columns is not None:
            return {"angles": [angle_signal(side, c, self._angle_names[c]) for c in columns]}
        imu = max(0, self.choice.currentIndex())
        chosen = imu_signals(side, imu, self._setup.glove.imu_names[imu])
        kinds = ("gyro", "accel")
        return {k: [s for s in chosen if s.column == k][: len(AXES)] for k in kinds}

    def _chosen_angles(self) -> list[int] | None:
        """Columns of the selected angles; None if an IMU is selected."""
        return self._fingers.get(str(self.choice.currentData()))

    def _make_toggles(self, names: Sequence[str]) -> None:
        for box in self.toggles:
            self._head.take_out(box)
            box.deleteLater()
        self.toggles = []
        for k, name in enumerate(names):
            box = QCheckBox(name)
            box.setStyleSheet(f"QCheckBox {{ border-bottom: 2px solid {COLOURS[k]}; }}")
            box.setChecked(True)
            box.setToolTip(self.tr("Show this curve"))
            box.toggled.connect(self._toggle_curves)
            self._head.add(box)
            self.toggles.append(box)

    def _toggle_curves(self) -> None:
        for plot in self.plots.values():
            for k in range(min(len(plot.curves), len(self.toggles))):
                plot.show_curve(k, self.toggles[k].isChecked())

    # --- displayed data

    def refresh(self, view: Snapshot | None) -> None:
        if view is None:
            self._show_nothing()
        if view is None or not self.chips:
            return
        states = imu_states(
            view.setup.glove.imu_names, view.imu, view.running and view.packets_arrive
        )
        for chip, state in zip(self.chips, states, strict=True):
            name = display_name(state.name)
            text = name if state.look is GOOD else f"{name}: {state.text}"
            chip.show_state(state.look.colour, state.look.sign, text, state.text)
        self._figures = "   ".join(glove_figures(view.status, view.imu))
        self.figures.setToolTip(link_tip(view.status))
        self._curves.take(view)
        if not self.hold.isChecked():
            self._draw()
        self._read()

    def _show_nothing(self) -> None:
        """Clear the plots while no engine is open."""
        self._curves.clear()
        self._draw()
        for chip in self.chips:
            chip.show_state(IDLE.colour, IDLE.sign, chip.text().partition(":")[0])
        self._figures = ""
        self.figures.setToolTip("")
        self._read()

    def _draw(self) -> None:
        self._shown = {
            name: [self._curves.curve(signal.key) for signal in chosen]
            for name, chosen in self._signals.items()
        }
        ends = (float(t[-1]) for curves in self._shown.values() for t, _ in curves if len(t))
        self._now = max(ends, default=0.0)
        for name, curves in self._shown.items():
            self.plots[name].draw(curves, self._now)

    def _hold(self, on: bool) -> None:
        """Copy the displayed curves, since their buffers continue to change."""
        if on:
            for name, curves in self._shown.items():
                self._shown[name] = [(t.copy(), values.copy()) for t, values in curves]
                self.plots[name].draw(self._shown[name], self._now)

    # --- the cursor

    def _point(self, t: float | None) -> None:
        self._pointed = t
        for plot in self.plots.values():
            plot.show_cursor(t)
        self._read()

    def _read(self) -> None:
        """The values of the visible curves under the pointer; without a pointer, the glove's
        statistics."""
        if self._pointed is None:
            self.figures.setText(self._figures)
            return
        parts = []
        for kind, curves in self._shown.items():
            shown = [
                f"{box.text()} {local(value_at(curve, self._now + self._pointed)):.3g}"
                for box, curve in zip(self.toggles, curves, strict=True)
                if box.isChecked() and len(curve[0])
            ]
            if shown:
                parts.append(f"{', '.join(shown)} {UNITS[kind]}")
        text = "; ".join(parts)
        self.figures.setText(f"{local(self._pointed):.2f} s: {text}" if text else "")
