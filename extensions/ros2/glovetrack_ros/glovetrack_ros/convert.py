"""Messages of ROS 2 from an estimate of Glovetrack's stream, as dictionaries of their fields.

Nothing of ROS is imported: a node sets these fields on messages, and other programs on DDS.
Stamps are those of the estimate. Units and axes are those of REP 103: m, rad, z up, x forward.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from typing import Any, NamedTuple

UNKNOWN = -1.0
"""First rotational variance of a pose: the stream has no standard deviation of orientations."""
WARN, OK, STALE = 1, 0, 3
LEVEL = {"tracking": OK, "coasting": WARN, "lost": WARN, "searching": STALE}


class Made(NamedTuple):
    """A message for a topic: ``type`` such as ``sensor_msgs/msg/JointState``."""

    topic: str
    type: str
    fields: dict[str, Any]


def messages(estimate: dict[str, Any], frame: str = "world") -> Iterator[Made]:
    """All messages of an estimate (`glovetrack schema stream`, schema 2 with own joints)."""
    root, at = f"hand/{estimate['side']}", stamp(estimate)
    yield Made(f"{root}/joint_states", "sensor_msgs/msg/JointState", joint_state(estimate, at))
    yield Made(f"{root}/keypoints", "geometry_msgs/msg/PoseArray", pose_array(estimate, at, frame))
    yield Made("tf", "tf2_msgs/msg/TFMessage", {"transforms": transforms(estimate, at, frame)})
    wrist = estimate["keypoints"]["wrist"]
    if wrist["position"] is not None:
        pose = {"header": header(at, frame), "pose": pose_with_covariance(wrist)}
        yield Made(f"{root}/wrist", "geometry_msgs/msg/PoseWithCovarianceStamped", pose)
    moving = estimate.get("velocity", {}).get("wrist")
    if moving is not None and moving["linear"] is not None:
        twist = {"header": header(at, frame), "twist": twist_with_covariance(moving)}
        yield Made(f"{root}/twist", "geometry_msgs/msg/TwistWithCovarianceStamped", twist)
    yield Made("diagnostics", "diagnostic_msgs/msg/DiagnosticArray", diagnostics(estimate, at))


def stamp(estimate: dict[str, Any]) -> dict[str, int]:
    """The estimate's instant; the current time for a stream without a wall clock."""
    ns = estimate.get("t_unix_ns")
    sec, nanosec = divmod(time.time_ns() if ns is None else int(ns), 10**9)
    return {"sec": sec, "nanosec": nanosec}


def header(at: dict[str, int], frame: str) -> dict[str, Any]:
    """A std_msgs/Header."""
    return {"stamp": at, "frame_id": frame}


def joint_state(estimate: dict[str, Any], at: dict[str, int]) -> dict[str, Any]:
    """Joints whose angle is known, with their rates where all are known."""
    known = {n: a for n, a in estimate["angles"].items() if a["value"] is not None}
    rates = [a.get("rate") for a in known.values()]
    return {
        "header": header(at, ""),
        "name": list(known),
        "position": [float(a["value"]) for a in known.values()],
        "velocity": [] if None in rates else [float(r) for r in rates],
        "effort": [],
    }


def pose(keypoint: dict[str, Any]) -> dict[str, Any]:
    """A geometry_msgs/Pose; NaN where the keypoint is lost."""
    p = keypoint["position"] or [math.nan] * 3
    q = keypoint["orientation_xyzw"] or [math.nan] * 4
    return {
        "position": dict(zip("xyz", map(float, p), strict=True)),
        "orientation": dict(zip("xyzw", map(float, q), strict=True)),
    }


def pose_array(estimate: dict[str, Any], at: dict[str, int], frame: str) -> dict[str, Any]:
    """All keypoints in the stream's order."""
    return {
        "header": header(at, frame),
        "poses": [pose(k) for k in estimate["keypoints"].values()],
    }


def transforms(estimate: dict[str, Any], at: dict[str, int], frame: str) -> list[dict[str, Any]]:
    """A frame ``SIDE_KEYPOINT`` for each keypoint that is not lost."""
    out = []
    for name, keypoint in estimate["keypoints"].items():
        if keypoint["position"] is None:
            continue
        found = pose(keypoint)
        moved = {"translation": found["position"], "rotation": found["orientation"]}
        child = f"{estimate['side']}_{name}"
        out.append({"header": header(at, frame), "child_frame_id": child, "transform": moved})
    return out


def pose_with_covariance(keypoint: dict[str, Any]) -> dict[str, Any]:
    """The pose with its variances of position, m²; `UNKNOWN` for the orientation."""
    variance = float(keypoint["sd"]) ** 2
    diagonal = [variance] * 3 + [UNKNOWN, 0.0, 0.0]
    return {"pose": pose(keypoint), "covariance": _diagonal(diagonal)}


def twist_with_covariance(moving: dict[str, Any]) -> dict[str, Any]:
    """Velocities in the fixed frame, m/s and rad/s, with their variances."""
    diagonal = [float(moving["sd"]) ** 2] * 3 + [float(moving["angular_sd"]) ** 2] * 3
    twist = {
        name: dict(zip("xyz", map(float, moving[name]), strict=True))
        for name in ("linear", "angular")
    }
    return {"twist": twist, "covariance": _diagonal(diagonal)}


def diagnostics(estimate: dict[str, Any], at: dict[str, int]) -> dict[str, Any]:
    """The state of tracking, and how many keypoints are measured, inferred and lost."""
    states = [k["state"] for k in estimate["keypoints"].values()]
    counts = {s: str(states.count(s)) for s in ("measured", "inferred", "lost")}
    status = {
        "level": bytes([LEVEL.get(estimate["tracking"], WARN)]),
        "name": f"glovetrack: {estimate['side']} hand",
        "message": estimate["tracking"],
        "hardware_id": f"{estimate['side']} glove",
        "values": [{"key": k, "value": v} for k, v in counts.items()],
    }
    return {"header": header(at, ""), "status": [status]}


def _diagonal(values: list[float]) -> list[float]:
    return [values[i] if i == j else 0.0 for i in range(6) for j in range(6)]
