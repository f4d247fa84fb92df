"""A session with a reference: topics ``/reference/<side>/…`` and the attachment that describes it.

``keypoints`` has the reference's keypoints in G after the rigid registration, in the order of the
session's keypoints, NaN where the reference has none, and axes of the segments computed from them;
``joint_states`` the angles computed from them. The attachment ``reference_<side>.json`` contains
file, time alignment, registration and marker offsets.
"""

from __future__ import annotations

import heapq
import json
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline

from extensions.reference.angles import angles_of, segment_axes
from extensions.reference.registration import Registration
from extensions.reference.timing import ReferenceTiming
from tracker.base.errors import FileError
from tracker.base.files import whole_file
from tracker.base.notices import notice
from tracker.messages import Array, IntArray
from tracker.session.encode import Out
from tracker.session.export.mcap import copy_extras
from tracker.session.holes import runs
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.message_check import sound
from tracker.session.number_rows import NumberRows
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, topics

SCHEMA = 1
MEDIA_TYPE = "application/json"
_REGISTRATIONS = ("rigid", "with_offsets")


@dataclass(frozen=True, eq=False)
class Described:
    """What is known of an imported reference. ``keypoints`` of which it has points; ``rigid`` and
    ``with_offsets`` have the rows of ``keypoints``. ``residuals`` (2, K) m: rms of each keypoint,
    rigid and with offsets, NaN where unknown; ``covered``: share of the session's instants with a
    reference, NaN if unknown; ``missing``: keypoints of the hand without a reference."""

    file: str
    kind: str
    rate: float
    keypoints: tuple[str, ...]
    timing: ReferenceTiming
    rigid: Registration
    with_offsets: Registration
    residuals: Array
    covered: float
    missing: tuple[str, ...]

    def as_json(self) -> dict[str, Any]:
        """Plain values, in m, s and without units."""
        return {
            "schema": SCHEMA,
            "file": self.file,
            "format": self.kind,
            "rate_hz": self.rate,
            "keypoints": list(self.keypoints),
            "timing": asdict(self.timing),
            "rigid": _plain(self.rigid),
            "with_offsets": _plain(self.with_offsets),
            "keypoint_residuals": dict(
                zip(_REGISTRATIONS, map(_numbers, self.residuals), strict=True)
            ),
            "covered": self.covered,
            "missing": list(self.missing),
        }

    def corrected(self, x_G: Array, R_GB: Array) -> Array:
        """(N, K, 3) keypoints with marker offsets of rigidly registered points (N, K, 3), for the
        segments' axes R_GB (N, K, 3, 3)."""
        x_L = (x_G - self.rigid.p_GL) @ self.rigid.R_GL
        return self.with_offsets.keypoints(x_L, R_GB)


def _plain(r: Registration) -> dict[str, Any]:
    return {
        "R_GL": r.R_GL.tolist(),
        "p_GL": r.p_GL.tolist(),
        "residual": r.residual,
        "share": r.share,
        "offsets": r.offsets.tolist(),
        "offset_sd": [_numbers(row) for row in r.offset_sd],
    }


def _numbers(row: Array) -> list[float | None]:
    return [float(v) if np.isfinite(v) else None for v in row]


def _registration(stored: dict[str, Any], n: int) -> Registration:
    offset_sd = [[np.nan if v is None else v for v in row] for row in stored["offset_sd"]]
    return Registration(
        np.array(stored["R_GL"], float).reshape(3, 3),
        np.array(stored["p_GL"], float).reshape(3),
        float(stored["residual"]),
        float(stored["share"]),
        np.array(stored["offsets"], float).reshape(n, 3),
        np.array(offset_sd, float).reshape(n, 3),
    )


def _number(stored: float | None) -> float:
    return float("nan") if stored is None else float(stored)


def _residuals(stored: dict[str, Any] | None, n: int) -> Array:
    """(2, n) m; NaN in sessions of earlier versions."""
    if stored is None:
        return np.full((2, n), np.nan)
    rows = [[_number(v) for v in stored[how]] for how in _REGISTRATIONS]
    return np.array(rows, float).reshape(2, n)


def described(text: str, session: Path) -> Described:
    """The inverse of `Described.as_json`. Raises FileError."""
    try:
        stored = json.loads(text)
        keypoints = tuple(str(k) for k in stored["keypoints"])
        timing: dict[str, Any] = {
            k: np.nan if v is None else v for k, v in stored["timing"].items()
        }
        return Described(
            str(stored["file"]),
            str(stored["format"]),
            float(stored["rate_hz"]),
            keypoints,
            ReferenceTiming(**timing),
            _registration(stored["rigid"], len(keypoints)),
            _registration(stored["with_offsets"], len(keypoints)),
            _residuals(stored.get("keypoint_residuals"), len(keypoints)),
            _number(stored.get("covered")),
            tuple(str(k) for k in stored.get("missing", ())),
        )
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise FileError(notice("reference.damaged", session=session)) from error


@dataclass(frozen=True, eq=False)
class Imported:
    """A session's reference of one hand: ``points`` (M, K, 3) m in G at ``stamp_ns`` (M,), of
    ``about.keypoints`` (K)."""

    about: Described
    stamp_ns: IntArray
    points: Array


def read_imported(reader: SessionReader) -> Imported:
    """The reference of the reader's hand. Raises FileError if the session contains none."""
    side, names = reader.info.side, reader.info.keypoint_names
    text = reader.attachments.get(topics.reference_about(side))
    topic = topics.reference(side, "keypoints")
    if text is None or topic not in reader.topic_names:
        raise FileError(notice("reference.none", session=reader.path))
    about = described(text, reader.path)
    rows = NumberRows(8 * 7)
    for raw in reader.raw_messages(frozenset({topic})):
        with reader.source.left_out.reading(raw.topic, raw.log_time):
            rows.feed_poses(raw.data)
    if not set(about.keypoints) <= set(names):
        raise FileError(notice("reference.damaged", session=reader.path))
    columns = [names.index(k) for k in about.keypoints]
    points = rows.table(len(names))[:, columns, :3]
    return Imported(about, np.array(rows.stamps, np.int64), points)


def write_with_reference(
    reader: SessionReader, out: Path, about: Described, stamp_ns: IntArray, points: Array,
    force: bool = False, watch: Callable[[float], None] = lambda share: None,
) -> None:  # fmt: skip
    """Copy the session, with this reference of the reader's hand in place of an earlier one.

    ``points`` (M, K, 3) m in G, of ``about.keypoints``. ``watch`` receives the share done. Raises
    FileError."""
    side = reader.info.side
    name = topics.reference_about(side)
    with whole_file(out, force, [reader.path]) as part:
        output = McapOutput(part, sync=False)
        try:
            copy_extras(reader, output, without=[name])
            text = json.dumps(_without_nan(about.as_json()), indent=1)
            output.attach_bytes(name, MEDIA_TYPE, text.encode(), int(stamp_ns[0]))
            copier = Copier(reader.source, output)
            stored = sound(ordered(reader.source, None), reader.source.left_out)
            ours = frozenset(topics.reference(side, what) for what in ("keypoints", "joint_states"))
            theirs = (m for m in stored if m.topic not in ours)
            both: list[Iterator[RawMessage | Out]] = [
                theirs, _messages(reader, about, stamp_ns, points)
            ]  # fmt: skip
            first, last = reader.span_ns
            for m in heapq.merge(*both, key=lambda m: m.log_time):
                watch(min(max((m.log_time - first) / max(last - first, 1), 0.0), 1.0))
                if isinstance(m, RawMessage):
                    copier.copy(m)
                else:
                    channel = output.channel(m.topic, m.type)
                    output.write(channel, m.log_time, m.stamp, m.data, m.sequence)
        finally:
            output.finish()


def _messages(
    reader: SessionReader, about: Described, stamp_ns: IntArray, points: Array
) -> Iterator[Out]:
    side, names = reader.info.side, reader.info.keypoint_names
    columns = [names.index(k) for k in about.keypoints]
    angles = angles_of(about.keypoints, points, side)
    q = np.full((len(stamp_ns), len(names), 4), np.nan)
    q[:, columns] = segment_axes(about.keypoints, points, side)
    for i, stamp in enumerate(int(s) for s in stamp_ns):
        known = {k: v[i] for k, v in angles.items() if np.isfinite(v[i])}
        joints = motion.pack_joints(
            motion.JointState(stamp, list(known), np.array(list(known.values()), float))
        )
        topic = topics.reference(side, "joint_states")
        yield Out(topic, motion.JOINTS, stamp, stamp, joints)
        position = np.full((len(names), 3), np.nan)
        position[columns] = points[i]
        poses = motion.pack_poses(motion.PoseArray(stamp, topics.WORLD, position, q[i]))
        yield Out(topics.reference(side, "keypoints"), motion.POSES, stamp, stamp, poses)


def _without_nan(value: Any) -> Any:
    if isinstance(value, dict):
        return {k: _without_nan(v) for k, v in value.items()}
    return None if isinstance(value, float) and not np.isfinite(value) else value


def at_instants(t: Array, points: Array, instants: Array) -> Array:
    """(n, K, 3) of points (N, K, 3) at rising t (N,) s, by a cubic spline through each part without
    a hole; NaN in holes and outside."""
    out = np.full((len(instants), *points.shape[1:]), np.nan)
    for k in range(points.shape[1]):
        known = np.asarray(np.isfinite(points[:, k]).all(axis=1))
        for part in runs(t, known):
            rows = np.flatnonzero(known[part]) + part.start
            inside = (instants >= t[rows[0]]) & (instants <= t[rows[-1]])
            if len(rows) > 3 and inside.any():
                out[inside, k] = CubicSpline(t[rows], points[rows, k])(instants[inside])
    return out
