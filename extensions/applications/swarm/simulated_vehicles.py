"""Simulated vehicles that receive targets as MAVLink over UDP and report their positions."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Sequence

import numpy as np

from extensions.applications.swarm.mavlink import TARGET, heartbeats, positions, received, target_of
from extensions.applications.swarm.vehicles import MOST_RECEIVED, PER_PORT, systems
from tracker.base.clock import monotonic
from tracker.streaming.publisher import LOOPBACK

STEP = 0.02  # s
ANSWER_EVERY, ALIVE_EVERY = 0.1, 1.0  # s
STIFFNESS, DAMPING = 4.0, 4.0  # 1/s², 1/s
FASTEST, STRONGEST = 15.0, 12.0  # m/s, m/s²


class Fleet:
    """``count`` multicopters as points with bounded speed and acceleration.

    p (N, 3) m and v (N, 3) m/s in G; they start at the origin and wait for targets.
    """

    def __init__(self, count: int) -> None:
        self.p, self.v = np.zeros((count, 3)), np.zeros((count, 3))
        self.wanted_p, self.wanted_v = self.p.copy(), self.v.copy()
        self._has_target = np.zeros(count, bool)

    @property
    def requested(self) -> int:
        """Number of vehicles that have received a target."""
        return int(self._has_target.sum())

    def receive(self, datagrams: Sequence[bytes], first: int) -> None:
        """Process datagrams on the port of the vehicles from ``first`` on."""
        for message in received(datagrams):
            if message.message == TARGET:
                system, p, v = target_of(message)
                row = first + system - 1
                if system > 0 and row < len(self.p) and np.isfinite([*p, *v]).all():
                    self.wanted_p[row], self.wanted_v[row] = p, v
                    self._has_target[row] = True

    def fly(self, dt: float) -> None:
        """Simulate ``dt`` s."""
        pull = STIFFNESS * (self.wanted_p - self.p) + DAMPING * (self.wanted_v - self.v)
        self.v = _bounded(self.v + dt * _bounded(pull, STRONGEST), FASTEST)
        self.p = self.p + dt * self.v


class VehicleSimulator:
    """Runs a fleet in its own thread until `close`; 250 vehicles per port from ``port`` on."""

    def __init__(
        self,
        count: int,
        port: int,
        host: str = LOOPBACK,
        clock: Callable[[], float] = monotonic,
    ) -> None:
        self.fleet, self._clock = Fleet(count), clock
        self._sockets: list[socket.socket] = []
        self._peers: dict[int, tuple[str, int]] = {}
        for k in range(-(-count // PER_PORT)):
            listener = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            listener.bind((host, port + k if port else 0))
            listener.setblocking(False)
            self._sockets.append(listener)
        self.port = int(self._sockets[0].getsockname()[1])
        self._ending = threading.Event()
        self._sequence = 0
        self._thread = threading.Thread(target=self._run, name="glovetrack-vehicles", daemon=True)
        self._thread.start()

    def wait(self, seconds: float) -> None:
        """Wait for ``seconds`` or until interrupted."""
        until = self._clock() + seconds
        while self._clock() < until:
            self._ending.wait(min(1.0, until - self._clock()))

    def close(self) -> None:
        """End the thread and free the ports. May be called again."""
        self._ending.set()
        self._thread.join()
        for listener in self._sockets:
            listener.close()

    def _run(self) -> None:
        last = self._clock()
        answer = alive = last
        while not self._ending.wait(STEP):
            now = self._clock()
            for k, listener in enumerate(self._sockets):
                self._listen(k, listener)
            while last + STEP <= now:
                self.fleet.fly(STEP)
                last += STEP
            if now >= answer:
                answer = now + ANSWER_EVERY
                self._answer(now, now >= alive)
                alive = now + ALIVE_EVERY if now >= alive else alive

    def _listen(self, k: int, listener: socket.socket) -> None:
        datagrams: list[bytes] = []
        while len(datagrams) < MOST_RECEIVED:
            try:
                data, self._peers[k] = listener.recvfrom(65536)
            except (BlockingIOError, ConnectionRefusedError):
                break
            datagrams.append(data)
        self.fleet.receive(datagrams, k * PER_PORT)

    def _answer(self, t: float, alive: bool) -> None:
        """Send positions and, occasionally, heartbeats to the sender of targets."""
        self._sequence += 1
        for k, peer in self._peers.items():
            rows = slice(k * PER_PORT, (k + 1) * PER_PORT)
            p, v = self.fleet.p[rows], self.fleet.v[rows]
            numbers = systems(len(p))
            out = positions(p, v, numbers, t, self._sequence)
            out += heartbeats(numbers, self._sequence) if alive else []
            for packet in out:
                try:
                    self._sockets[k].sendto(packet, peer)
                except (BlockingIOError, ConnectionRefusedError):
                    break


def _bounded(rows: np.ndarray, most: float) -> np.ndarray:
    """Rows (n, 3), shortened to ``most``."""
    length = np.linalg.norm(rows, axis=1, keepdims=True)
    return np.asarray(rows * np.minimum(1.0, most / np.maximum(length, 1e-9)))
