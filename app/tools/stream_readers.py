"""Reads all live streams of this computer, as the programs do for which they are meant.

``python -m app.tools.stream_readers udp=9750 websocket=9751 …`` reads until its input ends, in a
process of its own, and prints how many messages it received of each as JSON: after each line of
input, and at the end.
"""

from __future__ import annotations

import contextlib
import json
import socket
import sys
import threading
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from websockets.exceptions import WebSocketException
from websockets.sync.client import connect
from websockets.typing import Subprotocol

LOOPBACK = "127.0.0.1"
AGAIN = 0.2  # s between attempts to connect
DATAGRAMS = ("udp", "vmc", "vmt", "hts", "mediapipe", "poses")
FOXGLOVE = "foxglove.sdk.v1"
Count = Callable[[], None]


def main(argv: Sequence[str] | None = None) -> int:
    wanted = [word.split("=") for word in (sys.argv[1:] if argv is None else argv)]
    counts: Counter[str] = Counter()
    ended = threading.Event()
    for name, port in wanted:
        read = _reader_of(name)
        if read is not None:
            args = (read, int(port), lambda name=name: counts.update([name]), ended)
            threading.Thread(target=_again, args=args, daemon=True).start()
    for _ in sys.stdin:
        print(json.dumps(counts), flush=True)
    ended.set()
    print(json.dumps(counts))
    return 0


def _reader_of(name: str) -> Callable[[int, Count], None] | None:
    if name in DATAGRAMS:
        return _read_datagrams
    return {"websocket": _read_websocket, "foxglove": _read_foxglove, "lsl": _read_lsl}.get(name)


def _again(
    read: Callable[[int, Count], None], port: int, count: Count, ended: threading.Event
) -> None:
    """Connects again whenever the stream is closed."""
    while not ended.is_set():
        try:
            read(port, count)
        except (OSError, LookupError, RuntimeError):  # it is off, or was closed
            ended.wait(AGAIN)


def _read_datagrams(port: int, count: Count) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind((LOOPBACK, port))
        while sock.recv(65536):
            count()


@contextlib.contextmanager
def _connected(port: int, protocols: Sequence[str] = ()) -> Iterator[Any]:
    """A WebSocket; its errors are OSError."""

    display_name = [Subprotocol(name) for name in protocols] or None
    try:
        with connect(f"ws://{LOOPBACK}:{port}/", subprotocols=display_name) as connection:
            yield connection
    except WebSocketException as error:
        raise OSError(str(error)) from error


def _read_websocket(port: int, count: Count) -> None:
    with _connected(port) as connection:
        for _ in connection:
            count()


def _read_foxglove(port: int, count: Count) -> None:
    with _connected(port, [FOXGLOVE]) as connection:
        for message in connection:
            if isinstance(message, bytes):
                count()
                continue
            parsed = json.loads(message)
            if parsed["op"] == "advertise":
                topics = [{"id": c["id"], "channelId": c["id"]} for c in parsed["channels"]]
                connection.send(json.dumps({"op": "subscribe", "subscriptions": topics}))


def _read_lsl(_port: int, count: Count) -> None:
    import pylsl  # deferred: fails without its library

    found = pylsl.resolve_byprop("name", "Glovetrack right", 1, 1.0)
    inlet = pylsl.StreamInlet(found[0], recover=False)
    while True:
        samples, _ = inlet.pull_chunk(timeout=1.0)
        for _ in samples or ():
            count()


if __name__ == "__main__":
    sys.exit(main())
