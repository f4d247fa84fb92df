"""A WebSocket server that sends every client all estimates as JSON; see `payload`.

A client chooses the schema of its messages by its address: ``ws://127.0.0.1:9751/?schema=1``.

A client that reads slowly misses the oldest of `client_queue.BACKLOG` waiting messages, which are
counted. Pages of other sites that
a browser on this computer shows are rejected: a WebSocket is not subject to the same-origin
policy, so the server must check ``Origin`` itself (RFC 6455, 10.2).
"""

from __future__ import annotations

import asyncio
from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple
from urllib.parse import parse_qs, urlsplit

from websockets.asyncio.server import ServerConnection
from websockets.frames import CloseCode

from tracker.base.notices import notice
from tracker.messages import Estimate
from tracker.streaming.builtin import WebSocketOptions
from tracker.streaming.client_queue import ClientQueue
from tracker.streaming.payload import LATEST, SCHEMAS, check_schema, text_of
from tracker.streaming.publisher import LOOPBACK, Names, OtherHand, Publisher, StreamError
from tracker.streaming.server_thread import LOCAL_PAGE, ServerThread
from tracker.streaming.shared import Gestures

MAX_CLIENT_MESSAGE = 1024  # bytes of a client's message; clients send none


class WebSocketPublisher:
    """Serves ws://host:port/. Port 0 selects a free one; ``port`` is the one in use."""

    def __init__(
        self, names: Names, host: str = LOOPBACK, port: int = 0, schema: int = LATEST
    ) -> None:
        """``schema``: the default for clients that do not choose one."""
        check_schema(schema)
        self._names, self._gestures, self._schema = names, names.recogniser(), schema
        self._clients: tuple[_Client, ...] = ()  # replaced by the server's thread, not changed
        self._missed = 0  # by clients that have left
        self._closing = False
        self._server = ServerThread(
            "WebSocket",
            self._feed,
            host,
            port,
            origins=[None, LOCAL_PAGE],
            max_size=MAX_CLIENT_MESSAGE,
        )
        self.port = self._server.port
        self.name = notice("stream.at", stream="WebSocket", host=host, port=self.port)

    @property
    def clients(self) -> int:
        """Number of connected clients."""
        return self._server.connected

    def missed(self) -> dict[str, int]:
        """Messages that slow clients missed, by address; "" for clients that have left."""
        return {"": self._missed} | {c.queue.name: c.queue.dropped for c in self._clients}

    def send(self, estimate: Estimate) -> None:
        self._send(self._names, self._gestures, estimate)

    def for_other_hand(self, names: Names) -> OtherHand:
        """A publisher of another hand for the same clients."""
        return OtherHand(self.name, partial(self._send, names, names.recogniser()))

    def _send(self, names: Names, gestures: Gestures | None, estimate: Estimate) -> None:
        if self._closing:
            raise StreamError(notice("stream.closed", what="WebSocket server"))
        if not self.clients:
            return
        if gestures is not None:
            gestures.feed(estimate)
        wanted = {self._schema, *(client.schema for client in self._clients)}
        texts = {s: text_of(estimate, names, gestures, s) for s in sorted(wanted)}
        self._server.call(self._hand_out, texts)

    def close(self) -> None:
        self._closing = True
        self._server.close()

    # ---- in the server's own thread

    def _hand_out(self, texts: dict[int, str]) -> None:
        """Queues ``texts``, by schema; a client that has just connected starts with the next
        ones."""
        for client in self._clients:
            if client.schema in texts:
                client.queue.put(texts[client.schema])

    async def _feed(self, connection: ServerConnection) -> None:
        """Serves one client until it disconnects; its messages are ignored."""
        requested = _requested_schema(connection, self._schema)
        if requested not in SCHEMAS:
            await connection.close(CloseCode.POLICY_VIOLATION, f"schema is one of {SCHEMAS}")
            return
        client = _Client(ClientQueue(connection), requested)
        self._clients += (client,)
        sending = asyncio.create_task(client.queue.send())
        try:
            async for _ in connection:
                continue
        finally:
            self._clients = tuple(c for c in self._clients if c is not client)
            self._missed += client.queue.dropped
            sending.cancel()


class _Client(NamedTuple):
    """The pending messages of one client, and their schema."""

    queue: ClientQueue
    schema: int


def _requested_schema(connection: ServerConnection, usual: int) -> int:
    """The schema in the address ``ws://host:port/?schema=1``; -1 if it is not a number."""
    query = parse_qs(urlsplit(connection.request.path if connection.request else "").query)
    word = query.get("schema", [str(usual)])[-1]
    return int(word) if word.isdecimal() else -1


def open_stream(options: WebSocketOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    """Yields the publisher of each hand."""
    first, *others = hands
    server = WebSocketPublisher(first, options.host, options.port, options.schema)
    yield server
    yield from map(server.for_other_hand, others)
