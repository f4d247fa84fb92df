"""An application's drawing in the 3D view: surfaces, lines and labels, and the hand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from app.engines.engine import EngineSetup
from app.engines.snapshot import Snapshot
from app.panels.hand.bodies import HandBodies
from app.platform.tasks import LatestJob
from app.viewmodels.hand_scene import HandScene, HandSceneModel, ShownParts, followed
from app.viewmodels.hand_skin import HandSkin
from app.viewmodels.made_skins import MADE
from app.widgets.view3d.orbit import VIEW_ANGLE_DEG, Orbit
from app.widgets.view3d.scene import BodyLook, BodyScene, DrawnBody, DrawnSurface, Label, contrast
from app.widgets.view3d.shapes import Surface, polyline
from app.widgets.view3d.view_3d import View3D
from extensions.applications.drawing import Drawing, Line, Mesh, Points, Text
from tracker.messages import Array, IntArray

LOOK = 7  # numbers that describe the look of a point, as `app.widgets.view3d.shapes.DRESS`
AMBIENT = 0.25
FIRST_LOOK = np.array([-0.75, 0.25, 0.6])
PARTS = ShownParts(markers=False, uncertainty=False, camera=False, reference=False)
ROOM = 1.25  # times the size of what is drawn that the view shows
FIRST_PART = 3000  # part numbers above those of the hand
MOST = 400
"""Bodies in a scene, shown or not, after which it is rebuilt."""
FEWEST = 8  # least number of points of a line
_A, _B = 0.525731, 0.850651
BALL = np.array(
    [[-_A, 0, _B], [_A, 0, _B], [-_A, 0, -_B], [_A, 0, -_B], [0, _B, _A], [0, _B, -_A],
     [0, -_B, _A], [0, -_B, -_A], [_B, _A, 0], [-_B, _A, 0], [_B, -_A, 0], [-_B, -_A, 0]]
)  # fmt: skip
BALL_FACES = np.array(
    [[0, 1, 4], [0, 4, 9], [9, 4, 5], [4, 8, 5], [4, 1, 8], [8, 1, 10], [8, 10, 3], [5, 8, 3],
     [5, 3, 2], [2, 3, 7], [7, 3, 10], [7, 10, 6], [7, 6, 11], [11, 6, 0], [0, 6, 1], [6, 10, 1],
     [9, 11, 0], [9, 2, 11], [9, 5, 2], [7, 11, 2]]
)  # fmt: skip
"""An icosahedron, which looks like a ball if it is small."""


@dataclass(frozen=True, eq=False)
class SurfaceForm:
    """Triangles (F, 3) with points and normals (V, 3) and looks (V, `LOOK`)."""

    name: str
    faces: IntArray
    points: Array
    normals: Array
    looks: Array


@dataclass(frozen=True, eq=False)
class LineForm:
    """A polyline (N, 3), N a power of two: the last point is repeated where there are fewer."""

    name: str
    points: Array
    colour: str
    width: float


@dataclass(frozen=True, eq=False)
class LabelForm:
    text: str
    p: Array
    colour: str


class DrawingForms:
    """Converts drawings to forms; caches the normals of meshes that do not change."""

    def __init__(self) -> None:
        self._known: dict[str, tuple[Mesh, Array]] = {}

    def surfaces(self, drawing: Drawing) -> list[SurfaceForm]:
        """The surfaces of meshes and balls."""
        out = [self._mesh(d) for d in drawing if isinstance(d, Mesh)]
        return out + [_balls(d) for d in drawing if isinstance(d, Points) and len(d.points)]

    def _mesh(self, mesh: Mesh) -> SurfaceForm:
        known, normals = self._known.get(mesh.name, (None, np.empty((0, 3))))
        if known is None or known.points is not mesh.points:
            normals = vertex_normals(mesh.points, mesh.faces)
            self._known[mesh.name] = mesh, normals
        size = np.cbrt(max(float(np.linalg.det(mesh.R)), 1e-12))
        points = mesh.points @ mesh.R.T + mesh.p
        look = _look(mesh.colour, mesh.opacity)
        looks = np.broadcast_to(look, (len(points), LOOK))
        return SurfaceForm(mesh.name, mesh.faces, points, normals @ mesh.R.T / size, looks)

    @staticmethod
    def lines(drawing: Drawing) -> list[LineForm]:
        return [_padded(d) for d in drawing if isinstance(d, Line) and len(d.points) > 1]

    @staticmethod
    def labels(drawing: Drawing, ink: str) -> list[LabelForm]:
        """``ink`` is the colour of labels without one."""
        texts = [d for d in drawing if isinstance(d, Text)]
        return [LabelForm(d.text, d.p, d.colour or ink) for d in texts]


def vertex_normals(points: Array, faces: IntArray) -> Array:
    """(V, 3) unit normals: those of the triangles around each point, weighted by area."""
    a, b, c = (points[faces[:, k]] for k in range(3))
    flat = np.cross(b - a, c - a)
    out = np.zeros_like(points)
    for k in range(3):
        np.add.at(out, faces[:, k], flat)
    return np.asarray(out / np.maximum(np.linalg.norm(out, axis=1, keepdims=True), 1e-12))


def bounds(drawing: Drawing) -> tuple[Array, Array] | None:
    """Least and greatest corner (3,) m of a drawing; None if it is empty."""
    every = [d.points @ d.R.T + d.p for d in drawing if isinstance(d, Mesh) and len(d.points)]
    every += [d.points for d in drawing if isinstance(d, Line | Points) and len(d.points)]
    if not every:
        return None
    points = np.concatenate(every)
    return points.min(axis=0), points.max(axis=0)


def _balls(balls: Points) -> SurfaceForm:
    n = len(balls.points)
    points = (balls.points[:, None] + balls.radius * BALL).reshape(-1, 3)
    faces = (BALL_FACES + len(BALL) * np.arange(n)[:, None, None]).reshape(-1, 3)
    look = _look(balls.colour, 1.0)
    looks = np.broadcast_to(look, (len(points), LOOK))
    return SurfaceForm(f"{balls.name} {n}", faces, points, np.tile(BALL, (n, 1)), looks)


def _padded(line: Line) -> LineForm:
    room = max(FEWEST, 1 << (len(line.points) - 1).bit_length())
    last = np.broadcast_to(line.points[-1], (room - len(line.points), 3))
    points = np.concatenate([line.points, last])
    return LineForm(f"{line.name} {room}", points, line.colour, line.width)


def _look(colour: str, opacity: float) -> Array:
    red, green, blue = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    return np.array([red, green, blue, opacity, AMBIENT, 0.0, 0.0])


class ApplicationBodies:
    """The bodies of a drawing in one scene, which has others too."""

    def __init__(self, scene: BodyScene) -> None:
        self._scene = scene
        self._surfaces: dict[str, DrawnSurface] = {}
        self._lines: dict[str, DrawnBody] = {}
        self._faces: dict[str, int] = {}

    @property
    def worn_out(self) -> bool:
        """Whether so many bodies were made that the scene should be rebuilt."""
        return len(self._surfaces) + len(self._lines) > MOST

    def update(self, surfaces: list[SurfaceForm], lines: list[LineForm]) -> None:
        """Show these forms and hide all others."""
        for form in surfaces:
            self._surface(form)
        for line in lines:
            self._line(line)
        drawn = {f.name for f in surfaces}
        for name, surface in self._surfaces.items():
            if name not in drawn:
                surface.show(False)
        there = {f.name for f in lines}
        for name, body in self._lines.items():
            if name not in there:
                body.show(False)

    def _surface(self, form: SurfaceForm) -> None:
        surface = self._surfaces.get(form.name)
        if surface is None or self._faces[form.name] != len(form.faces):
            if surface is not None:
                surface.show(False)
            part = FIRST_PART + len(self._surfaces)
            shape = Surface(form.faces, form.faces[:, 0] * 0 + part, form.points[:, 0] * 0)
            surface = self._surfaces[form.name] = self._scene.add_surface(shape)
            self._faces[form.name] = len(form.faces)
        surface.drape(form.points, form.normals, form.looks)
        surface.show(True)

    def _line(self, form: LineForm) -> None:
        look = BodyLook(form.colour, line_width=form.width)
        body = self._lines.get(form.name)
        if body is None:
            body = self._lines[form.name] = self._scene.add(polyline(form.points), look)
        body.reshape(form.points)
        body.wear(look)
        body.show(True)


class ApplicationView(View3D):
    """The hand and what an application draws of it."""

    failed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._ink = contrast("#000000")
        self._setup: EngineSetup | None = None
        self._model: HandSceneModel | None = None
        self._bodies: tuple[HandBodies, ApplicationBodies] | None = None
        self._forms = DrawingForms()
        self.skin: HandSkin | None = None
        self._skin_requested = self._to_fit = False
        self._skins = LatestJob(self.tr("Generating the hand mesh"), self)
        self._skins.failed.connect(self.failed)
        self.scene_changed.connect(self._make_bodies)

    def set_background(self, colour: str) -> None:
        self._ink = contrast(colour)
        super().set_background(colour)

    def open(self, setup: EngineSetup) -> None:
        """Show the hand of this setup."""
        self._setup, self._model = setup, HandSceneModel(setup)
        self.orbit.look_from(FIRST_LOOK)
        self.fit_next()
        self._make_bodies()

    def clear(self) -> None:
        """Show nothing."""
        self._setup = self._model = self._bodies = self.skin = None
        self._skin_requested = False
        self._skins.forget()
        self.set_labels(())
        if self.scene is not None:
            self.scene.clear()

    def fit_next(self) -> None:
        """Move the eye with the next drawing until all of it is in view."""
        self._to_fit = True

    def draw(self, view: Snapshot | None, drawing: Drawing, runs: bool) -> None:
        """Draw the hand and the application's ``drawing``; ``runs``: there is an application."""
        if self._setup is None or self._model is None or view is None or self._bodies is None:
            self.caption = self.tr("No hand yet")
            self.render_scene()
            return
        if not self._skin_requested:
            self._make_skin(self._setup)  # the view's setup is another one once colours change
        if self._bodies[1].worn_out:
            self._make_bodies()
        scene = self._model.scene(view)
        self.caption = self._caption_of(scene)
        self._look(scene, drawing, runs)
        self._update(scene, drawing)
        self.render_scene()

    def _caption_of(self, scene: HandScene | None) -> str:
        if scene is None:
            return self.tr("No hand yet")
        making = "" if self.skin is not None else self.tr("Generating the hand mesh…")
        return " · ".join(filter(None, (scene.caption, making)))

    def _look(self, scene: HandScene | None, drawing: Drawing, runs: bool) -> None:
        if self._to_fit and (drawing or scene is not None):
            box = bounds(drawing)
            self._to_fit = box is None and runs
            look_at(self.orbit, box, scene)
        elif scene is not None and not runs:  # an application's drawing stays where it is
            self.orbit.target = followed(self.orbit.target, [scene], True)

    def _update(self, scene: HandScene | None, drawing: Drawing) -> None:
        assert self._bodies is not None
        hand, own = self._bodies
        labels: list[Label] = []
        if scene is not None:
            labels += hand.update_ground(scene)
            hand.update(scene, PARTS, self.orbit)
        own.update(self._forms.surfaces(drawing), self._forms.lines(drawing))
        labels += [Label(f.text, f.p, f.colour) for f in self._forms.labels(drawing, self._ink)]
        self.set_labels(labels)

    def _make_skin(self, setup: EngineSetup) -> None:
        """Once the view is visible; it takes about a second, on another thread."""
        self._skin_requested = True
        hand, glove = setup.hand, setup.glove
        if MADE.has(hand, glove):  # as where the hand's own panel has it
            self.skin = HandSkin(hand, glove)
            self._make_bodies()
            return

        def made(skin: HandSkin) -> None:
            if self._setup is setup:
                self.skin = skin
                self._make_bodies()

        self._skins.run(lambda _progress: HandSkin(hand, glove), made)

    def _make_bodies(self) -> None:
        """Fill the scene of the present renderer."""
        self._bodies = None
        scene = self.scene
        if self._setup is None or scene is None:
            return
        scene.clear()
        hand = HandBodies(scene, self._setup, {})
        self._bodies = hand, ApplicationBodies(scene)
        if self.skin is not None:
            hand.apply_profile(self.skin)

    def shut_down(self) -> None:
        self._bodies = None
        self._skins.shut_down()
        super().shut_down()


def look_at(orbit: Orbit, box: tuple[Array, Array] | None, scene: HandScene | None) -> None:
    """Move the eye until the drawing in its ``box``, if any, and the hand are visible."""
    corners = [*box] if box is not None else []
    if scene is not None:
        corners += [scene.segment_p.min(axis=0), scene.segment_p.max(axis=0)]
    low, high = np.min(corners, axis=0), np.max(corners, axis=0)
    orbit.target = (low + high) / 2
    half = max(0.5 * float(np.linalg.norm(high - low)), 0.08)
    orbit.distance = ROOM * half / float(np.tan(np.deg2rad(VIEW_ANGLE_DEG / 2)))
