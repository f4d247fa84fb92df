"""Requests and answers as OSC: ``/glovetrack/note "the cup is taken"``.

An answer goes to the port that asked: ``/glovetrack/reply do ok sentence file``. Values stand in
the order of `request.FIELDS`; those at the end may be left out.
"""

from __future__ import annotations

from dataclasses import dataclass

from extensions.osc import decode as osc_decode
from extensions.osc import encode as osc_encode
from extensions.osc.decode import OscError
from tracker.base.notices import notice
from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.remote.doors import DatagramDoor, Door
from tracker.streaming.remote.reception import Answer
from tracker.streaming.remote.registry import DoorKind
from tracker.streaming.remote.request import (
    FIELDS,
    MOST_BYTES,
    Reply,
    Request,
    RequestError,
    from_fields,
)

ROOT = "/glovetrack/"
REPLY = f"{ROOT}reply"


@dataclass(frozen=True)
class OscOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(9761, "listening port")


def parse(data: bytes, t: float) -> Request | None:
    """None for an answer, which is not answered again. Raises RequestError."""
    if len(data) > MOST_BYTES:
        raise RequestError(notice("request.too_long", most=MOST_BYTES))
    try:
        address, values = osc_decode.message(data)
    except OscError as error:
        raise RequestError(notice("osc.not_osc", why=error)) from error
    if address == REPLY:
        return None
    do = address.removeprefix(ROOT)
    if not address.startswith(ROOT) or do not in FIELDS:
        addresses = ", ".join(ROOT + name for name in FIELDS)
        raise RequestError(notice("osc.address", addresses=addresses))
    if not FIELDS[do] and len(values) == 1:  # of a button: one when pressed, zero when let go
        if values[0] in (0, ""):
            return None
        values = []
    if len(values) > len(FIELDS[do]):
        raise RequestError(
            notice("osc.values", address=address, expected=len(FIELDS[do]), found=len(values))
        )
    return from_fields({"do": do, **dict(zip(FIELDS[do], values, strict=False))}, t)


def encode(reply: Reply) -> bytes:
    """The answer as one message."""
    name = reply.file.name if reply.file is not None else ""
    return osc_encode.message(REPLY, reply.do, int(reply.ok), reply.text, name)


def _door(options: OscOptions, answer: Answer) -> Door:
    return DatagramDoor("OSC", (parse, encode), answer, options.host, options.port)


REMOTE = DoorKind(name="osc", title="OSC", options=OscOptions, make=_door, order=11)
