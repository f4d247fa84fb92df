"""Remote control by OSC: requests, replies and the socket."""

from __future__ import annotations

import socket
from concurrent.futures import Future
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pythonosc.osc_message import OscMessage
from pythonosc.osc_message_builder import OscMessageBuilder

from extensions.osc import requests as osc
from extensions.osc.decode import message
from extensions.osc.encode import message as osc_message
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.streaming.connection import ConnectionSettings
from tracker.streaming.publisher import StreamError
from tracker.streaming.remote.registry import DOORS, open_door, with_doors
from tracker.streaming.remote.request import Reply, Request, RequestError

HERE = "127.0.0.1"


def test_osc_requests_are_executed_and_answered() -> None:
    note = osc.parse(osc_message("/glovetrack/note", "grün"), 1.0)
    assert note == Request("note", 1.0, text="grün")
    motor = osc.parse(osc_message("/glovetrack/vibrate", "thumb", 90.0, 40), 1.0)
    assert motor == Request("vibrate", 1.0, finger="thumb", amplitude=90, duration_ms=40)
    said = osc.encode(Reply(True, "start", "Recording a.", Path("/x/a.mcap")))
    assert message(said) == ("/glovetrack/reply", ["start", 1, "Recording a.", "a.mcap"])


def test_a_button_of_an_osc_surface_acts_only_when_pressed() -> None:
    assert osc.parse(osc_message("/glovetrack/start", 1.0), 0.0) == Request("start", 0.0)
    assert osc.parse(osc_message("/glovetrack/start", 0.0), 0.0) is None


@pytest.mark.parametrize(
    "data", [osc_message("/other"), osc_message("/glovetrack/note", "a", "b"), b"note hello"]
)
def test_invalid_osc_is_refused(data: bytes) -> None:
    with pytest.raises(RequestError):
        osc.parse(data, 0.0)


@given(st.binary(max_size=300))
def test_arbitrary_bytes_are_harmless(data: bytes) -> None:
    for candidate in (data, b"/glovetrack/" + data):
        try:
            osc.parse(candidate, 0.0)
        except RequestError:
            continue


def test_a_reply_is_not_answered() -> None:
    """Two programs that reply to each other would never stop."""
    assert osc.parse(osc.encode(Reply(False, "", "What?")), 0.0) is None


def test_a_contact_has_three_values() -> None:
    want = Request("contact", 1.0, finger="index", strength=0.5, object="cup")
    assert osc.parse(osc_message("/glovetrack/contact", "index", 0.5, "cup"), 1.0) == want


def test_requests_of_another_library_are_answered_and_the_port_is_freed() -> None:
    asked: list[Request] = []

    def answer(request: Request) -> Future[Reply]:
        asked.append(request)
        future: Future[Reply] = Future()
        future.set_result(Reply(True, request.do, "Done."))
        return future

    kind = DOORS.get("osc")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.settimeout(60)
        client.bind((HERE, 0))
        port = client.getsockname()[1]
        taken = kind.options(port=port)
        with raises(StreamError, "remote.not_started"):
            open_door(kind, taken, answer)
        door = open_door(kind, kind.options(port=0), answer)
        try:
            builder = OscMessageBuilder("/glovetrack/note")
            builder.add_arg("cup")
            client.sendto(builder.build().dgram, (HERE, door.port))
            reply = OscMessage(client.recv(9999))
        finally:
            door.close()
        with pytest.raises(ConnectionRefusedError):  # no program listens at the port now
            client.connect((HERE, door.port))
            client.send(b"x")
            client.recv(10)
    assert reply.address == "/glovetrack/reply"
    assert reply.params == ["note", 1, "Done.", ""]
    assert asked[0].text == "cup"


def test_the_command_line_sets_the_port() -> None:
    settings = with_doors(ConnectionSettings(), "OSC:9000")
    assert settings.is_on("osc") and settings.options(DOORS.get("osc")).port == 9000
    with raises(ConfigError, "stream.bad_port"):
        with_doors(ConnectionSettings(), "osc:x")
