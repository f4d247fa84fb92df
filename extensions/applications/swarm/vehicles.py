"""Sends a swarm's commands to vehicles as MAVLink over UDP, and receives their positions."""

from __future__ import annotations

import socket
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from extensions.applications.interface import Command, VehicleCommand
from extensions.applications.swarm.mavlink import POSITION, position_of, received, targets
from tracker.base.errors import DeviceError
from tracker.base.notices import notice
from tracker.messages import Array

PER_PORT = 250  # a MAVLink network has at most 255 systems, so each 250 use another port
RATE_HZ = 20.0  # of targets per vehicle; autopilots accept setpoints at 2 to 50
MOST_RECEIVED = 1000  # datagrams per call


def systems(count: int) -> NDArray[np.uint8]:
    """System numbers (n,) of the vehicles on one port, from 1."""
    return np.arange(1, count + 1).astype(np.uint8)


def address_of(text: str) -> tuple[str, int]:
    """Parse ``host:port``. Raises DeviceError."""
    host, _, port = text.rpartition(":")
    if not host or not port.isdecimal() or not 1 <= int(port) <= 65535:
        raise DeviceError(notice("swarm.address", address=text))
    return host, int(port)


class VehicleSink:
    """Sends targets to each vehicle at `RATE_HZ` on average, and receives positions.

    ``answered`` (n,): whether a vehicle has replied; ``p`` (n, 3) m in G: its last position.
    """

    def __init__(self) -> None:
        self._socket: socket.socket | None = None
        self._sequence = self._port = 0
        self._due = -np.inf
        self.answered: NDArray[np.bool_] = np.zeros(0, bool)
        self.p: Array = np.empty((0, 3))
        self.requested: Array = np.empty((0, 3))

    def take(self, commands: Sequence[Command], t: float) -> None:
        for command in commands:
            if isinstance(command, VehicleCommand):
                self._receive()
                if self._is_due(t):
                    self._send(command, t)

    def _is_due(self, t: float) -> bool:
        """Whether targets are due at ``t`` (s).

        Due times lie `RATE_HZ` apart, so that samples just before one do not lower the rate: a
        command every 50 ms after the last would be one every 60 ms where samples are 10 ms apart
        and some are early. The series starts again after a pause and where the time jumps back.
        """
        if self._due - 1 <= t < self._due:
            return False
        period = 1 / RATE_HZ
        late = t - self._due
        self._due = self._due + period if 0 <= late < period else t + period
        return True

    def _send(self, command: VehicleCommand, t: float) -> None:
        host, port = address_of(command.to)
        self._port = port
        if self._socket is None:
            self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            self._socket.setblocking(False)
        n = len(command.p)
        if len(self.p) != n:
            self.answered, self.p = np.zeros(n, bool), np.full((n, 3), np.nan)
        self.requested = command.p
        self._sequence += 1
        for k, first in enumerate(range(0, n, PER_PORT)):
            rows = slice(first, min(first + PER_PORT, n))
            numbers = systems(rows.stop - first)
            for packet in targets(command.p[rows], command.v[rows], numbers, t, self._sequence):
                self._put(packet, (host, port + k))

    def _put(self, packet: bytes, to: tuple[str, int]) -> None:
        """Send a packet; if the buffer is full, the next targets replace it."""
        assert self._socket is not None
        try:
            self._socket.sendto(packet, to)
        except (BlockingIOError, ConnectionRefusedError):
            return

    def _receive(self) -> None:
        by_port: dict[int, list[bytes]] = {}
        for _ in range(MOST_RECEIVED if self._socket is not None else 0):
            assert self._socket is not None
            try:
                data, (_, port) = self._socket.recvfrom(65536)
            except (BlockingIOError, ConnectionRefusedError):
                break
            by_port.setdefault(port, []).append(data)
        for port, datagrams in by_port.items():
            for message in received(datagrams):
                row = message.system - 1 + PER_PORT * (port - self._port)
                if message.message == POSITION and 0 <= row < len(self.p):
                    self.p[row], _ = position_of(message)
                    self.answered[row] = True

    @property
    def error(self) -> float:
        """Median distance in m of the vehicles from their targets; NaN without replies."""
        if not self.answered.any():
            return float("nan")
        away = np.linalg.norm(self.p - self.requested, axis=1)
        return float(np.median(away[self.answered]))

    def close(self) -> None:
        if self._socket is not None:
            self._socket.close()
            self._socket = None
