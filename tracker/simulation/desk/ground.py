"""The desk and the objects on it, seen by a static camera: radiance of each pixel.

The desk's frame D has its origin below the camera on the desk: x forward, y left, z up.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.geometry import so3
from tracker.messages import Array, CameraPose
from tracker.simulation.desk import textures
from tracker.simulation.desk.lights import RoomLight
from tracker.simulation.desk.textures import Texture, felt, picture
from tracker.simulation.smooth import rng_for

HEIGHT = 0.53  # m of the camera over the desk
TEXEL = 0.0015  # m
FIRST, LAST, HALF = -0.5, 1.02, 1.15  # m: the desk's edges forward and to the sides
REFERENCE = np.array([0.25, 0.0, 0.10])  # m: point where a light has its nominal strength
FLOOR = np.array([0.018, 0.018, 0.019])
LAMP_SAMPLES = 12
Mask = NDArray[np.bool_]


def desk_pose(camera: CameraPose) -> tuple[Array, Array]:
    """R_GD (3, 3), p_GD (3,) of the desk below a camera, facing in the camera's direction."""
    ahead = camera.R_GC[:, 2] * [1, 1, 0]
    if np.linalg.norm(ahead) < 1e-6:
        ahead = -camera.R_GC[:, 1] * [1, 1, 0]
    x = ahead / np.linalg.norm(ahead)
    z = np.array([0.0, 0.0, 1.0])
    return np.column_stack([x, np.cross(z, x), z]), camera.p_GC - HEIGHT * z


def strength(light_position: Array, points: Array, normals: Array, softness: float = 0.0) -> Array:
    """(…) irradiance relative to that at `REFERENCE`, on surfaces at points (…, 3) with normals (…,
    3).

    It decreases with the squared distance; an extended light reaches slightly beyond the
    terminator.
    """
    away = light_position - points
    r2 = np.sum(away * away, axis=-1)
    cosine = np.sum(away * normals, axis=-1) / np.sqrt(r2)
    near = light_position - REFERENCE
    return np.maximum((cosine + softness) / (1 + softness), 0.0) * float(near @ near) / r2


@dataclass(frozen=True, eq=False)
class GroundImages:
    """For one camera: linear BGR (h, w, 3) from the lamp and from other light; depth (h, w) m along
    the camera's axis."""

    lamp: NDArray[np.float32]
    rest: NDArray[np.float32]
    depth: NDArray[np.float32]


class Desk:
    """A random desk under a light; ``surface`` wood or laminate, random if empty."""

    def __init__(self, light: RoomLight, seed: int, surface: str = "") -> None:
        rng = rng_for(seed, "desk")
        self.light = light
        shift = rng.uniform(-0.06, 0.06, 3)
        self.lamp_position: Array = np.array(light.position) + shift
        self.power = float(rng.uniform(0.92, 1.08))
        shape = (round((LAST - FIRST) / TEXEL), round(2 * HALF / TEXEL))
        by_chance = "wood" if rng.random() < 0.7 else "laminate"
        self._surface = textures.SURFACES[surface or by_chance](rng, shape, TEXEL)
        self.items = items_of(rng)

    # ---- light on the desk's top

    @cached_property
    def _irradiance(self) -> tuple[Texture, Texture]:
        """(h, w) and (h, w, 3) at 4 texels: the lamp's share and the remaining light on the desk's
        top in the shadows of the objects."""
        step = 4 * TEXEL
        shape = (round((LAST - FIRST) / step), round(2 * HALF / step))
        x, y = (np.arange(shape[0]) + 0.5) * step + FIRST, (np.arange(shape[1]) + 0.5) * step - HALF
        points = np.dstack([*np.meshgrid(x, y, indexing="ij"), np.zeros(shape)])
        main, rest = self._light(points, np.broadcast_to([0.0, 0.0, 1.0], points.shape))
        lamp_share, sky_share = self._shadows(shape, step)
        lamp, sky = lamp_share * main, sky_share[..., None] * rest
        return np.asarray(lamp, np.float32), np.asarray(sky, np.float32)

    def _shadows(self, shape: tuple[int, int], step: float) -> tuple[Texture, Texture]:
        """(h, w): shares of the lamp and of the sky that are not blocked by the objects."""
        hidden, foot = np.zeros(shape, np.float32), np.zeros(shape, np.float32)
        spread = self.light.softness * np.linalg.norm(self.lamp_position - REFERENCE)
        golden = np.pi * (3 - np.sqrt(5)) * np.arange(LAMP_SAMPLES)
        disc = np.sqrt((np.arange(LAMP_SAMPLES) + 0.5) / LAMP_SAMPLES)
        for a, r in zip(golden, disc, strict=True):
            lamp = self.lamp_position + spread * r * np.array([0.5 * np.cos(a), np.sin(a), 0.5])
            one = np.zeros(shape, np.uint8)
            for item in self.items:
                cv2.fillConvexPoly(one, _cast(item.corners, lamp, step), 1)
            hidden += one
        for item in self.items:
            one = np.zeros(shape, np.uint8)
            cv2.fillConvexPoly(one, _cast(item.corners * [1, 1, 0], np.array([0, 0, 1.0]), step), 1)
            foot = np.maximum(foot, one * min(float(item.corners[:, 2].max()) / 0.03, 1.0))
        lamp_share = 1 - cv2.GaussianBlur(hidden / LAMP_SAMPLES, (0, 0), 0.8)
        sky_share = 1 - 0.6 * cv2.GaussianBlur(foot, (0, 0), 0.016 / step)
        return np.asarray(lamp_share, np.float32), np.asarray(sky_share, np.float32)

    # ---- camera view

    def seen(self, slopes: NDArray[np.float32], R_DC: Array, eye: Array) -> GroundImages:
        """From ``eye`` (3,) in D along rays slopes (h, w, 2): x/z and y/z in C."""
        ones = np.ones((*slopes.shape[:2], 1), np.float32)
        rays = np.concatenate([slopes, ones], axis=2) @ R_DC.T.astype(np.float32)
        depth = np.where(rays[..., 2] < -1e-3, -eye[2] / np.minimum(rays[..., 2], -1e-3), 20.0)
        depth = np.minimum(depth, 20.0)
        points = (eye + depth[..., None] * rays).astype(np.float32)
        lamp, rest = self._top(points)
        for item in self.items:
            self._add(item, rays, eye, (lamp, rest, depth))
        return GroundImages(
            np.asarray(lamp, np.float32),
            np.asarray(rest, np.float32),
            np.asarray(depth, np.float32),
        )

    def _top(self, points: Array) -> tuple[Array, Array]:
        """Light from the desk's top and from beyond its edges."""
        row, column = (points[..., 0] - FIRST) / TEXEL - 0.5, (points[..., 1] + HALF) / TEXEL - 0.5
        at = column.astype(np.float32), row.astype(np.float32)
        surface = cv2.remap(self._surface, *at, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        quarter = (at[0] + 0.5) / 4 - 0.5, (at[1] + 0.5) / 4 - 0.5
        main, sky = (
            cv2.remap(s, *quarter, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
            for s in self._irradiance
        )
        off = (points[..., 0] > LAST) | (np.abs(points[..., 1]) > HALF) | (points[..., 0] < FIRST)
        surface[off] = FLOOR
        return surface * main[..., None] * np.array(self.light.main, np.float32), surface * sky

    def _light(self, points: Array, normals: Array) -> tuple[Array, Array]:
        """Irradiance of surfaces: the lamp's share (…), and the rest, linear BGR (…, 3)."""
        light = self.light
        main = self.power * strength(self.lamp_position, points, normals, light.softness)
        second = strength(np.array(light.second_position), points, normals)
        sky = 0.6 + 0.4 * normals[..., 2]
        rest = sky[..., None] * np.array(light.sky) + second[..., None] * np.array(light.second)
        return main, rest

    def _add(self, item: Item, rays: Array, eye: Array, images: tuple[Array, Array, Array]) -> None:
        """Draw one object where it is nearest so far."""
        window = _window(item, rays, eye)
        if window is None:
            return
        lamp, rest, depth = (image[window] for image in images)
        d = rays[window]
        t, normal, colour = _intersected(item, d, eye)
        nearer = t < depth
        if not nearer.any():
            return
        points = eye + t[nearer][:, None] * d[nearer]
        main, by_rest = self._light(points, normal[nearer])
        by_lamp = main[:, None] * np.array(self.light.main) * colour[nearer]
        by_rest *= colour[nearer]
        if item.gloss:
            by_lamp += item.gloss * self._glint(points, normal[nearer], d[nearer])
        lamp[nearer], rest[nearer], depth[nearer] = by_lamp, by_rest, t[nearer]

    def _glint(self, points: Array, normals: Array, rays: Array) -> Array:
        """The lamp's reflection on a glossy surface (Blinn 1977)."""
        to_lamp = self.lamp_position - points
        to_lamp = to_lamp / np.linalg.norm(to_lamp, axis=1, keepdims=True)
        half = to_lamp - rays / np.linalg.norm(rays, axis=1, keepdims=True)
        half = half / np.linalg.norm(half, axis=1, keepdims=True)
        sharp = 60.0 / (1 + 20 * self.light.softness)
        shine = np.maximum(np.sum(half * normals, axis=1), 0.0) ** sharp
        return shine[:, None] * np.array(self.light.main)


def _cast(points: Array, lamp: Array, step: float) -> NDArray[np.int32]:
    """Hull (n, 1, 2) of the shadow of ``points`` on the desk, in texels (column, row)."""
    share = lamp[2] / np.maximum(lamp[2] - points[:, 2], 1e-3)
    xy = lamp[:2] + share[:, None] * (points[:, :2] - lamp[:2])
    texels = np.column_stack([(xy[:, 1] + HALF) / step, (xy[:, 0] - FIRST) / step])
    return np.asarray(cv2.convexHull(np.clip(texels, -3000, 3000).astype(np.int32)), np.int32)


def _window(item: Item, rays: Array, eye: Array) -> tuple[slice, slice] | None:
    """Rows and columns in which the object may be visible; None if in none."""
    away = item.centre - eye
    reach = float(np.linalg.norm(item.half)) * (1.0 if item.kind != "ball" else 0.6)
    # a ray passes within ``reach`` of the centre: its distance from the line of sight
    along = rays[::8, ::8] @ away / np.sum(rays[::8, ::8] ** 2, axis=2)
    gap = np.linalg.norm(rays[::8, ::8] * along[..., None] - away, axis=2)
    rows, columns = np.nonzero(gap < reach + 0.02)
    if len(rows) == 0:
        return None
    first, last = 8 * max(rows.min() - 1, 0), 8 * (rows.max() + 2)
    left, right = 8 * max(columns.min() - 1, 0), 8 * (columns.max() + 2)
    return slice(first, last), slice(left, right)


def _intersected(item: Item, rays: Array, eye: Array) -> tuple[Array, Array, Array]:
    """Intersections of rays (h, w, 3) with the object: ray parameter (h, w), inf where they miss;
    normal and colour (h, w, 3)."""
    if item.kind == "box":
        return _box(item, rays, eye)
    o = eye - item.centre
    axes = 3 if item.kind == "ball" else 2
    a = np.sum(rays[..., :axes] ** 2, axis=2)
    b = rays[..., :axes] @ o[:axes]
    h = b * b - a * (o[:axes] @ o[:axes] - item.half[0] ** 2)
    t = np.where(h >= 0, (-b - np.sqrt(np.maximum(h, 0))) / a, np.inf)
    normal = (o + np.where(np.isfinite(t), t, 0)[..., None] * rays) / item.half[0]
    if item.kind == "can":
        normal, t = _can(item, rays, o, t, normal)
    return t, normal, np.broadcast_to(item.colour, rays.shape)


def _can(item: Item, rays: Array, o: Array, t: Array, normal: Array) -> tuple[Array, Array]:
    """A can's lateral surface between its ends, and its upper end."""
    z = o[2] + np.where(np.isfinite(t), t, 0) * rays[..., 2]
    t = np.where(np.abs(z) <= item.half[2], t, np.inf)
    normal = normal * np.array([1.0, 1.0, 0.0])
    top = (item.half[2] - o[2]) / np.minimum(rays[..., 2], -1e-6)
    at = o[:2] + top[..., None] * rays[..., :2]
    lid = (np.sum(at * at, axis=2) < item.half[0] ** 2) & (top < t)
    return np.where(lid[..., None], np.array([0.0, 0.0, 1.0]), normal), np.where(lid, top, t)


def _box(item: Item, rays: Array, eye: Array) -> tuple[Array, Array, Array]:
    o, d = (eye - item.centre) @ item.R, rays @ item.R
    d = np.where(np.abs(d) < 1e-9, 1e-9, d)
    one, other = (-item.half - o) / d, (item.half - o) / d
    enter = np.minimum(one, other)
    low, high = enter.max(axis=2), np.maximum(one, other).min(axis=2)
    t = np.where((low <= high) & (low > 0), low, np.inf)
    axis = enter.argmax(axis=2)
    unit = np.eye(3)[axis] * -np.sign(np.take_along_axis(d, axis[..., None], axis=2))
    colour = np.broadcast_to(item.colour, rays.shape)
    if item.page is not None:
        at = (o + np.where(np.isfinite(t), t, 0)[..., None] * d) / item.half
        n = len(item.page)
        cell = np.clip(((at[..., :2] + 1) / 2 * n).astype(int), 0, n - 1)
        colour = np.where((axis == 2)[..., None], item.page[cell[..., 0], cell[..., 1]], colour)
    return t, unit @ item.R.T, colour


# ---- the objects on the desk: books, notes, prints, pens, blocks, balls, a cup, in any colours

HUES = ("red", "yellow", "green", "blue")
FRONT, BACK, SIDE = -0.02, 0.92, 0.72  # m from below the camera: area of the objects


@dataclass(frozen=True, eq=False)
class Item:
    """An object in the desk's frame: x forward, y left, z up from its surface, m.

    ``kind``: a box (half (3,), rotated by R), a ball (half[0] its radius) or an upright can (radius
    half[0], half height half[2]). ``page`` is printed on a box's upper side.
    """

    kind: str
    centre: Array
    half: Array
    R: Array
    colour: Array  # (3,) linear BGR
    gloss: float = 0.0
    page: Texture | None = None

    @property
    def corners(self) -> Array:
        """(n, 3) points whose hull contains it."""
        if self.kind == "box":
            signs = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
            return self.centre + (signs * self.half) @ self.R.T
        turn = np.linspace(0, 2 * np.pi, 16, endpoint=False)
        ring = np.column_stack([np.cos(turn), np.sin(turn), 0 * turn]) * self.half[0]
        if self.kind == "can":
            lift = np.array([0.0, 0.0, self.half[2]])
            return self.centre + np.concatenate([ring - lift, ring + lift])
        upright = np.roll(ring, 1, axis=1), np.roll(ring, 2, axis=1)
        return self.centre + np.concatenate([ring, *upright])


def items_of(rng: np.random.Generator) -> list[Item]:
    """The objects of a desk, drawn at random."""
    out: list[Item] = []
    for size, colours in (
        ((0.085, 0.06, 0.008), (*HUES, "teal", "orange", "paper")),
        ((0.075, 0.055, 0.011), (*HUES, "paper", "black")),
        ((0.16, 0.06, 0.008), ("black",)),
    ):
        out.append(_item_box(rng, out, size, colours))
    for _ in range(2):
        out.append(_item_box(rng, out, (0.062, 0.062, 0.0008), ("paper",), picture(rng)))
    for colour in ("note", "note", "pink"):
        out.append(_item_box(rng, out, (0.037, 0.037, 0.0006), (colour,)))
    for _ in range(4):
        out.append(_item_box(rng, out, (0.07, 0.004, 0.004), (*HUES, "black")))
    for _ in range(9):
        edges = rng.uniform(0.007, 0.016, 3) * [1, 1, 0.7]
        out.append(_item_box(rng, out, tuple(edges), (*HUES, "rose")))
    for _ in range(5):
        edge = float(rng.uniform(0.0035, 0.006))
        out.append(_item_box(rng, out, (edge, edge, 0.6 * edge), HUES))
    for paint in (("red",), ("orange", "yellow"), ("green", "blue")):
        radius = rng.uniform(0.026, 0.036)
        out.append(_round(rng, out, "ball", np.full(3, radius), paint))
    out.append(_round(rng, out, "can", np.array([0.036, 0.036, 0.042]), (*HUES, "paper")))
    return out


def _place(rng: np.random.Generator, others: list[Item], z: float, reach: float) -> Array:
    """A free position, if one is found after a few tries."""
    place = np.zeros(3)
    for _ in range(20):
        place = np.array([rng.uniform(FRONT, BACK), rng.uniform(-SIDE, SIDE), z])
        gaps = [
            np.hypot(*(place - o.centre)[:2]) - float(np.max(o.half[:2])) - reach for o in others
        ]
        if not gaps or min(gaps) > 0:
            break
    return place


def _item_box(
    rng: np.random.Generator,
    others: list[Item],
    half: tuple[float, ...],
    colours: tuple[str, ...],
    page: Texture | None = None,
) -> Item:
    size = np.array(half) * rng.uniform(0.9, 1.15)
    place = _place(rng, others, float(size[2]), float(np.max(size[:2])))
    R = so3.rz(rng.uniform(0, np.pi))
    return Item("box", place, size, R, _colour(rng, colours), 0.0, page)


def _round(
    rng: np.random.Generator, others: list[Item], kind: str, half: Array, colours: tuple[str, ...]
) -> Item:
    place = _place(rng, others, float(half[2]), float(half[0]))
    return Item(kind, place, half, np.eye(3), _colour(rng, colours), 0.35)


def _colour(rng: np.random.Generator, names: tuple[str, ...]) -> Array:
    return felt(str(rng.choice(names))) * rng.uniform(0.6, 1.0)
