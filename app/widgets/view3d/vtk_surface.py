"""Surfaces whose points move one by one, for the graphics card."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersHybrid import vtkPolyDataSilhouette
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkTexture

from app.widgets.view3d.meshes import BodyMesh
from app.widgets.view3d.raster.skin import BETWEEN_DOTS, HATCH_DARKNESS, RING
from app.widgets.view3d.scene import rgb
from app.widgets.view3d.shapes import Surface
from app.widgets.view3d.vtk_mesh import cells_of, polydata
from tracker.kernels.arrays import BoolVector
from tracker.messages import Array

PLAIN, HATCHED, DOTTED = 0.125, 0.375, 0.625
"""Where in the texture each pattern is: the middle of its row of four."""


class VtkSurface:
    """A surface with patterns; ``outlined`` draws its outline alone."""

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
        """Of an outline."""
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
