"""The JSON form and UDP, read by a plain socket."""

from __future__ import annotations

import json
import socket
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from extensions.applications.tests.hands import GLOVE, HAND, estimates
from tests.notices import raises
from tracker.gestures.values import GESTURES
from tracker.messages import Tracking
from tracker.simulation.scripted import Key
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.udp import UdpPublisher


def test_every_row_is_under_its_own_name(make_estimate, names: Names) -> None:
    e = make_estimate(angles={"index_pip_flexion": 0.7})
    read = json.loads(to_json(e, names))
    assert (read["t"], read["tracking"], read["side"]) == (1.25, "tracking", "right")
    assert tuple(read["keypoints"]) == names.keypoints
    assert tuple(read["angles"]) == names.angles
    for i, name in enumerate(names.keypoints):
        assert_allclose(read["keypoints"][name]["position"], e.keypoints[i], atol=1e-6)
        assert_allclose(read["keypoints"][name]["orientation_xyzw"], e.keypoint_q[i], atol=1e-6)
    assert read["angles"]["index_pip_flexion"] == {"state": "measured", "value": 0.7}


def test_lost_is_null_and_not_zero(make_estimate, names: Names) -> None:
    e = make_estimate(lost=("thumb_tip", "thumb_ip_flexion"))
    read = json.loads(to_json(e, names))
    assert read["keypoints"]["thumb_tip"] == {
        "state": "lost",
        "position": None,
        "orientation_xyzw": None,
        "sd": None,
    }
    assert read["angles"]["thumb_ip_flexion"] == {"state": "lost", "value": None}
    assert read["keypoints"]["thumb_ip"]["position"] is not None


def test_numbers_of_a_lost_row_are_not_sent(make_estimate, names: Names) -> None:
    e = make_estimate()
    state = np.array(e.keypoint_state)
    state[0] = 0  # lost, though a finite position is still in the row
    read = json.loads(to_json(replace(e, keypoint_state=state), names))
    assert read["keypoints"]["wrist"]["position"] is None


def test_a_searching_hand_is_strict_json(make_estimate, names: Names) -> None:
    e = make_estimate(lost=(*names.keypoints, *names.angles), tracking=Tracking.SEARCHING)
    text = to_json(e, names)
    assert "NaN" not in text
    assert json.loads(text)["tracking"] == "searching"


def test_udp_arrives_as_one_datagram_per_estimate(make_estimate, names: Names) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind(("127.0.0.1", 0))
        client.settimeout(60)
        out = UdpPublisher(names, port=client.getsockname()[1])
        for t in (1.0, 1.01):
            out.send(make_estimate(t))
        assert [json.loads(client.recv(65536))["t"] for _ in range(2)] == [1.0, 1.01]
        out.close()


def test_udp_without_a_listener_continues(make_estimate, names: Names) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind(("127.0.0.1", 0))
        port = client.getsockname()[1]
    out = UdpPublisher(names, port=port)
    for _ in range(5):  # an ICMP "port unreachable" must not be raised as an error
        out.send(make_estimate())
    out.close()


@pytest.mark.parametrize(
    ("host", "port", "code"),
    [
        ("no such host", 1, "stream.no_route"),
        ("127.0.0.1", 70000, "stream.port_range"),
        ("127.0.0.1", 0, "stream.port_range"),
    ],
)
def test_udp_to_an_invalid_address_is_reported(
    names: Names, host: str, port: int, code: str
) -> None:
    with raises(StreamError, code):
        UdpPublisher(names, host, port)


def test_gestures_are_sent_with_their_values() -> None:
    names = Names.of(HAND, GLOVE)
    gestures, here = names.recogniser(), (0.17, 0.0, 0.1)
    assert gestures is not None
    for estimate in estimates([Key(0.0, "fist", here), Key(0.2, "fist", here)]):
        data = json.loads(to_json(estimate, names, gestures))
    assert data["gestures"]["shown"] == ["fist"]
    assert data["gestures"]["values"]["fist"] == 1.0
    assert set(data["gestures"]["values"]) == set(GESTURES)
    lost = replace(estimate, tracking=Tracking.SEARCHING, t=estimate.t + 1.0)
    data = json.loads(to_json(lost, names, gestures))
    assert data["gestures"] == {"shown": [], "values": dict.fromkeys(GESTURES), "confidence": {}}
