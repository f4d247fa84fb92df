"""Where poses arrive: a UDP socket and a thread, which pass them to the hands as they come.

They take no way through the window: a pose that waits for it would be late.
"""

from __future__ import annotations

import contextlib
import socket
import struct
import threading
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from extensions.osc.decode import OscError
from extensions.room.extension import NatNetOptions, OscPoseOptions
from extensions.room.frames import UP_AXES, from_upright
from extensions.room.osc_poses import PoseReader, RoomPose
from extensions.room.placement import Placement, placement_of
from extensions.room.taker import PoseTaker
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.base.notices import failure, notice
from tracker.messages import Array
from tracker.streaming.connection import StreamError
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.reception import Answer, DoorCounts

WAIT = 0.2  # s between checks whether the door was closed
MOST_BYTES = 65536
CONNECT_EVERY = 1.0  # s between requests for a server's description, and to keep its stream


class UdpPoses:
    """Reads packets at a socket until it is closed. ``read`` raises ValueError for a packet that
    it cannot read; ``between`` is called between packets with the time (s)."""

    def __init__(
        self,
        name: str,
        sock: socket.socket,
        taker: PoseTaker,
        read: Callable[[bytes], Sequence[RoomPose]],
        between: Callable[[float], None] = lambda now: None,
    ) -> None:
        self._socket, self.taker, self._read, self._between = sock, taker, read, between
        sock.settimeout(WAIT)
        self.port = sock.getsockname()[1]
        self._name = f"{name} at {sock.getsockname()[0]}:{self.port}"
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="glovetrack-remote-poses")
        self._thread.daemon = True
        self._thread.start()

    def counts(self) -> DoorCounts:
        return self.taker.counts(self._name)

    def close(self) -> None:
        self._ended.set()
        self._thread.join()

    def _run(self) -> None:
        with contextlib.closing(self._socket):
            while not self._ended.is_set():
                self._between(monotonic())
                try:
                    data, address = self._socket.recvfrom(MOST_BYTES)
                except TimeoutError:
                    continue
                except OSError:  # such as no process at the address of a request
                    continue
                self._packet(data, f"{address[0]}:{address[1]}")

    def _packet(self, data: bytes, peer: str) -> None:
        t = monotonic()
        try:
            poses = self._read(data)
        except (OscError, NatNetError):
            self.taker.refuse()
            return
        self.taker.take(poses, t, peer)


def osc_door(answer: Answer, placement: Placement, host: str, port: int) -> UdpPoses:
    """Poses by VMC, VRChat's and our own addresses. Raises StreamError."""
    taker = PoseTaker(answer, placement)
    return UdpPoses("OSC poses", _bound("OSC poses", host, port), taker, PoseReader().poses)


class NatNetServer:
    """What is known of Motive: the version of its protocol, and who asks it for data.

    With a ``server`` (its address) it is asked for its version and, in unicast, for its frames.
    """

    def __init__(self, sock: socket.socket, server: str, up: str, version: Version) -> None:
        self._socket, self._server, self._up, self._version = sock, server, up, version
        self._next = 0.0

    def between(self, now: float) -> None:
        """Asks again now and then: the server forgets clients that are silent."""
        if self._server and now >= self._next:
            self._next = now + CONNECT_EVERY
            with contextlib.suppress(OSError):
                for kind in (CONNECT, KEEP_ALIVE):
                    address = (self._server, COMMAND_PORT)
                    self._socket.sendto(request(kind), address)

    def read(self, data: bytes) -> list[RoomPose]:
        """The poses of the bodies that are tracked. Raises NatNetError."""
        kind = kind_of(data)
        if kind == SERVER_INFO:
            self._version = protocol_version(data)
        if kind != FRAME_OF_DATA:
            return []
        bodies = rigid_bodies(data, self._version)
        return [
            RoomPose(str(b.number), *from_upright(b.p, b.q, self._up)) for b in bodies if b.valid
        ]


def natnet_door(
    answer: Answer, placement: Placement, host: str, port: int, server: str, group: str, up: str
) -> UdpPoses:
    """Rigid bodies from Motive. Raises StreamError, and ConfigError for an unknown axis."""
    if up not in UP_AXES:
        raise ConfigError(failure("room.unknown_axis", axis=up))
    sock = _bound("NatNet", host if not group else "", port, shared=bool(group))
    if group:
        _join("NatNet", sock, group, host)
    motive = NatNetServer(sock, server, up, (4, 1))
    return UdpPoses("NatNet", sock, PoseTaker(answer, placement), motive.read, motive.between)


def _bound(kind: str, host: str, port: int, shared: bool = False) -> socket.socket:
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        if shared:
            sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        sock.bind((host, port))
    except (OSError, OverflowError) as error:
        sock.close()
        raise StreamError(
            notice("remote.not_started", kind=kind, host=host, port=port, why=error)
        ) from error
    return sock


def _join(kind: str, sock: socket.socket, group: str, host: str) -> None:
    """Take part in a multicast group by the network of ``host``."""
    try:
        member = struct.pack("4s4s", socket.inet_aton(group), socket.inet_aton(host))
        sock.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, member)
    except OSError as error:
        sock.close()
        raise StreamError(
            notice("remote.not_started", kind=kind, host=group, port=0, why=error)
        ) from error


def open_osc(options: OscPoseOptions, answer: Answer) -> Door:
    """Starts to receive poses."""
    return osc_door(answer, placement_of(options), options.host, options.port)


def open_natnet(options: NatNetOptions, answer: Answer) -> Door:
    """Starts to receive poses."""
    where = (options.host, options.port, options.server, options.group, options.up)
    return natnet_door(answer, placement_of(options), *where)


# ---- rigid bodies from OptiTrack's NatNet packets (protocol 2.6 to 4.x), little-endian
#
# A frame of data contains marker sets, unlabelled markers, then rigid bodies; since 4.1 the size
# of each section in bytes follows its count. What comes after the rigid bodies is not read.

CONNECT, SERVER_INFO, FRAME_OF_DATA, KEEP_ALIVE = 0, 1, 7, 10
GROUP = "239.255.42.99"  # the multicast group that Motive uses by default
COMMAND_PORT, DATA_PORT = 1510, 1511
MOST = 4096  # elements of a section
_NAME = 256  # bytes of the server's name, before its versions
Version = tuple[int, int]


class NatNetError(ValueError):
    """The packet cannot be read."""


class RigidBody(NamedTuple):
    """p (3,) m and q (4,) xyzw in Motive's axes; ``valid``: the cameras track it."""

    number: int
    p: Array
    q: Array
    valid: bool


class _Reader:
    def __init__(self, data: bytes) -> None:
        self._data, self._at = data, 0

    def take(self, form: str) -> tuple[float, ...]:
        values = struct.unpack_from(form, self._data, self._at)
        self._at += struct.calcsize(form)
        return values

    def count(self, sized: bool) -> int:
        n = int(self.take("<i")[0])
        if sized:
            self.take("<i")
        if not 0 <= n <= MOST:
            raise NatNetError("a section has an impossible number of elements")
        return n

    def skip(self, size: int) -> None:
        self._at += size
        if self._at > len(self._data):
            raise NatNetError("the packet is cut off")

    def skip_text(self) -> None:
        end = self._data.find(b"\0", self._at)
        if end < 0:
            raise NatNetError("a name has no end")
        self._at = end + 1


def kind_of(data: bytes) -> int:
    """The message's kind; -1 of what is not a packet."""
    return int(struct.unpack_from("<H", data)[0]) if len(data) >= 4 else -1


def request(kind: int) -> bytes:
    """A request of a client without content."""
    return struct.pack("<HH", kind, 0) + b"\0"


def protocol_version(data: bytes) -> Version:
    """For a server's answer to `CONNECT`. Raises NatNetError."""
    if kind_of(data) != SERVER_INFO or len(data) < 4 + _NAME + 8:
        raise NatNetError("this is not a server's description")
    return data[4 + _NAME + 4], data[4 + _NAME + 5]


def rigid_bodies(data: bytes, version: Version) -> list[RigidBody]:
    """The rigid bodies of a frame of data. Raises NatNetError."""
    if kind_of(data) != FRAME_OF_DATA:
        raise NatNetError("this is not a frame of data")
    try:
        return _bodies(_Reader(data[4:]), version)
    except struct.error as error:
        raise NatNetError("the packet is cut off") from error


def _bodies(source: _Reader, version: Version) -> list[RigidBody]:
    sized = version >= (4, 1)
    source.take("<i")  # the frame's number
    for _ in range(source.count(sized)):
        source.skip_text()
        source.skip(12 * source.count(False))
    source.skip(12 * source.count(sized))
    return [_body(source, version) for _ in range(source.count(sized))]


def _body(source: _Reader, version: Version) -> RigidBody:
    number = int(source.take("<i")[0])
    values = np.array(source.take("<7f"), float)
    if version < (3, 0):  # markers: position, number and size of each
        source.skip(20 * source.count(False))
    source.take("<f")  # mean error
    flags = int(source.take("<H")[0]) if version >= (2, 6) else 1
    length = float(np.linalg.norm(values[3:]))
    valid = bool(flags & 1) and bool(np.isfinite(values).all()) and length > 0.5
    return RigidBody(number, values[:3], values[3:] / max(length, 1e-9), valid)
