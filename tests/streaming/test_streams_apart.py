"""Outputs in a process of their own: what a program receives, and what the window learns of it."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import sys
from collections.abc import Iterator
from dataclasses import fields, replace

import numpy as np
import pytest

from tests.notices import raises
from tests.streaming.moving_hand import turning
from tracker.base.clock import ClockAnchor
from tracker.base.notices import Notice
from tracker.streaming.apart import ApartFeed, DirectFeed, StreamsProcess
from tracker.streaming.apart_estimate import packed, unpacked
from tracker.streaming.connection import StreamError
from tracker.streaming.payload import LATEST, to_json
from tracker.streaming.publisher import Names
from tracker.streaming.registry import STREAMS

LOOPBACK = "127.0.0.1"


@pytest.fixture(scope="module")
def process() -> Iterator[StreamsProcess]:
    made = StreamsProcess()
    yield made
    made.close()
    assert made.ended


@pytest.fixture
def named(hand, glove) -> Names:
    return Names.of(hand, glove, anchor=ClockAnchor(10**18, 0))


@pytest.fixture
def receiver() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind((LOOPBACK, 0))
        sock.settimeout(30)
        yield sock


def udp(port: int) -> object:
    return replace(STREAMS.get("udp").options(), port=port)


def test_messages_are_those_of_the_window_s_own_process(
    process: StreamsProcess, named: Names, make_estimate, receiver, wait_for
) -> None:
    stream = process.open("udp", udp(receiver.getsockname()[1]), [named])
    reports: list[Notice] = []
    stream.start(reports.append)
    feed = ApartFeed(process.line, 0)
    estimates = [make_estimate(t=0.01 * k, angles={"index_pip_flexion": 0.1 * k}) for k in range(4)]
    gestures = named.recogniser()
    for number, estimate in zip((7, 8, 11, 12), estimates, strict=True):  # two are missing
        feed.send(replace(estimate, seq=number))
    for number, estimate in zip((0, 1, 4, 5), estimates, strict=True):
        expected = to_json(replace(estimate, seq=number), named, gestures, LATEST)
        assert receiver.recv(65536).decode() == expected
    wait_for(lambda: stream.counts()[0].sent == 4)
    assert stream.test().code == "stream.test_udp"
    assert receiver.recv(65536), "the test sends the last one again"
    stream.close()
    feed.send(estimates[0])
    receiver.settimeout(0.5)
    with pytest.raises(TimeoutError):
        receiver.recv(65536)
    assert not reports


def test_estimates_are_read_bit_for_bit(make_estimate, names: Names) -> None:
    other = make_estimate()
    turned = np.asfortranarray(other.segment_R)
    other = replace(other, segment_R=turned, angle_state=other.angle_state.astype(np.int8))
    for e in (make_estimate(lost=("wrist",)), turning(make_estimate(), names), other):
        hand, read = unpacked(packed(1, e, e.seq))
        assert (hand, read.t, read.seq, read.tracking) == (1, e.t, e.seq, e.tracking)
        pairs = [(read, e)] if e.motion is None else [(read, e), (read.motion, e.motion)]
        for found, wanted in pairs:
            for name in (f.name for f in fields(wanted) if f.name != "motion"):
                np.testing.assert_array_equal(getattr(found, name), getattr(wanted, name))


@pytest.mark.skipif(sys.platform != "linux", reason="estimates take another way there")
def test_a_process_that_hangs_does_not_delay_the_engine(
    process: StreamsProcess, named: Names, make_estimate, receiver
) -> None:
    """The newest estimates arrive once it runs again, numbered as they were offered."""
    stream = process.open("udp", udp(receiver.getsockname()[1]), [named])
    stream.start(lambda _: None)
    direct = DirectFeed(process.line, 0)
    direct(make_estimate())
    assert json.loads(receiver.recv(65536))["seq"] == 0
    os.kill(process.pid, signal.SIGSTOP)
    try:
        for _ in range(500):  # 2 MB
            direct(make_estimate())
    finally:
        os.kill(process.pid, signal.SIGCONT)
    receiver.settimeout(0.2)
    seen = [0]
    for _ in range(20):
        direct(make_estimate())
        with contextlib.suppress(TimeoutError):
            while True:
                seen.append(json.loads(receiver.recv(65536))["seq"])
        if seen[-1] > 500:
            break
    stream.close()
    assert seen == sorted(seen) and seen[-1] > 500 > len(seen)


def test_each_hand_has_its_own_estimates(
    process: StreamsProcess, named: Names, make_estimate, receiver
) -> None:
    left = replace(named, side="left")
    stream = process.open("udp", udp(receiver.getsockname()[1]), [left, named])
    stream.start(lambda _: None)
    for k in (1, 0):
        process.line.send(k, replace(make_estimate(t=1.0 + k), seq=3))
    got = [json.loads(receiver.recv(65536)) for _ in range(2)]
    assert {(m["side"], m["t"], m["seq"]) for m in got} == {("right", 2.0, 0), ("left", 1.0, 0)}
    stream.close()


def test_the_reason_why_a_stream_cannot_be_opened_is_reported(
    process: StreamsProcess, named: Names
) -> None:
    with socket.create_server((LOOPBACK, 0)) as taken:
        options = replace(STREAMS.get("websocket").options(), port=taken.getsockname()[1])
        with raises(StreamError, "stream.server_not_started"):
            process.open("websocket", options, [named])


def test_the_clients_of_a_server_are_known(
    process: StreamsProcess, named: Names, make_estimate, wait_for
) -> None:
    client = pytest.importorskip("websockets.sync.client")
    with socket.create_server((LOOPBACK, 0)) as free:
        port = free.getsockname()[1]
    options = replace(STREAMS.get("websocket").options(), port=port)
    stream = process.open("websocket", options, [named])
    stream.start(lambda _: None)
    assert stream.test().code == "stream.test_no_client"
    with client.connect(f"ws://{LOOPBACK}:{port}/") as connection:
        wait_for(lambda: stream.counts()[0].clients == 1)
        process.line.send(0, replace(make_estimate(t=0.5), seq=0))
        assert json.loads(connection.recv(30))["t"] == 0.5
        assert stream.test().code == "stream.test_clients"
    stream.close()


def test_a_process_that_was_killed_is_reported(
    named: Names, make_estimate, receiver, wait_for
) -> None:
    process = StreamsProcess()
    stream = process.open("udp", udp(receiver.getsockname()[1]), [named])
    stream.start(lambda _: None)
    os.kill(process.pid, signal.SIGTERM)
    wait_for(lambda: process.ended)
    with raises(StreamError, "stream.process_ended"):
        process.line.send(0, make_estimate())
    with raises(StreamError, "stream.process_ended"):
        process.open("udp", udp(9), [named])
    assert stream.counts()[0].error
    stream.close()
    process.close()
