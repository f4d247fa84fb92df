"""Hands in the form in which MediaPipe's Hand Landmarker returns them, as JSON.

Keys are those of its results in JavaScript (ai.google.dev/edge/mediapipe, HandLandmarkerResult):

    {"timestampMs": 12340, "landmarks": [[{"x", "y", "z"}, ...]],
     "worldLandmarks": [[{"x", "y", "z"}, ...]],
     "handednesses": [[{"score", "index", "categoryName", "displayName"}]]}

worldLandmarks are in m about the mean of the landmarks, with a camera's axes: x right, y down, z
away. The camera looks along G's x. landmarks are in its image: x and y from 0 to 1 across
``width`` m and three quarters of it, z as x, from the wrist. A hand with a lost landmark is absent.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

import numpy as np

from extensions.landmarks.points import CAMERA_OF_G, WRIST, landmarks_of
from tracker.base.notices import Notice, notice
from tracker.messages import Array, Estimate
from tracker.streaming.connection import StreamError
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.publisher import Names

ASPECT = 4 / 3
DECIMALS = 6
INDEX = {"left": 0, "right": 1}


@dataclass(frozen=True)
class ImaginedView:
    """For the imagined camera: ``width`` m that its image shows."""

    width: float = 0.8

    def __post_init__(self) -> None:
        if not self.width > 0:
            raise StreamError(notice("option.positive", option="width"))

    def project(self, points: Array) -> Array:
        """(21, 3) image coordinates of points (21, 3) m in the camera's axes."""
        size = np.array([self.width, self.width / ASPECT, self.width])
        centre = np.array([0.5, 0.5, -points[WRIST, 2] / self.width])
        return np.asarray(points / size + centre)


class MediaPipePublisher:
    """One datagram of JSON for each estimate of a hand."""

    def __init__(self, names: Names, view: ImaginedView, host: str, port: int) -> None:
        self._names, self._view = names, view
        self.name = f"MediaPipe JSON to {host}:{port}"
        self._socket = DatagramSocket("mediapipe", host, port)

    def send(self, estimate: Estimate) -> None:
        result = hand_result(estimate, self._names, self._view)
        self._socket.send(json.dumps(result, separators=(",", ":"), allow_nan=False).encode())

    def probe(self) -> Notice:
        return self._socket.probe(self.name)

    def close(self) -> None:
        self._socket.close()


def hand_result(e: Estimate, names: Names, view: ImaginedView) -> dict[str, Any]:
    """A HandLandmarkerResult with this hand, or with none where a landmark is lost."""
    hand = landmarks_of(e, names)
    out: dict[str, Any] = {"timestampMs": round(1000 * e.t)}
    if not hand.whole:
        return {**out, "landmarks": [], "worldLandmarks": [], "handednesses": []}
    seen = hand.points @ CAMERA_OF_G.T
    name = names.side.title()
    category = {"score": 1.0, "index": INDEX[names.side], "categoryName": name, "displayName": name}
    return {
        **out,
        "landmarks": [_points(view.project(seen))],
        "worldLandmarks": [_points(seen - seen.mean(axis=0))],
        "handednesses": [[category]],
    }


def _points(points: Array) -> list[dict[str, float]]:
    return [
        {axis: round(x, DECIMALS) for axis, x in zip("xyz", row, strict=True)}
        for row in points.tolist()
    ]
