"""Conversion of meshes to VTK; the arrays are copied."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from app.widgets.view3d.meshes import BodyMesh


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
