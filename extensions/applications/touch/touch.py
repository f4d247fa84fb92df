"""A virtual object whose contact each fingertip feels, with depth and direction.

In Lee et al. 2021, people explore a virtual rabbit with fingertip devices with one and three axes
(Fig. 8): the force is along the surface normal and grows with the depth of penetration.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import ClassVar, NamedTuple

import numpy as np

from extensions.applications.drawing import Drawing, Line, Mesh, Points, Text
from extensions.applications.hand import TIPS, HandSample
from extensions.applications.interface import Command, Happening, MotorCommand, Step, Value
from resources import folder
from tracker.base.errors import FileError
from tracker.base.files import read_bounded
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.geometry.triangles import Triangles, nearest, triangles_of
from tracker.messages import Array, IntArray, Validity

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


# ---- triangle meshes from files: Wavefront OBJ and STL

MOST_BYTES = 50_000_000
STL_HEAD = 84  # bytes before the triangles of a binary STL
STL_ROW = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])


class MeshFile(NamedTuple):
    """points (V, 3) relative to the centre of their box, whose longest side is 1; faces (F, 3)."""

    points: Array
    faces: IntArray


class TouchableSolid(NamedTuple):
    """A mesh with its data for contact computations."""

    file: MeshFile
    triangles: Triangles


def solid(name: str) -> TouchableSolid:
    """Like `load_mesh`, which takes up to half a second, but cached while the file is unchanged.
    Raises FileError."""
    path = Path(name)
    return _solid(name, path.stat().st_mtime_ns if path.is_file() else 0)


@lru_cache(maxsize=4)
def _solid(name: str, _written_ns: int) -> TouchableSolid:
    file = load_mesh(name)
    return TouchableSolid(file, triangles_of(*file))


def load_mesh(name: str) -> MeshFile:
    """Load a mesh by the name of a bundled one or by path.

    Raises FileError if it does not exist or is not a mesh.
    """
    path = Path(name)
    if not path.suffix and len(path.parts) == 1:
        shipped = folder("meshes") / f"{name}.obj"
        if not shipped.is_file():
            raise FileError(notice("mesh.unknown", name=name))
        return _centred(*_obj(shipped.read_text("utf-8").splitlines(), name))
    try:
        data = read_bounded(path, MOST_BYTES, "a mesh that can be read")
    except OSError as error:
        raise FileError(notice("file.not_readable", path=path, why=error.strerror)) from error
    if path.suffix.lower() == ".stl":
        return _centred(*_stl(data, str(path)))
    if path.suffix.lower() == ".obj":
        return _centred(*_obj(data.decode("utf-8", "replace").splitlines(), str(path)))
    raise FileError(notice("mesh.unknown_kind", path=path))


def _obj(lines: list[str], name: str) -> tuple[Array, IntArray]:
    """Points and faces of an OBJ file; polygons become triangle fans."""
    points: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    try:
        for words in (line.split() for line in lines):
            if words[:1] == ["v"]:
                points.append([float(w) for w in words[1:4]])
            elif words[:1] == ["f"]:
                rows = [int(w.split("/")[0]) for w in words[1:]]
                rows = [r - 1 if r > 0 else len(points) + r for r in rows]
                faces += [(rows[0], b, c) for b, c in pairwise(rows[1:])]
    except ValueError as error:
        raise FileError(notice("mesh.not_obj", name=name, why=error)) from error
    return _checked(np.array(points, float), np.array(faces, np.int64), name)


def _stl(data: bytes, name: str) -> tuple[Array, IntArray]:
    """Points and faces of an STL file; equal points are merged."""
    count = int.from_bytes(data[STL_HEAD - 4 : STL_HEAD], "little")
    if len(data) == STL_HEAD + count * STL_ROW.itemsize:
        corners = np.frombuffer(data, STL_ROW, count, STL_HEAD)["corners"].astype(float)
    else:
        words = [line.split()[1:4] for line in data.decode("ascii", "replace").splitlines()
                 if line.split()[:1] == ["vertex"]]  # fmt: skip
        try:
            corners = np.array(words, float).reshape(-1, 3, 3)
        except ValueError as error:
            raise FileError(notice("mesh.not_stl", name=name, why=error)) from error
    points, rows = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return _checked(points, np.asarray(rows).reshape(-1, 3).astype(np.int64), name)


def _checked(points: Array, faces: IntArray, name: str) -> tuple[Array, IntArray]:
    if len(points) < 4 or len(faces) < 4 or points.shape[1:] != (3,):
        raise FileError(notice("mesh.too_few", name=name))
    if not np.isfinite(points).all() or faces.min() < 0 or faces.max() >= len(points):
        raise FileError(notice("mesh.bad_points", name=name))
    return points, faces


def _centred(points: Array, faces: IntArray) -> MeshFile:
    low, high = points.min(axis=0), points.max(axis=0)
    size = float((high - low).max()) or 1.0
    a, b, c = (points[faces[:, k]] for k in range(3))
    if np.einsum("fk,fk->", a - low, np.cross(b - low, c - low)) < 0:
        faces = faces[:, ::-1]  # inside out
    return MeshFile((points - (low + high) / 2) / size, np.ascontiguousarray(faces))
