"""Poses from a VRPN server, by one TCP connection that is made again when it ends."""

from __future__ import annotations

import contextlib
import math
import socket
import threading
from collections import deque

from extensions.room import vrpn
from extensions.room.extension import VrpnOptions
from extensions.room.frames import UP_AXES, from_upright
from extensions.room.osc_poses import RoomPose
from extensions.room.placement import Placement, placement_of
from extensions.room.taker import PoseTaker
from extensions.room.vrpn import VrpnError, VrpnPose, VrpnReader
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.base.notices import failure, notice
from tracker.streaming.connection import StreamError
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.reception import Answer, DoorCounts

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
        sock.sendall(vrpn.COOKIE)
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
