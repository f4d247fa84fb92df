"""Simulated gloves in a process of their own, as a real glove is a computer of its own.

Beside a window, in its process, packets would wait for whatever Python does there, and the window
for the making of packets; figures of latency would tell of the simulation.
"""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Mapping
from multiprocessing.connection import Connection
from typing import NamedTuple

from tracker.base.child import start_child
from tracker.base.errors import DeviceError, GlovetrackError
from tracker.glove.model import GloveModel
from tracker.simulation.asked import Asked
from tracker.simulation.demo import DemoSpec, ask, build_scene, hands_of
from tracker.simulation.drawn_ahead import DrawnAhead
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove

GLOVE_IDS = {"right": 1, "left": 2}
END_WAIT = 5.0  # s
SWITCH_S = 0.0002  # s after which what makes packets lets go of the interpreter for what sends them


class _Begin(NamedTuple):
    """Simulated time 0 is the host's ``t_0`` (s)."""

    t_0: float


class _There(NamedTuple):
    """The gloves' pseudo-terminals, by side."""

    paths: dict[str, str]


class _Failed(NamedTuple):
    text: str


class GloveProcess:
    """The gloves of a `DemoSpec`; getting ready takes the process a second or two."""

    def __init__(self, spec: DemoSpec) -> None:
        self._pipe, self._process = start_child("glovetrack-glove", _serve, spec)

    def paths(self, timeout: float) -> Mapping[str, str]:
        """Of the gloves' lines by side, once they are there. Call it once.

        Raises DeviceError where they are not within ``timeout`` s, or cannot be.
        """
        try:
            said = self._pipe.recv() if self._pipe.poll(timeout) else _Failed("")
        except (EOFError, OSError):
            said = _Failed("")
        if isinstance(said, _Failed):
            raise DeviceError(said.text or "The simulated glove did not start.")
        paths: dict[str, str] = said.paths
        return paths

    def begin(self, t_0: float) -> None:
        """Let simulated time 0 be the host's ``t_0`` (s)."""
        self._send(_Begin(t_0))

    def ask(self, asked: Asked) -> None:
        """Let the wearer take a posture."""
        self._send(asked)

    def close(self) -> None:
        """End the process: the cables are pulled. May be called again."""
        self._pipe.close()
        self._process.join(END_WAIT)
        if self._process.is_alive():
            self._process.kill()
            self._process.join()

    def _send(self, what: _Begin | Asked) -> None:
        with contextlib.suppress(OSError):  # it has gone: the link to the glove says so
            self._pipe.send(what)


def _serve(pipe: Connection, spec: DemoSpec) -> None:
    """The other process: gloves until the pipe closes."""
    sys.setswitchinterval(SWITCH_S)
    with contextlib.suppress(EOFError, OSError, KeyboardInterrupt), contextlib.ExitStack() as worn:
        scene = build_scene(spec)
        try:
            devices = {
                side: _device(worn, DrawnAhead(simulation.imu_samples()), simulation.glove)
                for side, simulation in hands_of(scene).items()
            }
        except GlovetrackError as error:
            pipe.send(_Failed(str(error)))
            return
        pipe.send(_There({side: device.path for side, device in devices.items()}))
        while True:
            item: _Begin | Asked = pipe.recv()
            if isinstance(item, Asked):
                ask(scene, item)
                continue
            for device in devices.values():
                device.begin(item.t_0)


def _device(worn: contextlib.ExitStack, packets: DrawnAhead, glove: GloveModel) -> SimulatedGlove:
    worn.callback(packets.close)
    params = GloveDeviceParams(glove_id=GLOVE_IDS[glove.side])
    device = SimulatedGlove(packets, len(glove.imus), params=params)
    worn.callback(device.stop)
    return device
