"""Remote control through real sockets."""

from __future__ import annotations

import json
import socket
import time
from collections.abc import Iterator
from concurrent.futures import Future

import pytest

pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from tests.notices import raises, shows
from tracker.base.clock import monotonic
from tracker.streaming.publisher import StreamError
from tracker.streaming.remote.client import ask
from tracker.streaming.remote.doors import (
    Door,
    WebSocketDoor,
    is_loopback,
    udp_door,
)
from tracker.streaming.remote.request import MOST_BYTES, Reply, Request

HERE = "127.0.0.1"


class Window:
    """Executes at once, unless it is busy."""

    def __init__(self) -> None:
        self.asked: list[Request] = []
        self.waiting: list[Future[Reply]] = []
        self.busy = False

    def answer(self, request: Request) -> Future[Reply]:
        self.asked.append(request)
        future: Future[Reply] = Future()
        if self.busy:
            self.waiting.append(future)
        else:
            future.set_result(Reply(True, request.do, "Done.", id=request.id))
        return future


@pytest.fixture
def desk() -> Window:
    return Window()


@pytest.fixture
def udp(desk: Window) -> Iterator[Door]:
    door = udp_door(desk.answer, HERE, 0)
    yield door
    door.close()


@pytest.fixture
def web(desk: Window) -> Iterator[WebSocketDoor]:
    door = WebSocketDoor(desk.answer, HERE, 0)
    yield door
    door.close()


@pytest.fixture
def client() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
        out.settimeout(5)
        yield out


def test_a_datagram_is_executed_and_answered(udp: Door, desk: Window) -> None:
    before = monotonic()
    answer = json.loads(ask({"do": "note", "text": "now", "id": 4}, HERE, udp.port))
    assert answer == {"ok": True, "do": "note", "text": "Done.", "id": 4}
    assert [r.text for r in desk.asked] == ["now"]
    assert before <= desk.asked[0].t <= monotonic()
    assert udp.counts().asked == 1 and len(udp.counts().peers) == 1


def test_a_request_is_timestamped_on_arrival_even_if_the_window_is_busy(
    udp: Door, desk: Window, client: socket.socket, wait_for
) -> None:
    desk.busy = True
    client.sendto(b"note first", (HERE, udp.port))
    wait_for(lambda: desk.asked)
    time.sleep(0.3)
    client.sendto(b"note second", (HERE, udp.port))
    wait_for(lambda: len(desk.asked) == 2)
    assert 0.25 < desk.asked[1].t - desk.asked[0].t < 3.0
    for future, text in zip(desk.waiting, ("a", "b"), strict=True):
        future.set_result(Reply(True, "note", text))
    assert [json.loads(client.recv(9999))["text"] for _ in range(2)] == ["a", "b"]


def test_invalid_requests_are_answered_and_answers_are_not(
    udp: Door, desk: Window, client: socket.socket
) -> None:
    client.sendto(b'{"ok": true}', (HERE, udp.port))
    client.sendto(b"\xff", (HERE, udp.port))
    assert shows(json.loads(client.recv(9999))["error"], "request.not_readable")
    client.sendto(bytes(MOST_BYTES + 1), (HERE, udp.port))
    assert shows(json.loads(client.recv(9999))["error"], "request.too_long", most=2048)
    assert desk.asked == []


def test_a_flood_is_throttled(udp: Door, desk: Window, client: socket.socket, wait_for) -> None:
    for _ in range(3000):
        client.sendto(b"note x", (HERE, udp.port))
    wait_for(lambda: udp.counts().refused > 100)
    assert len(desk.asked) < 200
    time.sleep(0.3)  # its allowance is replenished
    client.settimeout(0.1)
    with pytest.raises(TimeoutError):
        while True:
            client.recv(9999)  # the earlier answers
    assert json.loads(ask({"do": "status"}, HERE, udp.port))["ok"]


def test_web_socket_requests_are_answered_in_order(web: WebSocketDoor, desk: Window) -> None:
    with connect(f"ws://{HERE}:{web.port}/") as page:
        page.send('{"do": "start"}')
        assert json.loads(page.recv(timeout=60)) == {"ok": True, "do": "start", "text": "Done."}
        page.send("nonsense")
        assert not json.loads(page.recv(timeout=60))["ok"]
        assert web.counts().clients == 1
    assert [r.do for r in desk.asked] == ["start"]


def test_a_page_of_another_site_is_rejected(web: WebSocketDoor) -> None:
    with pytest.raises(InvalidStatus) as refused:
        connect(f"ws://{HERE}:{web.port}/", origin="https://example.com")
    assert refused.value.response.status_code == 403


@pytest.mark.parametrize("sent_text", ["x" * (MOST_BYTES + 1), None])
def test_a_client_that_sends_too_much_is_disconnected(web: WebSocketDoor, sent_text) -> None:
    """One message that is too long, or too many of them."""
    with connect(f"ws://{HERE}:{web.port}/") as page, pytest.raises(ConnectionClosed):
        for _ in range(1 if sent_text else 2000):
            page.send(sent_text or "status")
        for _ in range(2000):
            page.recv(timeout=60)


@pytest.mark.parametrize(
    ("kind", "code"),
    [(udp_door, "remote.not_started"), (WebSocketDoor, "stream.server_not_started")],
)
def test_only_the_loopback_address_is_used_and_the_port_is_freed(kind, code, desk: Window) -> None:
    door = kind(desk.answer, HERE, 0)
    port = door.port
    with raises(StreamError, code):
        kind(desk.answer, HERE, port)
    kind(desk.answer, "127.0.0.2", port).close()  # another address is free: it is not used
    door.close()
    door.close()
    kind(desk.answer, HERE, port).close()


def test_an_unresponsive_window_is_reported(client: socket.socket) -> None:
    client.bind((HERE, 0))
    with raises(StreamError, "remote.no_window"):
        ask({"do": "status"}, HERE, client.getsockname()[1], wait=0.2)


def test_external_access_is_detected() -> None:
    assert all(map(is_loopback, ("127.0.0.1", "localhost", "::1", "127.3.2.1")))
    assert not any(map(is_loopback, ("0.0.0.0", "192.168.1.5", "::", "lab-pc")))
