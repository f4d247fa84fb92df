"""Exports an OpenSim model of the tracked hand, and the orientations of its IMUs.

The model has the coordinates of the MOT file, the markers of the TRC file and one frame
``<segment>_imu`` per IMU, as in the STO file. Each joint has all three rotations: those that the
hand file does not define have narrow limits, so that the model can follow the tracked motion; they
are named like the others but do not appear in the MOT file. In a joint without twist, flexion is
the last rotation: otherwise abduction and twist would be about the same axis at 90° of flexion, and
inverse kinematics could not distinguish them.
"""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.messages import Array, Calibration
from tracker.session.export.joints import JointMotion, joint_motion
from tracker.session.export.load import load_series
from tracker.session.export.markers import ABOVE, dorsal_names, marker_names, read_sizes
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader

_DOCUMENT = "40500"  # OpenSim 4.5 and newer read it
_DENSITY = 1100.0  # kg/m³ of a hand
_LOOSE = 0.35  # rad: limit of an axis that the hand file does not define
_STILL = 1e-3  # rad: such an axis is locked if it moves less than this
_TURNS = ("abduction", "flexion", "twist")
_FLEXED_LAST = ("abduction", "twist", "flexion")
"""Rotations, in order, of a joint without twist in the hand file (`JointMotion.flexed_last`)."""
_AXIS_OF = {"abduction": "0 0 1", "flexion": "0 1 0", "twist": "1 0 0"}
_AXES = ("0 0 1", "0 1 0", "1 0 0")
_ROOT = ("turn_z", "turn_y", "turn_x", "x", "y", "z")


def export_osim(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write the model: median sizes over the selected part, first pose, y up."""
    model, m = hand_model(reader, options)
    document = ET.Element("OpenSimDocument", Version=_DOCUMENT)
    document.append(model)
    ET.indent(document)
    ET.ElementTree(document).write(path, encoding="utf-8", xml_declaration=True)
    return m


def hand_model(reader: SessionReader, options: ExportOptions) -> tuple[ET.Element, EstimateSeries]:
    """The element ``Model``, and the estimates that it is of."""
    m = load_series(reader, options, axes="opensim", segments=True)
    motion = joint_motion(m)
    name = "hand" if "hand" in options.anonymous else m.info.hand.name
    model = ET.Element("Model", name=name)
    _text(model, "gravity", "0 -9.80665 0")
    _text(model, "length_units", "meters")
    _text(model, "force_units", "N")
    sizes = read_sizes(reader)
    scale = np.median(sizes.scale[sizes.at(m.stamp_ns + m.zero_ns)], axis=0)
    _bodies(model, m, scale, reader)
    _joints(model, m, motion, scale)
    _markers(model, m, scale)
    return model, m


def coordinate_values(m: EstimateSeries) -> tuple[list[str], Array]:
    """Names and values (N, C) rad of all rotations of the joints but the root's, also of those that
    the hand file does not define."""
    hand, motion = m.info.hand, joint_motion(m)
    plain, flexed_last = motion.angles(), motion.flexed_last()
    names, values = [], []
    for i in (s for s, a in enumerate(hand.parent) if a >= 0):
        names += coordinate_names(hand, i)
        values.append((plain if _turns(hand, i) == _TURNS else flexed_last)[:, i])
    return names, np.hstack(values)


def _bodies(model: ET.Element, m: EstimateSeries, scale: Array, reader: SessionReader) -> None:
    bodies = _objects(model, "BodySet")
    mounting = imu_turns(reader)
    for i, segment in enumerate(m.info.hand.segments):
        body = ET.SubElement(bodies, "Body", name=segment.name)
        length = segment.length * scale[i, 0]
        half = np.array([length / 2, segment.width / 2 or segment.radius, segment.radius])
        frames = ET.SubElement(body, "components")
        shape = _frame(frames, f"{segment.name}_shape", "..", np.array([length / 2, 0, 0]))
        geometry = ET.SubElement(
            ET.SubElement(shape, "attached_geometry"), "Ellipsoid", name="bone"
        )
        _text(geometry, "socket_frame", "..")
        _text(geometry, "radii", _numbers(half))
        for k, imu in enumerate(m.info.glove.imus):
            if imu.segment == segment.name:
                place = imu.position * scale[i]
                _frame(frames, f"{segment.name}_imu", "..", place, mounting[k])
        mass = _DENSITY * 4 / 3 * np.pi * float(half.prod())
        inertia = mass / 5 * (float((half**2).sum()) - half**2)
        _text(body, "mass", f"{mass:.9g}")
        _text(body, "mass_center", f"{length / 2:.9g} 0 0")
        _text(body, "inertia", f"{_numbers(inertia)} 0 0 0")


def _joints(model: ET.Element, m: EstimateSeries, motion: JointMotion, scale: Array) -> None:
    hand = m.info.hand
    joints = _objects(model, "JointSet")
    origins = [
        s.origin if a < 0 else s.origin * scale[a]
        for s, a in zip(hand.segments, hand.parent, strict=True)
    ]
    offset = motion.median_offset(np.array(origins))
    plain, flexed_last = motion.angles(), motion.flexed_last()
    for i, segment in enumerate(hand.segments):
        joint = ET.SubElement(joints, "CustomJoint", name=f"{segment.name}_joint")
        if segment.parent is None:
            _free(joint, m, i)
            continue
        _text(joint, "socket_parent_frame", "parent")
        _text(joint, "socket_child_frame", f"/bodyset/{segment.name}")
        turns = _turns(hand, i)
        angles = (plain if turns == _TURNS else flexed_last)[:, i]
        names = coordinate_names(hand, i)
        limits = [_limits(hand, i, turn) for turn in turns]
        used = np.nanmax(np.abs(np.nan_to_num(angles)), axis=0) > _STILL
        locked = [not u and high == _LOOSE for u, (_, high) in zip(used, limits, strict=True)]
        _coordinates(joint, names, _first(angles), limits, locked)
        parent = f"/bodyset/{segment.parent}"
        frames = ET.SubElement(joint, "frames")
        _frame(frames, "parent", parent, offset[i], segment.R_rest)
        _transform(joint, names, ("",) * 3, tuple(_AXIS_OF[turn] for turn in turns))


def _free(joint: ET.Element, m: EstimateSeries, i: int) -> None:
    """The root's six degrees of freedom against the ground."""
    root = m.info.hand.segments[i].name
    _text(joint, "socket_parent_frame", "/ground")
    _text(joint, "socket_child_frame", f"/bodyset/{root}")
    names = [f"{root}_{c}" for c in _ROOT]
    known = np.isfinite(m.segment_q[:, i]).all(axis=1)
    turns = np.full((len(m), 3), np.nan)
    if known.any():
        turns[known] = Rotation.from_quat(m.segment_q[known, i]).as_euler("ZYX")
    start = np.r_[_first(turns), _first(m.segment_p[:, i])]
    _coordinates(
        joint, names, start, [(-2 * np.pi, 2 * np.pi)] * 3 + [(-10.0, 10.0)] * 3, [False] * 6
    )
    _transform(joint, names[:3], tuple(names[3:]))


def _turns(hand: HandModel, i: int) -> tuple[str, ...]:
    """Rotations of segment ``i``'s joint, in order."""
    joint = hand.joint_of.get(hand.segments[i].name)
    return _TURNS if joint is not None and "twist" in joint.axes else _FLEXED_LAST


def coordinate_names(hand: HandModel, i: int) -> list[str]:
    """Coordinates of segment ``i``'s joint, in the order of its rotations."""
    joint = hand.joint_of.get(hand.segments[i].name)
    name = hand.segments[i].name if joint is None else joint.name
    return [f"{name}_{turn}" for turn in _turns(hand, i)]


def _limits(hand: HandModel, i: int, turn: str) -> tuple[float, float]:
    joint = hand.joint_of.get(hand.segments[i].name)
    if joint is None or turn not in joint.axes:
        return -_LOOSE, _LOOSE
    return joint.limits[turn]


def _first(rows: Array) -> Array:
    """The first row (d,) of (N, d) without NaN, zeros if there is none."""
    known = np.flatnonzero(np.isfinite(rows).all(axis=1))
    first: Array = rows[known[0]] if len(known) else np.zeros(rows.shape[1])
    return first


def _coordinates(
    joint: ET.Element,
    names: list[str],
    start: Array,
    limits: list[tuple[float, float]],
    locked: list[bool],
) -> None:
    coordinates = ET.SubElement(joint, "coordinates")
    for name, value, (low, high), still in zip(names, start, limits, locked, strict=True):
        coordinate = ET.SubElement(coordinates, "Coordinate", name=name)
        _text(coordinate, "default_value", f"{value:.9g}")
        _text(coordinate, "range", f"{low:.9g} {high:.9g}")
        _text(coordinate, "clamped", "false")
        _text(coordinate, "locked", "true" if still else "false")


def _transform(
    joint: ET.Element, turns: list[str], moves: tuple[str, ...], about: tuple[str, ...] = _AXES
) -> None:
    """Rotations about the axes ``about``, then translations along x, y, z for those with names."""
    transform = ET.SubElement(joint, "SpatialTransform")
    along = ("1 0 0", "0 1 0", "0 0 1")
    axes = [("rotation", k, n, a) for k, (n, a) in enumerate(zip(turns, about, strict=True), 1)]
    axes += [("translation", k, n, a) for k, (n, a) in enumerate(zip(moves, along, strict=True), 1)]
    for kind, k, name, axis in axes:
        element = ET.SubElement(transform, "TransformAxis", name=f"{kind}{k}")
        _text(element, "coordinates", name)
        _text(element, "axis", axis)
        if name:
            function = ET.SubElement(element, "LinearFunction", name="function")
            _text(function, "coefficients", "1 0")
        else:
            _text(ET.SubElement(element, "Constant", name="function"), "value", "0")


def _markers(model: ET.Element, m: EstimateSeries, scale: Array) -> None:
    """Keypoints of the hand and the glove's markers, as in the TRC file."""
    hand, glove = m.info.hand, m.info.glove
    n = len(hand.segments)
    on = [*glove.keypoint_segments(hand), *glove.marker_segment(hand), *range(n)]
    markers = glove.marker_position * scale[glove.marker_segment(hand)]
    dorsal = scale * [[0.5 * s.length, 0.0, ABOVE] for s in hand.segments]
    place = np.concatenate([_keypoints(m, scale), markers, dorsal])
    names = [*glove.keypoint_names(hand), *marker_names(glove), *dorsal_names(hand)]
    out = _objects(model, "MarkerSet")
    for name, segment, p in zip(names, on, place, strict=True):
        marker = ET.SubElement(out, "Marker", name=name)
        _text(marker, "socket_parent_frame", f"/bodyset/{hand.segments[segment].name}")
        _text(marker, "location", _numbers(p))
        _text(marker, "fixed", "true")


def _keypoints(m: EstimateSeries, scale: Array) -> Array:
    """Keypoints (K, 3) m in their segments' B: medians, or calibrated positions where unknown."""
    hand, glove = m.info.hand, m.info.glove
    n = len(hand.segments)
    at_rest = np.tile(np.eye(3), (n, 1, 1)), np.zeros((n, 3))
    place = glove.keypoint_positions(hand, *at_rest, scale)
    for k, s in enumerate(glove.keypoint_segments(hand)):
        away, q = m.keypoints[:, k] - m.segment_p[:, s], m.segment_q[:, s]
        known = np.isfinite(away).all(axis=1) & np.isfinite(q).all(axis=1)
        if known.any():
            own = Rotation.from_quat(q[known]).apply(away[known], inverse=True)
            place[k] = np.median(own, axis=0)
    return place


def imu_turns(reader: SessionReader) -> Array:
    """R_BI (n, 3, 3) of each IMU from the last calibration."""
    turns = {imu.segment: imu.R_BI for imu in reader.info.glove.imus}
    for c in reader.messages([Calibration]):
        assert isinstance(c, Calibration)
        for segment, vector in zip(c.segments, c.mounting, strict=True):
            if segment in turns and np.isfinite(vector).all():
                nominal = next(i.R_BI for i in reader.info.glove.imus if i.segment == segment)
                turns[segment] = so3.exp(-vector) @ nominal
    return np.array([turns[imu.segment] for imu in reader.info.glove.imus])


def export_sto(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write the IMUs' orientations as OpenSim's quaternion table (w, x, y, z). Rows with a lost
    orientation are omitted, because OpenSim interprets every cell as a rotation."""
    m = load_series(reader, options, even=True, axes="opensim", segments=True)
    glove, hand = m.info.glove, m.info.hand
    q = m.segment_q[:, glove.imu_segment(hand)]
    known = np.flatnonzero(np.isfinite(q).all(axis=(1, 2)))
    turned = _mounted_all(q[known], imu_turns(reader))
    labels = [f"{imu.segment}_imu" for imu in glove.imus]
    head = [f"DataRate={m.rate:.6f}", "DataType=Quaternion", "version=3", "OpenSimVersion=4.5"]
    with path.open("w", encoding="utf-8", newline="\n") as out:
        out.write("\n".join([*head, "endheader", "\t".join(["time", *labels])]) + "\n")
        for t, row in zip(m.elapsed[known], turned, strict=True):
            cells = [",".join(f"{v:.9f}" for v in (x[3], x[0], x[1], x[2])) for x in row]
            out.write("\t".join([f"{t:.6f}", *cells]) + "\n")
    return m


def _mounted_all(q: Array, R_BI: Array) -> Array:
    """Orientations (N, n, 4) of IMUs on segments with orientations (N, n, 4)."""
    out = np.empty_like(q)
    for k in range(q.shape[1]):
        if len(q):
            out[:, k] = (Rotation.from_quat(q[:, k]) * Rotation.from_matrix(R_BI[k])).as_quat()
    return out


def _objects(model: ET.Element, name: str) -> ET.Element:
    owner = ET.SubElement(model, name, name=name.lower())
    return ET.SubElement(owner, "objects")


def _frame(
    parent: ET.Element, name: str, on: str, place: Array, R: Array | None = None
) -> ET.Element:
    """A frame fixed to ``on``; OpenSim expects body-fixed angles about x, then y, then z."""
    frame = ET.SubElement(parent, "PhysicalOffsetFrame", name=name)
    _text(frame, "socket_parent", on)
    _text(frame, "translation", _numbers(place))
    turn = np.zeros(3) if R is None else Rotation.from_matrix(R).as_euler("XYZ")
    _text(frame, "orientation", _numbers(turn))
    return frame


def _text(parent: ET.Element, tag: str, text: str) -> None:
    ET.SubElement(parent, tag).text = text


def _numbers(values: Array) -> str:
    return " ".join(f"{v:.9g}" for v in values)
