"""The hand in 3D."""

from __future__ import annotations

import numpy as np
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.panels.hand.actors import HandActors, ShownParts
from app.panels.hand.view_chooser import ViewChooser
from app.panels.panel import Panel
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.colours import hue_colours
from app.viewmodels.hand_scene import HandScene, HandSceneModel
from app.viewmodels.states import VALIDITY
from app.widgets.flow_layout import FlowLayout
from app.widgets.view3d.view_3d import View3D
from tracker.errors import GlovetrackError
from tracker.messages import Array, Validity

FOLLOW = 0.3
"""Share of the way that the view's centre goes to the hand at each image."""

FIRST_LOOK = np.array([-0.75, 0.25, 0.85])
"""From behind the hand and above it, as its owner sees it."""

JUMP = 0.25  # m; a hand this far from the view's centre is found again, not followed

NO_REFERENCE, OTHER = "", "other"
ENGINES = ("chain", "vist", "switching", "madgwick")


class HandPanel(Panel):
    name = "hand"
    period = 1 / 30

    def __init__(
        self,
        host: EngineHost,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(host, parent)
        self.view = View3D()
        self.chooser = ViewChooser(self.view, store, tasks, self)
        self.chooser.told.connect(host.error)
        self.view.scene_changed.connect(self._make_actors)
        self._setup: EngineSetup | None = None
        self._actors: HandActors | None = None
        self._model: HandSceneModel | None = None
        self._scene: HandScene | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        column.setSpacing(6)
        self._controls = FlowLayout(spacing=6)
        self._add_presets()
        self._add_boxes()
        self._add_choices()
        column.addLayout(self._controls)
        column.addWidget(self.view, 1)
        column.addLayout(self._legend())
        host.opened.connect(self._open)
        host.closed.connect(self._clear)

    def title(self) -> str:
        return self.tr("Hand")

    # --- controls

    def _add_presets(self) -> None:
        """Buttons that look from somewhere."""
        presets = (
            (self.tr("Back"), self.view_back),
            (self.tr("Palm"), self.view_palm),
            (self.tr("Side"), self.view_side),
            (self.tr("Camera"), self.view_camera),
        )
        for text, slot in presets:
            button = QToolButton()
            button.setText(text)
            button.setToolTip(self.tr("Look from there"))
            button.clicked.connect(slot)
            self._controls.addWidget(button)

    def _add_boxes(self) -> None:
        """What is shown beside the hand."""
        boxes = (
            ("markers", self.tr("Markers"), self.tr("Large: seen now. Smaller: lately, never")),
            ("uncertainty", self.tr("2σ"), self.tr("A ball round each fingertip")),
            ("camera", self.tr("Camera"), self.tr("The left camera's field of view")),
            ("axes", self.tr("Axes"), self.tr("The frame of each segment at its joint: x, y, z")),
        )
        self._boxes: dict[str, QCheckBox] = {}
        for name, text, tip in boxes:
            box = self._boxes[name] = QCheckBox(text)
            box.setToolTip(tip)
            box.setChecked(name != "axes")
            self._controls.addWidget(box)

    def _add_choices(self) -> None:
        """Another hand to compare with, and the way of a fingertip."""
        self.reference = QComboBox()
        self.reference.setAccessibleName(self.tr("Hand to compare with"))
        self.reference.setToolTip(
            self.tr(
                "Another hand, see-through: the truth of a simulated one, the second tracking "
                "of a replay, or another engine on the same data"
            )
        )
        self.reference.addItem(self.tr("No ghost"), NO_REFERENCE)
        self.reference.addItem(self.tr("Ghost: truth or second"), OTHER)
        for name in ENGINES:
            self.reference.addItem(self.tr("Ghost: {}").format(name), name)
        self.reference.currentIndexChanged.connect(self._choose_reference)
        self.trail = QComboBox()
        self.trail.setAccessibleName(self.tr("Fingertip whose way is drawn"))
        self.trail.setToolTip(self.tr("The way of a fingertip over the last three seconds"))
        self.trail.addItem(self.tr("No trail"), "")
        self.trail.currentIndexChanged.connect(self._choose_trail)
        for widget in (self.reference, self.trail):
            self._controls.addWidget(widget)

    def show_reference(self) -> None:
        """Draw the other hand, now that there is one."""
        self.reference.setCurrentIndex(self.reference.findData(OTHER))

    def _choose_reference(self) -> None:
        """Start or end the second engine."""
        setup, name = self.host.setup, str(self.reference.currentData())
        if setup is None or setup.reference_tracking is None:
            return
        try:
            setup.reference_tracking.set_reference(name if name in ENGINES else None)
        except GlovetrackError as error:
            self.host.error.emit(str(error))

    def _choose_trail(self) -> None:
        if self._model is not None:
            self._model.set_trail(str(self.trail.currentData() or ""))

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

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.chooser.start()

    def _open(self, setup: EngineSetup) -> None:
        self._clear()
        self._setup = setup
        self._model = HandSceneModel(setup)
        self._offer(setup)
        self.view.orbit.look_from(FIRST_LOOK)
        self._make_actors()

    def _offer(self, setup: EngineSetup) -> None:
        """The fingertips of this hand, and the engines where a second one can run."""
        assert self._model is not None
        chosen = self.trail.currentData()
        self.trail.clear()
        self.trail.addItem(self.tr("No trail"), "")
        for name in self._model.tip_names:
            self.trail.addItem(self.tr("Trail: {}").format(name), name)
        self.trail.setCurrentIndex(max(0, self.trail.findData(chosen)))
        for i in range(self.reference.count()):
            able = self.reference.itemData(i) not in ENGINES or setup.reference_tracking is not None
            self.reference.model().item(i).setEnabled(able)  # type: ignore[attr-defined]
        if self.reference.currentData() in ENGINES:
            self._choose_reference()

    def _make_actors(self) -> None:
        """Fill the scene of the view that draws now."""
        self._actors = None
        if self._setup is not None and self.view.scene is not None:
            colours = hue_colours(self._setup.profile)
            self._actors = HandActors(self.view.scene, self._setup, colours)

    def _clear(self) -> None:
        self._actors = self._model = self._scene = self._setup = None
        if self.view.scene is not None:
            self.view.scene.clear()

    def show_options(self) -> ShownParts:
        ticked = {name: box.isChecked() for name, box in self._boxes.items()}
        reference, trail = self.reference.currentData(), self.trail.currentData()
        return ShownParts(**ticked, truth=reference != NO_REFERENCE, trail=bool(trail))

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
        self.chooser.drawn()

    def _follow(self, scene: HandScene) -> None:
        centre = scene.segment_p.mean(axis=0)
        away = float(np.linalg.norm(centre - self.view.orbit.target))
        step = FOLLOW if self._scene is not None and away < JUMP else 1.0
        self.view.orbit.target = self.view.orbit.target + step * (centre - self.view.orbit.target)
        self._scene = scene

    def shut_down(self) -> None:
        self._actors = None
        self.chooser.shut_down()
        self.view.shut_down()
