"""What a protocol of remote control is made of: a plug-in under ``glovetrack.remote``.

A `DoorKind` has the name, the options and a function that opens the protocol as a `Door`, which
passes each `Request` to ``answer`` and returns the `Reply` to the program that sent it. A
`DatagramDoor` is one for UDP, given functions that parse requests and encode replies. See
``docs/streaming.md``.
"""

from tracker.streaming.connection import LOOPBACK, StreamError, option
from tracker.streaming.remote.doors import DatagramDoor, Door
from tracker.streaming.remote.reception import Answer, DoorCounts, Reception
from tracker.streaming.remote.registry import DoorKind
from tracker.streaming.remote.request import Reply, Request, RequestError, from_fields

__all__ = [
    "LOOPBACK",
    "Answer",
    "DatagramDoor",
    "Door",
    "DoorCounts",
    "DoorKind",
    "Reception",
    "Reply",
    "Request",
    "RequestError",
    "StreamError",
    "from_fields",
    "option",
]
