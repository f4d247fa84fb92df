"""The WebSocket server: with the library's client, and with misbehaving bare sockets."""

from __future__ import annotations

import contextlib
import json
import logging
import socket
import time
from collections.abc import Iterator
from dataclasses import replace

import pytest

pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from tests.notices import raises
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.server_thread import MAX_CLIENTS
from tracker.streaming.websocket import WebSocketPublisher


@pytest.fixture
def server(names: Names) -> Iterator[WebSocketPublisher]:
    out = WebSocketPublisher(names, port=0)
    yield out
    out.close()


def url(server: WebSocketPublisher) -> str:
    return f"ws://127.0.0.1:{server.port}/"


def bare_client(server: WebSocketPublisher) -> socket.socket:
    """A client that completes the handshake and then reads nothing, with a small window."""
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2048)
    client.connect(("127.0.0.1", server.port))
    client.sendall(
        f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nUpgrade: websocket\r\n"
        "Connection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
        "Sec-WebSocket-Version: 13\r\n\r\n".encode()
    )
    assert b" 101 " in client.recv(100)
    return client


def test_every_client_receives_the_estimates(server, make_estimate, names, wait_for) -> None:
    with connect(url(server)) as a, connect(url(server)) as b:
        wait_for(lambda: server.clients == 2)
        for t in (1.0, 2.0):
            server.send(make_estimate(t, lost=("thumb_tip",)))
            for client in (a, b):
                read = json.loads(client.recv(timeout=60))
                assert read["t"] == t
                assert read["keypoints"]["thumb_tip"]["position"] is None
    wait_for(lambda: not server.clients or server.send(make_estimate()))


def test_connections_are_not_logged(server, wait_for, caplog) -> None:
    with caplog.at_level(logging.INFO):
        with connect(url(server)):
            wait_for(lambda: server.clients == 1)
        wait_for(lambda: server.clients == 0)
    assert [r.message for r in caplog.records if "client" not in r.name] == []


@pytest.mark.long
def test_a_client_that_does_not_read_delays_no_one(server, make_estimate, wait_for) -> None:
    with contextlib.closing(bare_client(server)), connect(url(server)) as healthy:
        wait_for(lambda: server.clients == 2)
        estimate, longest = make_estimate(), 0.0
        for k in range(1500):  # about 6 MB: far more than the buffers in between
            started = time.perf_counter()
            server.send(replace(estimate, t=float(k)))
            longest = max(longest, time.perf_counter() - started)
            assert json.loads(healthy.recv(timeout=60))["t"] == k
        assert longest < 0.5
        missed = server.missed()
        assert sorted(n > 0 for n in missed.values()) == [False, False, True], missed
    wait_for(lambda: server.missed()[""] > 0)


def test_a_client_that_disappears_is_removed(server, make_estimate, wait_for) -> None:
    client = bare_client(server)
    wait_for(lambda: server.clients == 1)
    client.close()
    wait_for(lambda: not server.clients or server.send(make_estimate()))


def test_pages_of_other_sites_are_rejected(server) -> None:
    with pytest.raises(InvalidStatus) as refused:
        connect(url(server), origin="https://example.com")
    assert refused.value.response.status_code == 403
    with pytest.raises(InvalidStatus):
        connect(url(server), origin="http://localhost.example.com")
    for page in ("http://localhost:8000", "http://127.0.0.1"):
        with connect(url(server), origin=page):
            pass


def test_the_number_of_clients_is_limited(server, wait_for) -> None:
    with contextlib.ExitStack() as stack:
        for _ in range(MAX_CLIENTS):
            stack.enter_context(connect(url(server)))
        wait_for(lambda: server.clients == MAX_CLIENTS)
        with connect(url(server)) as late, pytest.raises(ConnectionClosed) as refused:
            late.recv(timeout=60)
        assert refused.value.rcvd is not None and refused.value.rcvd.code == 1013


def test_only_the_loopback_address_is_used(server) -> None:
    with socket.socket() as other:  # another loopback address represents the network
        other.settimeout(1)
        assert other.connect_ex(("127.0.0.2", server.port)) != 0


def test_a_port_in_use_is_reported(names: Names) -> None:
    with socket.socket() as holder:
        holder.bind(("127.0.0.1", 0))
        holder.listen()
        with raises(StreamError, "stream.server_not_started"):
            WebSocketPublisher(names, port=holder.getsockname()[1])


def test_closing_disconnects_clients_and_frees_the_port(
    names: Names, make_estimate, wait_for
) -> None:
    server = WebSocketPublisher(names, port=0)
    with connect(url(server)) as client:
        wait_for(lambda: server.clients == 1)
        server.close()
        server.close()
        with pytest.raises(ConnectionClosed):
            client.recv(timeout=60)
    with raises(StreamError, "stream.closed"):
        server.send(make_estimate())
    WebSocketPublisher(names, port=server.port).close()


def test_a_client_selects_its_schema_by_the_address(server, make_estimate, wait_for) -> None:
    with connect(url(server)) as new, connect(url(server) + "?schema=1") as old:
        wait_for(lambda: server.clients == 2)
        server.send(make_estimate())
        server.send(make_estimate())
        assert json.loads(new.recv(timeout=60))["schema"] == 2
        assert json.loads(old.recv(timeout=60))["schema"] == 1


def test_a_client_that_requests_an_unknown_schema_is_rejected(server) -> None:
    with connect(url(server) + "?schema=9") as client, pytest.raises(ConnectionClosed) as closed:
        client.recv(timeout=60)
    assert closed.value.rcvd is not None and "schema is one of" in closed.value.rcvd.reason


def test_a_server_of_the_first_schema(names: Names, make_estimate, wait_for) -> None:
    server = WebSocketPublisher(names, schema=1)
    with contextlib.closing(server), connect(url(server)) as client:
        wait_for(lambda: server.clients == 1)
        server.send(make_estimate())
        assert json.loads(client.recv(timeout=60))["schema"] == 1
