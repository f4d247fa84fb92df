"""MediaPipe's results as JSON, read by a plain socket and compared with geometry."""

from __future__ import annotations

import contextlib
import json
import socket

import numpy as np
from numpy.testing import assert_allclose

from extensions.landmarks.mediapipe import ImaginedView, result_text
from glovetrack.conventions import MEDIAPIPE
from tests.notices import raises
from tracker.streaming.connection import LOOPBACK
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.registry import StreamSettings, open_streams, with_streams


def rows(points: list[dict[str, float]]) -> np.ndarray:
    return np.array([[p["x"], p["y"], p["z"]] for p in points])


def test_a_program_gets_world_landmarks_and_an_image(make_estimate, names: Names) -> None:
    e = make_estimate()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind((LOOPBACK, 0))
        client.settimeout(2)
        table = {"mediapipe": True, "mediapipe_port": client.getsockname()[1]}
        (out,) = open_streams(StreamSettings(table), [names])["mediapipe"]
        with contextlib.closing(out):
            out.send(e)
            result = json.loads(client.recv(65536))
    points = e.keypoints[[names.keypoints.index(n) for n in MEDIAPIPE]]
    right, down, away = -points[:, 1], -points[:, 2], points[:, 0]
    world = rows(result["worldLandmarks"][0])
    assert_allclose(world, np.stack([right, down, away], 1) - world_mean(points), atol=2e-6)
    image = rows(result["landmarks"][0])
    assert_allclose(image[:, 0], 0.5 + right / 0.8, atol=2e-6)
    assert_allclose(image[:, 1], 0.5 + down / 0.6, atol=2e-6)
    assert_allclose(image[:, 2], (away - away[0]) / 0.8, atol=2e-6)
    (category,) = result["handednesses"][0]
    assert (category["categoryName"], category["index"]) == ("Right", 1)
    assert result["timestampMs"] == 1250


def world_mean(points: np.ndarray) -> np.ndarray:
    x, y, z = points.mean(axis=0)
    return np.array([-y, -z, x])


def test_a_hand_with_a_lost_landmark_is_absent(make_estimate, names: Names) -> None:
    result = json.loads(result_text(make_estimate(lost=("ring_tip",)), names, ImaginedView()))
    assert result["landmarks"] == result["worldLandmarks"] == result["handednesses"] == []


def test_an_image_has_a_width(names: Names) -> None:
    with raises(StreamError, "option.positive"):
        open_streams(with_streams(StreamSettings(), "mediapipe?width=0"), [names])
