"""Bodies drawn by VTK, off-screen or in a renderer of someone else.

VTK's own modules are used: pyvista takes 1.5 s longer to import and four times the libraries.
"""

from __future__ import annotations

import os
import sys

import numpy as np
import numpy.typing as npt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  gives the classes below their OpenGL
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkProperty,
    vtkRenderer,
    vtkRenderWindow,
)

from app.widgets.meshes import Mesh
from app.widgets.orbit import Orbit
from tracker.messages import Array

VIEW_ANGLE_DEG = 32.0
CHANNELS = 3


class Body:
    """A mesh in the scene: moved, coloured, shown or hidden."""

    def __init__(self, mesh: Mesh) -> None:
        self._data, mapper = _polydata(mesh), vtkPolyDataMapper()
        mapper.SetInputData(self._data)
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self._pose = vtkMatrix4x4()
        self.actor.SetUserMatrix(self._pose)

    @property
    def look(self) -> vtkProperty:
        return self.actor.GetProperty()

    def paint(self, colour: str) -> None:
        self.look.SetColor(*rgb(colour))

    def show(self, on: bool) -> None:
        self.actor.SetVisibility(on)

    def reshape(self, points: Array) -> None:
        """Other points (N, 3) for the same lines or faces."""
        data = self._data.GetPoints()
        data.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
        data.Modified()

    def move(self, R: Array, p: Array) -> None:
        """To a rotation (3, 3), times a size, and a position (3,), both in G."""
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = R, p
        self._pose.DeepCopy(T.ravel().tolist())


class Bodies:
    """What a renderer draws, wherever that renderer draws to."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        vtkLightKit().AddLightsToRenderer(renderer)

    def add(
        self,
        mesh: Mesh,
        colour: str,
        *,
        opacity: float = 1.0,
        ambient: float = 0.0,
        specular: float = 0.0,
        line_width: float = 1.0,
    ) -> Body:
        """A body at the origin; ``line_width`` in pixels."""
        body = Body(mesh)
        body.paint(colour)
        look = body.look
        look.SetOpacity(opacity)
        look.SetAmbient(ambient)
        look.SetSpecular(specular)
        look.SetLineWidth(line_width)
        look.SetEdgeColor(0.0, 0.0, 0.0)
        look.SetInterpolationToPhong()
        look.SetLighting(len(mesh.normals) > 0)  # lines have a colour and no sides
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


class VtkScene(Bodies):
    """A window that is never seen, and what is in it. RuntimeError where there is no OpenGL."""

    def __init__(self) -> None:
        self._window = vtkRenderWindow()
        self._window.SetOffScreenRendering(True)
        self._window.SetMultiSamples(0)
        super().__init__(vtkRenderer())
        self._window.AddRenderer(self._renderer)
        if not self._window.SupportsOpenGL():
            raise RuntimeError(self._window.GetOpenGLSupportMessage())
        self._shot = vtkUnsignedCharArray()

    def render(self, orbit: Orbit, width: int, height: int) -> Array:
        """(height, width, 3) uint8, the scene from the orbit's eye."""
        self._window.SetSize(width, height)
        self.look_from(orbit)
        self._window.Render()
        self._window.GetPixelData(0, 0, width - 1, height - 1, False, self._shot, 0)
        rows = vtk_to_numpy(self._shot).reshape(height, width, CHANNELS)
        return np.ascontiguousarray(rows[::-1])  # VTK begins at the bottom

    def close(self) -> None:
        """Free the GL context while it can still be made current."""
        self.clear()
        self._window.Finalize()


def rgb(colour: str) -> tuple[float, float, float]:
    """``#rrggbb`` as three shares of one."""
    red, green, blue = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    return red, green, blue


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
