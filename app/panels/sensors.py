"""Gyro and accelerometer as scrolling curves, and how each IMU is.

Pens are one pixel wide and ranges fixed: wider pens cost five times as much to draw.
"""

from __future__ import annotations

import pyqtgraph as pg
from PySide6.QtWidgets import QCheckBox, QComboBox, QGridLayout, QHBoxLayout, QVBoxLayout, QWidget

from app.engine import EngineSetup
from app.panels.panel import Panel
from app.session import Session
from app.viewmodels.sensors import curves, imu_states
from app.viewmodels.snapshot import Snapshot
from app.viewmodels.states import BLUISH_GREEN, ORANGE, SKY
from app.widgets.chip import Chip

SPAN = 8.0
AXES = (("x", ORANGE), ("y", BLUISH_GREEN), ("z", SKY))
RANGES = {"gyro": (-400.0, 400.0), "accel": (-2.5, 2.5)}


class SensorsPanel(Panel):
    name = "sensors"
    period = 1 / 20

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(session, parent)
        self.choice = QComboBox()
        self.choice.setAccessibleName(self.tr("IMU"))
        self.hold = QCheckBox(self.tr("Pause"))
        self.chips: list[Chip] = []
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(4)
        self._plots = {
            "gyro": self._plot(self.tr("Angular rate"), "°/s", RANGES["gyro"]),
            "accel": self._plot(self.tr("Acceleration"), "g", RANGES["accel"]),
        }
        head = QHBoxLayout()
        head.addWidget(self.choice)
        head.addWidget(self.hold)
        head.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        column.addLayout(head)
        plots = QHBoxLayout()
        for plot, _ in self._plots.values():
            plots.addWidget(plot)
        column.addLayout(plots, 1)
        column.addLayout(self._grid)
        session.opened.connect(self._open)

    def title(self) -> str:
        return self.tr("Sensors")

    def _plot(
        self, title: str, unit: str, limits: tuple[float, float]
    ) -> tuple[pg.PlotWidget, list[pg.PlotDataItem]]:
        plot = pg.PlotWidget()
        plot.setMinimumHeight(90)
        plot.setLabel("left", f"{title} / {unit}")
        plot.setXRange(-SPAN, 0, padding=0)
        plot.setYRange(*limits, padding=0)
        plot.setMenuEnabled(False)
        plot.hideButtons()
        plot.showGrid(y=True, alpha=0.2)
        items = [plot.plot(pen=pg.mkPen(c, width=1), name=n) for n, c in AXES]
        return plot, items

    def set_colours(self, background: str, text: str) -> None:
        """Dress the plots; pyqtgraph does not follow the palette by itself."""
        for plot, _ in self._plots.values():
            plot.setBackground(background)
            for side in ("left", "bottom"):
                plot.getAxis(side).setPen(text)
                plot.getAxis(side).setTextPen(text)

    def _open(self, setup: EngineSetup) -> None:
        self.choice.clear()
        self.choice.addItems([n.replace("_", " ") for n in setup.glove.imu_names])
        for chip in self.chips:
            chip.deleteLater()
        self.chips = [Chip() for _ in setup.glove.imus]
        for i, chip in enumerate(self.chips):
            self._grid.addWidget(chip, i // 4, i % 4)

    def refresh(self, view: Snapshot | None) -> None:
        if view is None or not self.chips:
            return
        names = view.setup.glove.imu_names
        states = imu_states(names, view.imu, view.running)
        for chip, state in zip(self.chips, states, strict=True):
            name = state.name.replace("_", " ")
            chip.show_state(state.look.colour, state.look.sign, name, state.text)
        if not self.hold.isChecked():
            self._draw(view)

    def _draw(self, view: Snapshot) -> None:
        imu = max(0, self.choice.currentIndex())
        for kind, (_, items) in self._plots.items():
            data = curves(view.imu, imu, kind, SPAN)
            for axis, item in enumerate(items):
                item.setData(data.t, data.values[:, axis])
