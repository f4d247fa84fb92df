"""Attaches tracked hands to the hand segments of a whole-body OpenSim model.

The body's model is copied. Each hand's bodies, joints, coordinates and markers are added with the
side before their names, and its root is welded to the segment, at the wrist joint of the body. The
segment's mass is distributed over the bodies of the hand, so that the mass of the body is the same.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree as ET

import numpy as np
from scipy.spatial.transform import Rotation

from extensions.movement.commands import OpensimBodyArguments
from extensions.movement.osim import coordinate_values, hand_model
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import whole_files
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.messages import Array
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import sides_of
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader

OLDEST = 40000  # of the document: earlier ones have joints inside of bodies
SEGMENTS = {"right": "hand_r", "left": "hand_l"}
AXES = {
    "right": np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]]),
    "left": np.array([[0.0, -1, 0], [-1, 0, 0], [0, 0, -1]]),
}
"""Columns: the dorsum's x (to the fingers), y and z (out of the back of the hand) in a segment
whose -y points to the fingers and whose x points forward while the palm faces the thigh."""
LIGHT = 1e-6  # kg that remain at the segment: OpenSim requires a mass above zero for its inertia
PARTS = ("Body", "Joint", "Coordinate", "Marker")


class DorsumPlacement(NamedTuple):
    """Where the dorsum is in the body's segment: position (3,) m, None: at the wrist joint, and
    rotation (3, 3)."""

    segment: str
    position: Array | None
    R: Array

    @staticmethod
    def of(side: str, segment: str = "", numbers: Array | None = None) -> DorsumPlacement:
        """``numbers`` (6,): position (m) and body-fixed x, y, z rotations (deg)."""
        name = segment or SEGMENTS[side]
        if numbers is None:
            return DorsumPlacement(name, None, AXES[side])
        R = Rotation.from_euler("XYZ", numbers[3:], degrees=True).as_matrix()
        return DorsumPlacement(name, numbers[:3], R)


class WholeBody:
    """The model of a body in ``path``. Raises FileError for another file or an old model."""

    def __init__(self, path: Path) -> None:
        self._path = path
        try:
            self._root = ET.parse(path).getroot()
        except (OSError, ET.ParseError) as error:
            raise FileError(notice("file.not_readable", path=path, why=error)) from error
        version = self._root.get("Version", "0")
        model = self._root.find("Model")
        if model is None or not version.isdigit():
            raise FileError(notice("osim.no_model", path=path))
        if int(version) < OLDEST:
            raise FileError(notice("osim.old_model", path=path))
        self._model = model

    def attach(self, reader: SessionReader, placement: DorsumPlacement) -> EstimateSeries:
        """Adds the hand of a session; returns its estimates. Raises ConfigError for a segment that
        does not exist."""
        segment = self._segment(placement.segment)
        hand, series = hand_model(reader, ExportOptions())
        side = series.info.hand.side
        root = series.info.hand.segments[series.info.hand.root].name
        _prefix(hand, f"{side}_")
        self._take_mass(segment, hand)
        for kind in ("BodySet", "JointSet", "MarkerSet"):
            into = self._objects(kind)
            for part in hand.find(f"{kind}/objects") or ():
                if part.get("name") != f"{side}_{root}_joint":
                    into.append(part)
        position = self._wrist(placement.segment) if placement.position is None else None
        at = placement.position if position is None else position
        assert at is not None
        weld = _weld(f"{side}_{root}", placement.segment, at, placement.R)
        self._objects("JointSet").append(weld)
        return series

    def defaults(self) -> dict[str, float]:
        """Default values, in rad and m, of the coordinates."""
        found = self._model.iterfind("JointSet/objects/*/coordinates/Coordinate")
        return {c.get("name", ""): float(c.findtext("default_value", "0")) for c in found}

    def write(self, path: Path) -> None:
        ET.indent(self._root)
        ET.ElementTree(self._root).write(path, encoding="utf-8", xml_declaration=True)

    def _segment(self, name: str) -> ET.Element:
        bodies = {body.get("name", ""): body for body in self._objects("BodySet")}
        if name not in bodies:
            known = tuple(bodies)
            raise ConfigError(notice("osim.no_segment", name=name, path=self._path, known=known))
        return bodies[name]

    def _objects(self, kind: str) -> ET.Element:
        owner = self._model.find(kind)
        if owner is None:
            owner = ET.SubElement(self._model, kind, name=kind.lower())
        found = owner.find("objects")
        return ET.SubElement(owner, "objects") if found is None else found

    def _wrist(self, segment: str) -> Array:
        """Position (3,) m in the segment of the joint that moves it."""
        for joint in self._objects("JointSet"):
            child = joint.findtext("socket_child_frame", "").rpartition("/")[2]
            for frame in joint.iterfind("frames/PhysicalOffsetFrame"):
                on = frame.findtext("socket_parent", "").rpartition("/")[2]
                if (frame.get("name"), on) == (child, segment):
                    return np.array([float(v) for v in frame.findtext("translation", "").split()])
        return np.zeros(3)

    @staticmethod
    def _take_mass(segment: ET.Element, hand: ET.Element) -> None:
        """Move the mass of the segment to the bodies of the hand."""
        bodies = list(hand.iterfind("BodySet/objects/Body"))
        whole = sum(float(body.findtext("mass", "0")) for body in bodies)
        mass = float(segment.findtext("mass", "0"))
        share = max(mass - LIGHT, 0.0) / whole
        for body in bodies if share > 0 else ():
            _scale(body, share)
        if share > 0:
            _scale(segment, LIGHT / mass)


def combined(
    hands: Mapping[str, EstimateSeries], body: MotionCourse | None, defaults: Mapping[str, float],
    offset: float = 0.0,
) -> MotionCourse:  # fmt: skip
    """The coordinates of the body and of the hands by side. Without a motion of the body, its
    coordinates have their ``defaults``. ``offset``: s of the body's motion at which the session's
    first estimate is. What is lost is NaN.

    Raises ConfigError where the motion has no instant of the session.
    """
    first = next(iter(hands.values()))
    if body is None:
        rows = np.tile(list(defaults.values()), (len(first), 1))
        body = MotionCourse(first.elapsed + offset, tuple(defaults), rows, in_degrees=False)
    start, end = offset, offset + first.elapsed[-1]
    inside = (body.t >= start) & (body.t <= end)
    if not inside.any():
        raise ConfigError(notice("osim.no_overlap", start_s=start, end_s=end))
    t, names, parts = body.t[inside], list(body.names), [body.values[inside]]
    for side, series in hands.items():
        own, angles = coordinate_values(series)
        turned = np.rad2deg(angles) if body.in_degrees else angles
        elapsed = series.elapsed + (series.stamp_ns[0] - first.stamp_ns[0]) / 1e9 + offset
        names += [f"{side}_{name}" for name in own]
        parts += [np.interp(t, elapsed, column)[:, None] for column in turned.T]
    return MotionCourse(t, tuple(names), np.hstack(parts), body.in_degrees)


def _scale(body: ET.Element, share: float) -> None:
    for tag in ("mass", "inertia"):
        found = body.find(tag)
        if found is not None and found.text:
            found.text = " ".join(f"{share * float(v):.9g}" for v in found.text.split())


def _prefix(hand: ET.Element, side: str) -> None:
    """Put ``side`` before the names of parts, and in the references to them."""
    for element in hand.iter():
        if element.tag.endswith(PARTS) and "name" in element.attrib:
            element.set("name", side + element.attrib["name"])
        text = element.text or ""
        if text.startswith("/bodyset/"):
            element.text = text.replace("/bodyset/", f"/bodyset/{side}")
        elif element.tag == "coordinates" and text.strip():
            element.text = " ".join(side + name for name in text.split())


def _weld(child: str, segment: str, position: Array, R: Array) -> ET.Element:
    joint = ET.Element("WeldJoint", name=f"{child}_weld")
    ET.SubElement(joint, "socket_parent_frame").text = "parent"
    ET.SubElement(joint, "socket_child_frame").text = f"/bodyset/{child}"
    frame = ET.SubElement(ET.SubElement(joint, "frames"), "PhysicalOffsetFrame", name="parent")
    ET.SubElement(frame, "socket_parent").text = f"/bodyset/{segment}"
    turn = Rotation.from_matrix(R).as_euler("XYZ")
    for tag, values in (("translation", position), ("orientation", turn)):
        ET.SubElement(frame, tag).text = " ".join(f"{v:.9g}" for v in values)
    return joint


def opensim_body(args: OpensimBodyArguments) -> int:
    """Write the model and the motion."""
    inputs = [path for path in (args.session, args.body, args.motion) if path is not None]
    check_json(args, inputs)
    body, hands, placed = WholeBody(args.body), {}, {}
    motion = MotionCourse.read(args.motion) if args.motion is not None else None
    own = body.defaults()
    for each in sides_of(args.session) or ("",):
        with SessionReader(args.session, side=each) as reader:
            side = reader.info.hand.side
            numbers = getattr(args, f"place_{side}")
            at = None if numbers is None else np.array(numbers)
            placed[side] = DorsumPlacement.of(side, getattr(args, side), at)
            hands[side] = body.attach(reader, placed[side])
    table = combined(hands, motion, own, args.offset)
    target = args.output.with_suffix(".mot")
    with whole_files(target, args.output, force=args.force, inputs=inputs) as (mot, osim):
        table.write(mot)
        body.write(osim)
    segments = {side: found.segment for side, found in placed.items()}
    result = {"segments": segments, "rows": len(table.t), "coordinates": table.names}
    lines = [f"{args.output}: {', '.join(f'{s} hand at {n}' for s, n in segments.items())}"]
    finish(args, result, [*lines, f"{target}: {len(table.t)} rows"], [*inputs, args.output, target])
    return 0


# ---- openSim's motion files (MOT, STO): coordinates over time


class MotionCourse(NamedTuple):
    """t (N,) s; values (N, C) of the coordinates ``names``: rotations in deg or rad, translations
    in m."""

    t: Array
    names: tuple[str, ...]
    values: Array
    in_degrees: bool

    @staticmethod
    def read(path: Path) -> MotionCourse:
        """Raises FileError."""
        try:
            head, _, rest = path.read_text("utf-8").partition("endheader")
            columns, *rows = rest.strip().splitlines()
            table = np.array([[float(cell) for cell in row.split()] for row in rows])
            first, *names = columns.split()
            if first != "time" or table.shape != (len(rows), len(names) + 1) or not rows:
                raise ValueError("time and one number per column are expected")
        except (OSError, ValueError) as error:
            raise FileError(notice("file.not_readable", path=path, why=error)) from error
        degrees = "indegrees=yes" in head.replace(" ", "").lower()
        return MotionCourse(table[:, 0], tuple(names), table[:, 1:], degrees)

    def write(self, path: Path) -> None:
        columns = ["time", *self.names]
        head = [path.stem, "version=1", f"nRows={len(self.t)}", f"nColumns={len(columns)}"]
        head.append(f"inDegrees={'yes' if self.in_degrees else 'no'}")
        with path.open("w", encoding="utf-8", newline="\n") as out:
            out.write("\n".join([*head, "endheader", "\t".join(columns)]) + "\n")
            np.savetxt(out, np.column_stack([self.t, self.values]), fmt="%.9g", delimiter="\t")
