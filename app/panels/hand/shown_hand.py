"""One of the hands in the 3D view: what it looks like, and its bodies there."""

from __future__ import annotations

from dataclasses import replace

from app.engines.engine import EngineSetup
from app.engines.snapshot import Snapshot
from app.panels.hand.bodies import HandBodies
from app.viewmodels.colours import hue_colours
from app.viewmodels.hand_scene import HandScene, HandSceneModel, ShownParts
from app.viewmodels.hand_skin import HandSkin
from app.widgets.view3d.orbit import Orbit
from app.widgets.view3d.scene import BodyScene, Label


class HandInScene:
    """Knows its hand from the start; gets a ``skin``, and ``bodies`` in whatever scene is drawn."""

    def __init__(self, setup: EngineSetup, is_main: bool, of_two: bool) -> None:
        self.setup, self.is_main = setup, is_main
        self.model = HandSceneModel(setup, of_two)
        self.bodies: HandBodies | None = None
        self.skin: HandSkin | None = None
        self.scene: HandScene | None = None

    def put_on(self, skin: HandSkin) -> None:
        """From now on there is a hand to be seen."""
        self.skin = skin
        if self.bodies is not None:
            self.bodies.put_on(skin)

    def make_bodies(self, scene: BodyScene) -> None:
        """Into the scene of the view that draws now."""
        self.bodies = HandBodies(scene, self.setup, hue_colours(self.setup.profile))
        if self.skin is not None:
            self.bodies.put_on(self.skin)

    def forget_bodies(self) -> None:
        """Their scene is gone."""
        self.bodies = None

    def look(self, view: Snapshot, show: ShownParts) -> HandScene | None:
        """The hand as it is to be drawn; None where nothing can be drawn yet."""
        scene = self.model.scene(view, show.reference)
        if scene is None or self.bodies is None:
            return None
        self.scene = scene
        return scene

    def draw(self, show: ShownParts, orbit: Orbit) -> list[Label]:
        """Move the bodies to the last `look`; with the main hand come camera and ground."""
        if self.scene is None or self.bodies is None:
            return []
        labels = self.bodies.update_ground(self.scene) if self.is_main else []
        own = show if self.is_main else replace(show, camera=False)
        self.bodies.update(self.scene, own, orbit)
        return labels
