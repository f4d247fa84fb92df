"""What is on, and what is said where a package is absent."""

from __future__ import annotations

import socket
import sys
from dataclasses import fields

import pytest

pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")

from tracker.base.config import from_toml, to_toml
from tracker.base.errors import ConfigError
from tracker.engine.settings import Settings
from tracker.streaming.osc import DEFAULT_PORT as VMC_PORT
from tracker.streaming.params import STREAMS, StreamParams, open_publishers, with_streams
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


def test_words_of_the_command_line() -> None:
    params = with_streams(StreamParams(), "udp, WebSocket:9000,lsl", "10.0.0.2")
    assert params == StreamParams(
        udp=True, websocket=True, lsl=True, websocket_port=9000, host="10.0.0.2"
    )
    assert with_streams(params, "") == params
    assert all(getattr(with_streams(StreamParams(), name), name) for name in STREAMS)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("udp,ros", "no stream 'ros'; there are udp, websocket"),
        ("udp:0", "'0' is no port for the udp stream"),
        ("vmc:", "'' is no port"),
        ("lsl:5", "LSL stream has no port"),
    ],
)
def test_a_wrong_word_is_named(words: str, said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        with_streams(StreamParams(), words)


def test_a_section_of_the_settings_file() -> None:
    text = "[streams]\nfoxglove = true\nfoxglove_port = 9100\n"
    settings = from_toml(Settings, text)
    assert settings.streams == StreamParams(foxglove=True, foxglove_port=9100)
    assert from_toml(Settings, to_toml(settings)) == settings
    with pytest.raises(ConfigError, match=r"streams\.ros is not a setting"):
        from_toml(Settings, "[streams]\nros = true\n")
