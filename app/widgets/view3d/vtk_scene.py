"""The scene of the graphics card's view: bodies that VTK draws in a renderer of its own.

VTK's own modules are used for it: only the window on the card comes from pyvistaqt.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
)

from app.widgets.view3d.meshes import Mesh, mesh_of
from app.widgets.view3d.orbit import VIEW_ANGLE_DEG, Orbit
from app.widgets.view3d.scene import BodyLook, Grid, rgb
from app.widgets.view3d.shapes import Shape
from tracker.messages import Array


class VtkBody:
    """A mesh that VTK draws."""

    def __init__(self, mesh: Mesh) -> None:
        self._data, mapper = _polydata(mesh), vtkPolyDataMapper()
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


class VtkScene:
    """What a renderer draws, wherever that renderer draws to."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        vtkLightKit().AddLightsToRenderer(renderer)

    def add(self, shape: Shape, look: BodyLook) -> VtkBody:
        mesh = mesh_of(shape)
        body = VtkBody(mesh)
        body.wear(look)
        drawn = body.actor.GetProperty()
        drawn.SetEdgeColor(0.0, 0.0, 0.0)
        drawn.SetInterpolationToPhong()
        drawn.SetLighting(len(mesh.normals) > 0)  # lines have a colour and no sides
        self._renderer.AddActor(body.actor)
        return body

    def clear(self) -> None:
        self._renderer.RemoveAllViewProps()

    def set_background(self, colour: str) -> None:
        self._renderer.SetBackground(*rgb(colour))

    def look_from(self, orbit: Orbit) -> None:
        """Put the camera into the orbit's eye."""
        camera = self._renderer.GetActiveCamera()
        camera.SetPosition(*orbit.eye)
        camera.SetFocalPoint(*orbit.target)
        camera.SetViewUp(*orbit.up)
        camera.SetViewAngle(VIEW_ANGLE_DEG)
        self._renderer.ResetCameraClippingRange()


def _polydata(mesh: Mesh) -> vtkPolyData:
    """VTK's form of a mesh; the arrays are copied."""
    data, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(mesh.points), deep=True))
    data.SetPoints(points)
    if mesh.cells.shape[1] == 2:
        data.SetLines(_cells(mesh.cells))
        return data
    data.SetPolys(_cells(mesh.cells))
    data.GetPointData().SetNormals(numpy_to_vtk(np.ascontiguousarray(mesh.normals), deep=True))
    return data


def _cells(cells: npt.NDArray[np.intp]) -> vtkCellArray:
    """(M, K) corners as VTK's offsets and indices."""
    many, corners = cells.shape
    offsets = np.arange(0, many * corners + 1, corners)
    array = vtkCellArray()
    array.SetData(
        numpy_to_vtk(offsets, deep=True, array_type=VTK_ID_TYPE),
        numpy_to_vtk(cells.ravel(), deep=True, array_type=VTK_ID_TYPE),
    )
    return array
