"""The hand that shows a pose, in a ring that fills while the wearer holds it."""

from __future__ import annotations

import dataclasses

import numpy as np
from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.platform.tasks import JobProgress, LatestJob
from app.viewmodels.guided_hand import DrawnHand, Shown
from app.viewmodels.hand_skin import Draped, HandSkin
from app.viewmodels.states import NEUTRAL
from app.widgets.hold_ring import HoldRing
from app.widgets.view3d.scene import DrawnSurface, rgb
from app.widgets.view3d.shapes import Surface
from app.widgets.view3d.view_3d import View3D
from tracker.base.clock import monotonic
from tracker.messages import Estimate, Validity


class PoseStage(QWidget):
    """Draws for one hand; `show_pose` begins the way to a pose, `refresh` goes on with it.

    The wearer's own hand, as it is tracked, lies over the drawn one as an outline.
    """

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._hand = setup.hand
        self._drawn = DrawnHand(setup.hand)
        self._skin: HandSkin | None = None
        self._body: DrawnSurface | None = None
        self._outline: DrawnSurface | None = None
        self.before, self.pose, self._since = "", "flat", monotonic()
        self.view = View3D()
        self.view.setMinimumSize(240, 240)
        self.view.set_background(background)
        self.view.setAccessibleName(self.tr("The pose to be held"))
        self.ring = HoldRing(self.view)
        self.view.installEventFilter(self)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.view)
        self._skins = LatestJob(self.tr("Making the hand's skin"), self)

        def make(_progress: JobProgress) -> HandSkin:
            return HandSkin(setup.hand, setup.glove)

        self._skins.run(make, self._put_on)

    @property
    def is_ready(self) -> bool:
        """Whether there is a hand to be seen."""
        return self._skin is not None

    def _put_on(self, skin: HandSkin) -> None:
        scene = self.view.scene
        if scene is None:
            return
        self._skin = skin
        surface = Surface(skin.skin.faces, skin.part, skin.skin.along)
        self._body, self._outline = scene.add_surface(surface), scene.add_outline(surface)

    def show_pose(self, pose: str) -> None:
        """Go from the pose that is shown to this one."""
        if pose != self.pose:
            self.before, self.pose = self.pose, pose
        self._since = monotonic()

    def refresh(self, estimate: Estimate | None, again: bool) -> None:
        """Draw the hand as it is by now; ``again``: show the way anew after a while."""
        skin, body = self._skin, self._body
        if skin is None or body is None:
            return
        shown = self._drawn.shown(self.before, self.pose, monotonic() - self._since, again)
        orbit = self.view.orbit
        orbit.target, orbit.distance = shown.p_middle, self._drawn.distance()
        orbit.look_from(shown.eye)
        draped = _plain(skin, shown)
        body.drape(draped.points, draped.normals, draped.looks)
        body.show(True)
        self._refresh_outline(skin, estimate, shown)
        self.view.render_scene()

    def _refresh_outline(self, skin: HandSkin, estimate: Estimate | None, shown: Shown) -> None:
        """The wearer's hand with its back where the drawn one has it."""
        if self._outline is None:
            return
        there = estimate is not None and bool(np.isfinite(estimate.segment_p).all())
        self._outline.show(there)
        if there and estimate is not None:
            root = self._hand.root
            turn = shown.R[root] @ estimate.segment_R[root].T
            p = (estimate.segment_p - estimate.segment_p[root]) @ turn.T + shown.p[root]
            seen = skin.plain(turn @ estimate.segment_R, p)
            self._outline.drape(seen.points, seen.normals, seen.looks)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self.ring.setGeometry(self.view.rect())
            self.ring.raise_()
        return super().eventFilter(watched, event)

    def shut_down(self) -> None:
        """Wait for the skin and free what the view holds."""
        self._skins.shut_down()
        self.view.shut_down()


def _plain(skin: HandSkin, shown: Shown) -> Draped:
    """In no state's colour: it is nobody's hand."""
    states = np.full(len(shown.R), int(Validity.MEASURED), np.int64)
    draped = skin.draped(shown.R, shown.p, states)
    looks = draped.looks.copy()
    looks[:, :3] = rgb(NEUTRAL)
    return dataclasses.replace(draped, looks=looks)
