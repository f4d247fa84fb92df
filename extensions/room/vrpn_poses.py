"""Poses from a VRPN server, by one TCP connection that is made again when it ends.

VRPN is the Virtual-Reality Peripheral Network (version 7), big-endian. Both sides of a TCP
connection first send a cookie of 24 bytes, ``vrpn: ver. 07.35  0``. Then each message has a header
of five integers (length with this header, seconds and microseconds since 1970, sender, type) in 24
bytes, and a payload padded to 8 bytes. A server describes the names of its senders (type -1) and of
its types (-2); the number that is described is in the sender's place. A tracker's pose is of the
type *vrpn_Tracker Pos_Quat*: sensor, padding, x y z, qx qy qz qw.
"""

from __future__ import annotations

import contextlib
import math
import socket
import struct
import threading
from collections import deque
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from extensions.room.extension import VrpnOptions
from extensions.room.frames import UP_AXES, from_upright
from extensions.room.osc_poses import RoomPose
from extensions.room.placement import Placement, placement_of
from extensions.room.taker import PoseTaker
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.base.notices import failure, notice
from tracker.messages import Array
from tracker.streaming.connection import StreamError
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.reception import Answer, DoorCounts

PORT = 3883
COOKIE_BYTES = 24
COOKIE = b"vrpn: ver. 07.35  0".ljust(COOKIE_BYTES, b"\0")
MAJOR = b"vrpn: ver. 07."  # other versions behind the point understand each other
POSE_TYPE = "vrpn_Tracker Pos_Quat"
SENDER, TYPE = -1, -2  # types of messages that describe a name
MOST_BYTES = 1 << 16  # of one message
MOST_NAMES = 4096
_HEADER = struct.Struct(">IIIii")
_POSE = struct.Struct(">ii7d")
HEADER_BYTES = 24


class VrpnError(ValueError):
    """The bytes are not what a VRPN server sends."""


class VrpnPose(NamedTuple):
    """Pose of a sensor, p (3,) and q (4,) xyzw in the server's units and axes; ``stamp``: s since
    1970 by the server's clock."""

    tracker: str
    sensor: int
    stamp: float
    p: Array
    q: Array


class VrpnReader:
    """Reads the bytes of one connection, from the server's cookie on."""

    def __init__(self) -> None:
        self._bytes = b""
        self._greeted = False
        self._senders: dict[int, str] = {}
        self._types: dict[int, str] = {}

    @property
    def greeted(self) -> bool:
        """Whether the server's cookie has arrived."""
        return self._greeted

    def poses(self, data: bytes) -> list[VrpnPose]:
        """The poses that are complete with ``data``. Raises VrpnError."""
        self._bytes += data
        if not self._greeted:
            if len(self._bytes) < COOKIE_BYTES:
                return []
            self._greet(self._bytes[:COOKIE_BYTES])
            self._bytes = self._bytes[COOKIE_BYTES:]
        return [pose for each in self._messages() if (pose := self._read(*each)) is not None]

    def _greet(self, cookie: bytes) -> None:
        if not cookie.startswith(MAJOR):
            raise VrpnError("this is not a VRPN server of version 7")
        self._greeted = True

    def _messages(self) -> Iterator[tuple[float, int, int, bytes]]:
        """Stamp (s), sender, type and payload of each complete message, which is then dropped."""
        at = 0
        while at + HEADER_BYTES <= len(self._bytes):
            length, seconds, micros, sender, kind = _HEADER.unpack_from(self._bytes, at)
            if not HEADER_BYTES <= length <= MOST_BYTES:
                raise VrpnError("a message has an impossible length")
            end = at + -(-length // 8) * 8
            if end > len(self._bytes):
                break
            yield (
                seconds + 1e-6 * micros,
                sender,
                kind,
                self._bytes[at + HEADER_BYTES : at + length],
            )
            at = end
        self._bytes = self._bytes[at:]

    def _read(self, stamp: float, sender: int, kind: int, payload: bytes) -> VrpnPose | None:
        if kind in (SENDER, TYPE):
            names = self._senders if kind == SENDER else self._types
            if len(names) < MOST_NAMES:
                names[sender] = _name(payload)
            return None
        if self._types.get(kind) != POSE_TYPE:
            return None
        if len(payload) < _POSE.size:
            raise VrpnError("a pose is cut off")
        sensor, _, *values = _POSE.unpack_from(payload)
        p_q = np.array(values)
        length = float(np.linalg.norm(p_q[3:]))
        if not np.isfinite(p_q).all() or length < 0.5:
            return None  # the server has no pose of this sensor
        name = self._senders.get(sender, str(sender))
        return VrpnPose(name, int(sensor), stamp, p_q[:3], p_q[3:] / length)


def _name(payload: bytes) -> str:
    """For a description: its length with the zero at its end, then the name."""
    if len(payload) < 4:
        raise VrpnError("a description is cut off")
    (length,) = struct.unpack_from(">I", payload)
    return payload[4 : 4 + length].split(b"\0")[0].decode("utf-8", "replace")


WAIT = 0.2  # s between checks whether the door was closed
CONNECT_WAIT = 2.0  # s for an answer of the server's computer
AGAIN = 1.0  # s between attempts to connect
READ_BYTES = 65536
WINDOW = 10.0  # s over which the server's clock is compared with this one
MOST_LATE = 0.5  # s of a message's transit; beyond it, the stamp is not used


class VrpnPoses:
    """Reads the trackers of the server at ``server``:``port``; ``up`` is its vertical axis."""

    def __init__(
        self, answer: Answer, placement: Placement, server: str, port: int, up: str
    ) -> None:
        """Raises StreamError for an address that is none, and ConfigError for an unknown axis."""
        if up not in UP_AXES:
            raise ConfigError(failure("room.unknown_axis", axis=up))
        self.taker, self._up, self.port = PoseTaker(answer, placement), up, port
        self._address = _resolved(server, port)
        self._name, self._clients = f"VRPN server {server}:{port}", 0
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="glovetrack-remote-vrpn-poses")
        self._thread.daemon = True
        self._thread.start()

    def counts(self) -> DoorCounts:
        return self.taker.counts(self._name, self._clients)

    def close(self) -> None:
        self._ended.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._ended.is_set():
            try:
                with socket.create_connection(self._address, CONNECT_WAIT) as sock:
                    self._follow(sock)
            except VrpnError:
                self.taker.refuse()
            except OSError:  # no server there, or it has ended
                pass
            self._clients = 0
            self._ended.wait(AGAIN)

    def _follow(self, sock: socket.socket) -> None:
        reader, clock = VrpnReader(), ServerClock()
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        sock.sendall(COOKIE)
        sock.settimeout(WAIT)
        while not self._ended.is_set():
            with contextlib.suppress(TimeoutError):
                data = sock.recv(READ_BYTES)
                now = monotonic()
                if not data:
                    return
                poses = reader.poses(data)
                self._clients = int(reader.greeted)
                for pose in poses:
                    t = clock.here(pose.stamp, now)
                    self.taker.take([self._in_room(pose)], t, self._name)

    def _in_room(self, pose: VrpnPose) -> RoomPose:
        """A tracker's first sensor has its name, the others have their number behind a colon."""
        name = pose.tracker if pose.sensor == 0 else f"{pose.tracker}:{pose.sensor}"
        return RoomPose(name, *from_upright(pose.p, pose.q, self._up))


class ServerClock:
    """Instants by the server's clock as instants of this computer.

    The quickest message of the last `WINDOW` gives the offset of both clocks: what others took
    longer is not a delay of the measurement. The time that the quickest one took remains, as with
    protocols without stamps; the alignment finds it.
    """

    def __init__(self) -> None:
        self._apart: deque[tuple[float, float]] = deque()  # arrival, arrival - stamp; increasing

    def here(self, stamp: float, arrival: float) -> float:
        """s of this computer's clock at ``stamp`` (s), of a message that arrived at ``arrival``."""
        apart = arrival - stamp
        if not math.isfinite(apart):
            return arrival
        while self._apart and self._apart[-1][1] >= apart:
            self._apart.pop()
        self._apart.append((arrival, apart))
        while self._apart[0][0] < arrival - WINDOW:
            self._apart.popleft()
        t = stamp + self._apart[0][1]
        if arrival - t > MOST_LATE:  # the server's clock was set
            self._apart.clear()
            return arrival
        return t


def _resolved(server: str, port: int) -> tuple[str, int]:
    """The server's address, looked up once. Raises StreamError."""
    try:
        found = socket.getaddrinfo(server, port, socket.AF_INET, socket.SOCK_STREAM)
    except (OSError, OverflowError, UnicodeError) as error:
        raise StreamError(
            notice("remote.not_started", kind="VRPN", host=server, port=port, why=error)
        ) from error
    host, number = found[0][4][:2]
    return str(host), int(number)


def open_vrpn(options: VrpnOptions, answer: Answer) -> Door:
    """Starts to receive poses."""
    return VrpnPoses(answer, placement_of(options), options.server, options.port, options.up)
