"""Where lines of text are sent: datagrams, a connection to a server, or our server's clients."""

from __future__ import annotations

import contextlib
import socket
import threading
import time
from collections.abc import Callable
from typing import Protocol

from tracker.base.notices import Notice, notice
from tracker.streaming.connection import StreamError
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.publisher import Title

UDP, TCP, SERVER = TRANSPORTS = ("udp", "tcp", "server")
CONNECT_WAIT, RETRY_AFTER = 0.5, 1.0  # s
MOST_CLIENTS = 16


class LineSender(Protocol):
    """Sends lines; of all hands, from a thread of each."""

    @property
    def name(self) -> Title: ...

    def send(self, lines: list[str]) -> None: ...

    def probe(self) -> Notice | None:
        """Whether a program receives; None if the number of connections shows it."""

    def close(self) -> None: ...


class DatagramLines:
    """One datagram for each line."""

    def __init__(self, what: str, host: str, port: int) -> None:
        self.name = notice("stream.to", stream=f"{what} (UDP)", host=host, port=port)
        self.socket = DatagramSocket(what, host, port)

    def send(self, lines: list[str]) -> None:
        for line in lines:
            self.socket.send(f"{line}\n".encode())

    def probe(self) -> Notice | None:
        return self.socket.probe(self.name)

    def close(self) -> None:
        self.socket.close()


class ConnectedLines:
    """A TCP connection to host:port, which is made when there is something to send and made again
    after it breaks. Raises StreamError meanwhile."""

    def __init__(self, what: str, host: str, port: int) -> None:
        self.name = notice("stream.to", stream=f"{what} (TCP)", host=host, port=port)
        self._address, self._lock = (host, port), threading.Lock()
        self._socket: socket.socket | None = None
        self._due = 0.0  # s of the monotonic clock when the next attempt is made
        self._closed = False

    @property
    def clients(self) -> int:
        """Whether a server is connected: 1 or 0."""
        return int(self._socket is not None)

    def send(self, lines: list[str]) -> None:
        with self._lock:
            if not self._closed:
                self._write("".join(f"{line}\n" for line in lines).encode())

    def probe(self) -> Notice | None:
        return None

    def _write(self, data: bytes) -> None:
        if self._socket is None:
            self._socket = self._connected()
        try:
            self._socket.sendall(data)
        except OSError as error:
            self._socket.close()
            self._socket = None
            raise StreamError(notice("stream.failed", stream=self.name, why=error)) from error

    def _connected(self) -> socket.socket:
        now = time.monotonic()
        if now < self._due:
            raise StreamError(notice("stream.not_connected", stream=self.name))
        self._due = now + RETRY_AFTER
        try:
            out = socket.create_connection(self._address, CONNECT_WAIT)
        except OSError as error:
            raise StreamError(
                notice("stream.no_connection", stream=self.name, why=error)
            ) from error
        out.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return out

    def close(self) -> None:
        with self._lock:
            self._closed = True
            if self._socket is not None:
                self._socket.close()
                self._socket = None


class ServedLines:
    """A TCP server; each client gets all lines from its connection on. A client that does not read
    is disconnected when the system's buffer is full."""

    def __init__(self, what: str, host: str, port: int) -> None:
        try:
            self._server = socket.create_server((host, port))
        except (OSError, OverflowError) as error:
            raise StreamError(
                notice("stream.server_not_started", kind=what, host=host, port=port, why=error)
            ) from error
        self._server.setblocking(False)
        self.port = self._server.getsockname()[1]
        self.name = notice("stream.at", stream=f"{what} (TCP)", host=host, port=self.port)
        self._clients: list[socket.socket] = []
        self._lock = threading.Lock()

    @property
    def clients(self) -> int:
        return len(self._clients)

    def send(self, lines: list[str]) -> None:
        data = "".join(f"{line}\n" for line in lines).encode()
        with self._lock:
            self._accept()
            for client in list(self._clients):
                try:
                    if client.send(data) < len(data):
                        raise BlockingIOError
                except OSError:
                    client.close()
                    self._clients.remove(client)

    def probe(self) -> Notice | None:
        return None

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                client, _ = self._server.accept()
                if len(self._clients) == MOST_CLIENTS:
                    client.close()
                    continue
                client.setblocking(False)
                self._clients.append(client)

    def close(self) -> None:
        with self._lock:
            for each in (*self._clients, self._server):
                each.close()
            self._clients.clear()


def open_lines(transport: str, what: str, host: str, port: int) -> LineSender:
    """Raises StreamError for an unknown transport, and where it cannot be opened."""
    if transport not in TRANSPORTS:
        raise StreamError(
            notice("option.choice", option="transport", known=TRANSPORTS, value=transport)
        )
    kinds: dict[str, Callable[[str, str, int], LineSender]]
    kinds = {UDP: DatagramLines, TCP: ConnectedLines, SERVER: ServedLines}
    return kinds[transport](what, host, port)
