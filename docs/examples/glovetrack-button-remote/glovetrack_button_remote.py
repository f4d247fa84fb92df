"""Remote control by single bytes over UDP, as a button box sends them: ``1`` starts a recording,
``0`` stops it, any other letter is a note. The reply is ``+`` or ``-``.

``glovetrack demo --remote button:9770``
"""

from __future__ import annotations

from dataclasses import dataclass

from glovetrack.notices import plain
from glovetrack.remote import (
    LOOPBACK,
    Answer,
    DatagramDoor,
    Door,
    DoorKind,
    Reply,
    Request,
    RequestError,
    option,
)

COMMANDS = {b"1": "start", b"0": "stop"}


@dataclass(frozen=True)
class ButtonOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(9770, "listening port")


def parse(data: bytes, t: float) -> Request:
    """``t``: arrival time on the host's monotonic clock, s."""
    if len(data) != 1 or not data.isalnum():
        raise RequestError(plain("A button sends one digit or letter."))
    if data in COMMANDS:
        return Request(COMMANDS[data], t)
    return Request("note", t, text=f"button {data.decode('ascii')}")


def encode(reply: Reply) -> bytes:
    return b"+" if reply.ok else b"-"


def _open(options: ButtonOptions, answer: Answer) -> Door:
    return DatagramDoor("button", (parse, encode), answer, options.host, options.port)


BUTTON = DoorKind(name="button", title="Button box", options=ButtonOptions, make=_open)
