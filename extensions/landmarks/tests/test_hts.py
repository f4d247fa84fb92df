"""Lines of the Hand Tracking Streamer, read by hand-tracking-sdk."""

from __future__ import annotations

import contextlib
import socket
import threading
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

pytest.importorskip("hand_tracking_sdk", reason="hand-tracking-sdk is not installed")
from hand_tracking_sdk.client import HTSClient, HTSClientConfig, StreamOutput, TransportMode
from hand_tracking_sdk.convert import unity_left_to_flu_position, unity_left_to_flu_rotation_matrix
from hand_tracking_sdk.parser import parse_line
from hand_tracking_sdk.transport import (
    TCPClientConfig,
    TCPClientLineReceiver,
    TCPServerConfig,
    TCPServerLineReceiver,
    UDPLineReceiver,
    UDPReceiverConfig,
)

from extensions.landmarks.hts import hts_lines
from glovetrack.conventions import MEDIAPIPE
from tests.notices import raises
from tests.streaming.posed_hand import posed_estimate, side_names
from tests.streaming.recorded_hand import RecordedHand, assert_near, assert_parallel
from tracker.base.clock import ClockAnchor
from tracker.messages import Tracking
from tracker.streaming.connection import LOOPBACK
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.registry import StreamSettings, open_streams, with_streams


def opened(names: Names, port: int, **options: object):
    """The stream as a user enables it."""
    table = {"hts": True, "hts_port": port} | {f"hts_{k}": v for k, v in options.items()}
    return open_streams(StreamSettings(table), [names])["hts"][0]


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind((LOOPBACK, 0))
        return int(probe.getsockname()[1])


def in_flu(wrist, landmarks) -> tuple[np.ndarray, Rotation]:
    """(21, 3) m of the landmarks and the wrist's rotation, with x forward, y left and z up, by the
    library's own conversions: G for a hand whose camera looks along G's x."""
    q = Rotation.from_quat([wrist.qx, wrist.qy, wrist.qz, wrist.qw])
    p = q.apply(np.array(landmarks.points)) + [wrist.x, wrist.y, wrist.z]
    R = unity_left_to_flu_rotation_matrix(wrist.qx, wrist.qy, wrist.qz, wrist.qw)
    return np.array([unity_left_to_flu_position(*row) for row in p]), Rotation.from_matrix(R)


def test_the_library_reads_a_recording(recorded: RecordedHand) -> None:
    receiver = UDPLineReceiver(UDPReceiverConfig(host=LOOPBACK, port=0))
    with receiver:
        out = opened(recorded.names, receiver.local_address[1], numbered=True)
        for i, e in enumerate(recorded.estimates):
            out.send(replace(e, seq=i))
            wrist, landmarks = (parse_line(receiver.recv_line()) for _ in range(2))
            assert (wrist.side.value, wrist.debug.source_frame_seq) == ("Right", i)
            assert abs(wrist.debug.source_ts_ns - recorded.unix_ns(e)) < 1000
            points, turn = in_flu(wrist.data, landmarks.data)
            wanted = recorded.points(e)
            assert_near(points, np.array([wanted[n] for n in MEDIAPIPE]))
            assert_parallel(turn, recorded.turns(e)["wrist"])
        out.close()


@pytest.mark.parametrize("side", ["right", "left"])
def test_the_librarys_client_gets_frames_of_either_hand(side: str) -> None:
    names = side_names(side)
    e, port = posed_estimate(names, 5), free_port()
    config = HTSClientConfig(
        transport_mode=TransportMode.UDP,
        host=LOOPBACK,
        port=port,
        timeout_s=60.0,
        output=StreamOutput.FRAMES,
    )
    client = HTSClient(config)
    events = client.iter_events()
    out = opened(names, port)
    stop = threading.Event()

    def send() -> None:
        while not stop.wait(0.02):
            out.send(e)

    sender = threading.Thread(target=send)
    sender.start()
    try:
        frame = next(events)
    finally:
        stop.set()
        sender.join()
        out.close()
        events.close()
    assert frame.side.value == side.title()
    points, turn = in_flu(frame.wrist, frame.landmarks)
    assert_near(points, e.keypoints[[names.keypoints.index(n) for n in MEDIAPIPE]])
    assert_parallel(turn, Rotation.from_quat(e.keypoint_q[0]))


def test_it_connects_to_a_server(names: Names, make_estimate) -> None:
    config = TCPServerConfig(host=LOOPBACK, port=0, accept_timeout_s=60, read_timeout_s=60)
    with TCPServerLineReceiver(config) as server:
        out = opened(names, server.local_address[1], transport="tcp")
        with contextlib.closing(out):
            out.send(make_estimate())
            assert parse_line(server.recv_line()).kind.value == "wrist"
            assert parse_line(server.recv_line()).kind.value == "landmarks"
            assert out.clients == 1


def test_without_a_server_it_fails_and_tries_again(names: Names, make_estimate) -> None:
    out = opened(names, free_port(), transport="tcp")
    with contextlib.closing(out):
        for _ in range(2):
            with raises(StreamError, "stream.no_connection", "stream.not_connected"):
                out.send(make_estimate())
        assert out.clients == 0


def test_programs_connect_to_its_server(names: Names, make_estimate) -> None:
    port = free_port()
    out = opened(names, port, transport="server")
    config = TCPClientConfig(host=LOOPBACK, port=port, read_timeout_s=60)
    with contextlib.closing(out), TCPClientLineReceiver(config) as client:
        out.send(make_estimate())
        assert parse_line(client.recv_line()).kind.value == "wrist"
        assert out.clients == 1


def test_what_is_lost_is_not_sent(names: Names, make_estimate) -> None:
    (wrist,) = hts_lines(make_estimate(lost=("index_tip",)), names, False)
    assert wrist.startswith("Right wrist:, ")
    lost = make_estimate(lost=names.keypoints, tracking=Tracking.LOST)
    assert hts_lines(lost, names, False) == []


def test_the_lines_have_the_documented_form(names: Names, make_estimate) -> None:
    dated = replace(names, anchor=ClockAnchor(1_000, 0))
    wrist, landmarks = hts_lines(replace(make_estimate(), seq=12), dated, True)
    assert wrist.startswith("Right wrist | f=12 | t=1250001000:, ")
    assert len(wrist.split(",")) == 8 and len(landmarks.split(",")) == 64
    assert landmarks.startswith("Right landmarks | f=12 | t=1250001000:, 0.000000, 0.000000, ")


def test_an_unknown_transport_is_refused(names: Names) -> None:
    with raises(StreamError, "option.choice", option="transport"):
        open_streams(with_streams(StreamSettings(), "hts?transport=serial"), [names])
