"""One UDP datagram of JSON per estimate; see `payload` for the form."""

from __future__ import annotations

from tracker.base.notices import Notice, notice
from tracker.messages import Estimate
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.payload import LATEST, check_schema, to_json
from tracker.streaming.publisher import LOOPBACK, Names

DEFAULT_PORT = 9750


class UdpPublisher:
    """Sends datagrams to one address without waiting."""

    def __init__(
        self,
        names: Names,
        host: str = LOOPBACK,
        port: int = DEFAULT_PORT,
        schema: int = LATEST,
    ) -> None:
        check_schema(schema)
        self._names, self._gestures, self._schema = names, names.recogniser(), schema
        self.name = notice("stream.to", stream="UDP", host=host, port=port)
        self._socket = DatagramSocket("UDP", host, port)

    def send(self, estimate: Estimate) -> None:
        self._socket.send(to_json(estimate, self._names, self._gestures, self._schema).encode())

    def probe(self) -> Notice:
        return self._socket.probe(self.name)

    def close(self) -> None:
        self._socket.close()
