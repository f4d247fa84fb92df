"""A UDP socket to one address that never waits."""

from __future__ import annotations

import socket

from tracker.base.notices import Notice, failure, notice, warning
from tracker.streaming.publisher import StreamError, Title

PROBE_WAIT = 0.3  # s for an ICMP message


class DatagramSocket:
    """Sends datagrams to host:port; ``what`` names the stream in messages.

    The name is resolved once, since a name server can take seconds. The socket stays unconnected,
    so that a missing listener ("port unreachable") does not raise an error.
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
        self._last = b""

    def send(self, data: bytes) -> None:
        """Sends one datagram. Raises OSError if the system has no buffer for it or no route."""
        self._last = data
        self._socket.sendto(data, self._address)

    def probe(self, stream: Title) -> Notice:
        """Send the last datagram once more and report whether its port is unreachable. Waits
        `PROBE_WAIT`; ``stream`` is the name in the report."""
        data = self._last
        if not data:
            return warning("stream.test_nothing", stream=stream)
        about = {"stream": stream, "size": len(data)}
        with socket.socket(self._socket.family, socket.SOCK_DGRAM) as probe:
            probe.settimeout(PROBE_WAIT)
            try:
                probe.connect(self._address)  # only then does the system report an ICMP error
                probe.send(data)
                probe.recv(1)
            except TimeoutError:
                return warning("stream.test_udp", **about)
            except OSError:
                return failure("stream.test_refused", **about)
        return notice("stream.test_clients", stream=stream, count=1)

    @property
    def is_open(self) -> bool:
        return self._socket.fileno() >= 0

    def close(self) -> None:
        self._socket.close()
