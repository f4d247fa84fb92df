"""Lines of the Hand Tracking Streamer (github.com/wengmister/hand-tracking-streamer).

    Right wrist | f=12 | t=1732538096123456789:, x, y, z, qx, qy, qz, qw
    Right landmarks | f=12 | t=1732538096123456789:, 63 numbers

in m and Unity's axes (x right, y up, z forward); landmarks in the wrist's axes, with the wrist at
0 0 0. A hand that lies flat, palm down, and points ahead has no rotation. What is lost is not sent:
without the wrist neither line, without a landmark only the wrist's.
"""

from __future__ import annotations

import contextlib
import socket
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from extensions.landmarks.points import UNITY_OF_G, WRIST, Landmarks, landmarks_of
from tracker.base.notices import Notice, notice
from tracker.geometry import so3
from tracker.messages import Array, Estimate
from tracker.streaming.connection import LOOPBACK, StreamError, option
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.publisher import Names, Publisher, Title
from tracker.streaming.registry import StreamKind

DECIMALS = 6  # µm
NUMBER = f", %.{DECIMALS}f"


@dataclass(frozen=True)
class HtsOptions:
    host: str = option(LOOPBACK, "destination; with transport server, the listening address")
    port: int = option(9000, "port")
    transport: str = option(
        "udp",
        "udp; tcp: connect to a program that listens; server: wait for programs to connect",
        ("udp", "tcp", "server"),
    )
    numbered: bool = option(False, "whether lines have a frame number and a time")


class HtsPublisher:
    """The lines of one hand; ``owner`` closes what they are sent by."""

    def __init__(self, names: Names, lines: LineSender, numbered: bool, owner: bool) -> None:
        self._names, self._lines, self._numbered, self._owner = names, lines, numbered, owner
        self.name = lines.name

    @property
    def clients(self) -> int | None:
        """Connections by TCP; None by UDP."""
        return getattr(self._lines, "clients", None)

    def send(self, estimate: Estimate) -> None:
        lines = hts_lines(estimate, self._names, self._numbered)
        if lines:
            self._lines.send(lines)

    def probe(self) -> Notice | None:
        return self._lines.probe()

    def close(self) -> None:
        if self._owner:
            self._lines.close()


def hts_lines(e: Estimate, names: Names, numbered: bool) -> list[str]:
    """What is known of the hand, as lines without their ends."""
    hand = landmarks_of(e, names)
    if not hand.has_wrist:
        return []
    meta = ""
    if numbered:
        unix_ns = names.wall_ns(e.t)
        meta = f" | f={e.seq} | t={round(e.t * 1e9) if unix_ns is None else unix_ns}"
    side = names.side.title()
    out = [f"{side} wrist{meta}:{_numbers(_wrist(hand))}"]
    if hand.whole:
        out.append(f"{side} landmarks{meta}:{_numbers(_local(hand).ravel())}")
    return out


def _wrist(hand: Landmarks) -> Array:
    """Position and quaternion in Unity's axes."""
    R = UNITY_OF_G @ hand.R_GB @ UNITY_OF_G.T
    return np.concatenate([UNITY_OF_G @ hand.points[WRIST], so3.quat_from_matrix(R)])


def _local(hand: Landmarks) -> Array:
    """(21, 3) m in the wrist's axes, which Unity's name."""
    from_wrist: Array = (hand.points - hand.points[WRIST]) @ hand.R_GB @ UNITY_OF_G.T
    return from_wrist


def _numbers(values: Array) -> str:
    rounded = (np.round(values, DECIMALS) + 0.0).tolist()  # no -0
    return NUMBER * len(rounded) % tuple(rounded)


def _publishers(options: HtsOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    lines = open_lines(options.transport, "HTS", options.host, options.port)
    for i, names in enumerate(hands):
        yield HtsPublisher(names, lines, options.numbered, owner=i == 0)


HTS = StreamKind(
    name="hts", title="Hand Tracking Streamer", options=HtsOptions, make=_publishers, order=24
)


# ---- where lines of text are sent: datagrams, a connection to a server, or our server's clients

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
