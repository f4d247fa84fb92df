"""Simulated vehicles that take targets as MAVLink over UDP and answer where they are."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Sequence

import numpy as np

from extensions.applications.swarm.mavlink import TARGET, heard, heartbeats, positions, target_of
from extensions.applications.swarm.vehicles import MOST_HEARD, PER_PORT, systems
from tracker.base.clock import monotonic
from tracker.streaming.publisher import LOOPBACK

STEP = 0.02  # s
ANSWER_EVERY, ALIVE_EVERY = 0.1, 1.0  # s
STIFFNESS, DAMPING = 4.0, 4.0  # 1/s², 1/s
FASTEST, STRONGEST = 15.0, 12.0  # m/s, m/s²


class Fleet:
    """``count`` multicopters as points with bounded speed and acceleration; no thread, no clock.

    p, v (N, 3) m and m/s in G; they begin at the origin and stay where they are until asked.
    """

    def __init__(self, count: int) -> None:
        self.p, self.v = np.zeros((count, 3)), np.zeros((count, 3))
        self.wanted_p, self.wanted_v = self.p.copy(), self.v.copy()
        self._told = np.zeros(count, bool)

    @property
    def asked(self) -> int:
        """How many have been told where to be."""
        return int(self._told.sum())

    def hear(self, datagrams: Sequence[bytes], first: int) -> None:
        """Datagrams on the port of the vehicles from ``first`` on."""
        for message in heard(datagrams):
            if message.message == TARGET:
                system, p, v = target_of(message)
                row = first + system - 1
                if system > 0 and row < len(self.p) and np.isfinite([*p, *v]).all():
                    self.wanted_p[row], self.wanted_v[row] = p, v
                    self._told[row] = True

    def fly(self, dt: float) -> None:
        """``dt`` s further."""
        pull = STIFFNESS * (self.wanted_p - self.p) + DAMPING * (self.wanted_v - self.v)
        self.v = _bounded(self.v + dt * _bounded(pull, STRONGEST), FASTEST)
        self.p = self.p + dt * self.v


class VehicleSimulator:
    """A fleet on ports from ``port`` on, 250 a port, in a thread of its own, until `close`."""

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
        """Until so much time has passed, or something interrupts."""
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
        while len(datagrams) < MOST_HEARD:
            try:
                data, self._peers[k] = listener.recvfrom(65536)
            except (BlockingIOError, ConnectionRefusedError):
                break
            datagrams.append(data)
        self.fleet.hear(datagrams, k * PER_PORT)

    def _answer(self, t: float, alive: bool) -> None:
        """Tell whoever asks where all are, and now and then that they are there."""
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
    """Rows (n, 3) no longer than ``most``."""
    length = np.linalg.norm(rows, axis=1, keepdims=True)
    return np.asarray(rows * np.minimum(1.0, most / np.maximum(length, 1e-9)))
