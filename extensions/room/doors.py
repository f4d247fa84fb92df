"""Where poses arrive: a UDP socket and a thread, which pass them to the hands as they come.

They take no way through the window: a pose that waits for it would be late.
"""

from __future__ import annotations

import contextlib
import socket
import struct
import threading
from collections.abc import Callable, Sequence

from extensions.osc.decode import OscError
from extensions.room import natnet
from extensions.room.extension import NatNetOptions, OscPoseOptions
from extensions.room.frames import UP_AXES, from_upright
from extensions.room.natnet import NatNetError, Version
from extensions.room.osc_poses import PoseReader, RoomPose
from extensions.room.placement import Placement, placement_of
from extensions.room.taker import PoseTaker
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.base.notices import failure, notice
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
                for kind in (natnet.CONNECT, natnet.KEEP_ALIVE):
                    address = (self._server, natnet.COMMAND_PORT)
                    self._socket.sendto(natnet.request(kind), address)

    def read(self, data: bytes) -> list[RoomPose]:
        """The poses of the bodies that are tracked. Raises NatNetError."""
        kind = natnet.kind_of(data)
        if kind == natnet.SERVER_INFO:
            self._version = natnet.protocol_version(data)
        if kind != natnet.FRAME_OF_DATA:
            return []
        bodies = natnet.rigid_bodies(data, self._version)
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
