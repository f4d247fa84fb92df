"""A map with labels to point at, and an object to grasp, rotate, scale and compare with its source.

Lemak et al. 2020, section 1.1: selecting a label on the map opens its object; the object can be
rotated, and a historical source overlaid on it is faded manually. Here, a finger that keeps
pointing at a label selects it; a grasp moves and rotates the object with the hand; a pinch of the
middle finger, moved up and down, scales it; a pinch of the index finger, moved sideways, fades the
source; a sustained open palm returns to the map. Each touch causes a short vibration (their Fig.
4).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np

from extensions.applications.drawing import Drawing, Line, Mesh, Points, Primitive, Text
from extensions.applications.hand import HandSample
from extensions.applications.interface import Command, Happening, MotorCommand, Step
from extensions.applications.solids import Solid, box, cylinder
from tracker.messages import Array

AHEAD = np.array([0.22, 0.0, -0.06])  # m of the map's centre from the first known palm
REACH = 1.5  # m, range of a pointing finger
AIM = np.deg2rad(15.0)  # largest angle between the finger and a label it points at
LABEL = 0.03  # m, radius of a label, which at a short distance exceeds `AIM`
KEEPS = 1.5  # factor on both while a label is pointed at: hysteresis against tremor
BACK_AFTER = 0.8  # s of an open palm
BUZZ, STRENGTH = 0.08, 0.7  # s
SLIDE = 0.12  # m of sideways movement of a pinch for a complete fade
PULL = 0.10  # m of upward movement of a pinch that doubles the size
SMALLEST, LARGEST = 0.4, 5.0
GRIPS = {"grasp": "middle", "pinch_index": "index", "pinch_middle": "middle"}
NEAR = 0.14  # m from the object's centre within which a grip takes it
INK, HIGHLIGHT, PAPER = "#56B4E9", "#E69F00", "#F0E442"


@dataclass(frozen=True)
class PlaceSettings:
    """``place``: the map's centre, m in G; empty: in front of the hand when first known.
    ``dwell``: s of pointing at a label that select it."""

    place: tuple[float, ...] = ()
    dwell: float = 0.6
    size: float = 2.0  # of an opened object relative to the map's models


@dataclass(eq=False)
class _OpenObject:
    """The opened object: R (3, 3), p (3,) m, its size and the opacity of the source."""

    thing: Thing
    R: Array
    p: Array
    size: float
    fade: float = 0.5


@dataclass(frozen=True, eq=False)
class _Grip:
    """State of the hand and the object at the beginning of a gesture."""

    gesture: str
    R_palm: Array
    point: Array
    R: Array
    p: Array
    size: float
    fade: float


class VirtualPlace:
    name: ClassVar[str] = "place"
    title: ClassVar[str] = "Virtual place"
    between: ClassVar[int] = 0

    def __init__(self, settings: PlaceSettings) -> None:
        self.settings = settings
        self._middle: Array | None = None
        self._open: _OpenObject | None = None
        self._grip: _Grip | None = None
        self._aimed: Thing | None = None
        self._aimed_since = self._palm_since = np.nan
        self._buzz: dict[str, float] = {}

    def step(self, hand: HandSample) -> Step:
        events: list[Happening] = []
        if self._middle is None and not self._stand(hand, events):
            return Step()
        if not hand.located:
            self._grip, self._aimed = None, None
        elif self._open is None:
            self._point(hand, events)
        else:
            self._handle(hand, self._open, events)
            self._go_back(hand, events)
        return Step(self._drawing(hand), events, self._buzzes(hand.t))

    def _stand(self, hand: HandSample, events: list[Happening]) -> bool:
        if len(self.settings.place) == 3:
            self._middle = np.array(self.settings.place)
        elif hand.palm is not None:
            self._middle = hand.palm[1] + AHEAD
        else:
            return False
        events.append(Happening("placed", {"at": self._middle.tolist()}))
        return True

    # --- the map

    def _point(self, hand: HandSample, events: list[Happening]) -> None:
        """Select a label that is pointed at for long enough."""
        thing = self._pointed_at(hand)
        if thing is not self._aimed:
            self._aimed, self._aimed_since = thing, hand.t
            if thing is not None:
                events.append(Happening("point", {"label": thing.name}))
                self._feel("index_tip", hand.t)
            return
        if thing is not None and hand.t - self._aimed_since >= self.settings.dwell:
            self._choose(thing, hand.t, events)

    def _pointed_at(self, hand: HandSample) -> Thing | None:
        tip, root = hand.point("index_tip"), hand.point("index_mcp")
        if not hand.shows("point") or tip is None or root is None or self._middle is None:
            return None
        ray = (tip - root) / max(float(np.linalg.norm(tip - root)), 1e-6)
        best, least = None, 1.0
        for thing in THINGS:
            to = self._middle + thing.label + [0.0, 0.0, 0.04] - tip
            distance = float(np.linalg.norm(to))
            off = float(np.arccos(np.clip(to @ ray / max(distance, 1e-6), -1.0, 1.0)))
            off /= max(AIM, np.arctan2(LABEL, distance)) * (KEEPS if thing is self._aimed else 1.0)
            if off < least and distance < REACH:
                best, least = thing, off
        return best

    def _choose(self, thing: Thing, t: float, events: list[Happening]) -> None:
        assert self._middle is not None
        self._open = _OpenObject(thing, np.eye(3), self._middle, self.settings.size)
        self._aimed = None
        events.append(Happening("choose", {"label": thing.name}))
        self._feel("index_tip", t)

    def _go_back(self, hand: HandSample, events: list[Happening]) -> None:
        """Return to the map after a sustained open palm."""
        if not hand.shows("open_palm"):
            self._palm_since = np.nan
        elif np.isnan(self._palm_since):
            self._palm_since = hand.t
        elif hand.t - self._palm_since >= BACK_AFTER:
            self._open, self._grip, self._palm_since = None, None, np.nan
            events.append(Happening("back"))

    # --- the object

    def _handle(self, hand: HandSample, thing: _OpenObject, events: list[Happening]) -> None:
        for gesture, finger in GRIPS.items():
            if hand.begins(gesture):
                self._grip = self._gripped(hand, gesture, hand.pinch_point(finger), thing)
                if self._grip is not None:
                    events.append(Happening("touch", {"gesture": gesture}))
                    self._feel("thumb_tip", hand.t)
                    self._feel(f"{finger}_tip", hand.t)
        grip = self._grip
        if grip is None:
            return
        if not hand.shows(grip.gesture):
            self._grip = None
            events.append(_let_go(grip, thing))
            return
        point = hand.pinch_point(GRIPS[grip.gesture])
        if point is not None and hand.palm is not None:
            _move(grip, thing, hand.palm[0], point)

    def _gripped(
        self, hand: HandSample, gesture: str, point: Array | None, thing: _OpenObject
    ) -> _Grip | None:
        if point is None or hand.palm is None:
            return None
        if np.linalg.norm(point - thing.p) > NEAR:
            return None
        return _Grip(gesture, hand.palm[0], point, thing.R, thing.p, thing.size, thing.fade)

    # --- feedback and drawing

    def _feel(self, tip: str, t: float) -> None:
        self._buzz[tip] = t + BUZZ

    def _buzzes(self, t: float) -> list[Command]:
        return [MotorCommand(tip, STRENGTH) for tip, until in self._buzz.items() if t < until]

    def _drawing(self, hand: HandSample) -> Drawing:
        assert self._middle is not None
        out: list[Primitive] = []
        if self._open is None:
            out += self._map(self._middle)
        else:
            out += _object(self._open)
        tip, root = hand.point("index_tip"), hand.point("index_mcp")
        if self._open is None and hand.shows("point") and tip is not None and root is not None:
            ray = (tip - root) / max(float(np.linalg.norm(tip - root)), 1e-6)
            out.append(Line("ray", np.array([tip, tip + 0.3 * ray]), HIGHLIGHT, 1.5))
        return tuple(out)

    def _map(self, middle: Array) -> list[Primitive]:
        h = MAP / 2
        edge = np.array([[-h, -h, 0], [h, -h, 0], [h, h, 0], [-h, h, 0], [-h, -h, 0.0]])
        out: list[Primitive] = [Line("edge", edge + middle, INK, 1.5)]
        for thing in THINGS:
            chosen = thing is self._aimed
            for k, (solid, colour) in enumerate(thing.solids):
                name = f"map {thing.name} {k}"
                colour = HIGHLIGHT if chosen else colour
                out.append(
                    Mesh(name, solid.points, solid.faces, colour, np.eye(3), middle + thing.label)
                )
            colour = HIGHLIGHT if chosen else ""
            above = middle + thing.label + [0.0, 0.0, 0.12]
            out.append(Text(f"label {thing.name}", thing.name, above, colour))
        return out


def _move(grip: _Grip, thing: _OpenObject, R_palm: Array, point: Array) -> None:
    """Move the object with the hand since the grip."""
    moved = point - grip.point
    if grip.gesture == "grasp":
        turn = R_palm @ grip.R_palm.T
        thing.R = turn @ grip.R
        thing.p = point + turn @ (grip.p - grip.point)
    elif grip.gesture == "pinch_middle":
        thing.size = float(np.clip(grip.size * 2 ** (moved[2] / PULL), SMALLEST, LARGEST))
    else:
        right = -float(moved[1])
        thing.fade = float(np.clip(grip.fade + right / SLIDE, 0.0, 1.0))


def _let_go(grip: _Grip, thing: _OpenObject) -> Happening:
    if grip.gesture == "grasp":
        cosine = np.clip((np.trace(thing.R @ grip.R.T) - 1) / 2, -1.0, 1.0)
        moved = (thing.p - grip.p).tolist()
        return Happening("moved", {"by": moved, "turned_deg": float(np.rad2deg(np.arccos(cosine)))})
    if grip.gesture == "pinch_middle":
        return Happening("scaled", {"size": thing.size})
    return Happening("faded", {"source": thing.fade})


def _object(thing: _OpenObject) -> list[Primitive]:
    """The object and the overlaid source, cross-faded."""
    R = thing.size * thing.R
    out: list[Primitive] = []
    for k, (solid, colour) in enumerate(thing.thing.solids):
        opacity = 1.0 - 0.85 * thing.fade
        name = f"object {thing.thing.name} {k}"
        out.append(Mesh(name, solid.points, solid.faces, colour, R, thing.p, opacity))
    for k, line in enumerate(plan_of(thing.thing)):
        if thing.fade > 0.02:
            width = 0.5 + 2.5 * thing.fade
            out.append(Line(f"plan {k}", line @ R.T + thing.p, PAPER, width))
    share = np.array([-0.06 + 0.12 * (1 - thing.fade)])
    bar = thing.p + [0.0, 0.0, -0.04]
    ends = np.array([bar + [0.0, 0.06, 0.0], bar - [0.0, 0.06, 0.0]])
    out.append(Line("bar", ends, INK, 2.0))
    out.append(Points("slider", (bar + [0.0, float(share[0]), 0.0])[None], 0.006, PAPER))
    out.append(Text("name", thing.thing.name, thing.p + R @ [0.0, 0.0, 0.11]))
    return out


# ---- objects of the virtual place: a gate tower with a wall, its plan, and labels; our own
# shapes
#
# Lemak et al. 2020 show a reconstruction of a town, labels that lead to its objects, and a
# historical source that is overlaid on an object and faded (section 1.1, Fig. 1 to 3).

MAP = 0.32  # m, the side of the map


class Thing(NamedTuple):
    """A reconstructed object: its solids relative to the centre of its base, and the position (3,)
    m of its label relative to the map's centre."""

    name: str
    solids: tuple[tuple[Solid, str], ...]
    label: Array


def _block(centre: tuple[float, float, float], half: tuple[float, float, float]) -> Solid:
    solid = box(np.array(half))
    return Solid(solid.points + np.array(centre), solid.faces)


def _column(centre: tuple[float, float, float], radius: float, half: float) -> Solid:
    solid = cylinder(radius, half)
    return Solid(solid.points + np.array(centre), solid.faces)


def _roof(centre: tuple[float, float, float], half: float, height: float) -> Solid:
    """A pyramid."""
    foot = np.array([[-half, -half, 0], [half, -half, 0], [half, half, 0], [-half, half, 0.0]])
    top = np.array([0.0, 0.0, height])
    sides = [np.array([foot[k], foot[(k + 1) % 4], top]) for k in range(4)]
    points = np.concatenate([*sides, foot[::-1]]) + np.array(centre)
    faces = np.concatenate([np.arange(12).reshape(-1, 3), [[12, 13, 14], [12, 14, 15]]])
    return Solid(points, faces.astype(np.int64))


STONE, BRICK, SLATE = "#C8BBA6", "#B5694B", "#5A6B7B"
THINGS = (
    Thing(
        "Gate tower",
        (
            (_block((0, 0.022, 0.03), (0.02, 0.008, 0.03)), STONE),
            (_block((0, -0.022, 0.03), (0.02, 0.008, 0.03)), STONE),
            (_block((0, 0, 0.055), (0.02, 0.03, 0.012)), STONE),
            (_roof((0, 0, 0.067), 0.026, 0.03), SLATE),
        ),
        np.array([0.08, 0.07, 0.0]),
    ),
    Thing(
        "Church",
        (
            (_block((0, 0, 0.02), (0.035, 0.018, 0.02)), BRICK),
            (_column((-0.02, 0, 0.04), 0.013, 0.04), BRICK),
            (_roof((-0.02, 0, 0.08), 0.012, 0.025), SLATE),
            (_roof((0.015, 0, 0.04), 0.018, 0.018), SLATE),
        ),
        np.array([0.08, -0.07, 0.0]),
    ),
    Thing(
        "Round tower",
        (
            (_column((0, 0, 0.03), 0.022, 0.03), STONE),
            (_column((0, 0, 0.064), 0.026, 0.006), STONE),
        ),
        np.array([-0.06, 0.0, 0.0]),
    ),
)


def plan_of(thing: Thing) -> list[Array]:
    """The source overlaid on the object: a drawing of its edges like in an old plan, as polylines
    (n, 3) m: the outlines of each solid's base and top."""
    out = []
    for solid, _ in thing.solids:
        low, high = solid.points.min(axis=0), solid.points.max(axis=0)
        for z in (low[2], high[2]):
            x0, y0, x1, y1 = low[0], low[1], high[0], high[1]
            out.append(np.array([[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z], [x0, y0, z]]))
    return out
