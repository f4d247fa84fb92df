"""Images of a scene: shaded glove, curved patches, motion blur and sensor noise."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracker.base.clock import nanoseconds
from tracker.messages import Array, IntArray, StereoFrame
from tracker.simulation.backgrounds import BackgroundParams, fabric_bgr, make_background
from tracker.simulation.camera_view import pitch_of, pixels_of, ray_map, within_rows
from tracker.simulation.exposure import (
    JITTER_PX,
    EyeView,
    Scene,
    moments_of,
    motion_at,
    patches_of_all,
    seen_patches,
)
from tracker.simulation.flicker import Exposure, FlickerParams, Lamps
from tracker.simulation.raster import Buffer, PixelRays, bounds, draw
from tracker.simulation.row_sampling import RowBand, band_px, bands_of
from tracker.simulation.sewn import SeenPatches
from tracker.simulation.shading import Light, SolidColours, develop, shade
from tracker.simulation.smooth import rng_for
from tracker.simulation.solids import SceneInstant, Solids

Image = NDArray[np.uint8]


@dataclass(frozen=True)
class RenderParams:
    """Camera and light."""

    background: BackgroundParams = field(default_factory=BackgroundParams)
    shutter: float = 0.008  # s
    exposures: int = 3  # averaged over the shutter, at most 4
    noise: float = 2.5  # standard deviation of a pixel, 0..255
    ambient: float = 0.45
    light_x: float = -0.35  # direction towards the light in C
    light_y: float = -0.6
    light_z: float = -0.75
    gain: float = 1.0  # exposure


class _Memory:
    """Reused between images: the system clears newly allocated memory page by page, which takes
    longer than writing to it."""

    def __init__(self) -> None:
        self._total, self._depth = np.empty(0, np.float32), np.empty(0, np.float32)
        self._solid = np.empty(0, np.int16)

    def of(self, rows: int, columns: int) -> tuple[NDArray[np.float32], Buffer]:
        """Light (rows, columns, 3), all zero, and a depth buffer; valid until the next call."""
        n = rows * columns
        if n > len(self._solid):
            self._total, self._depth = np.empty(3 * n, np.float32), np.empty(n, np.float32)
            self._solid = np.empty(n, np.int16)
        total = self._total[: 3 * n].reshape(rows, columns, 3)
        total.fill(0.0)
        depth, solid = self._depth[:n], self._solid[:n]
        return total, Buffer(depth.reshape(rows, columns), solid.reshape(rows, columns))


class Renderer:
    """Draws a scene. A renderer caches the rig's ray maps and backgrounds."""

    def __init__(
        self, scene: Scene, params: RenderParams | None = None, lamps: FlickerParams | None = None
    ) -> None:
        self.scene, self.params = scene, params or RenderParams()
        rig, p = scene.rig, self.params
        self._lamps = Lamps(Exposure(p.shutter, rig.readout), lamps)
        self._rays = (ray_map(rig.left), ray_map(rig.right))
        self._pitch = tuple(pitch_of(rays) for rays in self._rays)
        self._K = np.array([rig.fx, rig.fy, rig.cx, rig.cy])
        seed = scene.seed
        disparity = round(rig.fx * rig.baseline / p.background.distance)
        sizes = [(camera.width, camera.height) for camera in (rig.left, rig.right)]
        made = {s: make_background(p.background, *s, disparity, seed) for s in sizes}
        self._ground = made[sizes[0]][0], made[sizes[1]][1]
        rng = rng_for(seed, "grain")
        self._grain = (p.noise * rng.standard_normal((509, 521, 3))).astype(np.float32)
        self._noisy = tuple(self._with_grain(g, rng) for g in self._ground)
        light = np.array([p.light_x, p.light_y, p.light_z])
        self._light = Light(light / np.linalg.norm(light), p.ambient)
        self._order, self._patches = patches_of_all(scene.wearers, self._fabric)
        self._memory = _Memory()

    def _with_grain(self, ground: Image, rng: np.random.Generator) -> list[Image]:
        """Four noisy copies of a background, one of which each frame uses: new noise is too
        slow."""
        prints, even = [], np.ones(len(ground), np.float32)
        for _ in range(4):
            out = np.empty_like(ground)
            shift, corner = rng.integers(0, 500, 2), np.zeros(2, np.int64)
            develop(ground.astype(np.float32), 1, even, self._grain, shift, corner, out)
            prints.append(out)
        return prints

    def _fabric(self, hue: str) -> Array:
        return np.array(fabric_bgr(hue)) * self.params.gain

    def frame(self, t: float, t_arrival: float | None = None, index: int = -1) -> StereoFrame:
        """The images of the exposure with midpoint t (s), and the camera's reported pose."""
        left, *right = self.images(t)
        arrival = t if t_arrival is None else t_arrival
        pose = self.scene.reported_pose(t)
        return StereoFrame(t, arrival, left, right[0] if right else None, pose, index)

    def pair(self, t: float) -> tuple[Image, Image]:
        """The left and the right image (h, w, 3) uint8 BGR, of two cameras."""
        left, right = self.images(t)
        return left, right

    def images(self, t: float, into: Sequence[Image] | None = None) -> tuple[Image, ...]:
        """The image of each camera, (h, w, 3) uint8 BGR, the left one first; drawn ``into`` the
        given arrays, if any."""
        exposures = self._exposures(t)
        ns = nanoseconds(t)
        rng = rng_for(self.scene.seed, "image", ns % 2**32, ns // 2**32)
        sides = [int(side == "right") for side in self.scene.rig.sides]
        out = tuple(into or (np.empty_like(self._ground[side]) for side in sides))
        for image, side in zip(out, sides, strict=True):
            gains = self._lamps.gains(len(image), t)
            self._lamps.light(self._noisy[side][int(rng.integers(4))], gains, image)
            for moments, band in exposures:
                self._draw(image, moments, side, rng, band, gains)
        return out

    def _exposures(self, t: float) -> list[tuple[list[SceneInstant], RowBand | None]]:
        """Instants of the shutter, and of a rolling one the rows that are exposed then."""
        p, rig = self.params, self.scene.rig
        how = p.shutter, min(p.exposures, len(JITTER_PX))
        if rig.line_time == 0.0:
            return [(moments_of(self.scene, t, *how), None)]
        speed, rows = motion_at(self.scene, t)
        bands = bands_of(rig, rig.left, speed, rows, band_px(p.exposures))
        return [(moments_of(self.scene, t + band.delay, *how), band) for band in bands]

    def _eye_view(self, side: int) -> EyeView:
        """The left (0) or the right camera (1)."""
        rig = self.scene.rig
        camera = rig.right if side else rig.left
        return EyeView(np.array([rig.baseline * side, 0.0, 0.0]), self._K, camera)

    def _draw(
        self,
        out: Image,
        moments: list[SceneInstant],
        side: int,
        rng: np.random.Generator,
        band: RowBand | None,
        gains: NDArray[np.float32],
    ) -> None:
        """Draws the view of the left (0) or the right camera (1) into ``out`` (h, w, 3), or into a
        band of its rows; each row has the light ``gains`` (h,)."""
        view = self._eye_view(side)
        eye, camera = view.eye, view.camera
        boxes = [pixels_of(bounds(m.solids, eye, self._K), camera) for m in moments]
        if band is not None:
            boxes = [within_rows(box, band.first, band.end) for box in boxes]
        all_boxes = np.concatenate(boxes)
        some = all_boxes[all_boxes[:, 0] < all_boxes[:, 2]]
        if len(some) == 0:
            return
        u0, v0 = some[:, :2].min(axis=0)
        u1, v1 = some[:, 2:].max(axis=0)
        total, buffer = self._memory.of(v1 - v0, u1 - u0)
        ground = np.ascontiguousarray(self._ground[side][v0:v1, u0:u1])
        corner = np.array([v0, u0], np.int64)
        for k, (moment, pixels) in enumerate(zip(moments, boxes, strict=True)):
            jitter = JITTER_PX[k] / self._K[:2]
            rays = PixelRays(self._rays[side], self._pitch[side], jitter, eye, corner)
            sewn = self._patches._replace(position=moment.markers[self._order])
            patches = seen_patches(sewn, moment, view)
            self._expose(moment.solids, rays, pixels, patches, ground, (total, buffer))
        develop(total, len(moments), gains, self._grain, rng.integers(0, 500, 2), corner, out)

    def _expose(
        self,
        solids: Solids,
        rays: PixelRays,
        pixels: IntArray,
        patches: SeenPatches,
        ground: Image,
        into: tuple[NDArray[np.float32], Buffer],
    ) -> None:
        total, buffer = into
        draw(rays, pixels, solids, buffer)
        cloth = SolidColours(
            np.concatenate([solids.owner, solids.box_owner]),
            np.concatenate([solids.colour, solids.box_colour]) * self.params.gain,
        )
        shade(rays, buffer, solids, cloth, patches, self._light, ground, total)
