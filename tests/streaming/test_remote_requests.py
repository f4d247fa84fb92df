"""Requests and replies of remote control, without sockets."""

from __future__ import annotations

import contextlib
import json
from concurrent.futures import Future
from functools import partial
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.base.notices import failure
from tracker.streaming.connection import ConnectionSettings
from tracker.streaming.remote.reception import (
    ACTS_HZ,
    MOST_PEERS,
    MOST_WAITING,
    PER_PEER_HZ,
    Reception,
)
from tracker.streaming.remote.registry import DOORS, door_kinds, with_doors
from tracker.streaming.remote.request import (
    MOST_BYTES,
    MOST_TEXT,
    Reply,
    Request,
    RequestError,
    is_reply,
    parse,
)


def test_plain_text_and_json_are_equivalent() -> None:
    assert parse(b"start", 1.0) == parse(b'{"do": "start"}', 1.0) == Request("start", 1.0)
    note = Request("note", 2.0, text="the cup is taken")
    assert parse("note the cup is taken\n", 2.0) == note
    assert parse('{"do": "note", "text": "the cup is taken"}', 2.0) == note
    assert parse("vibrate index", 3.0) == Request("vibrate", 3.0, finger="index")


def test_an_id_is_returned() -> None:
    asked = parse('{"do": "stop", "id": "a-7"}', 0.0)
    assert asked is not None
    line = json.loads(Reply(True, "stop", "Done.", Path("takes/x.mcap"), id=asked.id).as_json())
    assert line == {"ok": True, "do": "stop", "text": "Done.", "file": "x.mcap", "id": "a-7"}


def test_only_the_local_user_gets_the_folder() -> None:
    reply = Reply(True, "start", "Recording.", Path("takes/x.mcap"))
    assert json.loads(reply.as_json())["file"] == "x.mcap"
    assert json.loads(reply.as_json(with_folder=True))["file"] == str(Path("takes/x.mcap"))


@pytest.mark.parametrize(
    ("line", "code"),
    [
        (b"", "request.unknown"),
        (b"explode", "request.unknown"),
        (b"start now", "request.unknown_field"),
        (b"note", "request.note_empty"),
        (b'{"do": "note", "text": "  "}', "request.note_empty"),
        (b'{"do": "note", "text": 3}', "request.text"),
        (b'{"do": ["note"]}', "request.unknown"),
        (b"vibrate toe", "request.finger"),
        (b"vibrate", "request.finger_missing"),
        (b'{"do": "vibrate", "finger": "index", "amplitude": 256}', "request.integer"),
        (b'{"do": "vibrate", "finger": "index", "amplitude": NaN}', "request.integer"),
        (b'{"do": "vibrate", "finger": "index", "duration_ms": true}', "request.integer"),
        (b'{"do": "start", "id": {}}', "request.id"),
        (b'{"do": "start", "id": ' + b"9" * 500 + b"}", "request.id"),
        (b'{"do": "note", "text": "' + b"x" * (MOST_TEXT + 1) + b'"}', "request.note_too_long"),
        (b"x" * (MOST_BYTES + 1), "request.too_long"),
        (b"{" * 2000, "request.not_readable"),
        (b"\xff\xfe", "request.not_readable"),
    ],
)
def test_invalid_requests_are_rejected(line: bytes, code: str) -> None:
    with raises(RequestError, code):
        parse(line, 0.0)


@given(st.binary(max_size=300))
def test_arbitrary_bytes_are_harmless(data: bytes) -> None:
    with contextlib.suppress(RequestError):
        parse(data, 0.0)


def test_a_note_cannot_control_a_terminal() -> None:
    asked = parse(json.dumps({"do": "note", "text": "a\x1b[2Jb\nc"}), 0.0)
    assert asked is not None and asked.text == "a [2Jb c"


def test_a_reply_is_not_answered() -> None:
    """Two programs that answer each other would never stop."""
    assert parse(Reply(False, "", "What?").as_json(), 0.0) is None


class Desk:
    """A handler that executes requests, or leaves them pending."""

    def __init__(self, acts: bool = True) -> None:
        self.acts, self.asked, self.now = acts, [], 100.0
        self.reception = Reception(self.answer, lambda: self.now)

    def answer(self, request: Request) -> Future[Reply]:
        self.asked.append(request)
        future: Future[Reply] = Future()
        if self.acts:
            future.set_result(Reply(True, request.do, "Done."))
        return future

    def say(self, text: str, peer: str = "a") -> Reply | None:
        t = self.reception.admit(peer)
        if t is None:
            return None
        future = self.reception.take(partial(parse, text, t))
        return future.result(0) if future is not None and future.done() else None


def test_the_rate_of_requests_is_limited() -> None:
    """The bucket contains two seconds' worth and is filled at its rate."""
    desk = Desk()
    answers = [desk.say("vibrate index") for _ in range(1000)]
    assert sum(a is not None for a in answers) == 2 * PER_PEER_HZ
    desk.now += 0.5
    answers = [desk.say("vibrate index") for _ in range(1000)]
    assert sum(a is not None for a in answers) == 0.5 * PER_PEER_HZ
    assert desk.say("vibrate index", peer="b") is not None, "another one is not to suffer for it"


def test_notes_have_a_lower_limit_and_rejections_state_the_reason() -> None:
    desk = Desk()
    answers = [desk.say("note hello") for _ in range(100)]
    taken = [a for a in answers if a is not None and a.ok]
    assert len(taken) == len(desk.asked) == 2 * ACTS_HZ
    refused = answers[-1]
    assert refused is not None and refused.notice == failure("request.too_many", rate_hz=10)
    line = json.loads(refused.as_json())
    assert (line["code"], line["values"]) == ("request.too_many", {"rate_hz": 10})
    assert is_reply(refused.as_json())
    counts = desk.reception.counts("x", None)
    assert (counts.asked, counts.refused) == (20, 80)


def test_pending_requests_and_known_clients_are_bounded() -> None:
    desk = Desk(acts=False)
    for k in range(10 * MOST_WAITING):
        desk.now += 0.2
        desk.say("status", peer=f"10.0.0.{k}")
    assert len(desk.asked) == MOST_WAITING
    assert len(desk.reception.counts("x", None).peers) == MOST_PEERS


def test_nothing_is_open_by_default() -> None:
    settings = ConnectionSettings()
    assert not any(map(settings.is_on, door_kinds()))
    own = ["udp", "osc", "websocket"]
    added = ["lsl", "vmt", "room", "natnet", "lslpose", "vrpn"]
    assert list(door_kinds()) == [*own, *added]
    for name, kind in door_kinds().items():
        options = settings.options(kind)
        if name == "lslpose":  # LSL finds streams by itself: of this computer
            assert not options.network
        elif name == "vrpn":  # a client of this computer's server
            assert options.server == "127.0.0.1"
        else:
            assert options.host == "127.0.0.1", name
    settings = with_doors(settings, "udp, WebSocket:9000", "0.0.0.0")
    assert settings.is_on("udp") and settings.is_on("websocket")
    options = settings.options(DOORS.get("websocket"))
    assert (options.host, options.port) == ("0.0.0.0", 9000)
    for words in ("tcp", "udp:0"):
        with pytest.raises(ConfigError):
            with_doors(settings, words)
