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

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from extensions.landmarks.points import CAMERA_OF_G, WRIST, landmarks_of
from glovetrack.conventions import MEDIAPIPE
from tracker.base.notices import Notice, notice
from tracker.messages import Array, Estimate
from tracker.streaming.connection import LOOPBACK, StreamError, option
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind
from tracker.streaming.text import HOLE, TextForm, holes

ASPECT = 4 / 3
INDEX = {"left": 0, "right": 1}


@dataclass(frozen=True)
class MediaPipeOptions:
    host: str = option(LOOPBACK, "destination")
    port: int = option(9002, "destination port")
    width: float = option(0.8, "width (m) that the virtual camera's image shows")


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
        self.name = notice("stream.to", stream="MediaPipe JSON", host=host, port=port)
        self._socket = DatagramSocket("mediapipe", host, port)

    def send(self, estimate: Estimate) -> None:
        self._socket.send(result_text(estimate, self._names, self._view).encode())

    def probe(self) -> Notice:
        return self._socket.probe(self.name)

    def close(self) -> None:
        self._socket.close()


def result_text(e: Estimate, names: Names, view: ImaginedView) -> str:
    """A HandLandmarkerResult as JSON with this hand, or with none where a landmark is lost."""
    hand, stamp = landmarks_of(e, names), str(round(1000 * e.t))
    if not hand.whole:
        return _form(names.side, False).fill(np.zeros(0), [stamp])
    seen = hand.points @ CAMERA_OF_G.T
    points = np.concatenate([view.project(seen), seen - seen.mean(axis=0)])
    return _form(names.side, True).fill(points.ravel(), [stamp])


@cache
def _form(side: str, whole: bool) -> TextForm:
    out: dict[str, Any] = {"timestampMs": HOLE}
    if not whole:
        return TextForm({**out, "landmarks": [], "worldLandmarks": [], "handednesses": []})
    (points,) = holes([(2 * len(MEDIAPIPE), 3)], None)
    landmarks = [dict(zip("xyz", point, strict=True)) for point in points]
    name = side.title()
    category = {"score": 1.0, "index": INDEX[side], "categoryName": name, "displayName": name}
    return TextForm(
        {
            **out,
            "landmarks": [landmarks[: len(MEDIAPIPE)]],
            "worldLandmarks": [landmarks[len(MEDIAPIPE) :]],
            "handednesses": [[category]],
        }
    )


def _publishers(options: MediaPipeOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    for names in hands:
        yield MediaPipePublisher(names, ImaginedView(options.width), options.host, options.port)


STREAM = StreamKind(
    name="mediapipe",
    title="MediaPipe (JSON)",
    options=MediaPipeOptions,
    make=_publishers,
    order=25,
)
