"""The scene of the software renderer: bodies as rows of arrays, and the rendered image."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from app.widgets.view3d.orbit import VIEW_ANGLE_DEG, Orbit
from app.widgets.view3d.raster.ground import Ground
from app.widgets.view3d.raster.image import Canvas, draw
from app.widgets.view3d.raster.outline import draw_outline
from app.widgets.view3d.raster.placing import Bodies, Pinhole, Strokes
from app.widgets.view3d.raster.solids import BLOCK, CAPSULE, DISC, LINES
from app.widgets.view3d.raster.surfaces import NOTHING, RaySamples, Surfaces
from app.widgets.view3d.scene import BodyLook, GroundLines, rgb
from app.widgets.view3d.shapes import (
    DRESS,
    Block,
    CapsuleShape,
    Disc,
    Lines,
    Shape,
    Surface,
    turn_x_to,
)
from tracker.kernels.arrays import BoolVector, UInt32Matrix
from tracker.messages import Array, IntArray


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


class RasterBody:
    """A row of the scene's arrays."""

    def __init__(self, scene: RasterScene, row: int, points: slice) -> None:
        self._scene, self._row, self._points = scene, row, points
        self._look: BodyLook | None = None

    @property
    def shown(self) -> bool:
        return bool(self._scene.shown[self._row])

    def show(self, on: bool) -> None:
        self._scene.shown[self._row] = on

    def wear(self, look: BodyLook) -> None:
        if look is not self._look:
            self._look = look
            self._scene.looks[self._row] = _look_row(look)

    def reshape(self, points: Array) -> None:
        self._scene.points[self._points] = points

    def move(self, R: Array, p: Array) -> None:
        self._scene.R_GB[self._row] = R
        self._scene.p_GB[self._row] = p


class RasterGroup:
    """Consecutive rows of the scene's arrays."""

    def __init__(self, scene: RasterScene, rows: slice) -> None:
        self._scene, self._rows = scene, rows

    def place(self, shown: BoolVector, R: Array, p: Array) -> None:
        scene, rows = self._scene, self._rows
        scene.shown[rows], scene.R_GB[rows], scene.p_GB[rows] = shown, R, p

    def hide(self) -> None:
        self._scene.shown[self._rows] = False


class RasterScene:
    """Its arrays are the arguments of `image.draw`."""

    def __init__(self) -> None:
        self._background = np.zeros(3)
        self._ink = np.ones(3)
        self._image: UInt32Matrix = np.empty((0, 0), np.uint32)
        self._backdrop: UInt32Matrix = np.empty((0, 0), np.uint32)
        self._numbers = np.empty((0, 0), np.int32)
        self.camera: tuple[Array, Array] | None = None  # pose of the last image, `camera_pose`
        self.clear()

    def clear(self) -> None:
        """Remove all bodies, which must not be used any more."""
        self.kinds: IntArray = np.empty(0, np.int64)
        self.shown: npt.NDArray[np.bool_] = np.empty(0, np.bool_)
        self.R_GB: Array = np.empty((0, 3, 3))
        self.p_GB: Array = np.empty((0, 3))
        self.R_BS: Array = np.empty((0, 3, 3))
        self.p_BS: Array = np.empty((0, 3))
        self.forms: Array = np.empty((0, 5))
        self.looks: Array = np.empty((0, 9))
        self.points: Array = np.empty((0, 3))
        self.ends = np.empty((0, 2), np.int64)
        self.owner = np.empty(0, np.int64)
        self.surfaces, self.outlined = SurfaceRows(), SurfaceRows()
        self.set_ground(GroundLines(np.empty((0, 6)), np.empty(0)))

    def set_ground(self, ground: GroundLines) -> None:
        self._ends = np.ascontiguousarray(ground.ends, float)
        self._strength = np.ascontiguousarray(ground.strength, float)

    def set_ink(self, colour: str) -> None:
        self._ink = np.array(rgb(colour))

    def add_surface(self, surface: Surface) -> RasterSurface:
        return self.surfaces.add(surface)

    def add_outline(self, surface: Surface) -> RasterSurface:
        return self.outlined.add(surface)

    def set_background(self, colour: str) -> None:
        self._background = np.array(rgb(colour))

    def add(self, shape: Shape, look: BodyLook) -> RasterBody:
        row, first = len(self.kinds), len(self.points)
        kind, form, R_BS, p_BS = _form_of(shape)
        self.kinds = _with(self.kinds, kind)
        self.shown = _with(self.shown, True)
        self.R_GB, self.p_GB = _with(self.R_GB, np.eye(3)), _with(self.p_GB, np.zeros(3))
        self.R_BS, self.p_BS = _with(self.R_BS, R_BS), _with(self.p_BS, p_BS)
        self.forms, self.looks = _with(self.forms, form), _with(self.looks, _look_row(look))
        if isinstance(shape, Lines):
            self.points = np.concatenate([self.points, shape.points])
            self.ends = np.concatenate([self.ends, shape.pairs + first])
            self.owner = np.concatenate([self.owner, np.full(len(shape.pairs), row)])
        return RasterBody(self, row, slice(first, len(self.points)))

    def add_group(self, shapes: Sequence[Shape], looks: Sequence[BodyLook]) -> RasterGroup:
        first = len(self.kinds)
        for shape, look in zip(shapes, looks, strict=True):
            self.add(shape, look).show(False)
        return RasterGroup(self, slice(first, len(self.kinds)))

    def render(self, orbit: Orbit, width: int, height: int) -> UInt32Matrix:
        """Render the scene: (height, width) of 0xFFRRGGBB, valid until the next call."""
        self.camera = camera_pose(orbit)
        if self._image.shape != (height, width):
            self._image = np.empty((height, width), np.uint32)
            self._backdrop = np.empty((height, width), np.uint32)
            self._numbers = np.empty((height, width), np.int32)
        if not self._any_shown():  # the kernels are not needed before there is a hand
            red, green, blue = np.rint(255 * self._background).astype(np.uint32)
            self._image.fill(0xFF000000 | red << 16 | green << 8 | blue)
            return self._image
        self._draw(Pinhole(*self.camera, focal_px(height), 0.5 * width, 0.5 * height))
        return self._image

    def _any_shown(self) -> bool:
        return bool(self.shown.any()) or self.surfaces.any_shown or self.outlined.any_shown

    def _draw(self, camera: Pinhole) -> None:
        """Fill the image."""
        bodies = Bodies(
            self.kinds, self.shown, self.R_GB, self.p_GB, self.R_BS, self.p_BS, self.forms,
            self.looks,
        )  # fmt: skip
        strokes = Strokes(self.points, self.ends, self.owner)
        ground = Ground(self._ends, self._strength, self._background, self._ink)
        size = self._image.shape
        canvas = Canvas(self._image, self._backdrop, self._numbers, self.surfaces.samples(*size))
        draw(bodies, strokes, self.surfaces.rows, ground, camera, canvas)
        if self.outlined.any_shown:
            samples = self.outlined.samples(*size)
            draw_outline(self.outlined.rows, camera, samples, self._ink, self._image)


def camera_pose(orbit: Orbit) -> tuple[Array, Array]:
    """R_GC (3, 3), whose columns are the image's right, its down, and forward; p_GC (3,) m."""
    R_GC = orbit.axes
    R_GC[:, 1:] *= -1.0
    return R_GC, np.ascontiguousarray(orbit.eye, float)


def focal_px(height: int) -> float:
    """Focal length of an image of this height, px."""
    return float(0.5 * height / np.tan(np.deg2rad(VIEW_ANGLE_DEG / 2)))


def _form_of(shape: Shape) -> tuple[int, Array, Array, Array]:
    """Kind, form (5,) m, and pose R_BS (3, 3), p_BS (3,) of a shape in its body."""
    form, R, p = np.zeros(5), np.eye(3), np.zeros(3)
    if isinstance(shape, CapsuleShape):
        form[:2] = shape.length, shape.radius
        return CAPSULE, form, R, p
    if isinstance(shape, Disc):
        form[:2] = shape.height / 2, shape.radius
        return DISC, form, turn_x_to(shape.normal), shape.centre
    if isinstance(shape, Block):
        form[:] = *shape.half, shape.corner, shape.edge
        return BLOCK, form, R, shape.centre
    return LINES, form, R, p


def _look_row(look: BodyLook) -> list[float]:
    """A row of looks, see `view`."""
    strength = (look.opacity, look.ambient, look.specular, look.line_width)
    return [*rgb(look.colour), *strength, float(look.grid), float(look.group)]


def _with(rows: npt.NDArray[Any], row: object) -> npt.NDArray[Any]:
    """Append a row."""
    return np.concatenate([rows, np.asarray([row], rows.dtype)])
