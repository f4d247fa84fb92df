"""The scene of the GPU renderer.

It uses VTK directly; only the window comes from pyvistaqt.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersHybrid import vtkPolyDataSilhouette
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkBillboardTextActor3D,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkTexture,
)

from app.widgets.view3d.orbit import VIEW_ANGLE_DEG, Orbit
from app.widgets.view3d.raster.skin import BETWEEN_DOTS, HATCH_DARKNESS, RING
from app.widgets.view3d.scene import BodyLook, Grid, GroundLines, Label, rgb
from app.widgets.view3d.shapes import Block, CapsuleShape, Disc, Lines, Shape, Surface, turn_x_to
from tracker.kernels.arrays import BoolVector
from tracker.messages import Array

GROUND_OPACITY = 0.25


PLAIN, HATCHED, DOTTED = 0.125, 0.375, 0.625
"""Texture coordinate of each pattern: the centre of its row of four."""


class VtkSurface:
    """A surface with patterns; ``outlined`` draws only its outline."""

    def __init__(self, surface: Surface, renderer: vtkRenderer, outlined: bool) -> None:
        self._surface, self._outlined = surface, outlined
        many = len(surface.along)
        nowhere = np.zeros((many, 3))
        self.data: vtkPolyData = polydata(BodyMesh(nowhere, nowhere, surface.faces))
        mapper = vtkPolyDataMapper()
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        drawn = self.actor.GetProperty()
        if outlined:
            silhouette = vtkPolyDataSilhouette()
            silhouette.SetInputData(self.data)
            silhouette.SetCamera(renderer.GetActiveCamera())
            silhouette.SetEnableFeatureAngle(0)
            mapper.SetInputConnection(silhouette.GetOutputPort())
            drawn.SetLineWidth(2.0)
            drawn.SetLighting(False)
        else:
            mapper.SetInputData(self.data)
            self.actor.SetTexture(_patterns())
            drawn.SetInterpolationToPhong()
            drawn.SetBackfaceCulling(True)
            drawn.SetSpecular(0.15)
        self.actor.SetVisibility(False)

    @property
    def shown(self) -> bool:
        return bool(self.actor.GetVisibility())

    def show(self, on: bool) -> None:
        self.actor.SetVisibility(on)

    def choose(self, faces: BoolVector) -> None:
        self.data.SetPolys(cells_of(self._surface.faces[faces]))

    def colour(self, colour: str) -> None:
        """Set the colour of an outline."""
        self.actor.GetProperty().SetColor(*rgb(colour))

    def drape(self, points: Array, normals: Array, dress: Array) -> None:
        held = self.data.GetPoints()
        held.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
        held.Modified()
        if not self._outlined:
            attributes = self.data.GetPointData()
            attributes.SetNormals(numpy_to_vtk(np.ascontiguousarray(normals), deep=True))
            shares = np.clip(dress[:, :4] * 255.0, 0, 255).astype(np.uint8)
            attributes.SetScalars(numpy_to_vtk(np.ascontiguousarray(shares), deep=True))
            pattern = np.where(
                dress[:, 6] > 0.5, DOTTED, np.where(dress[:, 5] > 0.5, HATCHED, PLAIN)
            )
            places = np.stack([self._surface.along / RING, pattern], axis=1)
            attributes.SetTCoords(numpy_to_vtk(places, deep=True))
        self.data.Modified()


def _patterns() -> vtkTexture:
    """Four rows of texels around the hand: plain, hatched, dotted, plain."""
    texels = np.full((4, 16, 4), 255, np.uint8)
    texels[1, :5, :3] = round(255 * (1 - HATCH_DARKNESS))
    texels[2, ::2, 3] = round(255 * BETWEEN_DOTS)
    image = vtkImageData()
    image.SetDimensions(16, 4, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(texels.reshape(-1, 4), deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.RepeatOn()
    return texture


class VtkBody:
    """A mesh drawn by VTK."""

    def __init__(self, mesh: BodyMesh) -> None:
        self._data, mapper = polydata(mesh), vtkPolyDataMapper()
        mapper.SetInputData(self._data)
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self._pose = vtkMatrix4x4()
        self.actor.SetUserMatrix(self._pose)
        self._look: BodyLook | None = None

    @property
    def shown(self) -> bool:
        return bool(self.actor.GetVisibility())

    def show(self, on: bool) -> None:
        self.actor.SetVisibility(on)

    def wear(self, look: BodyLook) -> None:
        if look is self._look:
            return
        self._look, drawn = look, self.actor.GetProperty()
        drawn.SetColor(*rgb(look.colour))
        drawn.SetOpacity(look.opacity)
        drawn.SetAmbient(look.ambient)
        drawn.SetSpecular(look.specular)
        drawn.SetLineWidth(look.line_width)
        drawn.SetEdgeVisibility(look.grid == Grid.OVER)
        if look.grid == Grid.ALONE:
            drawn.SetRepresentationToWireframe()
        else:
            drawn.SetRepresentationToSurface()

    def reshape(self, points: Array) -> None:
        data = self._data.GetPoints()
        data.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
        data.Modified()

    def move(self, R: Array, p: Array) -> None:
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = R, p
        self._pose.DeepCopy(T.ravel().tolist())


class VtkGroup:
    """Meshes drawn by VTK that are moved together."""

    def __init__(self, bodies: Sequence[VtkBody]) -> None:
        self._bodies = bodies
        self.hide()

    def place(self, shown: BoolVector, R: Array, p: Array) -> None:
        for k, body in enumerate(self._bodies):
            body.show(bool(shown[k]))
            if shown[k]:
                body.move(R[k], p[k])

    def hide(self) -> None:
        for body in self._bodies:
            body.show(False)


class VtkScene:
    """The contents of a VTK renderer."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        vtkLightKit().AddLightsToRenderer(renderer)
        self._ink = "#FFFFFF"
        self._outlines: list[VtkSurface] = []
        self._ground: VtkBody | None = None
        self._labels: list[vtkBillboardTextActor3D] = []

    def add(self, shape: Shape, look: BodyLook) -> VtkBody:
        mesh = mesh_of(shape)
        body = VtkBody(mesh)
        body.wear(look)
        drawn = body.actor.GetProperty()
        drawn.SetEdgeColor(0.0, 0.0, 0.0)
        drawn.SetInterpolationToPhong()
        drawn.SetLighting(len(mesh.normals) > 0)  # lines are not lit
        self._renderer.AddActor(body.actor)
        return body

    def add_group(self, shapes: Sequence[Shape], looks: Sequence[BodyLook]) -> VtkGroup:
        return VtkGroup([self.add(*each) for each in zip(shapes, looks, strict=True)])

    def add_surface(self, surface: Surface) -> VtkSurface:
        body = VtkSurface(surface, self._renderer, outlined=False)
        self._renderer.AddActor(body.actor)
        return body

    def add_outline(self, surface: Surface) -> VtkSurface:
        body = VtkSurface(surface, self._renderer, outlined=True)
        body.colour(self._ink)
        self._outlines.append(body)
        self._renderer.AddActor(body.actor)
        return body

    def set_ink(self, colour: str) -> None:
        self._ink = colour
        for body in self._outlines:
            body.colour(colour)
        if self._ground is not None:
            self._ground.wear(self._ground_look())

    def _ground_look(self) -> BodyLook:
        return BodyLook(self._ink, opacity=GROUND_OPACITY)

    def set_ground(self, ground: GroundLines) -> None:
        if self._ground is not None:
            self._renderer.RemoveActor(self._ground.actor)
        pairs = np.arange(2 * len(ground.ends)).reshape(-1, 2)
        self._ground = self.add(Lines(ground.ends.reshape(-1, 3), pairs), self._ground_look())

    def set_labels(self, labels: tuple[Label, ...]) -> None:
        while len(self._labels) < len(labels):
            self._labels.append(vtkBillboardTextActor3D())
            self._renderer.AddActor(self._labels[-1])
        for k, actor in enumerate(self._labels):
            actor.SetVisibility(k < len(labels))
            if k < len(labels):
                actor.SetInput(labels[k].text)
                actor.SetPosition(*labels[k].p_G)
                actor.GetTextProperty().SetColor(*rgb(labels[k].colour))

    def clear(self) -> None:
        self._renderer.RemoveAllViewProps()
        self._outlines, self._ground, self._labels = [], None, []

    def set_background(self, colour: str) -> None:
        self._renderer.SetBackground(*rgb(colour))

    def look_from(self, orbit: Orbit) -> None:
        """Set the VTK camera from the orbit."""
        camera = self._renderer.GetActiveCamera()
        camera.SetPosition(*orbit.eye)
        camera.SetFocalPoint(*orbit.target)
        camera.SetViewUp(*orbit.up)
        camera.SetViewAngle(VIEW_ANGLE_DEG)
        self._renderer.ResetCameraClippingRange()


def polydata(mesh: BodyMesh) -> vtkPolyData:
    """A mesh as vtkPolyData; the arrays are copied."""
    data, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(mesh.points), deep=True))
    data.SetPoints(points)
    if mesh.cells.shape[1] == 2:
        data.SetLines(cells_of(mesh.cells))
        return data
    data.SetPolys(cells_of(mesh.cells))
    data.GetPointData().SetNormals(numpy_to_vtk(np.ascontiguousarray(mesh.normals), deep=True))
    return data


def cells_of(cells: npt.NDArray[np.intp]) -> vtkCellArray:
    """(M, K) corners as VTK offsets and connectivity."""
    many, corners = cells.shape
    offsets = np.arange(0, many * corners + 1, corners)
    array = vtkCellArray()
    array.SetData(
        numpy_to_vtk(offsets, deep=True, array_type=VTK_ID_TYPE),
        numpy_to_vtk(cells.ravel(), deep=True, array_type=VTK_ID_TYPE),
    )
    return array


# ---- meshes of the 3D view's shapes, for a graphics card; uses only NumPy


@dataclass(frozen=True)
class BodyMesh:
    """A surface of quads, or lines, in the body's own frame, m."""

    points: Array  # (N, 3)
    normals: Array  # (N, 3) outward unit normals; (0, 3) for lines
    cells: npt.NDArray[
        np.intp
    ]  # (M, 4) corners of each face, or (M, 2) ends of each line; indices of points

    @property
    def bounds(self) -> tuple[float, ...]:
        """(x0, x1, y0, y1, z0, z1)."""
        ends = np.stack([self.points.min(axis=0), self.points.max(axis=0)], axis=1)
        return tuple(ends.ravel().tolist())


def mesh_of(shape: Shape) -> BodyMesh:
    """The mesh of a shape in its own frame."""
    if isinstance(shape, CapsuleShape):
        return capsule(shape)
    if isinstance(shape, Disc):
        return disc(shape)
    if isinstance(shape, Block):
        return block(shape)
    return lines(shape)


def capsule(shape: CapsuleShape, sides: int = 24) -> BodyMesh:
    arc = np.linspace(0.0, np.pi / 2, sides // 4 + 2)
    half = np.stack([np.cos(arc), np.sin(arc)], axis=1)  # from the pole to the equator
    normals = np.vstack([half * [-1, 1], half[::-1]])
    profile = shape.radius * normals
    profile[len(arc) :, 0] += shape.length
    return _revolved(profile, normals, sides)


def disc(shape: Disc, sides: int = 16) -> BodyMesh:
    h, radius = shape.height / 2, shape.radius
    profile = np.array([[-h, 0], [-h, radius], [-h, radius], [h, radius], [h, radius], [h, 0]])
    normals = np.array([[-1, 0], [-1, 0], [0, 1], [0, 1], [1, 0], [1, 0]], float)
    mesh = _revolved(profile, normals, sides)
    R = turn_x_to(shape.normal)
    return BodyMesh(mesh.points @ R.T + shape.centre, mesh.normals @ R.T, mesh.cells)


def block(shape: Block, sides: int = 6) -> BodyMesh:
    """The outline follows the edges with ``sides`` steps per corner, from the centre of one flat
    side to that of the other."""
    quarter = np.linspace(0.0, np.pi / 2, sides + 1)
    angle = (quarter + np.pi / 2 * np.arange(4)[:, None]).ravel()
    out = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)  # (A, 3) of the outline
    corners = np.array([[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0]])
    outline = np.repeat(corners, sides + 1, axis=0) * (shape.half - shape.corner)
    outline = outline + out * (shape.corner - shape.edge)
    up = np.array([0.0, 0.0, 1.0])
    rise = np.concatenate([-quarter[::-1], quarter])[:, None, None]
    normals = np.cos(rise) * out + np.sin(rise) * up
    level = np.sign(rise) * (shape.half[2] - shape.edge) * up
    level[sides] = -level[-1]  # at zero height the lower edge ends and the upper one begins
    level[sides + 1] = level[-1]
    points = outline + level + shape.edge * normals
    flat = np.broadcast_to(up, (1, *outline.shape))
    points = np.concatenate([-shape.half[2] * flat, points, shape.half[2] * flat])
    normals = np.concatenate([-flat, normals, flat])
    return BodyMesh(
        points.reshape(-1, 3) + shape.centre,
        normals.reshape(-1, 3),
        _grid(len(points), len(angle)),
    )


def lines(shape: Lines) -> BodyMesh:
    return BodyMesh(np.asarray(shape.points, float), np.empty((0, 3)), shape.pairs)


def _revolved(profile: Array, normals: Array, sides: int) -> BodyMesh:
    """A surface of revolution: a profile (K, 2) of (along x, distance from x) with its normals."""
    angle = np.linspace(0.0, 2 * np.pi, sides + 1)[:-1]
    spokes = np.stack([np.zeros(sides), np.cos(angle), np.sin(angle)], axis=1)  # (S, 3)

    def turned(rows: Array) -> Array:
        along = rows[:, :1, None] * np.array([1.0, 0.0, 0.0])
        return (along + rows[:, 1:, None] * spokes).reshape(-1, 3)

    return BodyMesh(turned(profile), turned(normals), _grid(len(profile), sides))


def _grid(rows: int, columns: int) -> npt.NDArray[np.intp]:
    """(M, 4) quads of a grid whose columns form a closed ring."""
    at = np.arange(rows * columns).reshape(rows, columns)
    right = np.roll(at, -1, axis=1)
    quads = np.stack([at[:-1], right[:-1], right[1:], at[1:]], axis=-1)
    return quads.reshape(-1, 4)
