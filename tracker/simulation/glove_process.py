"""Simulated gloves in a separate process, comparable to real gloves with their own processor.

In the process of a window, packets would be delayed by other Python code, and the window by the
generation of packets; latency figures would reflect the simulation.
"""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Mapping
from multiprocessing.connection import Connection
from typing import NamedTuple

from tracker.base.child import start_child
from tracker.base.errors import DeviceError, GlovetrackError
from tracker.base.notices import Notice, notice
from tracker.simulation.demo import DemoSpec, ask, build_scene, hands_of
from tracker.simulation.drawn_ahead import DrawnAhead
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove
from tracker.simulation.posture_requests import PostureRequest
from tracker.simulation.scenario import Simulation

NOT_STARTED = notice("simulator.glove_not_started")
GLOVE_IDS = {"right": 1, "left": 2}
END_WAIT = 5.0  # s
SWITCH_S = 0.0002  # s after which generating threads release the GIL for sending ones


class _Begin(NamedTuple):
    """Sets simulated time 0 to the host's ``t_0`` (s)."""

    t_0: float


class _LinePaths(NamedTuple):
    """The gloves' pseudo-terminals, by side."""

    paths: dict[str, str]


class _Failed(NamedTuple):
    notice: Notice


class GloveProcess:
    """The gloves of a `DemoSpec`; the process needs one or two seconds to get ready."""

    def __init__(self, spec: DemoSpec) -> None:
        self._pipe, self._process = start_child("glovetrack-glove", _serve, spec)

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
        self._send(_Begin(t_0))

    def ask(self, asked: PostureRequest) -> None:
        """Make the wearer assume a posture."""
        self._send(asked)

    def close(self) -> None:
        """End the process, which unplugs the gloves. Idempotent."""
        self._pipe.close()
        self._process.join(END_WAIT)
        if self._process.is_alive():
            self._process.kill()
            self._process.join()

    def _send(self, what: _Begin | PostureRequest) -> None:
        with contextlib.suppress(OSError):  # it has ended: the serial link reports that
            self._pipe.send(what)


def _serve(pipe: Connection, spec: DemoSpec) -> None:
    """The other process: runs the gloves until the pipe is closed."""
    sys.setswitchinterval(SWITCH_S)
    with contextlib.suppress(EOFError, OSError, KeyboardInterrupt), contextlib.ExitStack() as worn:
        scene = build_scene(spec)
        try:
            devices = {
                side: _device(worn, simulation) for side, simulation in hands_of(scene).items()
            }
        except GlovetrackError as error:
            pipe.send(_Failed(error.notice))
            return
        pipe.send(_LinePaths({side: device.path for side, device in devices.items()}))
        while True:
            item: _Begin | PostureRequest = pipe.recv()
            if isinstance(item, PostureRequest):
                ask(scene, item)
                continue
            for device in devices.values():
                device.begin(item.t_0)


def _device(worn: contextlib.ExitStack, simulation: Simulation) -> SimulatedGlove:
    packets, glove = DrawnAhead(simulation.imu_samples()), simulation.glove
    worn.callback(packets.close)
    params = GloveDeviceParams(glove_id=GLOVE_IDS[glove.side])
    device = SimulatedGlove(
        packets, len(glove.imus), params=params, temperature=simulation.imus.temperature
    )
    worn.callback(device.stop)
    return device
