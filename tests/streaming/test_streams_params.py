"""What is on, and what is said where a package is absent."""

from __future__ import annotations

import socket
import sys
from dataclasses import fields

import pytest

pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")

from tracker.streaming.osc import DEFAULT_PORT as VMC_PORT
from tracker.streaming.params import StreamParams, open_publishers
from tracker.streaming.publisher import StreamError
from tracker.streaming.udp import DEFAULT_PORT as UDP_PORT
from tracker.streaming.websocket import DEFAULT_PORT as WEBSOCKET_PORT


def free_port() -> int:
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return int(s.getsockname()[1])


def test_nothing_is_on_and_nothing_leaves_the_machine(hand, glove) -> None:
    params = StreamParams()
    assert open_publishers(params, hand, glove) == []
    assert not [f.name for f in fields(params) if getattr(params, f.name) is True]
    assert params.host == "127.0.0.1"


def test_ports_are_those_of_the_outputs() -> None:
    p = StreamParams()
    assert (p.udp_port, p.websocket_port, p.vmc_port) == (UDP_PORT, WEBSOCKET_PORT, VMC_PORT)


def test_what_is_on_is_opened(hand, glove, make_estimate) -> None:
    port = free_port()
    params = StreamParams(udp=True, websocket=True, vmc=True, websocket_port=port)
    out = open_publishers(params, hand, glove)
    assert [p.name.split()[0] for p in out] == ["UDP", "WebSocket", "VMC"]
    for publisher in out:
        publisher.send(make_estimate())
        publisher.close()


def test_an_absent_package_is_named_and_the_rest_closed(hand, glove, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "tracker.streaming.lsl", None)  # import fails
    port = free_port()
    params = StreamParams(websocket=True, lsl=True, websocket_port=port)
    with pytest.raises(StreamError, match=r"LSL stream needs a package.*glovetrack\[streams\]"):
        open_publishers(params, hand, glove)
    with socket.socket() as s:
        assert s.connect_ex(("127.0.0.1", port)) != 0, "the WebSocket server is still there"
