"""A stream of lines of JSON to a TCP server: ``glovetrack demo --stream tcp:9800``."""

from __future__ import annotations

import socket
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from glovetrack.streams import Estimate, Names, StreamError, StreamKind, option, to_json


@dataclass(frozen=True)
class TcpOptions:
    host: str = option("127.0.0.1", "address of the server")
    port: int = option(9800, "port of the server")
    timeout: float = option(1.0, "time for connecting and for sending, s")


class TcpPublisher:
    """Connects when it is opened; each hand has a connection of its own."""

    def __init__(self, options: TcpOptions, names: Names) -> None:
        self.name = f"TCP to {options.host}:{options.port}"
        self._names = names
        try:
            self._socket = socket.create_connection((options.host, options.port), options.timeout)
        except OSError as error:
            raise StreamError(f"No server at {options.host}:{options.port}: {error}.") from error

    def send(self, estimate: Estimate) -> None:
        self._socket.sendall(to_json(estimate, self._names).encode() + b"\n")

    def close(self) -> None:
        self._socket.close()


def _make(options: TcpOptions, hands: Sequence[Names]) -> Iterator[TcpPublisher]:
    for names in hands:
        yield TcpPublisher(options, names)


STREAM = StreamKind(name="tcp", title="TCP (JSON lines)", options=TcpOptions, make=_make)
