"""The wearer's hand as teleoperation needs it: the palm's pose and the fingertips in its frame."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.geometry import so3
from tracker.hand.names import CHAINS, KEYPOINTS
from tracker.messages import Array, Estimate, IntArray, Tracking, Validity

FINGERS = tuple(CHAINS)
"""Order of all rows in this package, thumb first."""
PARTS = {f: [k for k in KEYPOINTS if k.startswith(f"{f}_")] for f in FINGERS}
ORIGIN = "middle_mcp"
"""The keypoint that is used as the palm's position."""


@dataclass(frozen=True, eq=False)
class WearerHand:
    """One instant. R_GB (3, 3) and p_G (3,) m of the palm at its middle knuckle; knuckle and tip
    (5, 3) m from there, in B; length (5,) m of each finger from knuckle to tip, along its bones.

    Rows of fingers that are not ``known`` (5,) are NaN. ``located``: the palm's pose is known.
    """

    t: float
    located: bool
    R_GB: Array
    p_G: Array
    known: NDArray[np.bool_]
    knuckle: Array
    tip: Array
    length: Array


def hand_from_estimate(estimate: Estimate, keypoint_names: Sequence[str]) -> WearerHand:
    """Hand of an estimate whose rows are ``keypoint_names``."""
    points = {
        name: (estimate.keypoints[i], estimate.keypoint_q[i], estimate.keypoint_state[i])
        for i, name in enumerate(keypoint_names)
    }
    tracked = estimate.tracking in (Tracking.TRACKING, Tracking.COASTING)
    rows = np.array([points[k][0] if k in points else [np.nan] * 3 for k in KEYPOINTS])
    state = np.array([points[k][2] if k in points else 0 for k in KEYPOINTS], np.int64)
    return hand_from_keypoints(estimate.t, tracked, rows, state, points["wrist"][1])


def hand_from_message(message: Mapping[str, Any]) -> WearerHand:
    """Hand of a message of the live streams (`tracker.streaming.payload`).

    Raises ValueError if the message is not one.
    """
    try:
        keypoints = message["keypoints"]
        found = [keypoints.get(k) for k in KEYPOINTS]
        rows = np.array([[np.nan] * 3 if not k else k["position"] or [np.nan] * 3 for k in found])
        state = np.array([0 if not k or k["state"] == "lost" else 1 for k in found], np.int64)
        q = np.array(keypoints["wrist"]["orientation_xyzw"] or [np.nan] * 4, float)
        tracked = message["tracking"] in ("tracking", "coasting")
        if rows.shape != (len(KEYPOINTS), 3) or q.shape != (4,):
            raise ValueError("positions have three numbers")
        return hand_from_keypoints(float(message["t"]), tracked, rows.astype(float), state, q)
    except (KeyError, TypeError, AttributeError) as error:
        raise ValueError(f"not a message of the live streams: {error}") from error


def hand_from_keypoints(
    t: float, tracked: bool, rows: Array, state: IntArray, q: Array
) -> WearerHand:
    """Hand of keypoints (21, 3) m in G and their states (21,), in the order of `KEYPOINTS`, and
    the dorsum's q_GB (4,) xyzw. ``tracked``: the hand's position is known."""
    there = (state != Validity.LOST) & np.isfinite(rows).all(axis=1)
    names = list(KEYPOINTS)
    origin = names.index(ORIGIN)
    located = tracked and bool(there[origin] and there[0] and np.isfinite(q).all())
    R = so3.matrix_from_quat(q) if located else np.full((3, 3), np.nan)
    known, knuckle, tip = np.zeros(5, bool), np.full((5, 3), np.nan), np.full((5, 3), np.nan)
    length = np.full(5, np.nan)
    for i, finger in enumerate(FINGERS):
        chain = [names.index(k) for k in PARTS[finger]]
        known[i] = located and bool(there[chain].all())
        if known[i]:
            knuckle[i] = R.T @ (rows[chain[0]] - rows[origin])
            tip[i] = R.T @ (rows[chain[-1]] - rows[origin])
            length[i] = np.linalg.norm(np.diff(rows[chain], axis=0), axis=1).sum()
    return WearerHand(t, located, R, rows[origin].copy(), known, knuckle, tip, length)
