"""Simulated gloves in separate processes, comparable to real gloves with their own processors.

In the process of a window, packets would be delayed by other Python code, and the window by the
generation of packets; latency figures would reflect the simulation. One process generates the
packets; another one sends them, which goes before all others, as a device does.
"""

from __future__ import annotations

import contextlib
import itertools
import multiprocessing as mp
import multiprocessing.connection
import sys
import threading
from collections.abc import Iterator, Mapping
from multiprocessing.connection import Connection
from typing import NamedTuple

import numpy as np

from tracker.base.child import start_child
from tracker.base.errors import DeviceError, GlovetrackError
from tracker.base.notices import Notice, notice
from tracker.base.urgency import run_as_device
from tracker.messages import Array, ImuSample
from tracker.sensors.protocol import MAX_IMUS
from tracker.simulation.demo import DemoSpec, ask, build_scene, hands_of
from tracker.simulation.drawn_ahead import DrawnAhead
from tracker.simulation.glove_device import COLD_C, GloveDeviceParams, SimulatedGlove
from tracker.simulation.posture_requests import PostureRequest

NOT_STARTED = notice("simulator.glove_not_started")
GLOVE_IDS = {"right": 1, "left": 2}
END_WAIT = 5.0  # s
SWITCH_S = 0.0002  # s after which receiving threads release the GIL for sending ones
AT_ONCE = 5  # packets per request to the generating process


class _Begin(NamedTuple):
    """Sets simulated time 0 to the host's ``t_0`` (s)."""

    t_0: float


class _LinePaths(NamedTuple):
    """The gloves' pseudo-terminals, by side."""

    paths: dict[str, str]


class _Failed(NamedTuple):
    notice: Notice


class _Packets(NamedTuple):
    """The next packets of a glove, and the temperatures (I,) °C of its chips at the first one."""

    samples: list[ImuSample]
    celsius: Array | None


class GloveProcess:
    """The gloves of a `DemoSpec`; the processes need one or two seconds to get ready."""

    def __init__(self, spec: DemoSpec) -> None:
        ours, theirs = mp.get_context("spawn").Pipe()
        self._asked, generates = start_child("glovetrack-packets", _generate, spec, ours)
        self._pipe, self._process = start_child("glovetrack-glove", _serve, theirs)
        self._processes = (self._process, generates)
        ours.close()
        theirs.close()

    def paths(self, timeout: float) -> Mapping[str, str]:
        """The paths of the gloves' lines by side, once they exist. Call it once.

        Raises DeviceError if they do not exist within ``timeout`` s, or cannot be created.
        """
        try:
            reply = self._pipe.recv() if self._pipe.poll(timeout) else _Failed(NOT_STARTED)
        except (EOFError, OSError):
            reply = _Failed(NOT_STARTED)
        if isinstance(reply, _Failed):
            raise DeviceError(reply.notice)
        paths: dict[str, str] = reply.paths
        return paths

    def begin(self, t_0: float) -> None:
        """Set simulated time 0 to the host's ``t_0`` (s)."""
        with contextlib.suppress(OSError):  # it has ended: the serial link reports that
            self._pipe.send(_Begin(t_0))

    def ask(self, request: PostureRequest) -> None:
        """Make the wearer assume a posture."""
        with contextlib.suppress(OSError):
            self._asked.send(request)

    def close(self) -> None:
        """End the processes, which unplugs the gloves. Idempotent."""
        self._pipe.close()
        self._asked.close()
        for process in self._processes:
            process.join(END_WAIT)
            if process.is_alive():
                process.kill()
                process.join()


def _generate(pipe: Connection, spec: DemoSpec, receiver: Connection) -> None:
    """One process: generates packets on request until the gloves or ``pipe`` are closed."""
    scene = build_scene(spec)
    simulations = hands_of(scene)
    packets = {side: simulation.imu_samples() for side, simulation in simulations.items()}
    with contextlib.suppress(EOFError, OSError, KeyboardInterrupt):
        receiver.send(
            {side: len(simulation.glove.imus) for side, simulation in simulations.items()}
        )
        while True:
            for ready in mp.connection.wait([pipe, receiver]):
                if ready is pipe:
                    ask(scene, pipe.recv())
                    continue
                side = receiver.recv()
                samples = list(itertools.islice(packets[side], AT_ONCE))
                t = [sample.t for sample in samples[:1]]
                celsius = simulations[side].imus.temperature(np.array(t))[0] if t else None
                receiver.send(_Packets(samples, celsius))


class _Generated:
    """Iterates over the packets of one glove that the other process generates."""

    def __init__(self, source: Connection, lock: threading.Lock, side: str) -> None:
        """``lock``: for one request at a time."""
        self._source, self._lock, self._side = source, lock, side
        self._celsius: Array = np.full(MAX_IMUS, COLD_C)

    def __iter__(self) -> Iterator[ImuSample]:
        while packets := self._next():
            yield from packets

    def temperature(self, t: Array) -> Array:
        """(n, I) °C of the chips in the packets that were generated last."""
        return np.tile(self._celsius, (len(t), 1))

    def _next(self) -> list[ImuSample]:
        with contextlib.suppress(EOFError, OSError), self._lock:
            self._source.send(self._side)
            reply: _Packets = self._source.recv()
            if reply.celsius is not None:
                self._celsius = reply.celsius
            return reply.samples
        return []


def _serve(pipe: Connection, source: Connection) -> None:
    """The other process: runs the gloves until the pipe is closed."""
    sys.setswitchinterval(SWITCH_S)
    run_as_device()
    with (
        contextlib.suppress(EOFError, OSError, KeyboardInterrupt),
        contextlib.ExitStack() as resources,
    ):
        counts: Mapping[str, int] = source.recv()
        lock = threading.Lock()
        try:
            devices = {
                side: _device(resources, _Generated(source, lock, side), side, imu_count)
                for side, imu_count in counts.items()
            }
        except GlovetrackError as error:
            pipe.send(_Failed(error.notice))
            return
        pipe.send(_LinePaths({side: device.path for side, device in devices.items()}))
        while True:
            begin: _Begin = pipe.recv()
            for device in devices.values():
                device.begin(begin.t_0)


def _device(
    resources: contextlib.ExitStack, generated: _Generated, side: str, imu_count: int
) -> SimulatedGlove:
    packets = DrawnAhead(iter(generated))
    resources.callback(packets.close)
    params = GloveDeviceParams(glove_id=GLOVE_IDS[side])
    device = SimulatedGlove(packets, imu_count, params=params, temperature=generated.temperature)
    resources.callback(device.stop)
    return device
