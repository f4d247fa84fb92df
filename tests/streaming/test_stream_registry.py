"""Enabled streams, their settings in files and on the command line, and the report of missing
packages."""

from __future__ import annotations

import socket
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")

from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.registry import (
    STREAMS,
    StreamKind,
    StreamSettings,
    open_stream,
    open_streams,
    read_settings,
    stream_kinds,
    with_streams,
)

ALL = [
    *("udp", "websocket", "vmc", "openxr", "vmt", "monado", "opengloves", "hts", "mediapipe"),
    *("poses", "lsl", "foxglove", "isaac"),
]
PORTS = {"udp": 9750, "websocket": 9751, "vmc": 39540, "foxglove": 8765} | {
    "vmt": 39570,
    "hts": 9000,
    "mediapipe": 9002,
    "poses": 9003,
}


def free_port() -> int:
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return int(s.getsockname()[1])


def test_nothing_is_enabled_by_default_and_no_data_leaves_the_computer(names: Names) -> None:
    settings = StreamSettings()
    assert open_streams(settings, [names]) == {} and settings.on == []
    for kind in stream_kinds().values():
        if kind.has("host"):
            assert settings.options(kind).host == "127.0.0.1"


def test_all_streams_are_listed_and_have_their_ports() -> None:
    kinds = stream_kinds()
    assert list(kinds) == ALL and [kind.name for kind in kinds.values()] == ALL
    found = {name: kind.options().port for name, kind in kinds.items() if kind.has("port")}
    assert found == PORTS


def test_every_option_has_a_help_text() -> None:
    for kind in stream_kinds().values():
        assert all(kind.fields.values()), kind.name


def test_enabled_streams_are_opened(names: Names, make_estimate) -> None:
    table = {"udp": True, "websocket": True, "vmc": True, "websocket_port": free_port()}
    out = open_streams(StreamSettings(table), [names])
    assert [p.name.values["stream"] for (p,) in out.values()] == ["UDP", "WebSocket", "VMC"]
    for (publisher,) in out.values():
        publisher.send(make_estimate())
        publisher.close()


@pytest.mark.parametrize(
    ("name", "module"),
    [("lsl", "extensions.lsl.outlet"), ("foxglove", "extensions.foxglove.live")],
)
def test_a_missing_package_is_named_and_the_rest_closed(
    names: Names, monkeypatch, name: str, module: str
) -> None:
    monkeypatch.setitem(sys.modules, module, None)  # import fails
    port = free_port()
    settings = StreamSettings({"websocket": True, name: True, "websocket_port": port})
    with raises(StreamError, "stream.needs_package"):
        open_streams(settings, [names])
    with socket.socket() as s:
        assert s.connect_ex(("127.0.0.1", port)) != 0, "the WebSocket server is still there"


def test_a_stream_with_too_few_publishers_is_rejected(names: Names) -> None:
    @dataclass(frozen=True)
    class Options:
        pass

    kind = StreamKind(name="none", title="None", options=Options, make=lambda options, hands: [])
    with raises(StreamError, "stream.publishers"):
        open_stream(kind, Options(), [names])


def test_command_line_options() -> None:
    settings = with_streams(StreamSettings(), "udp, WebSocket:9000,lsl", "10.0.0.2")
    assert settings.on == ["udp", "websocket", "lsl"] and settings.host == "10.0.0.2"
    options = settings.options(STREAMS.get("websocket"))
    assert (options.host, options.port) == ("10.0.0.2", 9000)
    assert with_streams(settings, "") == settings
    assert all(with_streams(StreamSettings(), name).is_on(name) for name in ALL)
    isaac = with_streams(StreamSettings(), "isaac:Take 1.mcap")
    assert isaac.options(STREAMS.get("isaac")).file == "Take 1.mcap"


@pytest.mark.parametrize(
    ("words", "code"),
    [
        ("udp,ros", "part.unknown"),
        ("udp:0", "stream.bad_port"),
        ("vmc:", "stream.bad_port"),
        ("lsl:5", "stream.no_port"),
    ],
)
def test_an_invalid_option_is_named(words: str, code: str) -> None:
    with raises(ConfigError, code):
        with_streams(StreamSettings(), words)


def test_a_section_of_the_settings_file(tmp_path: Path) -> None:
    path = tmp_path / "settings.toml"
    path.write_text('engine = "chain"\n[streams]\nfoxglove = true\nfoxglove_port = 9100\n')
    settings = read_settings(path)
    assert settings.on == ["foxglove"]
    assert settings.options(STREAMS.get("foxglove")).port == 9100
    path.write_text("[streams]\nros = true\n")
    with raises(ConfigError, "config.unknown_stream"):
        read_settings(path)


def test_settings_of_a_stream_that_is_not_installed_are_preserved() -> None:
    settings = StreamSettings({"ros": True, "ros_port": 7, "udp": False})
    assert settings.on == [] and open_streams(settings, []) == {}
    assert settings.changed(udp=True).table == {"ros": True, "ros_port": 7, "udp": True}
