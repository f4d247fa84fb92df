"""Images of a scene: shaded glove, curved patches, motion blur and sensor noise."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracker.clock import nanoseconds
from tracker.messages import Array, IntArray, StereoFrame
from tracker.simulation.backgrounds import BackgroundParams, fabric_bgr, make_background
from tracker.simulation.patches import SQUARE
from tracker.simulation.raster import Buffer, PixelRays, bounds, draw
from tracker.simulation.scene import SimulatedScene
from tracker.simulation.shading import Cloth, Light, SewnPatches, develop, shade
from tracker.simulation.smooth import rng_for
from tracker.simulation.solids import Instant
from tracker.simulation.wearer import tangents
from tracker.vision.rig import Camera

Image = NDArray[np.uint8]

_JITTER_PX = np.array([[-0.25, 0.15], [0.3, 0.3], [-0.05, -0.35], [0.2, -0.1]])
"""Where in the pixel each exposure looks: smooths edges at no cost."""


@dataclass(frozen=True)
class RenderParams:
    """The camera and the light."""

    background: BackgroundParams = field(default_factory=BackgroundParams)
    shutter: float = 0.008  # s
    exposures: int = 3  # averaged over the shutter, at most 4
    noise: float = 2.5  # standard deviation of a pixel, 0..255
    ambient: float = 0.45
    light_x: float = -0.35  # direction towards the light in C
    light_y: float = -0.6
    light_z: float = -0.75
    gain: float = 1.0  # exposure


_SLOW_PX = 0.5
"""Motion over half the shutter below which two exposures look like three."""


class Renderer:
    """Draws a scene. One renderer holds one rig's ray maps and backgrounds."""

    def __init__(self, scene: SimulatedScene, params: RenderParams | None = None) -> None:
        self.scene, self.params = scene, params or RenderParams()
        rig, p = scene.rig, self.params
        self._rays = (_ray_map(rig.left), _ray_map(rig.right))
        self._K = np.array([rig.fx, rig.fy, rig.cx, rig.cy])
        seed = scene.seed
        disparity = round(rig.fx * rig.baseline / p.background.distance)
        self._ground = make_background(
            p.background, rig.left.width, rig.left.height, disparity, seed
        )
        rng = rng_for(seed, "grain")
        self._grain = (p.noise * rng.standard_normal((509, 521, 3))).astype(np.float32)
        self._noisy = tuple(self._with_grain(g, rng) for g in self._ground)
        light = np.array([p.light_x, p.light_y, p.light_z])
        self._light = Light(light / np.linalg.norm(light), p.ambient)
        self._patches = self._sewn()

    def _with_grain(self, ground: Image, rng: np.random.Generator) -> list[Image]:
        """Four noisy prints of a background; each frame takes one, fresh grain is too slow."""
        prints = []
        for _ in range(4):
            out = np.empty_like(ground)
            shift, corner = rng.integers(0, 500, 2), np.zeros(2, np.int64)
            develop(ground.astype(np.float32), 1, self._grain, shift, corner, out)
            prints.append(out)
        return prints

    def _sewn(self) -> SewnPatches:
        """The wearer's patches; where the markers are is for each instant to say."""
        wearer = self.scene.wearer
        self._order = np.argsort(wearer.marker_segment, kind="stable")
        segment = wearer.marker_segment[self._order]
        markers = [wearer.glove.markers[i] for i in self._order]
        root, normal = wearer.hand.root, wearer.marker_normal[self._order]
        flat = [s == root or abs(m.normal[0]) > 0.5 for s, m in zip(segment, markers, strict=True)]
        fabric = np.array([fabric_bgr(m.hue) for m in markers], float).reshape(-1, 3)
        return SewnPatches(
            np.searchsorted(segment, np.arange(len(wearer.hand.segments) + 1)),
            np.zeros((len(markers), 3)),
            np.concatenate([tangents(normal), normal[:, None]], axis=1),
            wearer.glove.marker_size[self._order],
            np.array([int(m.shape == "square") * SQUARE for m in markers], np.int64),
            np.array(flat, np.int64),
            fabric * self.params.gain,
        )

    def frame(self, t: float, t_arrival: float | None = None, index: int = -1) -> StereoFrame:
        """Both images of the exposure whose middle is t (s), and the camera's reported pose."""
        left, right = self.pair(t)
        arrival = t if t_arrival is None else t_arrival
        return StereoFrame(t, arrival, left, right, self.scene.reported_pose(t), index)

    def pair(self, t: float) -> tuple[Image, Image]:
        """The left and the right image (h, w, 3) uint8 BGR."""
        moments = self._moments(t)
        ns = nanoseconds(t)
        rng = rng_for(self.scene.seed, "image", ns % 2**32, ns // 2**32)
        return self._image(moments, False, rng), self._image(moments, True, rng)

    def _moments(self, t: float) -> list[Instant]:
        """The scene at the middles of equal parts of the shutter; two parts do for a slow hand."""
        n, shutter = max(min(self.params.exposures, len(_JITTER_PX)), 1), self.params.shutter
        if n > 2:
            first, last = (self.scene.instant(t + shutter * s) for s in (-0.25, 0.25))
            path = np.abs(last.p_CB - first.p_CB).max() / max(first.p_CB[0, 2], 0.05)
            if path * self._K[0] < _SLOW_PX:
                return [first, last]
        middle = (np.arange(n) + 0.5) / n - 0.5
        return [self.scene.instant(t + shutter * m) for m in middle]

    def _image(self, moments: list[Instant], right: bool, rng: np.random.Generator) -> Image:
        side = int(right)
        out: Image = self._noisy[side][int(rng.integers(4))].copy()
        eye = np.array([self.scene.rig.baseline * side, 0.0, 0.0])
        camera = self.scene.rig.right if right else self.scene.rig.left
        boxes = [_pixels(bounds(m.solids, eye, self._K), camera) for m in moments]
        all_boxes = np.concatenate(boxes)
        some = all_boxes[all_boxes[:, 0] < all_boxes[:, 2]]
        if len(some) == 0:
            return out
        u0, v0 = some[:, :2].min(axis=0)
        u1, v1 = some[:, 2:].max(axis=0)
        total = np.zeros((v1 - v0, u1 - u0, 3), np.float32)
        ground = np.ascontiguousarray(self._ground[side][v0:v1, u0:u1])
        corner = np.array([v0, u0], np.int64)
        for k, (moment, pixels) in enumerate(zip(moments, boxes, strict=True)):
            rays = PixelRays(self._rays[side], _JITTER_PX[k] / self._K[:2], eye, corner)
            self._expose(moment, rays, pixels, ground, total)
        develop(total, len(moments), self._grain, rng.integers(0, 500, 2), corner, out)
        return out

    def _expose(
        self,
        now: Instant,
        rays: PixelRays,
        pixels: IntArray,
        ground: Image,
        total: NDArray[np.float32],
    ) -> None:
        s, size = now.solids, total.shape[:2]
        buffer = Buffer(np.empty(size, np.float32), np.empty(size, np.int16))
        draw(rays, pixels, s, buffer)
        cloth = Cloth(
            np.concatenate([s.owner, s.box_owner]),
            np.concatenate([s.colour, s.box_colour]) * self.params.gain,
        )
        patches = self._patches._replace(position=now.markers[self._order])
        shade(rays, buffer, now, cloth, patches, self._light, ground, total)


def _ray_map(camera: Camera) -> NDArray[np.float32]:
    """(h, w, 2): x/z and y/z in the rectified camera of each pixel as recorded."""
    u, v = np.meshgrid(np.arange(camera.width, dtype=float), np.arange(camera.height, dtype=float))
    uv = camera.rectify(np.column_stack([u.ravel(), v.ravel()]))
    P = camera.P
    rays = (uv - P[:2, 2]) / np.array([P[0, 0], P[1, 1]])
    return np.ascontiguousarray(rays.reshape(camera.height, camera.width, 2), np.float32)


def _pixels(box: Array, camera: Camera) -> IntArray:
    """Solids' bounds (n, 4) in rectified px as whole pixels of the image, empty where unseen."""
    out = np.zeros((len(box), 4), np.int64)
    seen = np.isfinite(box).all(axis=1)
    raw = _raw_bounds(box[seen], camera)
    size = [camera.width, camera.height]
    out[seen, :2] = np.clip(np.floor(raw[:, :2]) - 1, 0, size)
    out[seen, 2:] = np.clip(np.ceil(raw[:, 2:]) + 2, 0, size)
    empty = (out[:, 0] >= out[:, 2]) | (out[:, 1] >= out[:, 3])
    out[empty] = 0
    return out


def _raw_bounds(box: Array, camera: Camera) -> Array:
    """Bounds in raw px; a lens bends edges, so corners and middles are mapped."""
    if camera.is_rectified or len(box) == 0:
        return box
    u, v = box[:, [0, 2]], box[:, [1, 3]]
    us = np.concatenate([u, u.mean(axis=1, keepdims=True)], axis=1)
    vs = np.concatenate([v, v.mean(axis=1, keepdims=True)], axis=1)
    grid = np.stack([np.repeat(us, 3, axis=1), np.tile(vs, (1, 3))], axis=-1)
    raw = camera.unrectify(grid.reshape(-1, 2)).reshape(len(box), 9, 2)
    return np.concatenate([raw.min(axis=1) - 2, raw.max(axis=1) + 2], axis=1)
