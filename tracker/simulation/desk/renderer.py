"""Images of a gloved hand over a desk: drawn in linear light, with a camera model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.clock import nanoseconds
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array, IntArray, StereoFrame
from tracker.simulation.camera_view import pitch_of, pixels_of, ray_map, within_rows
from tracker.simulation.desk.ground import REFERENCE, Desk, desk_pose
from tracker.simulation.desk.lights import light_of, linear
from tracker.simulation.desk.sensor import develop, leaked, sensor_of, through_jpeg
from tracker.simulation.desk.shading import GRAIN_TEXEL, Knit, RoomLights, Surroundings, shade_knit
from tracker.simulation.desk.shadow import (
    CastShadow,
    GroundLight,
    cast_shadow,
    shaded_ground,
    shadow_corners,
)
from tracker.simulation.desk.textures import felt, knit, wandering
from tracker.simulation.exposure import (
    JITTER_PX,
    moments_of,
    motion_at,
    sewn_patches,
)
from tracker.simulation.flicker import Exposure, FlickerParams, Lamps
from tracker.simulation.raster import Buffer, PixelRays, bounds, draw
from tracker.simulation.row_sampling import band_px, bands_of
from tracker.simulation.scene import SimulatedScene
from tracker.simulation.smooth import rng_for
from tracker.simulation.solids import SceneInstant
from tracker.vision.rig import Camera

Image = NDArray[np.uint8]
MARGIN_PX = 3  # around the hand, for the lens's blur


@dataclass(frozen=True)
class DeskParams:
    """The light in the room by name, and the camera."""

    light: str = "window"
    surface: str = ""  # wood or laminate; random if empty
    shutter: float = 0.008  # s
    exposures: int = 3  # averaged over the shutter, at most 4
    jpeg_quality: int = 87  # of the camera's own compression; 0 for none
    backgrounds: int = 0  # pre-rendered, used in turn; 0: independent noise per image


class _CameraView(NamedTuple):
    """One of the two cameras, its rays and baseline, its images of the desk and their sum, and
    ``light``: the same with the hand while an image is drawn; ``drawn``: images of the desk
    alone."""

    camera: Camera
    eye: Array
    rays: NDArray[np.float32]
    pitch: float
    ground: GroundLight
    whole: NDArray[np.float32]
    light: NDArray[np.float32]
    drawn: list[Image]


class _Box(NamedTuple):
    """Pixels from (u0, v0) up to (u1, v1)."""

    u0: int
    v0: int
    u1: int
    v1: int

    @property
    def pixels(self) -> tuple[slice, slice]:
        return slice(self.v0, self.v1), slice(self.u0, self.u1)

    def around(self, other: _Box) -> _Box:
        """Both, and the area in between; an empty one adds nothing."""
        if other.u0 >= other.u1 or self.u0 >= self.u1:
            return self if other.u0 >= other.u1 else other
        low, high = np.minimum(self[:2], other[:2]), np.maximum(self[2:], other[2:])
        return _Box(int(low[0]), int(low[1]), int(high[0]), int(high[1]))


class _ExposurePart(NamedTuple):
    """Instants of the shutter with the hand's shadow of the lamp and points around it on the desk,
    and the rows that are exposed then: from ``first`` to before ``end``."""

    moments: list[SceneInstant]
    shadow: CastShadow
    corners: Array
    first: int
    end: int


NOWHERE = _Box(0, 0, 0, 0)


class DeskRenderer:
    """Draws a scene over a desk. A renderer caches the static parts.

    Raises ConfigError for an unknown light and for a moving camera.
    """

    def __init__(
        self,
        scene: SimulatedScene,
        params: DeskParams | None = None,
        lamps: FlickerParams | None = None,
    ) -> None:
        self.scene, self.params = scene, params or DeskParams()
        self._lamps = Lamps(Exposure(self.params.shutter, scene.rig.readout), lamps)
        if scene.head.moves:
            raise ConfigError(notice("simulate.desk_camera"))
        self.light = light_of(self.params.light)
        rig, seed = scene.rig, scene.seed
        self._K = np.array([rig.fx, rig.fy, rig.cx, rig.cy])
        rng = rng_for(seed, "cloth")
        self._order, self._patches = sewn_patches(
            scene.wearer, lambda hue: felt(hue) * float(rng.uniform(0.9, 1.05))
        )
        self._grain, self._ragged = knit(rng, texel=GRAIN_TEXEL), wandering(rng)
        self._sensor = sensor_of(self.light, rng_for(seed, "sensor"))
        self._set_up_desk(Desk(self.light, seed, self.params.surface))

    def _set_up_desk(self, desk: Desk) -> None:
        pose = self.scene.rig.pose
        R_GD, p_GD = desk_pose(pose)
        R_DC, p_DC = R_GD.T @ pose.R_GC, R_GD.T @ (pose.p_GC - p_GD)
        self._R_CD, self._p_DC = R_DC.T, p_DC
        light, lamp = self.light, desk.lamp_position
        second = np.array(light.second_position)
        self._lights = RoomLights(
            (lamp - p_DC) @ R_DC,
            desk.power * np.array(light.main),
            float(np.sum((lamp - REFERENCE) ** 2)),
            light.softness,
            (second - p_DC) @ R_DC,
            np.array(light.second),
            float(np.sum((second - REFERENCE) ** 2)),
            np.array(light.sky),
            np.array([0.0, 0.0, 1.0]) @ R_DC,
            light.vignetting,
            light.leak,
        )
        rig = self.scene.rig
        eyes = {"left": (rig.left, 0.0), "right": (rig.right, rig.baseline)}
        self._views = tuple(self._view(desk, *eyes[side]) for side in rig.sides)

    def _view(self, desk: Desk, camera: Camera, shift: float) -> _CameraView:
        rays, eye = ray_map(camera), np.array([shift, 0.0, 0.0])
        seen = desk.seen(rays, self._R_CD.T, self._p_DC + self._R_CD.T @ eye)
        dark = 1.0 / (1.0 + self.light.vignetting * np.sum(rays * rays, axis=2, keepdims=True))
        lamp, rest = (self._through_lens(image * dark) for image in (seen.lamp, seen.rest))
        ground, whole = GroundLight(lamp, rest, seen.depth), lamp + rest
        rng = rng_for(self.scene.seed, "backgrounds")
        drawn = [self._developed(whole, rng) for _ in range(self.params.backgrounds)]
        return _CameraView(camera, eye, rays, pitch_of(rays), ground, whole, whole.copy(), drawn)

    def _through_lens(self, light: Array) -> NDArray[np.float32]:
        blurred = cv2.GaussianBlur(leaked(light, self.light.leak), (0, 0), 1.3 * self.light.blur_px)
        return np.ascontiguousarray(blurred, np.float32)

    # ---- images

    def frame(self, t: float, t_arrival: float | None = None, index: int = -1) -> StereoFrame:
        """The images of the exposure with midpoint t (s)."""
        left, *right = self.images(t)
        arrival = t if t_arrival is None else t_arrival
        return StereoFrame(t, arrival, left, right[0] if right else None, index=index)

    def pair(self, t: float) -> tuple[Image, Image]:
        """The left and the right image (h, w, 3) uint8 BGR, of two cameras."""
        left, right = self.images(t)
        return left, right

    def images(self, t: float, into: Sequence[Image] | None = None) -> tuple[Image, ...]:
        """The image of each camera, (h, w, 3) uint8 BGR, the left one first; drawn ``into`` the
        given arrays, if any."""
        ns, parts = nanoseconds(t), self._parts(t)
        rng = rng_for(self.scene.seed, "image", ns % 2**32, ns // 2**32)
        drawn = tuple(self._image(view, parts, rng) for view in self._views)
        out = tuple(into or (np.empty_like(image) for image in drawn))
        for image, own in zip(out, drawn, strict=True):
            self._lamps.light(own, self._lamps.gains(len(own), t), image)
        return out

    def _parts(self, t: float) -> list[_ExposurePart]:
        """The image with the midpoint t (s): one part, or of a rolling shutter one for each band of
        rows."""
        rig = self.scene.rig
        if rig.line_time == 0.0:
            return [self._part(t, 0, rig.left.height)]
        speed, rows = motion_at(self.scene, t)
        bands = bands_of(rig, rig.left, speed, rows, band_px(self.params.exposures))
        return [self._part(t + band.delay, band.first, band.end) for band in bands]

    def _part(self, t: float, first: int, end: int) -> _ExposurePart:
        p = self.params
        moments = moments_of(self.scene, t, p.shutter, min(p.exposures, len(JITTER_PX)), 1)
        return _ExposurePart(moments, *self._shadow(moments[len(moments) // 2]), first, end)

    def _shadow(self, now: SceneInstant) -> tuple[CastShadow, Array]:
        """The hand's shadow of the lamp, and points around it on the desk."""
        middle = now.p_CB.mean(axis=0)
        towards = self._lights.place - middle
        towards /= np.linalg.norm(towards)
        over = float((middle @ self._R_CD + self._p_DC)[2])
        away = max(over, 0.02) / max(float(towards @ self._lights.up), 0.15)
        cast = cast_shadow(now.solids, middle, self._lights.place, self.light.softness * away)
        return cast, shadow_corners(cast, away)

    def _image(
        self, view: _CameraView, parts: list[_ExposurePart], rng: np.random.Generator
    ) -> Image:
        box = NOWHERE
        for part in parts:
            box = box.around(self._add(view, part))
        if view.drawn:
            out = view.drawn[int(rng.integers(len(view.drawn)))].copy()
            if box != NOWHERE:
                out[box.pixels] = self._developed(view.light[box.pixels], rng)
        else:
            out = self._developed(view.light, rng)
        view.light[box.pixels] = view.whole[box.pixels]
        return out

    def _developed(self, light: NDArray[np.float32], rng: np.random.Generator) -> Image:
        """The camera's output for linear light (h, w, 3)."""
        out = np.empty(light.shape, np.uint8)
        shift = rng.integers(0, 512, 2)
        develop(np.ascontiguousarray(light), self._sensor, shift, out)
        quality = self.params.jpeg_quality
        return through_jpeg(out, quality) if quality else out

    def _add(self, view: _CameraView, part: _ExposurePart) -> _Box:
        """Draws the rows of a part into the view's light; returns the bounds of what changed. The
        lens blurs across the border of two parts, so each is drawn beyond it."""
        first, height = part.first, len(view.light)
        low, high = max(first - MARGIN_PX, 0), min(part.end + MARGIN_PX, height)
        above = view.light[low:first].copy()
        if first > 0:
            both = slice(low, min(first + MARGIN_PX, height))
            view.light[both] = view.whole[both]
        boxes = [
            within_rows(pixels_of(bounds(m.solids, view.eye, self._K), view.camera), low, high)
            for m in part.moments
        ]
        box = self._add_shadow(view, part, (low, high))
        box = box.around(self._add_hand(view, part, boxes, (low, high)))
        view.light[low:first] = above
        return box

    def _add_shadow(self, view: _CameraView, part: _ExposurePart, rows: tuple[int, int]) -> _Box:
        """Draws the hand's shadow on these rows of the desk into the view's light; returns its
        bounds."""
        points = part.corners - view.eye
        points = points[points[:, 2] > 0.05]
        if len(points) == 0:
            return NOWHERE
        uv = points[:, :2] / points[:, 2:] * self._K[:2] + self._K[2:]
        uv = np.clip(uv, -2000, 4000)
        box = np.concatenate([uv.min(axis=0), uv.max(axis=0)])[None]
        ((u0, v0, u1, v1),) = within_rows(pixels_of(box, view.camera), *rows)
        if u0 >= u1 or v0 >= v1:
            return NOWHERE
        corner = np.array([v0, u0], np.int64)
        base = np.empty((v1 - v0, u1 - u0, 3), np.float32)
        rays = PixelRays(view.rays, view.pitch, np.zeros(2), view.eye, corner)
        shaded_ground(rays, view.ground, part.shadow, base)
        view.light[v0:v1, u0:u1] = base
        return _Box(int(u0), int(v0), int(u1), int(v1))

    def _add_hand(
        self,
        view: _CameraView,
        part: _ExposurePart,
        boxes: list[IntArray],
        rows: tuple[int, int],
    ) -> _Box:
        """Draws the hand into the view's light: the mean over the exposures, through the lens;
        returns its bounds."""
        all_boxes = np.concatenate(boxes)
        some = all_boxes[all_boxes[:, 0] < all_boxes[:, 2]]
        if len(some) == 0:
            return NOWHERE
        u0, v0 = np.maximum(some[:, :2].min(axis=0) - MARGIN_PX, 0)
        u1, v1 = some[:, 2:].max(axis=0) + MARGIN_PX
        v0, u1, v1 = max(v0, rows[0]), min(u1, view.light.shape[1]), min(v1, rows[1])
        base = np.ascontiguousarray(view.light[v0:v1, u0:u1])
        around, total = Surroundings(self._lights, part.shadow, base), np.zeros_like(base)
        size = base.shape[:2]
        buffer = Buffer(np.empty(size, np.float32), np.empty(size, np.int16))
        corner = np.array([v0, u0], np.int64)
        for k, (now, pixels) in enumerate(zip(part.moments, boxes, strict=True)):
            rays = PixelRays(view.rays, view.pitch, JITTER_PX[k] / self._K[:2], view.eye, corner)
            draw(rays, pixels, now.solids, buffer)
            patches = self._patches._replace(position=now.markers[self._order])
            shade_knit(rays, buffer, now, self._cloth(now), patches, around, total)
        total *= np.float32(1 / len(part.moments))
        view.light[v0:v1, u0:u1] = cv2.GaussianBlur(total, (0, 0), self.light.blur_px)
        return _Box(int(u0), int(v0), int(u1), int(v1))

    def _cloth(self, now: SceneInstant) -> Knit:
        s = now.solids
        owner = np.concatenate([s.owner, s.box_owner])
        colour = linear(np.concatenate([s.colour, s.box_colour]))
        return Knit(owner, colour, self._grain, self._ragged)
