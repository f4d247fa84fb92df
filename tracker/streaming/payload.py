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
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from tracker.gestures.recogniser import GestureRecogniser
from tracker.hand.openxr import JOINTS, OpenXrHand, to_openxr
from tracker.messages import Array, Estimate, Validity
from tracker.streaming.publisher import STATE_WORDS, Names

SCHEMA = 1
DECIMALS = 6  # µm and µrad: below every error of a hand tracker, and half the bytes of a double


def payload(
    estimate: Estimate, names: Names, gestures: GestureRecogniser | None = None
) -> dict[str, Any]:
    """The message as JSON-ready objects; ``gestures`` has been fed with the estimate."""
    return {
        "schema": SCHEMA,
        "side": names.side,
        "t": estimate.t,
        "tracking": estimate.tracking.name.lower(),
        **_points(estimate, names),
        "angles": {n: _angle(estimate, i) for i, n in enumerate(names.angles)},
        **({} if gestures is None else {"gestures": _gestures(gestures)}),
    }


def to_json(estimate: Estimate, names: Names, gestures: GestureRecogniser | None = None) -> str:
    """The message as strict JSON without spaces (no NaN); ``gestures`` is fed with the estimate."""
    if gestures is not None:
        gestures.feed(estimate)
    said = payload(estimate, names, gestures)
    return json.dumps(said, separators=(",", ":"), allow_nan=False)


def _gestures(found: GestureRecogniser) -> dict[str, Any]:
    """Those that are shown and how surely, and how much of each there is; null where it is lost."""
    values = {n: _number(v, False) for n, v in found.values.items()}
    sure = {n: round(c, 3) for n, c in found.confidences.items()}
    return {"shown": list(found.active), "values": values, "confidence": sure}


def openxr_of(estimate: Estimate, names: Names) -> OpenXrHand:
    """OpenXR's joints of an estimate, for ``names`` that have their radii."""
    return to_openxr(estimate, names.keypoints, np.array(names.radii))


def _points(estimate: Estimate, names: Names) -> dict[str, Any]:
    if names.openxr:
        hand = openxr_of(estimate, names)
        return {"joints": {n: _joint(hand, i) for i, n in enumerate(JOINTS)}}
    return {"keypoints": {n: _keypoint(estimate, i) for i, n in enumerate(names.keypoints)}}


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
