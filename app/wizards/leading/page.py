"""A page that guides the user: a 3D hand that shows the movement, and large text next to it."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Sequence

import numpy as np
from PySide6.QtCore import QEvent, QObject, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.platform.tasks import JobProgress, LatestJob
from app.viewmodels.guided_hand import DrawnHand, Shown
from app.viewmodels.hand_skin import Draped, HandSkin
from app.viewmodels.states import NEUTRAL
from app.widgets.measures import FAR
from app.widgets.view3d.scene import DrawnSurface, rgb
from app.widgets.view3d.shapes import Surface
from app.widgets.view3d.view_3d import View3D
from tracker.base.clock import monotonic
from tracker.messages import Array, Estimate, Validity

NOW = "▶"  # sign of the current step


WIDTH = 0.045  # of the ring, relative to its diameter
INSET = 6  # px to the border
TURN = 360 * 16  # Qt's angles are sixteenths of a degree
TOP = 90 * 16


class HoldRing(QWidget):
    """A ring centred over another widget; ignores the mouse."""

    def __init__(self, over: QWidget) -> None:
        super().__init__(over)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.share = 0.0
        self._full, self._empty = QColor("#009E73"), QColor(128, 128, 128, 90)

    def show_share(self, share: float, colour: str) -> None:
        """Show ``share`` 0..1 of the ring in ``colour``."""
        self.share = min(max(share, 0.0), 1.0)
        self._full = QColor(colour)
        self.setAccessibleName(self.tr("held for {} % of the time").format(round(100 * self.share)))
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        room = min(self.width(), self.height()) - 2 * INSET
        thick = max(WIDTH * room, 4.0)
        side = room - thick
        box = QRectF((self.width() - side) / 2, (self.height() - side) / 2, side, side)
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(self._empty, thick))
        painter.drawEllipse(box)
        pen = QPen(self._full, thick)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        painter.setPen(pen)
        painter.drawArc(box, TOP, -round(self.share * TURN))
        painter.end()


class PoseStage(QWidget):
    """Draws one hand; `show_pose` starts the movement to a pose, `refresh` continues it.

    The tracked hand of the wearer is drawn over it as an outline.
    """

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._hand = setup.hand
        self._drawn = DrawnHand(setup.hand)
        self.distance = self._drawn.distance()  # of the viewer, m
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
        self._skins = LatestJob(self.tr("Generating the hand mesh"), self)

        def make(_progress: JobProgress) -> HandSkin:
            return HandSkin(setup.hand, setup.glove)

        self._skins.run(make, self._load_wearer)

    def _load_wearer(self, skin: HandSkin) -> None:
        scene = self.view.scene
        if scene is None:
            return
        self._skin = skin
        surface = Surface(skin.skin.faces, skin.part, skin.skin.along)
        self._body, self._outline = scene.add_surface(surface), scene.add_outline(surface)

    def show_pose(self, pose: str) -> None:
        """Move from the displayed pose to this one."""
        if pose != self.pose:
            self.before, self.pose = self.pose, pose
        self._since = monotonic()

    def refresh(self, estimate: Estimate | None, again: bool) -> None:
        """Draw the hand at the current time; ``again``: repeat the movement after a while."""
        skin, body = self._skin, self._body
        if skin is None or body is None:
            return
        shown = self.shown(again)
        orbit = self.view.orbit
        orbit.target, orbit.distance = shown.p_middle, self.distance
        orbit.look_from(shown.eye)
        draped = _plain(skin, shown)
        body.drape(draped.points, draped.normals, draped.looks)
        body.show(True)
        self._refresh_outline(skin, estimate, shown)
        self.view.render_scene()

    def shown(self, again: bool) -> Shown:
        """The drawn hand at the current time."""
        return self._drawn.shown(self.before, self.pose, monotonic() - self._since, again)

    def _refresh_outline(self, skin: HandSkin, estimate: Estimate | None, shown: Shown) -> None:
        """Draw the outline of the wearer's hand, rotated by `alignment` about its wrist."""
        if self._outline is None:
            return
        there = estimate is not None and bool(np.isfinite(estimate.segment_p).all())
        self._outline.show(there)
        if there and estimate is not None:
            root = self._hand.root
            turn = self.alignment(shown.R[root], estimate.segment_R[root])
            R = turn @ estimate.segment_R
            wrist = R[root] @ (shown.R[root].T @ shown.p[root])
            p = (estimate.segment_p - estimate.segment_p[root]) @ turn.T + wrist
            seen = skin.plain(R, p)
            self._outline.drape(seen.points, seen.normals, seen.looks)

    def alignment(self, R_shown: Array, R_own: Array) -> Array:
        """(3, 3) rotation of the wearer's hand, whose dorsum has the orientation ``R_own`` (3, 3);
        ``R_shown`` (3, 3) is that of the drawn hand. Here both dorsa coincide."""
        return np.asarray(R_shown @ R_own.T)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self.ring.setGeometry(self.view.rect())
            self.ring.raise_()
        return super().eventFilter(watched, event)

    def shut_down(self) -> None:
        """Wait for the mesh and release the view."""
        self._skins.shut_down()
        self.view.shut_down()


def _plain(skin: HandSkin, shown: Shown) -> Draped:
    """Without state colours: it is not a tracked hand."""
    states = np.full(len(shown.R), int(Validity.MEASURED), np.int64)
    draped = skin.draped(shown.R, shown.p, states)
    looks = draped.looks.copy()
    looks[:, :3] = rgb(NEUTRAL)
    return dataclasses.replace(draped, looks=looks)


def foot_row(first: QWidget, rest: Iterable[QWidget]) -> QHBoxLayout:
    """``first`` on the left of a page's bottom row, ``rest`` on its right."""
    row = QHBoxLayout()
    row.addWidget(first)
    row.addStretch(1)
    for widget in rest:
        row.addWidget(widget)
    return row


class LeadingPage(QWidget):
    """Buttons and texts; the dialog executes the requests."""

    def __init__(
        self,
        setup: EngineSetup,
        background: str,
        parent: QWidget | None = None,
        stage: PoseStage | None = None,
    ) -> None:
        """``stage``: by default one that shows guided poses."""
        super().__init__(parent)
        self.stage = stage or PoseStage(setup, background)
        self.words, self.notes = self.label("words"), self.label("notes")
        self.chips = self.label("chips")
        self.chips.setTextFormat(Qt.TextFormat.RichText)
        self.sound = QCheckBox(self.tr("Soun&d"))
        self.start = QPushButton(self.tr("&Start"))
        self.start.setProperty("role", "primary")
        self.stop = QPushButton(self.tr("End (Esc)"))
        self.stop.setAutoDefault(False)

    def label(self, role: str) -> QLabel:
        """A label whose font size follows the window's, see `LeadingDialog`."""
        label = QLabel()
        label.setObjectName(f"leading_{role}")
        label.setWordWrap(True)
        return label

    def lay_out(self, widgets: Sequence[QWidget], buttons: Sequence[QWidget]) -> None:
        """Place ``widgets`` next to the hand and ``buttons`` below, in order."""
        text = QVBoxLayout()
        text.addStretch(1)
        for widget in widgets:
            text.addWidget(widget)
        text.addStretch(1)
        text.setSpacing(FAR)
        upper = QHBoxLayout()
        upper.setSpacing(FAR)
        upper.addWidget(self.stage, 11)
        upper.addLayout(text, 9)
        column = QVBoxLayout(self)
        column.addLayout(upper, 1)
        column.addWidget(self.chips)
        column.addLayout(foot_row(self.sound, buttons))

    def show_chips(self, chips: Iterable[tuple[str, str]]) -> None:
        """Show sign and name of all steps, with the current one highlighted."""
        texts = (f"<b>{s} {n}</b>" if s == NOW else f"{s} {n}" for s, n in chips)
        self.chips.setText(" &nbsp; ".join(texts))
