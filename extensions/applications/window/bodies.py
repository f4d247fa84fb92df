"""The bodies of an application's drawing: made once for each name, then moved."""

from __future__ import annotations

from app.widgets.view3d.scene import BodyLook, BodyScene, DrawnBody, DrawnSurface
from app.widgets.view3d.shapes import Surface, polyline
from extensions.applications.window.drawing import LineForm, SurfaceForm

FIRST_PART = 3000  # parts of their own, far from those of the hand
MOST = 400
"""Bodies that a scene keeps, shown or not, before it is made anew."""


class ApplicationBodies:
    """In one scene, beside others' bodies."""

    def __init__(self, scene: BodyScene) -> None:
        self._scene = scene
        self._surfaces: dict[str, DrawnSurface] = {}
        self._lines: dict[str, DrawnBody] = {}
        self._faces: dict[str, int] = {}

    @property
    def worn_out(self) -> bool:
        """Whether it has made so many bodies that the scene is better made anew."""
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
