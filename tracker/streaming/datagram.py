"""A UDP socket to one address that never waits."""

from __future__ import annotations

import socket

from tracker.base.notices import notice
from tracker.streaming.publisher import StreamError


class DatagramSocket:
    """Sends datagrams to host:port; ``what`` names the stream in messages.

    The name is resolved once, since a name server can take seconds. The socket stays unconnected,
    so that the absence of a listener ("port unreachable") does not come back as an error.
    """

    def __init__(self, what: str, host: str, port: int) -> None:
        to = {"what": what, "host": host, "port": port}
        if not 1 <= port <= 65535:
            raise StreamError(notice("stream.port_range", **to))
        try:
            found = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)
        except (OSError, UnicodeError) as error:
            raise StreamError(notice("stream.no_route", why=error, **to)) from error
        family, _, _, _, address = found[0]
        self._address: tuple[object, ...] = address
        self._socket = socket.socket(family, socket.SOCK_DGRAM)
        self._socket.setblocking(False)

    def send(self, data: bytes) -> None:
        """One datagram. Raises OSError where the system has no room for it or no way to it."""
        self._socket.sendto(data, self._address)

    @property
    def is_open(self) -> bool:
        return self._socket.fileno() >= 0

    def close(self) -> None:
        self._socket.close()
