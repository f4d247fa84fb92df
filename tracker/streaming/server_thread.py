"""A WebSocket server with an event loop in its own thread, for the outputs that need one."""

from __future__ import annotations

import asyncio
import logging
import re
import threading
from collections.abc import Awaitable, Callable
from concurrent.futures import Future
from typing import Any

from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.exceptions import ConnectionClosed

from tracker.base.notices import notice
from tracker.streaming.publisher import StreamError

MAX_CLIENTS = 16
START_WAIT = 5.0  # s
CLOSE_WAIT = 0.5  # s for a client's answer to the close frame
TRY_AGAIN_LATER = 1013  # close code
LOCAL_PAGE = re.compile(r"https?://(localhost|127\.0\.0\.1|\[::1\])(:\d+)?")
"""Origins of pages that this computer serves."""

_log = logging.getLogger(f"{__name__}.connections")
_log.setLevel(logging.WARNING)  # the library logs two lines for every connection

Client = Callable[[ServerConnection], Awaitable[None]]


class ServerThread:
    """Serves ws://host:port/. Port 0 selects a free one; ``port`` is the one in use.

    ``client`` is called in the thread for each connection and ends with it; its ConnectionClosed is
    expected. Raises StreamError, which names the server ``kind``, if the port is not available.
    """

    def __init__(self, kind: str, client: Client, host: str, port: int, **options: Any) -> None:
        """``options`` go to `websockets.asyncio.server.serve`."""
        self._client, self._options = client, options
        self._ending = False
        self.connected = 0
        """Number of connected clients."""
        started: Future[int] = Future()
        self._thread = threading.Thread(
            target=lambda: asyncio.run(self._serve(host, port, started)),
            name=f"glovetrack-{kind.lower()}",
            daemon=True,
        )
        self._thread.start()
        try:
            self.port = started.result(START_WAIT)
        except (OSError, OverflowError) as error:
            raise StreamError(
                notice("stream.server_not_started", kind=kind, host=host, port=port, why=error)
            ) from error

    def call(self, function: Callable[..., object], *args: object) -> None:
        """Schedules ``function`` in the thread; not after `close`."""
        if not self._ending:
            self._loop.call_soon_threadsafe(function, *args)

    def close(self) -> None:
        """Closes all connections and frees the port. May be called repeatedly."""
        self.call(self._ended.set)
        self._ending = True
        self._thread.join()

    async def _serve(self, host: str, port: int, started: Future[int]) -> None:
        self._loop, self._ended = asyncio.get_running_loop(), asyncio.Event()
        try:
            server: Server = await serve(
                self._welcome,
                host,
                port,
                compression=None,
                close_timeout=CLOSE_WAIT,
                logger=_log,
                **self._options,
            )
        except (OSError, OverflowError) as error:
            started.set_exception(error)
            return
        async with server:
            started.set_result(next(iter(server.sockets)).getsockname()[1])
            await self._ended.wait()

    async def _welcome(self, connection: ServerConnection) -> None:
        if self.connected >= MAX_CLIENTS:
            await connection.close(TRY_AGAIN_LATER, "too many clients")
            return
        self.connected += 1
        try:
            await self._client(connection)
        except ConnectionClosed:
            return
        finally:
            self.connected -= 1
