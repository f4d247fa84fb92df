"""MediaPipe's results as JSON, read by a plain socket and compared with geometry."""

from __future__ import annotations

import contextlib
import json
import socket
from typing import Any

import numpy as np

from extensions.landmarks.mediapipe import ImaginedView, result_text
from glovetrack.conventions import MEDIAPIPE
from tests.notices import raises
from tests.streaming.recorded_hand import RecordedHand, assert_near
from tracker.messages import Estimate
from tracker.streaming.connection import LOOPBACK
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.registry import StreamSettings, open_streams, with_streams


def rows(points: list[dict[str, float]]) -> np.ndarray:
    return np.array([[p["x"], p["y"], p["z"]] for p in points])


def test_a_program_gets_world_landmarks_and_an_image(recorded: RecordedHand) -> None:
    """Of each instant of a recording; points of the image by its scale at the wrist's depth."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind((LOOPBACK, 0))
        client.settimeout(60)
        table = {"mediapipe": True, "mediapipe_port": client.getsockname()[1]}
        (out,) = open_streams(StreamSettings(table), [recorded.names])["mediapipe"]
        with contextlib.closing(out):
            for e in recorded.estimates:
                out.send(e)
                check(json.loads(client.recv(65536)), recorded, e)


def check(result: dict[str, Any], recorded: RecordedHand, e: Estimate) -> None:
    points = np.array([recorded.points(e)[name] for name in MEDIAPIPE])
    wanted = np.stack([-points[:, 1], -points[:, 2], points[:, 0]], 1)  # right, down, away
    assert_near(rows(result["worldLandmarks"][0]), wanted - wanted.mean(axis=0))
    image = rows(result["landmarks"][0]) - [0.5, 0.5, 0.0]
    assert_near(image * [0.8, 0.6, 0.8], wanted - [0, 0, wanted[0, 2]])
    (category,) = result["handednesses"][0]
    assert (category["categoryName"], category["index"]) == ("Right", 1)
    assert result["timestampMs"] == round(1000 * e.t)


def test_a_hand_with_a_lost_landmark_is_absent(make_estimate, names: Names) -> None:
    result = json.loads(result_text(make_estimate(lost=("ring_tip",)), names, ImaginedView()))
    assert result["landmarks"] == result["worldLandmarks"] == result["handednesses"] == []


def test_an_image_has_a_width(names: Names) -> None:
    with raises(StreamError, "option.positive"):
        open_streams(with_streams(StreamSettings(), "mediapipe?width=0"), [names])
