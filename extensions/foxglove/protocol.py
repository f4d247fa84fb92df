"""The words of Foxglove's WebSocket protocol that a server of a few fixed channels needs.

Source: github.com/foxglove/ws-protocol, docs/spec.md. ``foxglove.sdk.v1`` is what Foxglove speaks
today, ``foxglove.websocket.v1`` what it and its descendants (Lichtblick) spoke before; what is used
here is the same in both. Text is JSON with an ``op``; data is binary and little-endian.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Collection, Iterable
from dataclasses import dataclass

from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice

SUBPROTOCOLS = ("foxglove.sdk.v1", "foxglove.websocket.v1")
MESSAGE_DATA = 1
"""Opcode of a binary message: subscription's number (uint32), time in ns (uint64), payload."""
ERROR_LEVEL = 2  # of a status: 0 info, 1 warning


class ProtocolError(GlovetrackError):
    """A client sent an invalid message; the text is sent to the client."""


@dataclass(frozen=True)
class Channel:
    """A topic. ``schema`` describes one message: its JSON schema, or for messages of ROS 2
    (``encoding`` cdr, ``schema_encoding`` ros2msg) its definition."""

    id: int
    topic: str
    schema_name: str
    schema: str
    encoding: str = "json"
    schema_encoding: str = "jsonschema"


def server_info(name: str, session_id: str) -> str:
    """What a client hears first. No capabilities: clients can subscribe and nothing else."""
    return json.dumps(
        {"op": "serverInfo", "name": name, "capabilities": [], "sessionId": session_id}
    )


def advertise(channels: Iterable[Channel]) -> str:
    """What there is to subscribe to."""
    offered = [
        {
            "id": c.id,
            "topic": c.topic,
            "encoding": c.encoding,
            "schemaName": c.schema_name,
            "schemaEncoding": c.schema_encoding,
            "schema": c.schema,
        }
        for c in channels
    ]
    return json.dumps({"op": "advertise", "channels": offered})


def error(text: str) -> str:
    """A status that Foxglove shows to its user."""
    return json.dumps({"op": "status", "level": ERROR_LEVEL, "message": text})


def message_data(subscription: int, stamp_ns: int, payload: bytes) -> bytes:
    """One message of a channel, for the client that calls its subscription so."""
    return struct.pack("<BIQ", MESSAGE_DATA, subscription, stamp_ns) + payload


class Subscriptions:
    """What one client wants: at most one subscription a channel, numbered by the client."""

    def __init__(self, channels: Collection[int]) -> None:
        self._known = channels
        self.by_channel: dict[int, int] = {}
        """The client's number for each channel it wants."""

    def receive(self, text: str | bytes) -> None:
        """Take a message of the client. Raises ProtocolError; earlier subscriptions remain."""
        try:
            request = json.loads(text)
            op = request["op"]
            if op == "subscribe":
                for one in request["subscriptions"]:
                    self._add(_uint32(one["id"]), _uint32(one["channelId"]))
            elif op == "unsubscribe":
                removed = {_uint32(number) for number in request["subscriptionIds"]}
                self.by_channel = {c: s for c, s in self.by_channel.items() if s not in removed}
            else:
                raise ProtocolError(notice("foxglove.no_operation", operation=op))
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            raise ProtocolError(notice("foxglove.not_understood", why=repr(error))) from error

    def _add(self, subscription: int, channel: int) -> None:
        if channel not in self._known:
            raise ProtocolError(notice("foxglove.no_channel", channel=channel))
        if channel in self.by_channel or subscription in self.by_channel.values():
            raise ProtocolError(
                notice("foxglove.second", subscription=subscription, channel=channel)
            )
        self.by_channel[channel] = subscription


def _uint32(value: object) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value < 2**32:
        raise ValueError(f"{value!r} is not a number from 0 to 4294967295")
    return value
