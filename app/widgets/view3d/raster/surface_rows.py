"""Surfaces as rows of a few contiguous arrays, as the kernels need them."""

from __future__ import annotations

import numpy as np

from app.widgets.view3d.raster.surfaces import NOTHING, RaySamples, Surfaces
from app.widgets.view3d.shapes import DRESS, Surface
from tracker.kernels.arrays import BoolVector
from tracker.messages import Array


class SurfaceRows:
    """All surfaces of one kind in a scene."""

    def __init__(self) -> None:
        self.rows = Surfaces(
            np.empty((0, 3)),
            np.empty((0, 3)),
            np.empty((0, DRESS)),
            np.empty(0),
            np.empty((0, 3), np.int64),
            np.empty(0, np.int64),
        )
        self._surfaces: list[RasterSurface] = []
        self._samples = RaySamples(np.empty((4, 0, 0), np.float32), np.empty((4, 0, 0), np.int32))

    def add(self, surface: Surface) -> RasterSurface:
        """Append a surface; it is hidden until it is draped."""
        rows, first, faces = self.rows, len(self.rows.points), len(self.rows.faces)
        many = len(surface.along)
        nowhere = np.zeros((many, 3))
        self.rows = Surfaces(
            np.concatenate([rows.points, nowhere]),
            np.concatenate([rows.normals, nowhere]),
            np.concatenate([rows.dress, np.zeros((many, DRESS))]),
            np.concatenate([rows.along, surface.along]),
            np.concatenate([rows.faces, surface.faces + first]),
            np.concatenate([rows.part, np.full(len(surface.faces), NOTHING)]),
        )
        stop = faces + len(surface.faces)
        made = RasterSurface(self, surface, slice(first, first + many), slice(faces, stop))
        self._surfaces.append(made)
        return made

    @property
    def any_shown(self) -> bool:
        return any(surface.shown for surface in self._surfaces)

    def samples(self, height: int, width: int) -> RaySamples:
        """Buffers for an image of this size; empty without surfaces."""
        if not len(self.rows.faces):
            height = width = 0
        shape = (4, height, width)
        if self._samples.face.shape != shape:
            self._samples = RaySamples(np.empty(shape, np.float32), np.empty(shape, np.int32))
        return self._samples


class RasterSurface:
    """The rows of one surface."""

    def __init__(self, owner: SurfaceRows, surface: Surface, points: slice, faces: slice) -> None:
        self._owner, self._surface, self._points, self._faces = owner, surface, points, faces
        self._chosen: BoolVector | None = None
        self._shown = False
        self._dress: Array | None = None

    @property
    def shown(self) -> bool:
        return self._shown

    def show(self, on: bool) -> None:
        if on != self._shown:
            self._shown = on
            self._write_parts()

    def choose(self, faces: BoolVector) -> None:
        """Draw only these faces (F,)."""
        if self._chosen is None or not np.array_equal(faces, self._chosen):
            self._chosen = np.array(faces)
            self._write_parts()

    def _write_parts(self) -> None:
        part = self._surface.part if self._shown else np.full(len(self._surface.part), NOTHING)
        if self._chosen is not None:
            part = np.where(self._chosen, part, NOTHING)
        self._owner.rows.part[self._faces] = part

    def drape(self, points: Array, normals: Array, dress: Array) -> None:
        rows = self._owner.rows
        rows.points[self._points] = points
        rows.normals[self._points] = normals
        if dress is not self._dress:  # it changes less often than the points
            rows.dress[self._points], self._dress = dress, dress
