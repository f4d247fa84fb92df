"""A VRPN server written from the format of its protocol (Format_Of_Protocol.txt of vrpn/vrpn)."""

from __future__ import annotations

import socket
import struct
import threading
import time
from collections.abc import Callable, Sequence
from typing import Any

Senders = tuple[str, ...]
TYPES = ("VRPN_Connection_Got_Connection", "vrpn_Tracker Pos_Quat", "vrpn_Tracker Velocity")
COOKIE = b"vrpn: ver. 07.38  0"


def message(sender: int, kind: int, payload: bytes, stamp: float | None = None) -> bytes:
    """A message with the header in network order, padded to 8 bytes."""
    now = time.time() if stamp is None else stamp
    seconds, micros = int(now), int(now % 1 * 1e6)
    head = struct.pack(">IIIiiI", 24 + len(payload), seconds, micros, sender, kind, 7)
    return head + payload + bytes(-len(payload) % 8)


def described(number: int, kind: int, name: str) -> bytes:
    """The name of a sender (-1) or of a type (-2)."""
    text = name.encode() + b"\0"
    return message(number, kind, struct.pack(">I", len(text)) + text)


def pose(sender: int, sensor: int, p: Any, q: Any, stamp: float | None = None) -> bytes:
    return message(sender, 1, struct.pack(">ii7d", sensor, sensor, *p, *q), stamp)


def greeting(senders: Senders, cookie: bytes = COOKIE) -> bytes:
    out = cookie.ljust(24, b"\0")
    for number, name in enumerate(senders):
        out += described(number, -1, name)
    for number, name in enumerate(TYPES):
        out += described(number, -2, name)
    return out


class VrpnServer:
    """Greets each client, checks its cookie, and sends what `send` gets to all of them."""

    def __init__(self, senders: Senders = ("VRPN Control", "Wrist"), cookie: bytes = COOKIE):
        self._greeting = greeting(senders, cookie)
        self._listening = socket.create_server(("127.0.0.1", 0))
        self.port = self._listening.getsockname()[1]
        self.cookies: list[bytes] = []
        self._clients: list[socket.socket] = []
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        while True:
            try:
                client, _ = self._listening.accept()
            except OSError:
                return
            client.sendall(self._greeting)
            self.cookies.append(client.recv(24, socket.MSG_WAITALL))
            self._clients.append(client)

    @property
    def clients(self) -> int:
        return len(self._clients)

    def send(self, data: bytes) -> None:
        for client in list(self._clients):
            client.sendall(data)

    def drop(self) -> None:
        """End all connections; new ones are taken."""
        while self._clients:
            self._clients.pop().close()

    def __enter__(self) -> VrpnServer:
        return self

    def __exit__(self, *_: object) -> None:
        self._listening.shutdown(socket.SHUT_RDWR)
        self._listening.close()
        self._thread.join()
        self.drop()


def in_pieces(data: bytes, sizes: Sequence[int], take: Callable[[bytes], Any]) -> list[Any]:
    """What ``take`` returns of all pieces of ``data``, whose sizes repeat."""
    out: list[Any] = []
    k = 0
    while data:
        size = sizes[k % len(sizes)]
        out += take(data[:size])
        data, k = data[size:], k + 1
    return out
