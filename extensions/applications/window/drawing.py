"""An application's drawing as forms of the 3D view: surfaces, lines and labels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.widgets.view3d.scene import BodyLook, BodyScene, DrawnBody, DrawnSurface
from app.widgets.view3d.shapes import Surface, polyline
from extensions.applications.drawing import Drawing, Line, Mesh, Points, Text
from tracker.messages import Array, IntArray

LOOK = 7  # numbers of a point's look, as `app.widgets.view3d.shapes.DRESS`
AMBIENT = 0.25
FIRST_PART = 3000  # parts of their own, far from those of the hand
MOST = 400
"""Bodies that a scene holds, shown or not, before it is made again."""
FEWEST = 8  # points that a line has room for
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
"""An icosahedron: what a small ball looks like from some way off."""


@dataclass(frozen=True, eq=False)
class SurfaceForm:
    """Triangles (F, 3) and where their points are: points, normals (V, 3), looks (V, `LOOK`)."""

    name: str
    faces: IntArray
    points: Array
    normals: Array
    looks: Array


@dataclass(frozen=True, eq=False)
class LineForm:
    """A polyline (N, 3), N a power of two: the last point stands where there are fewer."""

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
    """Makes forms of one drawing after another; remembers what does not change of a mesh."""

    def __init__(self) -> None:
        self._known: dict[str, tuple[Mesh, Array]] = {}

    def surfaces(self, drawing: Drawing) -> list[SurfaceForm]:
        """Of meshes and balls."""
        out = [self._mesh(d) for d in drawing if isinstance(d, Mesh)]
        return out + [_balls(d) for d in drawing if isinstance(d, Points) and len(d.points)]

    def _mesh(self, mesh: Mesh) -> SurfaceForm:
        kept, normals = self._known.get(mesh.name, (None, np.empty((0, 3))))
        if kept is None or kept.points is not mesh.points:
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
        """``ink`` is the colour of those that have none."""
        texts = [d for d in drawing if isinstance(d, Text)]
        return [LabelForm(d.text, d.p, d.colour or ink) for d in texts]


def vertex_normals(points: Array, faces: IntArray) -> Array:
    """(V, 3) of length 1, of the triangles around each point by their size."""
    a, b, c = (points[faces[:, k]] for k in range(3))
    flat = np.cross(b - a, c - a)
    out = np.zeros_like(points)
    for k in range(3):
        np.add.at(out, faces[:, k], flat)
    return np.asarray(out / np.maximum(np.linalg.norm(out, axis=1, keepdims=True), 1e-12))


def bounds(drawing: Drawing) -> tuple[Array, Array] | None:
    """Least and greatest corner (3,) m of all that is drawn; None of nothing."""
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
    """In one scene, beside others' bodies."""

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
        """Show these and no others."""
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
