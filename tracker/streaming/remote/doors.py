"""The sockets through which requests arrive: datagrams and WebSocket.

Each has its own thread, in which a message is stamped on arrival, however loaded the window
is. Datagrams above the limit are dropped without an answer; a WebSocket client that sends too many
requests is disconnected. Pages of other sites are rejected, as by the other servers.
"""

from __future__ import annotations

import asyncio
import contextlib
import ipaddress
import threading
from collections.abc import Callable
from concurrent.futures import Future
from functools import partial
from typing import TYPE_CHECKING, Any, Protocol, cast

from tracker.base.notices import failure, notice
from tracker.streaming.connection import StreamError
from tracker.streaming.remote.reception import Answer, DoorCounts, Reception
from tracker.streaming.remote.request import MOST_BYTES, Reply, Request, parse

if TYPE_CHECKING:
    from websockets.asyncio.server import ServerConnection

START_WAIT = 5.0  # s
ANSWER_WAIT = 10.0  # s without an answer after which a WebSocket client receives an error
TOO_MUCH = 1008  # close code: policy violation
Parse = Callable[[bytes, float], Request | None]
Encode = Callable[[Reply], bytes]


class Door(Protocol):
    """An open socket. ``close`` frees its port and may be called repeatedly."""

    @property
    def port(self) -> int: ...

    def counts(self) -> DoorCounts: ...

    def close(self) -> None: ...


class DatagramDoor:
    """Serves UDP at host:port; port 0 selects a free one. Raises StreamError."""

    def __init__(
        self, kind: str, codec: tuple[Parse, Encode], answer: Answer, host: str, port: int
    ) -> None:
        self._codec, self._reception = codec, Reception(answer)
        self._ended = threading.Event()
        started: Future[tuple[asyncio.AbstractEventLoop, asyncio.Event, int]] = Future()
        self._thread = threading.Thread(
            target=lambda: asyncio.run(self._serve(host, port, started)),
            name=f"glovetrack-remote-{kind.lower()}",
            daemon=True,
        )
        self._thread.start()
        try:
            self._loop, self._stop, self.port = started.result(START_WAIT)
        except (OSError, OverflowError, UnicodeError) as error:
            raise StreamError(
                notice("remote.not_started", kind=kind, host=host, port=port, why=error)
            ) from error
        self.name = notice("stream.at", stream=kind, host=host, port=self.port)

    def counts(self) -> DoorCounts:
        return self._reception.counts(self.name, None)

    def close(self) -> None:
        if not self._ended.is_set():
            self._ended.set()
            self._loop.call_soon_threadsafe(self._stop.set)
        self._thread.join()

    async def _serve(self, host: str, port: int, started: Future[Any]) -> None:
        loop, stop = asyncio.get_running_loop(), asyncio.Event()
        try:
            transport, _ = await loop.create_datagram_endpoint(
                lambda: _Datagrams(self._codec, self._reception), local_addr=(host, port)
            )
        except (OSError, OverflowError, UnicodeError) as error:
            started.set_exception(error)
            return
        with contextlib.closing(transport):
            started.set_result((loop, stop, transport.get_extra_info("sockname")[1]))
            await stop.wait()


class _Datagrams(asyncio.DatagramProtocol):
    """Receives datagrams and answers their senders."""

    def __init__(self, codec: tuple[Parse, Encode], reception: Reception) -> None:
        self._parse, self._encode = codec
        self._reception = reception

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self._transport = cast(asyncio.DatagramTransport, transport)
        self._loop = asyncio.get_running_loop()

    def datagram_received(self, data: bytes, address: tuple[Any, ...]) -> None:
        t = self._reception.admit(f"{address[0]}:{address[1]}")
        if t is None:
            return
        future = self._reception.take(partial(self._parse, data, t))
        if future is not None:
            future.add_done_callback(lambda done: self._later(done, address))

    def _later(self, done: Future[Reply], address: tuple[Any, ...]) -> None:
        """Called in the acting thread; the loop may have ended meanwhile."""
        if not done.cancelled():
            with contextlib.suppress(RuntimeError):
                self._loop.call_soon_threadsafe(self._send, done.result(), address)

    def _send(self, reply: Reply, address: tuple[Any, ...]) -> None:
        if not self._transport.is_closing():
            self._transport.sendto(self._encode(reply), address)


class WebSocketDoor:
    """Serves ws://host:port/; a message is a request, each is answered in turn."""

    def __init__(self, answer: Answer, host: str, port: int) -> None:
        # deferred: needs an extra
        from tracker.streaming.server_thread import LOCAL_PAGE, ServerThread

        self._reception = Reception(answer)
        self._server = ServerThread(
            "remote WebSocket",
            self._client,
            host,
            port,
            origins=[None, LOCAL_PAGE],
            max_size=MOST_BYTES,
        )
        self.port = self._server.port
        self.name = notice("stream.at", stream="WebSocket", host=host, port=self.port)

    def counts(self) -> DoorCounts:
        return self._reception.counts(self.name, self._server.connected)

    def close(self) -> None:
        self._server.close()

    async def _client(self, connection: ServerConnection) -> None:
        peer = "{}:{}".format(*connection.remote_address[:2])
        async for message in connection:
            t = self._reception.admit(peer)
            if t is None:
                await connection.close(TOO_MUCH, "too many requests")
                return
            future = self._reception.take(partial(parse, message, t))
            if future is not None:
                await connection.send((await _reply(future)).as_json())


async def _reply(future: Future[Reply]) -> Reply:
    """Returns the reply; a request that waits too long is cancelled."""
    try:
        return await asyncio.wait_for(asyncio.wrap_future(future), ANSWER_WAIT)
    except TimeoutError:
        return Reply.refused("", failure("remote.no_answer"))


def udp_door(answer: Answer, host: str, port: int) -> Door:
    """Handles JSON or plain text; the answer is JSON."""
    return DatagramDoor("UDP", (parse, lambda r: r.as_json().encode()), answer, host, port)


def is_loopback(host: str) -> bool:
    """Whether ``host`` can be reached only from this computer."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"
