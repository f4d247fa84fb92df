"""A WebSocket server that sends every client the newest estimates as JSON; see `payload`.

A client that reads slowly misses estimates instead of receiving old ones. Pages of other sites that
a browser on this machine shows are turned away: a WebSocket is not held back by the same-origin
rule, so the server has to look at ``Origin`` itself (RFC 6455, 10.2).
"""

from __future__ import annotations

import asyncio
from functools import partial

from websockets.asyncio.server import ServerConnection

from tracker.gestures.recogniser import GestureRecogniser
from tracker.messages import Estimate
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import LOOPBACK, Names, OtherHand, StreamError
from tracker.streaming.server_thread import LOCAL_PAGE, ServerThread

DEFAULT_PORT = 9751
MAX_SAID = 1024  # bytes of a client's message; clients have nothing to say


class WebSocketPublisher:
    """Serves ws://host:port/. Port 0 takes any free one; ``port`` says which."""

    def __init__(self, names: Names, host: str = LOOPBACK, port: int = DEFAULT_PORT) -> None:
        self._names, self._gestures = names, names.recogniser()
        self._texts: dict[str, str] = {}  # the newest of each hand, by its side
        self._fresh = asyncio.Event()
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

    def send(self, estimate: Estimate) -> None:
        self._send(self._names, self._gestures, estimate)

    def beside(self, names: Names) -> OtherHand:
        """Another hand for the same clients."""
        return OtherHand(self.name, partial(self._send, names, names.recogniser()))

    def _send(self, names: Names, gestures: GestureRecogniser | None, estimate: Estimate) -> None:
        if self._closing:
            raise StreamError("the WebSocket server is closed")
        if self.clients:
            self._server.call(self._show, names.side, to_json(estimate, names, gestures))

    def close(self) -> None:
        self._closing = True
        self._server.call(self._fresh_again)
        self._server.close()

    # ---- in the server's own thread

    def _show(self, side: str, text: str) -> None:
        self._texts[side] = text
        self._fresh_again()

    def _fresh_again(self) -> None:
        fresh, self._fresh = self._fresh, asyncio.Event()
        fresh.set()

    async def _feed(self, connection: ServerConnection) -> None:
        """One client: the newest text of each hand, whenever it has taken the last one."""
        sent = dict(self._texts)
        while not self._closing:
            fresh = [side for side, text in self._texts.items() if text is not sent.get(side)]
            if not fresh:
                await self._fresh.wait()
            for side in fresh:
                sent[side] = self._texts[side]
                await connection.send(sent[side])  # waits while the client is slow
