"""The hand in 3D."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

import numpy as np
from PySide6.QtCore import QElapsedTimer, Qt
from PySide6.QtGui import QResizeEvent, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.engines.host_parts import CurrentEngine, ErrorSignal, HandChanges
from app.engines.snapshot import Snapshot
from app.panels.hand.bodies import HandBodies
from app.panels.hand.controls import HandControls, View3DSettings, ViewChooser
from app.panels.hand.legend import ValidityLegend
from app.panels.panel import Panel, PanelColours
from app.platform.tasks import LatestJob, TaskOwner
from app.storage.settings import SettingsOf
from app.viewmodels.colours import hue_colours
from app.viewmodels.gestures import ShownGestures
from app.viewmodels.hand_scene import (
    HandScene,
    HandSceneModel,
    ShownParts,
    followed,
    view_direction,
)
from app.viewmodels.hand_skin import HandSkin
from app.viewmodels.made_skins import MADE
from app.widgets.elided_label import ElidedLabel
from app.widgets.measures import NEAR
from app.widgets.view3d.orbit import Orbit
from app.widgets.view3d.scene import BodyScene, Label
from app.widgets.view3d.view_3d import View3D
from app.words import error_text
from tracker.base.errors import GlovetrackError
from tracker.messages import Shed

FIRST_LOOK = np.array([-0.75, 0.25, 0.85])
"""From behind and above the hand, as its owner sees it."""
DISTANCE = {1: 0.42, 2: 0.75}
"""Initial distance of the camera from one hand or from the centre of two, m."""

LOW = 170  # px, above the minimum height; below it the legend is hidden to leave space for the hand


class HandInScene:
    """One hand in the 3D view. ``skin`` and ``bodies`` are added when they are available."""

    def __init__(self, setup: EngineSetup, is_main: bool, of_two: bool) -> None:
        self.setup, self.is_main = setup, is_main
        self.model = HandSceneModel(setup, of_two)
        self.bodies: HandBodies | None = None
        self.skin: HandSkin | None = None
        self.scene: HandScene | None = None

    def apply_profile(self, skin: HandSkin) -> None:
        """Use this mesh from now on."""
        self.skin = skin
        if self.bodies is not None:
            self.bodies.apply_profile(skin)

    def make_bodies(self, scene: BodyScene) -> None:
        """Create the bodies in the scene of the current view."""
        self.bodies = HandBodies(scene, self.setup, hue_colours(self.setup.profile))
        if self.skin is not None:
            self.bodies.apply_profile(self.skin)

    def forget_bodies(self) -> None:
        """Discard the bodies after their scene was deleted."""
        self.bodies = None

    def look(self, view: Snapshot, show: ShownParts) -> HandScene | None:
        """The scene to draw; None if nothing can be drawn yet."""
        scene = self.model.scene(view, show.reference)
        if scene is None or self.bodies is None:
            return None
        self.scene = scene
        return scene

    def draw(self, show: ShownParts, orbit: Orbit) -> list[Label]:
        """Move the bodies to the scene of the last `look`; the main hand also draws camera and
        ground."""
        if self.scene is None or self.bodies is None:
            return []
        labels = self.bodies.update_ground(self.scene) if self.is_main else []
        own = show if self.is_main else replace(show, camera=False)
        self.bodies.update(self.scene, own, orbit)
        return labels


class HandHost(CurrentEngine, ErrorSignal, HandChanges, Protocol):
    """What the panel uses of the engine host."""


class HandPanel(Panel):
    period = 1 / 30
    spared_at = Shed.VIEW_RATE

    def __init__(
        self,
        host: HandHost,
        store: SettingsOf[View3DSettings],
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.host = host
        self.view = View3D()
        self.chooser = ViewChooser(self.view, store, tasks, self)
        self.chooser.refused.connect(host.error)
        self.view.scene_changed.connect(self._make_bodies)
        self._hands: list[HandInScene] = []  # main hand first
        self._gestures: ShownGestures | None = None
        self._found = False
        self._since = QElapsedTimer()  # time since the last drawing
        self._since.start()
        self._skins = LatestJob(self.tr("Generating the hand mesh"), self)
        self._skins.failed.connect(host.error)
        self.controls = HandControls()
        self.controls.look_from.connect(self.look_from)
        self.controls.reference_chosen.connect(self._choose_reference)
        self.controls.trail_chosen.connect(self._choose_trail)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(NEAR)
        column.addWidget(self.controls)
        column.addWidget(self.view, 1)
        column.addWidget(self._legend())
        host.opened.connect(self._open)
        host.hand_changed.connect(self._open)
        host.closed.connect(self._clear)

    def _legend(self) -> QWidget:
        self.legend = ValidityLegend()
        self.gesture = ElidedLabel()
        self.gesture.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.gesture.setToolTip(self.tr("Current gestures and their strength"))
        self.legend.row.addWidget(self.gesture, 1)
        return self.legend

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.legend.setVisible(self.height() >= LOW)

    # --- requests

    def look_from(self, name: str) -> None:
        """View from the "back", "palm" or "side" of the hand, or from the "camera"."""
        scene, orbit = self._scene, self.view.orbit
        if name != "camera":
            R_GB = scene.segment_R[0] if scene is not None else np.eye(3)
            orbit.look_from(view_direction(name, R_GB))
        elif scene is not None:
            orbit.look_from(scene.p_GC - orbit.target)
        self.view.render_scene()

    def show_reference(self, name: str) -> None:
        """Show that the reference ``name`` is available."""
        self.controls.show_reference(name)

    def _choose_reference(self, engine: str) -> None:
        """Start or stop the reference engine."""
        setup = self.host.setup
        compared = setup.comparable if setup is not None else None
        if compared is None:
            return
        try:
            compared.set_reference(engine or None)
        except GlovetrackError as error:
            self.host.error.emit(error_text(error))

    def _choose_trail(self, tip: str) -> None:
        for hand in self._hands:
            hand.model.set_trail(tip)

    # --- the engine

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.chooser.start()

    def _open(self, setup: EngineSetup) -> None:
        self._clear()
        of_two = bool(setup.others)
        self._hands = [HandInScene(s, k == 0, of_two) for k, s in enumerate(setup.hands)]
        self._gestures = ShownGestures(setup)
        tips = self._hands[0].model.tip_names
        self.controls.offer(tips, setup.comparable is not None)
        truth = setup.truth
        of_truth = self.tr("laboratory") if truth and truth.is_measured else self.tr("truth")
        self.controls.name_other(of_truth if truth is not None else "")
        if truth is not None and truth.is_measured:
            self.controls.show_reference(of_truth)
        if self.controls.engine:
            self._choose_reference(self.controls.engine)
        self.view.orbit.look_from(FIRST_LOOK)
        self.view.orbit.distance = DISTANCE[len(self._hands)]
        self._make_bodies()
        self._make_skins(self._hands)

    def _make_skins(self, hands: list[HandInScene]) -> None:
        """Use cached meshes immediately; generate others in the background, which takes a second
        each."""
        models = [(hand.setup.hand, hand.setup.glove) for hand in hands]

        def made(skins: list[HandSkin]) -> None:
            if self._hands is hands:
                for hand, skin in zip(hands, skins, strict=True):
                    hand.apply_profile(skin)

        if all(MADE.has(*model) for model in models):
            made([HandSkin(*model) for model in models])
        else:
            self._skins.run(lambda _progress: [HandSkin(*model) for model in models], made)

    def _make_bodies(self) -> None:
        """Create all bodies in the scene of the current view."""
        for hand in self._hands:
            hand.forget_bodies()
            if self.view.scene is not None:
                hand.make_bodies(self.view.scene)

    def _clear(self) -> None:
        self._hands, self._found = [], False
        self._gestures = None
        self.gesture.setText("")
        self._skins.forget()
        self.view.set_labels(())
        if self.view.scene is not None:
            self.view.scene.clear()

    @property
    def _scene(self) -> HandScene | None:
        """The last drawn scene of the main hand."""
        return self._hands[0].scene if self._hands else None

    def refresh(self, view: Snapshot | None) -> None:
        show = self.controls.shown()
        if self._gestures is not None and view is not None:
            self.gesture.setText(self._gestures.line(view.estimate))
        seen = {hand.setup.side: hand for hand in view.hands} if view is not None else {}
        looks = [
            hand.look(seen[hand.setup.side], show)
            for hand in self._hands
            if hand.setup.side in seen
        ]
        scenes = [scene for scene in looks if scene is not None]
        if not scenes:
            player = self._hands[0].setup.player if self._hands else None
            if player is not None and not player.tracked:
                self.view.caption = self.tr("Not tracked yet. Choose Replay, Track again.")
            else:
                self.view.caption = self.tr("No hand yet")
            self.view.render_scene()
            return
        orbit = self.view.orbit
        elapsed = self._since.restart() / 1000
        orbit.target = followed(orbit.target, scenes, self._found, elapsed)
        self._found = True
        captions = [s.caption for s in scenes if s.caption]
        if any(hand.skin is None for hand in self._hands):
            captions.append(self.tr("Generating the hand mesh…"))
        self.view.caption = " · ".join(dict.fromkeys(captions))
        labels = [label for hand in self._hands for label in hand.draw(show, orbit)]
        self.view.set_labels(labels)
        self.view.render_scene()
        self.chooser.drawn()

    def show_theme(self, colours: PanelColours) -> None:
        self.view.set_background(colours.scene)

    def shut_down(self) -> None:
        self._hands = []
        self._skins.shut_down()
        self.chooser.shut_down()
        self.view.shut_down()
