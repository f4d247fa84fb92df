"""Parses the JSON of `payload`, which UDP and WebSocket clients receive, to an Estimate."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.messages import Array, Estimate, Tracking, Validity
from tracker.streaming.payload import SCHEMAS
from tracker.streaming.publisher import Names


def from_json(text: str | bytes, names: Names, segments: int) -> Estimate:
    """The estimate in a message of our keypoints; ``segments`` is how many the hand has, whose
    poses are not sent (NaN). Raises GlovetrackError for anything else."""
    try:
        data = json.loads(text)
        if data["schema"] not in SCHEMAS or data["side"] != names.side:
            raise GlovetrackError(notice("stream.other_hand"))
        points = [data["keypoints"].get(n, {}) for n in names.keypoints]
        angles = [data["angles"].get(n, {}) for n in names.angles]
        return Estimate(
            t=float(data["t"]),
            tracking=Tracking[data["tracking"].upper()],
            keypoints=np.array([_numbers(p.get("position"), 3) for p in points]),
            keypoint_q=np.array([_numbers(p.get("orientation_xyzw"), 4) for p in points]),
            keypoint_state=np.array([_state(p) for p in points], np.int64),
            keypoint_sd=np.array([_numbers(p.get("sd"), 1) for p in points])[:, 0],
            angles=np.array([_numbers(a.get("value"), 1) for a in angles])[:, 0],
            angle_state=np.array([_state(a) for a in angles], np.int64),
            segment_R=np.full((segments, 3, 3), np.nan),
            segment_p=np.full((segments, 3), np.nan),
        )
    except (ValueError, KeyError, TypeError, AttributeError, IndexError) as error:
        raise GlovetrackError(notice("stream.not_ours", why=repr(error))) from error


def _numbers(value: Any, many: int) -> Array:
    """(many,); NaN where there is null."""
    if value is None:
        return np.full(many, np.nan)
    out = np.atleast_1d(np.array(value, float))
    if out.shape != (many,):
        raise ValueError(f"{many} numbers were expected")
    return out


def _state(entry: dict[str, Any]) -> int:
    return int(Validity[str(entry.get("state", "lost")).upper()])
