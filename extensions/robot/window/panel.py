"""The panel with the robot hand in its scene."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

from app.engines.host_parts import ErrorSignal, HandSwitch
from app.engines.snapshot import Snapshot
from app.panels.hand_choice import HandChoice
from app.panels.panel import Panel, PanelColours
from app.storage.settings import SettingsStore
from app.widgets.chip import Chip
from app.widgets.measures import NEAR
from app.widgets.view3d.scene import DrawnSurface, GroundLines
from app.widgets.view3d.shapes import Surface
from app.widgets.view3d.view_3d import View3D
from extensions.robot.window.controls import RobotControls
from extensions.robot.window.finger_table import FingerTable
from extensions.robot.window.job import RobotHost, RobotLink
from extensions.robot.window.view_model import RobotView, table_lines
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
        self, host: RobotPanelHost, store: SettingsStore, parent: QWidget | None = None
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
