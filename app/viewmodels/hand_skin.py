"""The mesh of a hand with the patches of the glove, posed and coloured for the 3D view."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from app.viewmodels.made_skins import MADE, PATCH_FACES, PATCH_POINTS
from app.viewmodels.states import NEUTRAL, VALIDITY
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.skin.posing import RestingSkin, posed, rest_of
from tracker.messages import Array, Calibration, IntArray, Validity

LOOK = 7  # values per point: red, green, blue, opacity, ambient, hatch, dots
TINT = {Validity.MEASURED: 0.38, Validity.INFERRED: 0.45, Validity.LOST: 0.6}
"""Share of the state's colour in the mesh; hatching and dots show the same without colour."""
ARM_FROM, ARM_TO = 0.005, 0.03  # m behind the wrist where the hand changes into the plain forearm
FADE_FROM, FADE_TO = 0.05, 0.125  # and where the forearm, which is not tracked, fades out
OUTER, INNER = (0, 1, 2, 3), (0, 1)
"""Rings of a patch that is visible now, and of one visible recently; one never seen is the last
ring only."""
NOTICEABLE = 4e-3  # change of scale, half a pixel, after which the mesh is resized
Faces = npt.NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Draped:
    """Points, normals (V, 3) in G and looks (V, `LOOK`)."""

    points: Array
    normals: Array
    looks: Array


class HandSkin:
    """The mesh of a hand at the wearer's size. Generating one that is not in `MADE` takes about a
    second: do it in the background."""

    def __init__(self, hand: HandModel, glove: GloveModel) -> None:
        self._hand = hand
        made = MADE.get(hand, glove)
        self.skin, self.patches, self._ring = made.skin, made.patches, made.ring
        self._owner = np.repeat(np.arange(len(glove.markers)), PATCH_FACES)
        self._looks = np.empty((0, LOOK))
        self._states: IntArray | None = None
        self._fit(np.ones((len(hand.segments), 3)))
        posed(
            self._rest_patches, self.skin.bind_R, self.skin.bind_p
        )  # compiles the kernel if necessary

    @property
    def part(self) -> IntArray:
        """(F,) segment that each face follows most."""
        return np.asarray(self.skin.bones[self.skin.faces[:, 0], 0])

    def _fit(self, scale: Array) -> None:
        self._scale = scale
        self._rest: RestingSkin = rest_of(self.skin, self._hand, scale)
        self._rest_patches: RestingSkin = rest_of(self.patches, self._hand, scale)

    def fit(self, scale: Array) -> None:
        """Resize for a wearer whose segments are ``scale`` (S, 3) times those of the file."""
        if np.abs(scale - self._scale).max() > NOTICEABLE:
            self._fit(scale)

    def draped(self, R: Array, p: Array, states: IntArray) -> Draped:
        """The mesh for segments at R (S, 3, 3), p (S, 3) whose `Validity` is ``states`` (S,)."""
        if self._states is None or not np.array_equal(states, self._states):
            self._states, self._looks = np.array(states), self._dressed(states)
        return Draped(*posed(self._rest, R, p), self._looks)

    def plain(self, R: Array, p: Array) -> Draped:
        """The mesh of a reference hand, of which only the outline is drawn."""
        points, normals = posed(self._rest, R, p)
        return Draped(points, normals, np.ones((len(points), LOOK)))

    def _dressed(self, states: IntArray) -> Array:
        rows = np.array([_look(Validity(int(state))) for state in states])
        looks = np.einsum("vk,vkl->vl", self.skin.shares, rows[self.skin.bones])
        arm = _rise(self.skin.arm, ARM_FROM, ARM_TO)[:, None]
        looks[:, :3] += arm * (np.array(_rgb(NEUTRAL)) * 0.8 - looks[:, :3])
        looks[:, 5] *= 1 - arm[:, 0]
        looks[:, 3] *= 1 - _rise(self.skin.arm, FADE_FROM, FADE_TO)
        return np.asarray(looks)

    def draped_patches(self, R: Array, p: Array, colours: list[str]) -> Draped:
        """The patches of the glove in ``colours`` by marker."""
        return Draped(*posed(self._rest_patches, R, p), _patch_looks(tuple(colours)))

    def patch_faces(self, now: Faces, recent: Faces) -> Faces:
        """(F,) faces of the patches to draw, for markers (M,) visible now and recently."""
        now, recent = now[self._owner], recent[self._owner] & ~now[self._owner]
        ring = self._ring
        return np.asarray(np.where(now, True, np.where(recent, ring < len(INNER), ring == 3)))


def scales(hand: HandModel, calibration: Calibration | None) -> Array:
    """(S, 3) scale of all segments: without an estimate, that of the finger or else of the hand."""
    out = np.full((len(hand.segments), 3), np.nan)
    if calibration is not None:
        for name, row in zip(calibration.segments, calibration.scale, strict=True):
            out[hand.index[name]] = row
    known = np.isfinite(out).all(axis=1)
    mean = out[known].mean(axis=0) if known.any() else np.ones(3)
    for i, parent in enumerate(hand.parent):
        if not known[i]:
            out[i] = out[parent] if parent >= 0 and parent != hand.root else mean
    return out


@lru_cache(maxsize=4)
def _patch_looks(colours: tuple[str, ...]) -> Array:
    """Rows of looks for the points of all patches."""
    rows = np.array([[*_rgb(c), 1.0, 0.45, 0.0, 0.0] for c in colours]).reshape(-1, LOOK)
    return np.repeat(rows, PATCH_POINTS, axis=0)


def _look(state: Validity) -> list[float]:
    """Measured: plain. Inferred: hatched. Lost: dots."""
    tint = TINT[state]
    mixed = [
        (1 - tint) * a + tint * b
        for a, b in zip(_rgb(NEUTRAL), _rgb(VALIDITY[state].colour), strict=True)
    ]
    return [*mixed, 1.0, 0.0, float(state == Validity.INFERRED), float(state == Validity.LOST)]


def _rgb(colour: str) -> tuple[float, ...]:
    return tuple(int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))


def _rise(x: Array, low: float, high: float) -> Array:
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return np.asarray(t * t * (3 - 2 * t))
