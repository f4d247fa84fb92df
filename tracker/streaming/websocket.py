"""A WebSocket server that sends every client all estimates as JSON; see `payload`.

A client that reads slowly misses the oldest of `client_queue.BACKLOG` waiting messages, which are
counted. Pages of other sites that
a browser on this machine shows are turned away: a WebSocket is not held back by the same-origin
rule, so the server has to look at ``Origin`` itself (RFC 6455, 10.2).
"""

from __future__ import annotations

import asyncio
from functools import partial

from websockets.asyncio.server import ServerConnection

from tracker.gestures.recogniser import GestureRecogniser
from tracker.messages import Estimate
from tracker.streaming.client_queue import ClientQueue
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import LOOPBACK, Names, OtherHand, StreamError
from tracker.streaming.server_thread import LOCAL_PAGE, ServerThread

MAX_SAID = 1024  # bytes of a client's message; clients have nothing to say


class WebSocketPublisher:
    """Serves ws://host:port/. Port 0 takes any free one; ``port`` says which."""

    def __init__(self, names: Names, host: str = LOOPBACK, port: int = 0) -> None:
        self._names, self._gestures = names, names.recogniser()
        self._clients: tuple[ClientQueue, ...] = ()  # replaced by the server's thread, not changed
        self._missed = 0  # by clients that have left
        self._closing = False
        self._server = ServerThread(
            "WebSocket", self._feed, host, port, origins=[None, LOCAL_PAGE], max_size=MAX_SAID
        )
        self.port = self._server.port
        self.name = f"WebSocket at {host}:{self.port}"

    @property
    def clients(self) -> int:
        """How many are connected."""
        return self._server.connected

    def missed(self) -> dict[str, int]:
        """Messages that slow clients missed, by their address; under "" those of former clients."""
        return {"": self._missed} | {c.name: c.dropped for c in self._clients}

    def send(self, estimate: Estimate) -> None:
        self._send(self._names, self._gestures, estimate)

    def beside(self, names: Names) -> OtherHand:
        """Another hand for the same clients."""
        return OtherHand(self.name, partial(self._send, names, names.recogniser()))

    def _send(self, names: Names, gestures: GestureRecogniser | None, estimate: Estimate) -> None:
        if self._closing:
            raise StreamError("the WebSocket server is closed")
        if self.clients:
            self._server.call(self._hand_out, to_json(estimate, names, gestures))

    def close(self) -> None:
        self._closing = True
        self._server.close()

    # ---- in the server's own thread

    def _hand_out(self, text: str) -> None:
        for client in self._clients:
            client.put(text)

    async def _feed(self, connection: ServerConnection) -> None:
        """One client, until it leaves; what it sends is ignored."""
        client = ClientQueue(connection)
        self._clients += (client,)
        sending = asyncio.create_task(client.send())
        try:
            async for _ in connection:
                continue
        finally:
            self._clients = tuple(c for c in self._clients if c is not client)
            self._missed += client.dropped
            sending.cancel()
