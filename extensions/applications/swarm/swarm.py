"""A drone swarm in front of the hand: fingers push, drag, stretch and split it, and draw walls.

Lee et al. 2021, movie 2: complex behaviour of a swarm by nudging its formation and by quickly
defining virtual walls. A pointing finger pushes drones, and the formation yields; a pinch drags the
nearest group; a grasp at a group stretches it along the motion of the hand; an open palm that moves
through a group splits it, and elsewhere draws a wall; a fist restores one formation, a thumb up
removes the walls.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from extensions.applications.drawing import Drawing, Line, Points, Text
from extensions.applications.hand import HandSample
from extensions.applications.interface import Command, Happening, Step, VehicleCommand
from extensions.applications.swarm.flight import Drones, FlightParams, ball, fly
from tracker.messages import Array, IntArray

COLOURS = ("#E69F00", "#56B4E9", "#009E73", "#CC79A7", "#F0E442", "#D55E00")
WALL = "#8888AA"
AHEAD = np.array([0.16, 0.0, 0.0])  # m of the formation from the first known palm
LONGEST_STEP = 0.03  # s
NEAR = 1.3  # of a group's radius: distance within which a hand acts on it
APART = 0.5  # of a group's radius: displacement of each half when it is split
MOST_GROUPS = len(COLOURS)
LEAST_ARM = 0.01  # m, minimum distance from a group's centre to the grasp

STRETCH = 0.3, 3.0  # times
SMALLEST = 4  # drones of a group
GRIPS = {"pinch_index": "index", "grasp": "middle"}
"""Gestures that grip a group, and the finger that, with the thumb, defines the position."""


@dataclass(frozen=True)
class SwarmSettings:
    """``place`` m in G; empty: in front of the hand when first known. ``scale``: m in the drones'
    world per m of the model. ``vehicles``: host:port that receives MAVLink; empty: none."""

    drones: int = 200
    spacing: float = 0.02  # m
    place: tuple[float, ...] = ()
    scale: float = 100.0
    vehicles: str = ""


@dataclass(eq=False)
class _Group:
    """A group of drones ``rows`` (n,): its centre (3,) m, slots (n, 3) m about it, and stretch."""

    rows: IntArray
    middle: Array
    slots: Array
    stretch: Array

    @property
    def radius(self) -> float:
        return float(np.linalg.norm(self.slots @ self.stretch.T, axis=1).max()) + 0.01

    @property
    def placed(self) -> Array:
        return np.asarray(self.middle + self.slots @ self.stretch.T)


@dataclass(eq=False)
class _Held:
    """The gripped group, and the position ``start`` (3,) m of the hand at the grip."""

    gesture: str
    group: _Group
    start: Array
    middle: Array
    stretch: Array


class Swarm:
    name: ClassVar[str] = "swarm"
    title: ClassVar[str] = "Drone swarm"
    between: ClassVar[int] = 0

    def __init__(self, settings: SwarmSettings) -> None:
        self.settings = settings
        self._walls = Walls()
        self._params = FlightParams()
        self._groups: list[_Group] = []
        self._drones = Drones(np.empty((0, 3)), np.empty((0, 3)))
        self._t = np.nan
        self._held: _Held | None = None
        self._cut: _Group | None = None
        self._nudging = False

    @property
    def walls(self) -> Array:
        """Wall triangles (W, 3, 3) m in G, which drones do not cross."""
        return self._walls.triangles

    # --- one sample

    def step(self, hand: HandSample) -> Step:
        events: list[Happening] = []
        if not self._groups and not self._begin(hand, events):
            return Step()
        if hand.located:
            self._hold(hand, events)
            self._palm(hand, events)
            self._signs(hand, events)
        else:
            self._held = None
            self._finish_palm(events, None)
        self._fly(hand, events)
        return Step(self._drawing(), events, self._commands())

    def _begin(self, hand: HandSample, events: list[Happening]) -> bool:
        s = self.settings
        if len(s.place) == 3:
            middle = np.array(s.place)
        elif hand.palm is not None:
            middle = hand.palm[1] + AHEAD
        else:
            return False
        slots = ball(max(int(s.drones), 1), s.spacing)
        self._groups = [_Group(np.arange(len(slots)), middle, slots, np.eye(3))]
        self._drones = Drones(self._groups[0].placed, np.zeros_like(slots))
        events.append(Happening("placed", {"drones": len(slots), "at": middle.tolist()}))
        return True

    def _fly(self, hand: HandSample, events: list[Happening]) -> None:
        """Move all drones to the time of this sample."""
        passed = hand.t - self._t if np.isfinite(self._t) else 0.0
        self._t = hand.t
        dt = min(max(passed, 0.0), LONGEST_STEP)
        slots = np.empty_like(self._drones.p)
        for group in self._groups:
            slots[group.rows] = group.placed
        fingers = np.empty((0, 3))
        tip = hand.point("index_tip")
        if hand.located and hand.shows("point") and tip is not None:
            fingers = tip[None]
        self._drones, pushed = fly(
            self._drones, slots, fingers, self._walls.triangles, dt, self._params
        )
        for group in self._groups:
            touched = pushed[group.rows][pushed[group.rows].any(axis=1)]
            if len(touched):
                group.middle = group.middle + touched.mean(axis=0)
        self._report_nudge(bool(pushed.any()), events)

    def _report_nudge(self, now: bool, events: list[Happening]) -> None:
        if now and not self._nudging:
            events.append(Happening("nudge"))
        self._nudging = now

    # --- gestures

    def _at(self, point: Array, slack: float = NEAR) -> _Group | None:
        """The nearest group at a point."""
        away = [np.linalg.norm(point - g.middle) / (slack * g.radius) for g in self._groups]
        nearest = int(np.argmin(away))
        return self._groups[nearest] if away[nearest] < 1 else None

    def _grip(self, gesture: str, point: Array | None) -> _Held | None:
        group = self._at(point) if point is not None else None
        if group is None or point is None:
            return None
        return _Held(gesture, group, point, group.middle, group.stretch)

    def _hold(self, hand: HandSample, events: list[Happening]) -> None:
        """Drag a group with a pinch; stretch or compress it with a grasp."""
        for gesture, finger in GRIPS.items():
            if hand.begins(gesture):
                self._held = self._grip(gesture, hand.pinch_point(finger))
        held = self._held
        if held is None:
            return
        if not hand.shows(held.gesture):
            self._held = None
            events.append(_let_go(held))
            return
        point = hand.pinch_point(GRIPS[held.gesture])
        if point is not None and held.gesture == "grasp":
            held.group.stretch = _stretched(held, point)
        elif point is not None:
            held.group.middle = held.middle + point - held.start

    def _palm(self, hand: HandSample, events: list[Happening]) -> None:
        """Cut a group with an open palm inside it; elsewhere draw a wall."""
        tip, palm = hand.point("middle_tip"), hand.palm
        if not hand.shows("open_palm") or tip is None or palm is None:
            self._finish_palm(events, palm)
            return
        R, middle = palm
        wrist = middle - np.linalg.norm(tip - middle) * R[:, 0]
        inside = self._at((middle + tip) / 2, slack=0.8)
        if inside is not None:
            self._cut = inside
            self._report_wall(events)
        elif self._cut is not None:
            self._finish_palm(events, palm)
        else:
            self._walls.sweep(np.array([wrist, tip]))

    def _finish_palm(self, events: list[Happening], palm: tuple[Array, Array] | None) -> None:
        """Finish the wall, or split the group."""
        self._report_wall(events)
        group, self._cut = self._cut, None
        if group is not None and palm is not None and len(self._groups) < MOST_GROUPS:
            self._split(group, palm[0][:, 2], events)

    def _report_wall(self, events: list[Happening]) -> None:
        area = self._walls.finish()
        if area > 0:
            walls = len(self._walls.strips)
            events.append(Happening("wall", {"number": walls, "area_cm2": 1e4 * area}))

    def _split(self, group: _Group, normal: Array, events: list[Happening]) -> None:
        """Split a group along the palm's plane and move the halves apart."""
        side = group.slots @ group.stretch.T @ normal >= 0
        if min(side.sum(), (~side).sum()) < SMALLEST:
            return
        shift = APART * group.radius
        halves = []
        for half, direction in ((side, normal), (~side, -normal)):
            slots = group.slots[half]
            middle = slots.mean(axis=0)
            at = group.middle + group.stretch @ middle + shift * direction
            halves.append(_Group(group.rows[half], at, slots - middle, group.stretch))
        self._groups.remove(group)
        self._groups += halves
        events.append(Happening("split", {"drones": [float(len(h.rows)) for h in halves]}))

    def _signs(self, hand: HandSample, events: list[Happening]) -> None:
        """Restore one formation (fist); remove the walls (thumb up)."""
        if hand.begins("fist") and (len(self._groups) > 1 or self._stretched):
            rows = np.concatenate([g.rows for g in self._groups])
            middles = np.array([g.middle for g in self._groups])
            many = np.array([len(g.rows) for g in self._groups], float)
            middle = many @ middles / many.sum()
            slots = ball(len(rows), self.settings.spacing)
            self._groups = [_Group(np.sort(rows), middle, slots, np.eye(3))]
            events.append(Happening("merge"))
        if hand.begins("thumb_up") and self._walls.edges:
            events.append(Happening("cleared", {"walls": len(self._walls.strips)}))
            self._walls.clear()

    @property
    def _stretched(self) -> bool:
        return any(not np.array_equal(g.stretch, np.eye(3)) for g in self._groups)

    # --- geometry

    def _drawing(self) -> Drawing:
        flocks = [
            Points(f"group {i}", self._drones.p[g.rows], 0.003, COLOURS[i % len(COLOURS)])
            for i, g in enumerate(self._groups)
        ]
        texts = [
            Text(f"count {i}", str(len(g.rows)), g.middle + [0.0, 0.0, g.radius])
            for i, g in enumerate(self._groups)
        ]
        walls = [
            Line(f"wall {i}", _fence(strip), WALL, 1.5)
            for i, strip in enumerate(self._walls.strips)
            if len(strip) > 1
        ]
        return (*flocks, *texts, *walls)

    def _commands(self) -> list[Command]:
        s = self.settings
        if not s.vehicles:
            return []
        p, v = s.scale * self._drones.p, s.scale * self._drones.v
        return [VehicleCommand(p, v, s.vehicles)]


def _stretched(held: _Held, point: Array) -> Array:
    """Stretch (3, 3) by the hand's displacement along the line from the group's centre."""
    line = held.start - held.middle
    length = float(np.linalg.norm(line))
    if length < LEAST_ARM:
        return held.stretch
    axis = line / length
    factor = float(np.clip((point - held.middle) @ axis / length, *STRETCH))
    return np.asarray((np.eye(3) + (factor - 1) * np.outer(axis, axis)) @ held.stretch)


def _let_go(held: _Held) -> Happening:
    if held.gesture == "grasp":
        volume = np.linalg.det(held.group.stretch) / np.linalg.det(held.stretch)
        return Happening("stretched", {"factor": float(volume)})
    return Happening("dragged", {"by": (held.group.middle - held.middle).tolist()})


def _fence(strip: list[Array]) -> Array:
    """Polyline (2N, 3) along alternating edges of a wall, so that it is transparent."""
    return np.concatenate([edge if i % 2 else edge[::-1] for i, edge in enumerate(strip)])


# ---- virtual walls drawn by a flat hand, as triangles

SPACING = 0.012  # m of movement between two edges of a wall
FLATTEST = 0.3  # sine between the hand's step and its length, below which it sweeps nothing
MOST = 400  # edges of all walls


class Walls:
    """Walls built edge by edge; an edge is the line from the wrist to the fingertips."""

    def __init__(self) -> None:
        self.strips: list[list[Array]] = []  # each: edges (2, 3) m
        self.triangles: Array = np.empty((0, 3, 3))
        self._drawing = False

    @property
    def edges(self) -> int:
        return sum(len(s) for s in self.strips)

    def sweep(self, edge: Array) -> None:
        """Add the hand's current edge (2, 3) m."""
        if not self._drawing:
            self.strips.append([edge])
            self._drawing = True
            return
        last = self.strips[-1][-1]
        step = edge.mean(axis=0) - last.mean(axis=0)
        length = float(np.linalg.norm(step))
        if length < SPACING or self.edges >= MOST:
            return
        along = last[1] - last[0]
        across = np.linalg.norm(np.cross(step, along)) / (length * np.linalg.norm(along))
        if across < FLATTEST:
            return
        self.strips[-1].append(edge)
        quad = np.array([[last[0], last[1], edge[1]], [last[0], edge[1], edge[0]]])
        self.triangles = np.concatenate([self.triangles, quad])

    def finish(self) -> float:
        """Finish the wall and return its area in m², 0 if there is none."""
        if not self._drawing:
            return 0.0
        self._drawing = False
        quads = len(self.strips[-1]) - 1
        if quads == 0:
            self.strips.pop()
            return 0.0
        a, b, c = np.moveaxis(self.triangles[-2 * quads :], 1, 0)
        return float(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())

    def clear(self) -> None:
        """Remove all walls."""
        self.strips.clear()
        self.triangles = np.empty((0, 3, 3))
        self._drawing = False
