"""A virtual object whose contact each fingertip feels, with depth and direction.

In Lee et al. 2021, people explore a virtual rabbit with fingertip devices with one and three axes
(Fig. 8): the force is along the surface normal and grows with the depth of penetration.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np

from extensions.applications.drawing import Drawing, Line, Mesh, Points, Text
from extensions.applications.hand import TIPS, HandSample
from extensions.applications.interface import Command, Happening, MotorCommand, Step, Value
from extensions.applications.touch.meshes import solid
from tracker.geometry import so3
from tracker.geometry.triangles import Triangles, nearest
from tracker.messages import Array, Validity

LEAVE = 0.001  # m outside the surface at which a touch ends: hysteresis against tremor
ARROW = 0.03  # m, length of the arrow at full strength
AHEAD = np.array([0.10, 0.0, -0.07])  # m of the object's centre from the first known palm
QUIET, FELT = "#8FA8B8", "#D55E00"
LOST = int(Validity.LOST)


class Contact(NamedTuple):
    """Contact of a fingertip's pad, a ball of ``radius`` (m) around ``centre`` (3,), with an
    object.

    depth m, negative without contact; nearest point (3,) of the surface and its outward normal
    (3,), all in G. push (3,): the normal in the distal segment's frame B.
    """

    tip: str
    depth: float
    point: Array
    normal: Array
    push: Array


class Pads(NamedTuple):
    """Pads of the known fingertips: names, R_GB (n, 3, 3), centres (n, 3), radius (n,)."""

    tips: list[str]
    R_GB: Array
    centre: Array
    radius: Array


def pads(hand: HandSample) -> Pads:
    """Pads at the fingertips, one radius inside the tip."""
    names = [n for n in TIPS if n in hand.names]
    rows = np.array([hand.names[n] for n in names], np.int64)
    there = hand.state[rows] != LOST
    there &= np.isfinite(hand.p[rows]).all(axis=1) & np.isfinite(hand.q[rows]).all(axis=1)
    known = rows[there]
    R, radius = so3.matrix_from_quat(hand.q[known]), hand.radius[known]
    tips = [n for n, seen in zip(names, there.tolist(), strict=True) if seen]
    return Pads(tips, R, hand.p[known] - radius[:, None] * R[:, :, 0], radius)


class PlacedMesh(NamedTuple):
    """A mesh with its pose in G: rotation R (3, 3), ``size`` m, position p."""

    mesh: Triangles
    R: Array
    size: float
    p: Array


def contacts(fingers: Pads, thing: PlacedMesh) -> list[Contact]:
    """The contact of each pad."""
    local = (fingers.centre - thing.p) @ thing.R / thing.size
    found = nearest(thing.mesh, local)
    point = thing.size * found.point @ thing.R.T + thing.p
    normal = found.normal @ thing.R.T
    depth = fingers.radius - thing.size * found.distance
    push = np.einsum("nji,nj->ni", fingers.R_GB, normal)
    return [
        Contact(tip, float(depth[i]), point[i], normal[i], push[i])
        for i, tip in enumerate(fingers.tips)
    ]


@dataclass(frozen=True)
class TouchSettings:
    """``place`` m in G; empty: in front of the hand when first known. ``turn``: degrees about z.
    ``least``: strength at the surface, 1 at ``full_depth`` m. ``axes`` of the motors: 1 or 3."""

    mesh: str = "rabbit"
    size: float = 0.12  # m, the longest side
    place: tuple[float, ...] = ()
    turn: float = 120.0
    full_depth: float = 0.008
    least: float = 0.15
    axes: int = 1


class Touch:
    name: ClassVar[str] = "touch"
    title: ClassVar[str] = "Virtual object to touch"
    between: ClassVar[int] = 1  # packets arrive at 100 Hz; touch is rendered at 200

    def __init__(self, settings: TouchSettings) -> None:
        self.settings = settings
        self._loaded, self._solid = settings.mesh, solid(settings.mesh)
        self._place: Array | None = None
        self._touching: set[str] = set()

    @staticmethod
    def prepare(settings: TouchSettings) -> None:
        """Read the mesh. Raises FileError."""
        solid(settings.mesh)

    def _load(self) -> None:
        if self._loaded != self.settings.mesh:
            self._loaded, self._solid = self.settings.mesh, solid(self.settings.mesh)

    def step(self, hand: HandSample) -> Step:
        self._load()
        events: list[Happening] = []
        place = self._placed(hand, events)
        if place is None:
            return Step(events=self._let_go(events))
        s = self.settings
        thing = PlacedMesh(self._solid.triangles, so3.rz(np.deg2rad(s.turn)), s.size, place)
        if not hand.located:
            return Step(self._drawing(thing, []), self._let_go(events))
        found = contacts(pads(hand), thing)
        felt = [c for c in found if self._feels(c, events)]
        return Step(self._drawing(thing, felt), events, [self._command(c) for c in felt])

    def _placed(self, hand: HandSample, events: list[Happening]) -> Array | None:
        """Position of the object; None before the hand is known."""
        if len(self.settings.place) == 3:
            self._place = np.array(self.settings.place)
        elif self._place is None and hand.palm is not None:
            self._place = hand.palm[1] + AHEAD
            events.append(Happening("placed", {"at": self._place.tolist()}))
        return self._place

    def _let_go(self, events: list[Happening]) -> list[Happening]:
        """End all touches of a lost hand."""
        events += [Happening("release", {"tip": tip}) for tip in sorted(self._touching)]
        self._touching.clear()
        return events

    def _feels(self, contact: Contact, events: list[Happening]) -> bool:
        """Whether a tip touches the object; reports the beginning and end."""

        tip, before = contact.tip, contact.tip in self._touching
        now = contact.depth > (-LEAVE if before else 0.0)
        if now and not before:
            self._touching.add(tip)
            data: dict[str, Value] = {"tip": tip, "depth_mm": 1e3 * contact.depth}
            data |= {"at": contact.point.tolist(), "normal": contact.normal.tolist()}
            events.append(Happening("touch", data))
        elif before and not now:
            self._touching.discard(tip)
            events.append(Happening("release", {"tip": tip}))
        return now and contact.depth > 0

    def _strength(self, contact: Contact) -> float:
        s = self.settings
        share = min(contact.depth / max(s.full_depth, 1e-6), 1.0)
        return s.least + (1.0 - s.least) * share

    def _command(self, contact: Contact) -> Command:
        x, y, z = contact.push.tolist()
        return MotorCommand(contact.tip, self._strength(contact), (x, y, z), self.settings.axes)

    def _drawing(self, thing: PlacedMesh, felt: list[Contact]) -> Drawing:
        colour = FELT if felt else QUIET
        mesh = Mesh("object", *self._solid.file, colour, thing.size * thing.R, thing.p)
        arrows = [
            Line(
                f"push {c.tip}",
                np.array([c.point, c.point + ARROW * self._strength(c) * c.normal]),
                "#E69F00",
                4.0,
            )
            for c in felt
        ]
        spots = [Points("contacts", np.array([c.point for c in felt]), 0.003)] if felt else []
        texts = [
            Text(f"depth {c.tip}", f"{1e3 * c.depth:.1f} mm", c.point + 0.035 * c.normal)
            for c in felt
        ]
        return (mesh, *arrows, *spots, *texts)
