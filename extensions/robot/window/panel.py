"""The panel with the robot hand in its scene."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Protocol

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QComboBox,
    QDoubleSpinBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.host_parts import ErrorSignal, HandSwitch
from app.engines.snapshot import Snapshot
from app.panels.hand_choice import HandChoice
from app.panels.panel import Panel, PanelColours
from app.storage.settings import SettingsOf
from app.widgets.chip import Chip
from app.widgets.measures import NEAR
from app.widgets.number_box import NumberBox
from app.widgets.one_line import OneLine
from app.widgets.view3d.scene import DrawnSurface, GroundLines
from app.widgets.view3d.shapes import Surface
from app.widgets.view3d.view_3d import View3D
from app.words import error_text
from extensions.robot.window.finger_table import FingerTable
from extensions.robot.window.job import RobotHost, RobotLink, StoredRobot
from extensions.robot.window.view_model import (
    CLUTCHES,
    MODELS,
    RobotView,
    clutch_title,
    model_title,
    table_lines,
)
from tracker.base.errors import GlovetrackError
from tracker.messages import Shed

FIRST_LOOK = np.array([-0.8, 0.4, 0.7])
"""From behind and above the robot, like the wearer's viewpoint."""
TARGET, DISTANCE = np.array([0.03, 0.0, 0.09]), 0.85  # m
FOLLOW = 0.2
PALM = 0.75
"""The view's centre moves by the share `FOLLOW` per refresh towards the point that divides the
distance from the table's centre to the palm by `PALM`."""


class RobotPanelHost(ErrorSignal, HandSwitch, RobotHost, Protocol):
    """What the panel uses of the engine host."""


class RobotPanel(Panel):
    period = 1 / 20
    spared_at = Shed.VIEW_RATE

    def __init__(
        self, host: RobotPanelHost, store: SettingsOf[StoredRobot], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.link = RobotLink(host, store, self)
        self.view = View3D()
        self.view.orbit.target, self.view.orbit.distance = TARGET.copy(), DISTANCE
        self.view.orbit.look_from(FIRST_LOOK)
        self.view.scene_changed.connect(self._forget)
        self.controls = RobotControls(self.link)
        self.controls.refused.connect(host.error)
        self.fingers = FingerTable(self.link)
        self.fingers.refused.connect(host.error)
        self.fingers.hide()
        self.controls.fingers.toggled.connect(self.fingers.setVisible)
        self.link.failed.connect(host.error)
        self.chip = Chip()
        self._drawn: tuple[RobotView, DrawnSurface] | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(NEAR)
        self.hand_choice = HandChoice(host)
        head = QHBoxLayout()
        head.addWidget(self.hand_choice)
        head.addWidget(self.controls, 1)
        column.addLayout(head)
        column.addWidget(self.fingers)
        column.addWidget(self.view, 1)
        column.addWidget(self.chip)

    def _forget(self) -> None:
        """Draw everything again: the view or the robot has changed."""
        self._drawn = None

    def refresh(self, view: Snapshot | None) -> None:
        self.link.look(view)
        self.controls.show_clutch()
        figures = self.link.figures
        self.chip.show_state(figures.look.colour, figures.look.sign, figures.text, figures.tip)
        robot = self.link.view
        self._draw(robot)
        self.view.caption = "" if self._drawn is not None else figures.text
        self.view.render_scene()

    def _draw(self, robot: RobotView | None) -> None:
        scene = self.view.scene
        if scene is None:
            return
        if self._drawn is not None and self._drawn[0] is not robot:
            self._drawn = None
            scene.clear()
        draped = robot.draped() if robot is not None else None
        if robot is None or draped is None:
            return
        if self._drawn is None:
            shape = robot.shape
            scene.set_ground(GroundLines(*table_lines()))
            along = np.zeros(len(shape.points))
            self._drawn = robot, scene.add_surface(Surface(shape.faces, shape.part, along))
        palm = robot.palm
        if palm is not None:
            orbit = self.view.orbit
            orbit.target = orbit.target + FOLLOW * (TARGET + PALM * (palm - TARGET) - orbit.target)
        surface = self._drawn[1]
        surface.drape(draped.points, draped.normals, draped.looks)
        surface.show(True)

    @property
    def needs_low_latency(self) -> bool:
        return self.link.on

    def show_theme(self, colours: PanelColours) -> None:
        self.view.set_background(colours.scene)

    def shut_down(self) -> None:
        self.link.shut_down()
        self._drawn = None
        self.view.shut_down()


# ---- controls of the robot hand

CLUTCH_KEY = "Ctrl+Shift+E"
MOST_PORT = 65535


class RobotControls(QWidget):
    """Buttons and fields that command a `RobotLink` and show its state."""

    refused = Signal(str)

    def __init__(self, link: RobotLink, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._link = link
        self._updating = False
        line = OneLine()
        for widget in (
            self._connect_button(),
            self._clutch_button(),
            self._reset_button(),
            self._model_box(),
            self._fingers_button(),
            self._scale_box(),
            self._gesture_box(),
            self._port_box(),
        ):
            line.add(widget)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(line)
        link.changed.connect(self.show_link)
        self.show_link()

    # --- making

    def _connect_button(self) -> QPushButton:
        self.connect_robot = QPushButton(self.tr("Connect"))
        self.connect_robot.setCheckable(True)
        self.connect_robot.setToolTip(self.tr("Drive a simulated robot hand with the tracked hand"))
        self.connect_robot.toggled.connect(lambda on: self._ask(lambda: self._link.switch(on)))
        return self.connect_robot

    def _clutch_button(self) -> QPushButton:
        self.clutch = QPushButton(self.tr("Clutch"))
        self.clutch.setCheckable(True)
        self.clutch.setChecked(True)
        self.clutch.setShortcut(QKeySequence(CLUTCH_KEY))
        key = QKeySequence(CLUTCH_KEY).toString(QKeySequence.SequenceFormat.NativeText)
        self.clutch.setToolTip(
            self.tr("On: the robot follows the hand. Off: it holds its pose ({})").format(key)
        )
        self.clutch.clicked.connect(self._link.engage)
        return self.clutch

    def _reset_button(self) -> QPushButton:
        self.reset = QPushButton(self.tr("Reset"))
        self.reset.setToolTip(self.tr("Return the robot and the objects to their initial poses"))
        self.reset.clicked.connect(lambda: self._link.reset())
        return self.reset

    def _model_box(self) -> QComboBox:
        self.model = QComboBox()
        self.model.setAccessibleName(self.tr("Robot hand"))
        for name in MODELS:
            self.model.addItem(model_title(name), name)
        self.model.addItem(self.tr("From a file…"), "")
        self.model.activated.connect(lambda _i: self._choose_model())
        return self.model

    def _fingers_button(self) -> QPushButton:
        self.fingers = QPushButton(self.tr("Fingers"))
        self.fingers.setCheckable(True)
        self.fingers.setToolTip(self.tr("Show which links are the robot's fingertips"))
        return self.fingers

    def _scale_box(self) -> QWidget:
        self.scale = QDoubleSpinBox()
        self.scale.setRange(0.1, 10.0)
        self.scale.setSingleStep(0.1)
        self.scale.setKeyboardTracking(False)
        self.scale.setAccessibleName(self.tr("Motion scale"))
        self.scale.setToolTip(self.tr("Distance the robot's palm moves per distance of the hand"))
        self.scale.valueChanged.connect(lambda value: self._ask(lambda: self._link.scale(value)))
        return _titled(self.tr("Motion scale"), self.scale)

    def _gesture_box(self) -> QWidget:
        self.gesture = QComboBox()
        self.gesture.setAccessibleName(self.tr("Clutch gesture"))
        for name in CLUTCHES:
            self.gesture.addItem(clutch_title(name), name)
        self.gesture.activated.connect(
            lambda _i: self._ask(lambda: self._link.change(clutch=self.gesture.currentData()))
        )
        return _titled(self.tr("Clutch gesture"), self.gesture)

    def _port_box(self) -> QWidget:
        self.port = NumberBox()
        self.port.setRange(0, MOST_PORT)
        self.port.setSpecialValueText(self.tr("off"))
        self.port.setAccessibleName(self.tr("UDP port for robot states"))
        self.port.setToolTip(self.tr("Send the robot's joint states as JSON to this local port"))
        self.port.valueChanged.connect(lambda port: self._ask(lambda: self._link.send_to(port)))
        return _titled(self.tr("UDP port"), self.port)

    # --- actions

    def _ask(self, work: Callable[[], None]) -> None:
        if self._updating:
            return
        try:
            work()
        except GlovetrackError as error:
            self.refused.emit(error_text(error))
            self.show_link()

    def _choose_model(self) -> None:
        name = str(self.model.currentData() or "")
        if not name:
            title, kinds = self.tr("Open robot hand"), self.tr("Robot models (*.xml *.mjcf *.urdf)")
            name, _ = QFileDialog.getOpenFileName(self, title, str(Path.home()), kinds)
        if name:
            self._ask(lambda: self._link.change(model=name))
        self.show_link()

    def show_link(self) -> None:
        """The current state."""
        link, self._updating = self._link, True
        self.connect_robot.setChecked(link.on)
        self.model.setItemText(self.model.count() - 1, self._file_title())
        row = self.model.findData(link.settings.model)
        self.model.setCurrentIndex(row if row >= 0 else self.model.count() - 1)
        self.scale.setValue(link.settings.motion_scale)
        self.gesture.setCurrentIndex(max(0, self.gesture.findData(link.settings.clutch)))
        self.port.setValue(link.port)
        self._updating = False
        self.show_clutch()

    def show_clutch(self) -> None:
        """A gesture may have moved it."""
        usable = self._link.on and not self._link.replays
        for button in (self.clutch, self.reset):
            if button.isEnabled() != usable:
                button.setEnabled(usable)
        if self.clutch.isChecked() != self._link.engaged:
            self.clutch.setChecked(self._link.engaged)

    def _file_title(self) -> str:
        name = self._link.settings.model
        return self.tr("From a file…") if name in MODELS else Path(name).name


def _titled(title: str, widget: QWidget) -> QWidget:
    """Both find room, or neither."""
    out = QWidget()
    row = QHBoxLayout(out)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(NEAR)
    row.addWidget(QLabel(title))
    row.addWidget(widget)
    return out
