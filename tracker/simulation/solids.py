"""The solids of a scene: capsules and boxes, in any frame."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tracker.glove.model import GloveModel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Vector
from tracker.messages import Array, IntArray
from tracker.simulation.wearer import Wearer

UNOWNED = -1
"""Owner of a solid that is not part of the hand."""


class Solids(NamedTuple):
    """P capsules from ``a`` to ``b`` and Q boxes of centre ``centre`` and half edges ``half``, m.

    ``owner`` is the segment's row, or UNOWNED; ``colour`` BGR 0..255. box_R (Q, 3, 3) maps the
    box's axes to the frame.
    """

    a: Matrix
    b: Matrix
    radius: Vector
    owner: IntVector
    colour: Matrix
    box_R: Stack
    centre: Matrix
    half: Matrix
    box_owner: IntVector
    box_colour: Matrix

    def moved(self, R: Array, p: Array) -> Solids:
        """In another frame: x_new = R x + p."""
        return self._replace(
            a=self.a @ R.T + p,
            b=self.b @ R.T + p,
            box_R=R @ self.box_R,
            centre=self.centre @ R.T + p,
        )


class SceneInstant(NamedTuple):
    """A scene at one instant, in C: R_CB (S, 3, 3), p_CB (S, 3), solids; markers (M, 3) in B."""

    R_CB: Stack
    p_CB: Matrix
    solids: Solids
    markers: Matrix


def capsules(a: Array, b: Array, radius: Array, owner: IntArray, colour: Array) -> Solids:
    """Solids without boxes; colour (P, 3) or (3,)."""
    n = len(a)
    return Solids(
        np.asarray(a, float).reshape(n, 3),
        np.asarray(b, float).reshape(n, 3),
        np.asarray(radius, float),
        np.asarray(owner, np.int64),
        np.broadcast_to(np.asarray(colour, float), (n, 3)).copy(),
        np.zeros((0, 3, 3)),
        np.zeros((0, 3)),
        np.zeros((0, 3)),
        np.zeros(0, np.int64),
        np.zeros((0, 3)),
    )


def boxes(R: Array, centre: Array, half: Array, owner: IntArray, colour: Array) -> Solids:
    """Solids without capsules."""
    n = len(centre)
    none = np.zeros((0, 3))
    empty = capsules(none, none, np.zeros(0), np.zeros(0, np.int64), np.zeros(3))
    return empty._replace(
        box_R=np.asarray(R, float).reshape(n, 3, 3),
        centre=np.asarray(centre, float).reshape(n, 3),
        half=np.asarray(half, float).reshape(n, 3),
        box_owner=np.asarray(owner, np.int64),
        box_colour=np.broadcast_to(np.asarray(colour, float), (n, 3)).copy(),
    )


def together(parts: list[Solids]) -> Solids:
    """All solids of ``parts``."""
    return Solids(*(np.ascontiguousarray(np.concatenate(f)) for f in zip(*parts, strict=True)))


GLOVE_BGR = (62.0, 60.0, 58.0)
SLEEVE_BGR = (96.0, 90.0, 84.0)


@dataclass(frozen=True)
class BodyShape:
    """The gloved hand's surface: radius (S,) m of each segment, length (S,) m of its axis, the
    slab's edges, the forearm."""

    radius: Array
    length: Array
    slab: tuple[float, float]  # length and half width of the flat rectangle in the dorsum, m
    root: int

    @staticmethod
    def of(wearer: Wearer) -> BodyShape:
        """The cloth's surface is where the glove file has its markers, else 1 mm above skin; a
        finger's skin ends at the end of its last segment."""
        hand, glove = wearer.hand, wearer.glove
        nominal = np.array([_surface(hand.segments[i].radius, glove, s) for i, s in
                            enumerate(hand.segment_names)])  # fmt: skip
        root = hand.root
        girth = wearer.scale[:, 1]
        length = np.array([s.length for s in hand.segments]) * wearer.scale[:, 0]
        radius = nominal * girth
        ends = np.setdiff1d(np.arange(len(length)), [root, *hand.parent])  # rounded fingertips
        skin = np.array([hand.segments[i].radius for i in ends]) * girth[ends]
        length[ends] = np.maximum(length[ends] - skin, 0.0)
        half_width = max(hand.segments[root].width / 2 * girth[root] - radius[root], 1e-4)
        return BodyShape(radius, length, (float(length[root] - radius[root]), half_width), root)

    @cached_property
    def _fingers(self) -> IntArray:
        return np.array([i for i in range(len(self.radius)) if i != self.root], np.int64)

    @cached_property
    def _at_rest(self) -> Solids:
        """All of the hand's solids in local coordinates: created once, since that takes longer than
        moving them. Fingers, the palm's rim and the forearm; the palm's flat part."""
        fingers, r = self._fingers, self.radius[self.root]
        count = len(fingers) + 5
        owner = np.concatenate([fingers, np.full(4, self.root), [UNOWNED]])
        radius = np.concatenate([self.radius[fingers], np.full(4, r), [1.7 * r]])
        colour = np.tile(np.array(GLOVE_BGR), (count, 1))
        colour[-1] = SLEEVE_BGR
        nowhere = np.zeros((count, 3))
        length, half = self.slab
        flat = boxes(
            np.eye(3)[None], np.zeros((1, 3)), np.array([[length / 2, half, r]]),
            np.array([self.root]), np.array(GLOVE_BGR),
        )  # fmt: skip
        return together([capsules(nowhere, nowhere, radius, owner, colour), flat])

    def solids(self, R: Array, p: Array) -> Solids:
        """The hand in G from its segments' poses R (S, 3, 3), p (S, 3): its fingers; a rectangle
        swept by a sphere, composed of a box and the four capsules of its edges; the forearm."""
        length, half = self.slab
        R_0, p_0, fingers = R[self.root], p[self.root], self._fingers
        corners = np.array([[0, half, 0], [length, half, 0], [length, -half, 0], [0, -half, 0]])
        rim = corners @ R_0.T + p_0
        middle = np.array([length / 2, 0, 0]) @ R_0.T + p_0
        arm = np.array([[-0.02, 0.0, 0.0], [-0.07, 0.0, 0.0]]) @ R_0.T + p_0
        tip = p + R[:, :, 0] * self.length[:, None]
        return self._at_rest._replace(
            a=np.concatenate([p[fingers], rim, arm[:1]]),
            b=np.concatenate([tip[fingers], rim[1:], rim[:1], arm[1:]]),
            box_R=R_0[None].copy(),
            centre=middle[None],
        )


def _surface(radius: float, glove: GloveModel, segment: str) -> float:
    """Distance of the cloth from the bone, m: the median of the segment's markers there."""
    height = [
        float(np.hypot(m.position[1], m.position[2]) if segment != "dorsum" else abs(m.position[2]))
        for m in glove.markers
        if m.segment == segment and abs(m.normal[0]) < 0.5
    ]
    return float(np.median(height)) if height else radius + 0.001
