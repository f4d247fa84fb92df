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
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.base.notices import notice
from tracker.gestures.recogniser import GestureRecogniser
from tracker.hand.openxr import JOINTS, OpenXrHand, PointMotion, openxr_motion, to_openxr
from tracker.messages import Array, Estimate, Validity
from tracker.streaming.publisher import STATE_WORDS, Names, StreamError

BoolArray = NDArray[np.bool_]
SCHEMAS = FIRST, LATEST = 1, 2
DECIMALS = 6  # µm and µrad: below every error of a hand tracker, and half the bytes of a double


def payload(
    estimate: Estimate,
    names: Names,
    gestures: GestureRecogniser | None = None,
    schema: int = FIRST,
) -> dict[str, Any]:
    """The message as JSON-ready objects; ``gestures`` has been fed with the estimate."""
    first = schema == FIRST
    joints = openxr_of(estimate, names) if names.openxr else None
    return {
        "schema": schema,
        "side": names.side,
        **({} if first else _numbered(estimate, names)),
        "t": estimate.t,
        "tracking": estimate.tracking.name.lower(),
        **_points(estimate, names, joints),
        **({} if first else {"velocity": _velocities(estimate, names, joints)}),
        "angles": _angles(estimate, names, schema),
        **({} if gestures is None else {"gestures": _gestures(gestures)}),
    }


def to_json(
    estimate: Estimate,
    names: Names,
    gestures: GestureRecogniser | None = None,
    schema: int = FIRST,
) -> str:
    """The message as strict JSON without spaces (no NaN); ``gestures`` is fed with the estimate."""
    if gestures is not None:
        gestures.feed(estimate)
    return encoded(payload(estimate, names, gestures, schema))


def check_schema(schema: int) -> None:
    """Raises StreamError for a version that is not in `SCHEMAS`."""
    if schema not in SCHEMAS:
        known = " or ".join(map(str, SCHEMAS))
        raise StreamError(notice("stream.schema", known=known, schema=schema))


def encoded(message: dict[str, Any]) -> str:
    """Strict JSON without spaces."""
    return json.dumps(message, separators=(",", ":"), allow_nan=False)


def _numbered(estimate: Estimate, names: Names) -> dict[str, Any]:
    """The number of the estimate in the stream, and its instant on the wall clock."""
    seq = None if estimate.seq < 0 else estimate.seq
    return {"seq": seq, "t_unix_ns": names.wall_ns(estimate.t)}


def _gestures(found: GestureRecogniser) -> dict[str, Any]:
    """The shown gestures with their confidence, and the value of each; null where lost."""
    values = {n: _number(v, False) for n, v in found.values.items()}
    sure = {n: round(c, 3) for n, c in found.confidences.items()}
    return {"shown": list(found.active), "values": values, "confidence": sure}


def openxr_of(estimate: Estimate, names: Names) -> OpenXrHand:
    """OpenXR's joints of an estimate, for ``names`` that have their radii."""
    return to_openxr(estimate, names.keypoints, np.array(names.radii))


def _points(estimate: Estimate, names: Names, joints: OpenXrHand | None) -> dict[str, Any]:
    if joints is not None:
        return {"joints": _joints(joints)}
    return {"keypoints": _keypoints(estimate, names)}


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
    linear, angular = (np.where(lost[:, None], np.nan, v) for v in (m.linear, m.angular))
    sds = (np.where(lost, np.nan, sd) for sd in (m.linear_sd, m.angular_sd))
    return PointMotion(linear, angular, *sds)


def _velocities(estimate: Estimate, names: Names, joints: OpenXrHand | None) -> dict[str, Any]:
    """Velocities of each keypoint or joint; null where lost or not estimated."""
    moving = moving_points(estimate, names, joints)
    listed = names.keypoints if joints is None else JOINTS
    if moving is None:
        keys = ("linear", "angular", "sd", "angular_sd")
        return {n: dict.fromkeys(keys) for n in listed}
    columns = (
        _vectors(moving.linear),
        _vectors(moving.angular),
        _scalars(moving.linear_sd),
        _scalars(moving.angular_sd),
    )
    return {
        name: {"linear": linear, "angular": angular, "sd": sd, "angular_sd": angular_sd}
        for name, linear, angular, sd, angular_sd in zip(listed, *columns, strict=True)
    }


def _angles(e: Estimate, names: Names, schema: int) -> dict[str, Any]:
    """For each joint; from the second schema on with its rate and standard deviations."""
    lost: BoolArray = e.angle_state == Validity.LOST
    states = [STATE_WORDS[s] for s in e.angle_state.tolist()]
    values = _scalars(e.angles, lost)
    if schema == FIRST:
        rows = zip(names.angles, states, values, strict=True)
        return {name: {"state": state, "value": value} for name, state, value in rows}
    m = e.motion
    none: list[float | None] = [None] * len(states)
    sds = none if m is None else _scalars(m.angle_sd, lost)
    rates = none if m is None else _scalars(m.angle_rate, lost)
    rate_sds = none if m is None else _scalars(m.angle_rate_sd, lost)
    columns = zip(names.angles, states, values, sds, rates, rate_sds, strict=True)
    return {
        name: {"state": state, "value": value, "sd": sd, "rate": rate, "rate_sd": rate_sd}
        for name, state, value, sd, rate, rate_sd in columns
    }


def _joints(hand: OpenXrHand) -> dict[str, Any]:
    """OpenXR's joints."""
    lost: BoolArray = hand.state == Validity.LOST
    columns = (
        [STATE_WORDS[s] for s in hand.state.tolist()],
        _vectors(hand.position, lost),
        _vectors(hand.orientation, lost),
        _scalars(hand.radius, lost),
    )
    return {
        name: {"state": state, "position": p, "orientation_xyzw": q, "radius": radius}
        for name, state, p, q, radius in zip(JOINTS, *columns, strict=True)
    }


def _keypoints(e: Estimate, names: Names) -> dict[str, Any]:
    lost: BoolArray = e.keypoint_state == Validity.LOST
    columns = (
        [STATE_WORDS[s] for s in e.keypoint_state.tolist()],
        _vectors(e.keypoints, lost),
        _vectors(e.keypoint_q, lost),
        _scalars(e.keypoint_sd, lost),
    )
    return {
        name: {"state": state, "position": p, "orientation_xyzw": q, "sd": sd}
        for name, state, p, q, sd in zip(names.keypoints, *columns, strict=True)
    }


def _scalars(values: Array, lost: BoolArray | None = None) -> list[float | None]:
    """(n,) as numbers of a message; None where lost or not finite."""
    known: BoolArray = np.isfinite(values)
    known = known if lost is None else known & ~lost
    numbers = np.round(values, DECIMALS).tolist()
    if known.all():
        return list(numbers)
    return [x if k else None for x, k in zip(numbers, known.tolist(), strict=True)]


def _vectors(values: Array, lost: BoolArray | None = None) -> list[list[float] | None]:
    """(n, k) as lists of a message; None where lost or not finite."""
    known: BoolArray = np.asarray(np.isfinite(values).all(axis=1))
    known = known if lost is None else known & ~lost
    numbers = np.round(values, DECIMALS).tolist()
    if known.all():
        return list(numbers)
    return [v if k else None for v, k in zip(numbers, known.tolist(), strict=True)]


def _number(value: float, lost: bool) -> float | None:
    return None if lost or not np.isfinite(value) else round(value, DECIMALS)
