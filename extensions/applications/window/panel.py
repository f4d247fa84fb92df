"""Applications of the tracked hand: which one runs, its settings, and what it has drawn."""

from __future__ import annotations

from typing import Any

import numpy as np
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.panels.hand.bodies import HandBodies
from app.panels.hand.legend import ValidityLegend
from app.panels.hand_choice import HandChoice
from app.panels.panel import Panel, PanelColours
from app.platform.tasks import LatestJob
from app.storage.settings import SettingsStore
from app.viewmodels.hand_scene import HandScene, HandSceneModel, ShownParts, followed
from app.viewmodels.hand_skin import HandSkin
from app.viewmodels.made_skins import MADE
from app.widgets.measures import NEAR
from app.widgets.view3d.orbit import VIEW_ANGLE_DEG, Orbit
from app.widgets.view3d.scene import Label, contrast
from app.widgets.view3d.view_3d import View3D
from extensions.applications.window.controls import ApplicationControls, SettingsForm
from extensions.applications.window.drawing import ApplicationBodies, DrawingForms, bounds
from extensions.applications.window.view_model import ApplicationsModel
from tracker.messages import Shed

FIRST_LOOK = np.array([-0.75, 0.25, 0.6])
PARTS = ShownParts(markers=False, uncertainty=False, camera=False, reference=False)
ROOM = 1.25  # times what is drawn that the view shows
FORM_WIDTH = 230  # px


class ApplicationsPanel(Panel):
    period = 1 / 30
    spared_at = Shed.VIEW_RATE

    def __init__(
        self, host: EngineHost, store: SettingsStore, parent: QWidget | None = None
    ) -> None:
        super().__init__(host, parent)
        self._store = store
        self._background = "#000000"
        self.view = View3D()
        self.view.scene_changed.connect(self._make_bodies)
        self._setup: EngineSetup | None = None
        self.model: ApplicationsModel | None = None
        self._hand_model: HandSceneModel | None = None
        self._bodies: tuple[HandBodies, ApplicationBodies] | None = None
        self._forms = DrawingForms()
        self._skin: HandSkin | None = None
        self._skins = LatestJob(self.tr("Generating the hand mesh"), self)
        self._skins.failed.connect(host.error)
        self._to_fit = False
        self.form = SettingsForm()
        self.form.setFixedWidth(FORM_WIDTH)
        self.form.hide()
        self.controls = ApplicationControls()
        self.instruction, self.said = QLabel(), QLabel()
        self.instruction.setProperty("role", "figure")
        for label in (self.instruction, self.said):
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
        column.addWidget(self.said)

    def _connect(self) -> None:
        row = self.controls
        row.choice.currentIndexChanged.connect(lambda _i: self._run(row.chosen, self._usual()))
        row.again.clicked.connect(self._restart)
        row.fit.clicked.connect(self._fit_next)
        row.settings.toggled.connect(self.form.setVisible)
        row.page.toggled.connect(self._show_page)
        self.form.changed.connect(self._set)
        self.host.opened.connect(self._open)
        self.host.closed.connect(self._clear)
        self.host.hand_changed.connect(self._follow_hand)

    # --- what is wanted

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
        self._make_bodies()
        self._fit_next()
        self._say(problem)
        for button in (self.controls.again, self.controls.settings):
            button.setEnabled(bool(name) and not problem)
        self.view.setAccessibleDescription(self.controls.choice.currentText())

    def _usual(self) -> dict[str, Any] | None:
        """Settings that the chosen application is to begin with; None: its own defaults."""
        name, settings = self.model.expected if self.model is not None else ("", {})
        return settings if name == self.controls.chosen else None

    def _restart(self) -> None:
        if self.model is not None and self.model.stage is not None:
            self.model.stage.restart()

    def _set(self, key: str, value: object) -> None:
        self._say(self.model.set(key, value) if self.model is not None else "")

    def _show_page(self, on: bool) -> None:
        self._say(self.model.show_page(on) if self.model is not None else "")

    def _fit_next(self) -> None:
        self._to_fit = True

    def _say(self, text: str) -> None:
        self._problem = text
        self.said.setText(text)
        self._instruct()

    def _instruct(self) -> None:
        """What to do now, where there is something to be done."""
        text = self.model.instruction() if self.model is not None and not self._problem else ""
        self.instruction.setText(text)
        self.instruction.setVisible(bool(text))

    @property
    def needs_low_latency(self) -> bool:
        return self.runs

    def show_theme(self, colours: PanelColours) -> None:
        self._background = colours.scene
        self.view.set_background(colours.scene)

    # --- the engine

    def _open(self, setup: EngineSetup) -> None:
        self._clear()
        self._setup, self.model = setup, ApplicationsModel(setup)
        self._hand_model = HandSceneModel(setup)
        self.controls.offer(self.model.titles, self.model.stage is not None)
        self.view.orbit.look_from(FIRST_LOOK)
        self._fit_next()
        name, settings = self.model.expected
        if name in self.model.titles:
            self.choose(name, settings)
        self._make_bodies()

    def _follow_hand(self, setup: EngineSetup) -> None:
        """What runs goes on with the hand that is shown now, page and all."""
        name, settings = self.model.leave() if self.model is not None else ("", {})
        page = self.controls.page.isChecked()
        self._open(setup)
        if name:
            self.choose(name, settings)
            self.controls.page.setChecked(page)

    def _clear(self) -> None:
        self._setup = self.model = self._hand_model = self._bodies = self._skin = None
        self._skin_asked = False
        self._skins.forget()
        self.controls.clear()
        self.form.show_rows([])
        self._say("")
        self.view.set_labels(())
        if self.view.scene is not None:
            self.view.scene.clear()

    def _make_skin(self, setup: EngineSetup) -> None:
        """Once the panel is in sight; a second's work, beside the window."""
        self._skin_asked = True
        hand, glove = setup.hand, setup.glove
        if MADE.has(hand, glove):  # as where the hand's own panel has it
            self._skin = HandSkin(hand, glove)
            self._make_bodies()
            return

        def made(skin: HandSkin) -> None:
            if self._setup is setup:
                self._skin = skin
                self._make_bodies()

        self._skins.run(lambda _progress: HandSkin(hand, glove), made)

    def _make_bodies(self) -> None:
        """Fill the scene of the view that draws now, anew."""
        self._bodies = None
        scene = self.view.scene
        if self._setup is None or scene is None:
            return
        scene.clear()
        hand = HandBodies(scene, self._setup, {})
        self._bodies = hand, ApplicationBodies(scene)
        if self._skin is not None:
            hand.put_on(self._skin)

    # --- drawing

    def refresh(self, view: Snapshot | None) -> None:
        if self.model is None or self._hand_model is None or view is None or self._bodies is None:
            self.view.caption = self.tr("No hand yet")
            self.view.render_scene()
            return
        if not self._skin_asked and self._setup is not None:
            self._make_skin(self._setup)  # the view's setup is another one once colours change
        if self._bodies[1].worn_out:
            self._make_bodies()
        scene = self._hand_model.scene(view)
        self.view.caption = self._caption(scene)
        self._draw(scene)
        if not self._problem:
            self.said.setText(self.model.line())
        self._instruct()
        self.view.render_scene()

    def _caption(self, scene: HandScene | None) -> str:
        if scene is None:
            return self.tr("No hand yet")
        making = "" if self._skin is not None else self.tr("Generating the hand mesh…")
        return " · ".join(filter(None, (scene.caption, making)))

    def _draw(self, scene: HandScene | None) -> None:
        assert self.model is not None and self._bodies is not None
        hand, own = self._bodies
        drawing = self.model.drawing
        if self._to_fit and (drawing or scene is not None):
            box = bounds(drawing)
            self._to_fit = box is None and self.model.runs
            _look_at(self.view.orbit, box, scene)
        elif scene is not None and not self.model.runs:  # what is drawn about it stays where it is
            self.view.orbit.target = followed(self.view.orbit.target, [scene], True)
        labels: list[Label] = []
        if scene is not None:
            labels += hand.update_ground(scene)
            hand.update(scene, PARTS, self.view.orbit)
        own.update(self._forms.surfaces(drawing), self._forms.lines(drawing))
        ink = contrast(self._background)
        labels += [Label(f.text, f.p, f.colour) for f in self._forms.labels(drawing, ink)]
        self.view.set_labels(labels)

    def shut_down(self) -> None:
        self._bodies = None
        self._skins.shut_down()
        self.view.shut_down()


def _look_at(orbit: Orbit, box: Any, scene: HandScene | None) -> None:
    """Move the eye until the drawing in its ``box``, if any, and the hand are in sight."""
    corners = [*box] if box is not None else []
    if scene is not None:
        corners += [scene.segment_p.min(axis=0), scene.segment_p.max(axis=0)]
    low, high = np.min(corners, axis=0), np.max(corners, axis=0)
    orbit.target = (low + high) / 2
    half = max(0.5 * float(np.linalg.norm(high - low)), 0.08)
    orbit.distance = ROOM * half / float(np.tan(np.deg2rad(VIEW_ANGLE_DEG / 2)))
