"""The objects on the desk: books, notes, prints, pens, blocks, balls, a cup, in any colours."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.geometry import so3
from tracker.messages import Array
from tracker.simulation.desk.textures import Texture, felt, picture

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
        out.append(_box(rng, out, size, colours))
    for _ in range(2):
        out.append(_box(rng, out, (0.062, 0.062, 0.0008), ("paper",), picture(rng)))
    for colour in ("note", "note", "pink"):
        out.append(_box(rng, out, (0.037, 0.037, 0.0006), (colour,)))
    for _ in range(4):
        out.append(_box(rng, out, (0.07, 0.004, 0.004), (*HUES, "black")))
    for _ in range(9):
        edges = rng.uniform(0.007, 0.016, 3) * [1, 1, 0.7]
        out.append(_box(rng, out, tuple(edges), (*HUES, "rose")))
    for _ in range(5):
        edge = float(rng.uniform(0.0035, 0.006))
        out.append(_box(rng, out, (edge, edge, 0.6 * edge), HUES))
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


def _box(
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
