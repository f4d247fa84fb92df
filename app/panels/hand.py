"""The hand in 3D."""

from __future__ import annotations

import numpy as np
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from app.engine import EngineSetup
from app.panels.hand_actors import HandActors, Show
from app.panels.panel import Panel
from app.session import Session
from app.viewmodels.colours import hue_colours
from app.viewmodels.hand_scene import HandScene, HandSceneModel
from app.viewmodels.snapshot import Snapshot
from app.viewmodels.states import VALIDITY
from app.widgets.view_3d import View3D
from tracker.messages import Array, Validity

FOLLOW = 0.3
"""Share of the way that the view's centre goes to the hand at each picture."""


FIRST_LOOK = np.array([-0.75, 0.25, 0.85])
"""From behind the hand and above it, as its owner sees it."""


JUMP = 0.25  # m; a hand this far from the view's centre is found again, not followed


class HandPanel(Panel):
    name = "hand"
    period = 1 / 30

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(session, parent)
        self.view = View3D()
        self.view.setAccessibleName(self.tr("The hand in 3D"))
        self._actors: HandActors | None = None
        self._model: HandSceneModel | None = None
        self._scene: HandScene | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        column.setSpacing(6)
        column.addLayout(self._controls())
        column.addWidget(self.view, 1)
        column.addLayout(self._legend())
        session.opened.connect(self._open)
        session.closed.connect(self._clear)

    def title(self) -> str:
        return self.tr("Hand")

    def _controls(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(4)
        presets = (
            (self.tr("Back"), self.view_back),
            (self.tr("Palm"), self.view_palm),
            (self.tr("Side"), self.view_side),
            (self.tr("Camera"), self.view_camera),
        )
        for text, slot in presets:
            button = QToolButton()
            button.setText(text)
            button.clicked.connect(slot)
            row.addWidget(button)
        row.addStretch(1)
        self._boxes = {
            "markers": QCheckBox(self.tr("Markers")),
            "uncertainty": QCheckBox(self.tr("2σ")),
            "camera": QCheckBox(self.tr("Camera")),
            "truth": QCheckBox(self.tr("Ghost")),
        }
        for name, box in self._boxes.items():
            box.setChecked(name != "truth")
            row.addSpacing(6)
            row.addWidget(box)
        self._boxes["truth"].setToolTip(
            self.tr("The truth of a simulated hand, or the second tracking of a replay")
        )
        return row

    def show_ghost(self) -> None:
        """Draw the other hand, now that there is one."""
        self._boxes["truth"].setChecked(True)

    def _legend(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(16)
        words = {
            Validity.MEASURED: self.tr("measured"),
            Validity.INFERRED: self.tr("inferred"),
            Validity.LOST: self.tr("lost"),
        }
        for state, word in words.items():
            look = VALIDITY[state]
            row.addWidget(QLabel(f'<span style="color:{look.colour}">{look.sign}</span> {word}'))
        row.addStretch(1)
        return row

    # --- views

    def view_back(self) -> None:
        self._look(lambda R: R[:, 2] - 0.35 * R[:, 0])

    def view_palm(self) -> None:
        self._look(lambda R: -R[:, 2] - 0.35 * R[:, 0])

    def view_side(self) -> None:
        self._look(lambda R: R[:, 1] + 0.2 * R[:, 2])

    def view_camera(self) -> None:
        """From where the camera stands."""
        if self._scene is not None:
            self.view.orbit.look_from(self._scene.p_GC - self.view.orbit.target)
            self.view.render_scene()

    def _look(self, direction_of) -> None:  # type: ignore[no-untyped-def]
        """Look along a direction given by the dorsum's R_GB."""
        R: Array = self._scene.segment_R[0] if self._scene is not None else np.eye(3)
        self.view.orbit.look_from(direction_of(R))
        self.view.render_scene()

    # --- the engine

    def _open(self, setup: EngineSetup) -> None:
        self._clear()
        self._model = HandSceneModel(setup)
        self.view.orbit.look_from(FIRST_LOOK)
        if self.view.scene is not None:
            self._actors = HandActors(self.view.scene, setup, hue_colours(setup.profile))

    def _clear(self) -> None:
        self._actors = self._model = self._scene = None
        if self.view.scene is not None:
            self.view.scene.clear()

    def show_options(self) -> Show:
        return Show(**{name: box.isChecked() for name, box in self._boxes.items()})

    def refresh(self, view: Snapshot | None) -> None:
        show, scene = self.show_options(), None
        if self._model is not None and view is not None:
            scene = self._model.scene(view, show.truth)
        if scene is None or self._actors is None:
            self.view.caption = self.tr("No hand yet")
            self.view.render_scene()
            return
        self._follow(scene)
        self.view.caption = scene.caption
        self._actors.update(scene, show)
        self.view.render_scene()

    def _follow(self, scene: HandScene) -> None:
        centre = scene.segment_p.mean(axis=0)
        away = float(np.linalg.norm(centre - self.view.orbit.target))
        step = FOLLOW if self._scene is not None and away < JUMP else 1.0
        self.view.orbit.target = self.view.orbit.target + step * (centre - self.view.orbit.target)
        self._scene = scene

    def shut_down(self) -> None:
        self._actors = None
        self.view.shut_down()
