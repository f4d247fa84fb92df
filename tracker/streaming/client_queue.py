"""The messages that one client of a server has yet to receive."""

from __future__ import annotations

import asyncio
import contextlib
from collections import deque

from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

BACKLOG = 64  # messages per client


class ClientQueue:
    """The newest `BACKLOG` messages; ``dropped`` counts those that a slow client has missed.

    For the server's thread alone, except ``name`` and ``dropped``, which any thread may read.
    """

    def __init__(self, connection: ServerConnection) -> None:
        self._connection = connection
        self.name = _address(connection.remote_address)
        self.dropped = 0
        self._waiting: deque[str | bytes] = deque(maxlen=BACKLOG)
        self._fresh = asyncio.Event()

    def put(self, message: str | bytes) -> None:
        """Queue a message; a full queue discards its oldest."""
        self.dropped += len(self._waiting) == BACKLOG
        self._waiting.append(message)
        self._fresh.set()

    async def send(self) -> None:
        """Send queued messages until the client leaves; a slow client is awaited here."""
        with contextlib.suppress(ConnectionClosed):
            while True:
                while self._waiting:
                    await self._connection.send(self._waiting.popleft())
                self._fresh.clear()
                await self._fresh.wait()


def _address(address: object) -> str:
    """``host:port`` of a client."""
    return f"{address[0]}:{address[1]}" if isinstance(address, tuple) else str(address)
