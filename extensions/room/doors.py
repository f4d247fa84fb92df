"""Where poses arrive: a UDP socket and a thread, which pass them to the hands as they come.

They take no way through the window: a pose that waits for it would be late.
"""

from __future__ import annotations

import contextlib
import socket
import struct
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import Future

from extensions.osc.decode import OscError
from extensions.room import natnet
from extensions.room.frames import UP_AXES, from_upright
from extensions.room.natnet import NatNetError, Version
from extensions.room.osc_poses import PoseReader, RoomPose
from extensions.room.placement import Placement
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.base.notices import failure, notice
from tracker.streaming.connection import StreamError
from tracker.streaming.remote.reception import Allowance, Answer, DoorCounts
from tracker.streaming.remote.request import Reply, Request

WAIT = 0.2  # s between checks whether the door was closed
MOST_HZ = 2000.0  # poses of all trackers; more would only load the computer
MOST_BYTES = 65536
CONNECT_EVERY = 1.0  # s between requests for a server's description, and to keep its stream
REFUSED = "wrist"


class PoseTaker:
    """Passes poses on and counts them; calls come from one thread."""

    def __init__(self, answer: Answer, placement: Placement) -> None:
        self._answer, self._placement = answer, placement
        self._allowance = Allowance(MOST_HZ, monotonic())
        self._peers: dict[str, float] = {}
        self.asked = self.refused = 0

    def take(self, poses: Sequence[RoomPose], t: float, peer: str) -> None:
        """Poses that were measured at ``t`` (s)."""
        for pose in poses:
            if not self._allowance.take(monotonic()):
                self.refused += 1
                continue
            for message in self._placement.of(pose, t):
                self.asked += 1
                self._note_peer(peer)
                request = Request(REFUSED, message.t, data={"pose": message}, side=message.side)
                self._answer(request).add_done_callback(self._count)

    def refuse(self) -> None:
        """Counts a packet that cannot be read."""
        self.refused += 1

    def _note_peer(self, peer: str) -> None:
        self._peers.pop(peer, None)
        self._peers[peer] = monotonic()
        while len(self._peers) > 8:
            del self._peers[next(iter(self._peers))]

    def _count(self, done: Future[Reply]) -> None:
        if not done.cancelled() and not done.result().ok:
            self.refused += 1

    def counts(self, name: str, clients: int | None = None) -> DoorCounts:
        """From any thread."""
        now = monotonic()
        peers = tuple((peer, now - t) for peer, t in list(self._peers.items()))
        return DoorCounts(name, self.asked, self.refused, peers, clients)


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
        self._socket, self._taker, self._read, self._between = sock, taker, read, between
        sock.settimeout(WAIT)
        self.port = sock.getsockname()[1]
        self._name = f"{name} at {sock.getsockname()[0]}:{self.port}"
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="glovetrack-remote-poses")
        self._thread.daemon = True
        self._thread.start()

    def counts(self) -> DoorCounts:
        return self._taker.counts(self._name)

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
            self._taker.refuse()
            return
        self._taker.take(poses, t, peer)


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
