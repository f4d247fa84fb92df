"""An Estimate as JSON: what UDP and WebSocket clients read. Lost values are null, never zeros.

    {"schema": 1, "side": "right", "t": 12.34, "tracking": "tracking",
     "keypoints": {"wrist": {"state": "measured", "position": [x, y, z],
                             "orientation_xyzw": [x, y, z, w], "sd": 0.002}, ...},
     "angles": {"index_mcp_flexion": {"state": "measured", "value": 0.5}, ...},
     "gestures": {"shown": ["pinch_index"], "values": {"pinch_index": 0.93, ...},
                  "confidence": {"pinch_index": 0.99}}}

With OpenXR's joints there is "joints" in place of "keypoints", in OpenXR's world (y up, -z
forward):

    "joints": {"palm": {"state": "inferred", "position": [x, y, z],
                        "orientation_xyzw": [x, y, z, w], "radius": 0.013}, ...}

Position and sd in m, orientation q_GB, both in G (z up); angles in rad; t in s of the host's
monotonic clock.

Schema 2 has all fields of schema 1, and

    {"schema": 2, "seq": 7, "t_unix_ns": 1732538096123456789,
     "velocity": {"wrist": {"linear": [x, y, z], "angular": [x, y, z], "sd": 0.01,
                            "angular_sd": 0.05}, ...},
     "angles": {"index_mcp_flexion": {"state", "value", "sd": 0.02, "rate": 1.2, "rate_sd": 0.1},
                ...}}

with velocities in m/s and rad/s in the axes of the positions, of every keypoint or joint; an
angle's ``sd`` in rad, its ``rate`` and ``rate_sd`` in rad/s. ``resources/schemas`` has both as JSON
Schema.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import islice
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.notices import notice
from tracker.hand.openxr import JOINTS, OpenXrHand, PointMotion, openxr_motion, to_openxr
from tracker.messages import Array, Estimate, IntArray, Validity
from tracker.streaming.publisher import STATE_WORDS, Names, StreamError
from tracker.streaming.shared import Gestures, RecentResults
from tracker.streaming.text import DECIMALS as DECIMALS
from tracker.streaming.text import (
    HOLE,
    Column,
    TextForm,
    holes,
    numbers,
)

BoolArray = NDArray[np.bool_]
SCHEMAS = FIRST, LATEST = 1, 2
_RECENT_JOINTS: RecentResults[OpenXrHand] = RecentResults(8)
VELOCITY_KEYS = ("linear", "angular", "sd", "angular_sd")
ANGLE_KEYS = ("value", "sd", "rate", "rate_sd")
FORMS = 256  # of messages whose text is stored


def payload(
    estimate: Estimate,
    names: Names,
    gestures: Gestures | None = None,
    schema: int = FIRST,
) -> dict[str, Any]:
    """The message as JSON-ready objects; ``gestures`` has been fed with the estimate."""
    content = _content(estimate, names, gestures, schema)
    head = [estimate.t] if schema == FIRST else [*_numbered(estimate, names), estimate.t]
    return _message(content.form, head, [numbers(values) for values in content.columns])


def text_of(
    estimate: Estimate,
    names: Names,
    gestures: Gestures | None = None,
    schema: int = FIRST,
) -> str:
    """`payload` as strict JSON without spaces (no NaN)."""
    content = _content(estimate, names, gestures, schema)
    flat = np.concatenate([column.ravel() for column in content.columns])
    known = np.isfinite(flat)
    shapes = tuple(column.shape for column in content.columns)
    form = _text_form(content.form, shapes, b"" if known.all() else known.tobytes())
    head = [] if schema == FIRST else [encoded(x) for x in _numbered(estimate, names)]
    return form.fill(flat, [*head, encoded(estimate.t)])


def to_json(
    estimate: Estimate,
    names: Names,
    gestures: Gestures | None = None,
    schema: int = FIRST,
) -> str:
    """`text_of`; ``gestures`` is fed with the estimate."""
    if gestures is not None:
        gestures.feed(estimate)
    return text_of(estimate, names, gestures, schema)


def check_schema(schema: int) -> None:
    """Raises StreamError for a version that is not in `SCHEMAS`."""
    if schema not in SCHEMAS:
        known = " or ".join(map(str, SCHEMAS))
        raise StreamError(notice("stream.schema", known=known, schema=schema))


def encoded(message: object) -> str:
    """Strict JSON without spaces."""
    return json.dumps(message, separators=(",", ":"), allow_nan=False)


class _Form(NamedTuple):
    """What a message has apart from numbers: with the same form and the same numbers known, the
    text between the numbers is the same."""

    schema: int
    side: str
    tracking: str
    points: tuple[str, ...]
    openxr: bool
    angles: tuple[str, ...]
    point_states: tuple[int, ...]
    angle_states: tuple[int, ...]
    gestures: tuple[str, ...] | None  # None: without gestures
    shown: tuple[str, ...]


class _Content(NamedTuple):
    """The columns are those that `_message` takes, (n,) or (n, 3) or (n, 4), NaN where lost."""

    form: _Form
    columns: list[Array]


def _content(e: Estimate, names: Names, gestures: Gestures | None, schema: int) -> _Content:
    joints = openxr_of(e, names) if names.openxr else None
    states, points = _points(e, joints)
    columns = [*points, *([] if schema == FIRST else _velocities(e, names, joints))]
    columns += _angles(e, schema)
    found: tuple[str, ...] | None = None
    shown: tuple[str, ...] = ()
    if gestures is not None:
        values, sure = gestures.values, gestures.confidences
        found, shown = tuple(values), tuple(sure)
        columns.append(np.array([*values.values()]))
        columns.append(np.round([*sure.values()], 3))
    form = _Form(
        schema,
        names.side,
        e.tracking.name.lower(),
        JOINTS if joints is not None else names.keypoints,
        joints is not None,
        names.angles,
        tuple(states.tolist()),
        tuple(e.angle_state.tolist()),
        found,
        shown,
    )
    return _Content(form, columns)


@lru_cache(maxsize=FORMS)
def _text_form(form: _Form, shapes: tuple[tuple[int, ...], ...], known: bytes) -> TextForm:
    """``shapes`` of the columns; ``known``: bools for all their numbers, empty if all are."""
    there = np.frombuffer(known, bool) if known else None
    return TextForm(
        _message(form, [HOLE] * (1 if form.schema == FIRST else 3), holes(shapes, there))
    )


def _message(f: _Form, head: Sequence[Any], columns: Sequence[Column]) -> dict[str, Any]:
    """``head``: the instant, from the second schema on after the number of the estimate in the
    stream and its instant on the wall clock."""
    rest, first = iter(columns), f.schema == FIRST
    numbered = {} if first else {"seq": head[0], "t_unix_ns": head[1]}
    last = "radius" if f.openxr else "sd"
    keys: tuple[str, ...] = ("position", "orientation_xyzw", last)
    states = [STATE_WORDS[Validity(x)] for x in f.point_states]
    points = _rows(f.points, ("state", *keys), [states, *_take(rest, len(keys))])
    out: dict[str, Any] = {"schema": f.schema, "side": f.side, **numbered}
    out |= {"t": head[-1], "tracking": f.tracking, "joints" if f.openxr else "keypoints": points}
    if not first:
        keys = VELOCITY_KEYS
        out["velocity"] = _rows(f.points, keys, _take(rest, len(keys)))
    keys = ANGLE_KEYS[:1] if first else ANGLE_KEYS
    states = [STATE_WORDS[Validity(x)] for x in f.angle_states]
    out["angles"] = _rows(f.angles, ("state", *keys), [states, *_take(rest, len(keys))])
    if f.gestures is not None:
        values, sure = _take(rest, 2)
        out["gestures"] = {
            "shown": list(f.shown),
            "values": dict(zip(f.gestures, values, strict=True)),
            "confidence": dict(zip(f.shown, sure, strict=True)),
        }
    return out


def _rows(
    names: Sequence[str], keys: Sequence[str], columns: Sequence[Column]
) -> dict[str, dict[str, Any]]:
    """An object for each name, with a value of each column under its key."""
    rows = zip(*columns, strict=True)
    return {n: dict(zip(keys, row, strict=True)) for n, row in zip(names, rows, strict=True)}


def _take(columns: Iterator[Column], count: int) -> list[Column]:
    return list(islice(columns, count))


def _numbered(estimate: Estimate, names: Names) -> tuple[int | None, int | None]:
    """The number of the estimate in the stream, and its instant on the wall clock."""
    return None if estimate.seq < 0 else estimate.seq, names.wall_ns(estimate.t)


def openxr_of(estimate: Estimate, names: Names) -> OpenXrHand:
    """OpenXR's joints of an estimate, for ``names`` that have their radii. Several outputs that
    need them share the result, which must not be changed."""
    key = names.keypoints, names.radii
    return _RECENT_JOINTS.get(
        estimate, key, lambda: to_openxr(estimate, names.keypoints, np.array(names.radii))
    )


def _points(e: Estimate, joints: OpenXrHand | None) -> tuple[IntArray, list[Array]]:
    """State, position, orientation, and sd of keypoints or radius of joints; NaN where lost."""
    if joints is not None:
        return joints.state, [joints.position, joints.orientation, joints.radius]
    lost = e.keypoint_state == Validity.LOST
    columns = [e.keypoints, e.keypoint_q, e.keypoint_sd]
    return e.keypoint_state, [_without(c, lost) for c in columns]


def _without(values: Array, lost: BoolArray) -> Array:
    """NaN in the rows that are lost."""
    if not lost.any():
        return values
    return np.asarray(np.where(lost if values.ndim == 1 else lost[:, None], np.nan, values))


def moving_points(
    e: Estimate, names: Names, joints: OpenXrHand | None = None
) -> PointMotion | None:
    """Velocities of keypoints in G, or of OpenXR's ``joints`` in its world, NaN where lost;
    None where the engine gives no velocities."""
    m = e.motion
    if m is None:
        return None
    if names.openxr:
        return openxr_motion(e, names.keypoints, joints or openxr_of(e, names))
    lost = e.keypoint_state == Validity.LOST
    columns = (m.linear, m.angular, m.linear_sd, m.angular_sd)
    return PointMotion(*(_without(column, lost) for column in columns))


def _velocities(e: Estimate, names: Names, joints: OpenXrHand | None) -> list[Array]:
    """Columns of `VELOCITY_KEYS` for each keypoint or joint; NaN where lost or not estimated."""
    moving = moving_points(e, names, joints)
    if moving is not None:
        return [moving.linear, moving.angular, moving.linear_sd, moving.angular_sd]
    count = len(names.keypoints if joints is None else JOINTS)
    vectors, values = np.full((count, 3), np.nan), np.full(count, np.nan)
    return [vectors, vectors, values, values]


def _angles(e: Estimate, schema: int) -> list[Array]:
    """Columns of `ANGLE_KEYS` for each angle; of the first schema the first one."""
    lost: BoolArray = e.angle_state == Validity.LOST
    if schema == FIRST:
        return [_without(e.angles, lost)]
    m, none = e.motion, np.full(len(e.angles), np.nan)
    found = [none] * 3 if m is None else [m.angle_sd, m.angle_rate, m.angle_rate_sd]
    return [_without(column, lost) for column in (e.angles, *found)]
