"""A WebSocket server that sends every client the newest estimate as JSON; see `payload`.

A client that reads slowly misses estimates instead of receiving old ones. Pages of other sites that
a browser on this machine shows are turned away: a WebSocket is not held back by the same-origin
rule, so the server has to look at ``Origin`` itself (RFC 6455, 10.2).
"""

from __future__ import annotations

import asyncio
import re
import threading
from concurrent.futures import Future

from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.exceptions import ConnectionClosed

from tracker.messages import Estimate
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import LOOPBACK, Names, StreamError

DEFAULT_PORT = 9751
MAX_CLIENTS = 16
LOCAL_PAGE = re.compile(r"https?://(localhost|127\.0\.0\.1|\[::1\])(:\d+)?")
START_WAIT = 5.0  # s
TRY_AGAIN_LATER = 1013  # close code


class WebSocketPublisher:
    """Serves ws://host:port/. Port 0 takes any free one; ``port`` says which."""

    def __init__(self, names: Names, host: str = LOOPBACK, port: int = DEFAULT_PORT) -> None:
        self._names = names
        self._text: str | None = None
        self._clients = 0
        self._closing = False
        started: Future[int] = Future()
        self._thread = threading.Thread(
            target=lambda: asyncio.run(self._serve(host, port, started)),
            name="glovetrack-websocket",
            daemon=True,
        )
        self._thread.start()
        try:
            self.port = started.result(START_WAIT)
        except (OSError, OverflowError) as error:
            raise StreamError(f"No WebSocket server at {host}:{port}: {error}.") from error
        self.name = f"WebSocket at {host}:{self.port}"

    @property
    def clients(self) -> int:
        """How many are connected."""
        return self._clients

    def send(self, estimate: Estimate) -> None:
        if self._closing:
            raise StreamError("the WebSocket server is closed")
        if self._clients:
            self._loop.call_soon_threadsafe(self._show, to_json(estimate, self._names))

    def close(self) -> None:
        if not self._closing:
            self._closing = True
            self._loop.call_soon_threadsafe(self._ended.set)
        self._thread.join()

    # ---- in the server's own thread

    async def _serve(self, host: str, port: int, started: Future[int]) -> None:
        self._loop = asyncio.get_running_loop()
        self._ended, self._fresh = asyncio.Event(), asyncio.Event()
        try:
            server: Server = await serve(
                self._client,
                host,
                port,
                origins=[None, LOCAL_PAGE],
                compression=None,
                max_size=1024,  # clients have nothing to say
                close_timeout=0.5,
            )
        except (OSError, OverflowError) as error:
            started.set_exception(error)
            return
        async with server:
            started.set_result(next(iter(server.sockets)).getsockname()[1])
            await self._ended.wait()
            self._fresh.set()

    def _show(self, text: str) -> None:
        self._text = text
        fresh, self._fresh = self._fresh, asyncio.Event()
        fresh.set()

    async def _client(self, connection: ServerConnection) -> None:
        """One client: the newest text, whenever it has taken the last one."""
        if self._clients >= MAX_CLIENTS:
            await connection.close(TRY_AGAIN_LATER, "too many clients")
            return
        self._clients += 1
        try:
            await self._feed(connection)
        except ConnectionClosed:
            return
        finally:
            self._clients -= 1

    async def _feed(self, connection: ServerConnection) -> None:
        sent = self._text
        while not self._ended.is_set():
            text = self._text
            if text is None or text is sent:
                await self._fresh.wait()
                continue
            await connection.send(text)  # waits while the client is slow
            sent = text
