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

from tracker.gestures.recogniser import GestureRecogniser
from tracker.hand.openxr import JOINTS, OpenXrHand, PointMotion, openxr_motion, to_openxr
from tracker.messages import Array, Estimate, Validity
from tracker.streaming.publisher import STATE_WORDS, Names, StreamError

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
    angle = _angle if first else _moving_angle
    joints = openxr_of(estimate, names) if names.openxr else None
    return {
        "schema": schema,
        "side": names.side,
        **({} if first else _numbered(estimate, names)),
        "t": estimate.t,
        "tracking": estimate.tracking.name.lower(),
        **_points(estimate, names, joints),
        **({} if first else {"velocity": _velocities(estimate, names, joints)}),
        "angles": {n: angle(estimate, i) for i, n in enumerate(names.angles)},
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
        raise StreamError(f"The schema of JSON messages is {known}, not {schema}.")


def encoded(message: dict[str, Any]) -> str:
    """Strict JSON without spaces."""
    return json.dumps(message, separators=(",", ":"), allow_nan=False)


def _numbered(estimate: Estimate, names: Names) -> dict[str, Any]:
    """The number among a stream's estimates of this hand, and the instant on the wall clock."""
    seq = None if estimate.seq < 0 else estimate.seq
    return {"seq": seq, "t_unix_ns": names.wall_ns(estimate.t)}


def _gestures(found: GestureRecogniser) -> dict[str, Any]:
    """Those that are shown and how surely, and how much of each there is; null where it is lost."""
    values = {n: _number(v, False) for n, v in found.values.items()}
    sure = {n: round(c, 3) for n, c in found.confidences.items()}
    return {"shown": list(found.active), "values": values, "confidence": sure}


def openxr_of(estimate: Estimate, names: Names) -> OpenXrHand:
    """OpenXR's joints of an estimate, for ``names`` that have their radii."""
    return to_openxr(estimate, names.keypoints, np.array(names.radii))


def _points(estimate: Estimate, names: Names, joints: OpenXrHand | None) -> dict[str, Any]:
    if joints is not None:
        return {"joints": {n: _joint(joints, i) for i, n in enumerate(JOINTS)}}
    return {"keypoints": {n: _keypoint(estimate, i) for i, n in enumerate(names.keypoints)}}


def moving_points(
    e: Estimate, names: Names, joints: OpenXrHand | None = None
) -> PointMotion | None:
    """How each keypoint moves in G, or each of OpenXR's ``joints`` in its world, NaN where lost;
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
    """Of each keypoint or joint; null where it is lost or the engine gives none."""
    moving = moving_points(estimate, names, joints)
    listed = names.keypoints if joints is None else JOINTS
    return {n: _velocity(moving, i) for i, n in enumerate(listed)}


def _velocity(motion: PointMotion | None, i: int) -> dict[str, Any]:
    if motion is None:
        return dict.fromkeys(("linear", "angular", "sd", "angular_sd"))
    return {
        "linear": _numbers(motion.linear[i], False),
        "angular": _numbers(motion.angular[i], False),
        "sd": _number(float(motion.linear_sd[i]), False),
        "angular_sd": _number(float(motion.angular_sd[i]), False),
    }


def _moving_angle(e: Estimate, i: int) -> dict[str, Any]:
    lost, motion = e.angle_state[i] == Validity.LOST, e.motion
    if motion is None:
        return {**_angle(e, i), "sd": None, "rate": None, "rate_sd": None}
    return {
        **_angle(e, i),
        "sd": _number(float(motion.angle_sd[i]), lost),
        "rate": _number(float(motion.angle_rate[i]), lost),
        "rate_sd": _number(float(motion.angle_rate_sd[i]), lost),
    }


def _joint(hand: OpenXrHand, i: int) -> dict[str, Any]:
    state = Validity(int(hand.state[i]))
    lost = state == Validity.LOST
    return {
        "state": STATE_WORDS[state],
        "position": _numbers(hand.position[i], lost),
        "orientation_xyzw": _numbers(hand.orientation[i], lost),
        "radius": _number(float(hand.radius[i]), lost),
    }


def _keypoint(e: Estimate, i: int) -> dict[str, Any]:
    state = Validity(int(e.keypoint_state[i]))
    lost = state == Validity.LOST
    return {
        "state": STATE_WORDS[state],
        "position": _numbers(e.keypoints[i], lost),
        "orientation_xyzw": _numbers(e.keypoint_q[i], lost),
        "sd": _number(float(e.keypoint_sd[i]), lost),
    }


def _angle(e: Estimate, i: int) -> dict[str, Any]:
    state = Validity(int(e.angle_state[i]))
    return {
        "state": STATE_WORDS[state],
        "value": _number(float(e.angles[i]), state == Validity.LOST),
    }


def _number(value: float, lost: bool) -> float | None:
    return None if lost or not np.isfinite(value) else round(value, DECIMALS)


def _numbers(values: Array, lost: bool) -> list[float] | None:
    if lost or not np.isfinite(values).all():
        return None
    return [round(v, DECIMALS) for v in values.tolist()]
