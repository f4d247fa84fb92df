"""Samples for the glove set-up: from the open session, from a port, or simulated."""

from __future__ import annotations

import logging
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from app.engines.engine_host import EngineHost
from app.words import event_text, tr
from tracker.base.callbacks import ignore
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array, Event, ImuSample
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.link_params import LinkParams
from tracker.sensors.protocol import BAUD
from tracker.simulation.glove_device import SimulatedGlove
from tracker.simulation.imu import ImuSimulator
from tracker.simulation.motion import Poses
from tracker.simulation.postures import posture
from tracker.simulation.wearer import Wearer, WearerParams

_log = logging.getLogger(__name__)

KEPT = 12.0  # s of samples
WAIT = 0.05


class GloveFeed(Protocol):
    """The interface to a glove during set-up."""

    @property
    def problem(self) -> str:
        """Why no samples arrive, as text."""

    @property
    def glove_id(self) -> int | None:
        """The number that the glove reports; None if it has not reported one."""

    def recent(self) -> Sequence[ImuSample]:
        """Samples of the last seconds, oldest first."""

    def ask(self, part: str) -> None:
        """Instruct a simulated wearer."""

    def stop(self) -> None:
        """Release the port; may take a moment."""


class SessionFeed:
    """The glove that is already being tracked."""

    def __init__(self, host: EngineHost) -> None:
        self._host = host

    @property
    def problem(self) -> str:
        return "" if self._host.setup is not None else tr("The session was closed.")

    @property
    def glove_id(self) -> int | None:
        setup = self._host.setup
        return setup.connection.number if setup is not None else None

    def recent(self) -> Sequence[ImuSample]:
        setup = self._host.setup
        return setup.tracked.recent_imu() if setup is not None else ()

    def ask(self, part: str) -> None:
        """A real wearer reads the instruction."""

    def stop(self) -> None:
        """The session releases its port itself."""


class PortFeed:
    """A glove at another port, read in a thread. ``free`` is called at the end."""

    def __init__(
        self,
        path: str,
        imu_count: int,
        ask: Callable[[str], None] = ignore,
        free: Callable[[], None] = ignore,
        baud: int = BAUD,
    ) -> None:
        self._link = GloveLink(GlovePort(path, baud), imu_count, LinkParams(baud=baud))
        self._ask, self._free = ask, free
        self._samples: deque[ImuSample] = deque()
        self._lock = threading.Lock()
        self._stopping = threading.Event()
        self.problem = ""
        self._thread = threading.Thread(target=self._run, name="glovetrack-set-up", daemon=True)
        self._thread.start()

    @property
    def glove_id(self) -> int | None:
        hello = self._link.hello
        return hello.glove_id if hello is not None else None

    def recent(self) -> Sequence[ImuSample]:
        with self._lock:
            return list(self._samples)

    def ask(self, part: str) -> None:
        self._ask(part)

    def stop(self) -> None:
        self._stopping.set()
        self._thread.join()
        self._link.close()
        self._free()

    def _run(self) -> None:
        while not self._stopping.is_set():
            for item in self._link.poll(WAIT):
                if isinstance(item, Event):
                    _log.info("The glove's link: %s", item.code)
                    self.problem = event_text(item)
                else:
                    self._keep(item)

    def _keep(self, sample: ImuSample) -> None:
        self.problem = ""
        with self._lock:
            self._samples.append(sample)
            while sample.t - self._samples[0].t > KEPT:
                self._samples.popleft()


def simulated_feed(hand: HandModel, glove: GloveModel) -> PortFeed:
    """A simulated glove on a pseudo-terminal, whose wearer follows the instructions."""
    wearer = InstructedWearer(hand, glove)
    device = SimulatedGlove(wearer.samples(), len(glove.imus), t_0=time.monotonic())

    def ask(part: str) -> None:
        wearer.part = part

    return PortFeed(device.path, len(glove.imus), ask, device.stop)


FREQUENCY = 0.9  # Hz
REST = "rest"
COUPLING = 0.15
"""Motion of a neighbour relative to that of the finger being moved."""
TIP = np.deg2rad(25.0)
BLOCK = 200  # packets simulated at once


@dataclass(frozen=True, eq=False)
class Wiggle:
    """``part`` ("rest", "hand", "thumb" or a finger) oscillates, the rest is still."""

    hand: HandModel
    part: str
    duration: float = 600.0
    follows_synergies: bool = True

    def poses(self, t: Array) -> Poses:
        """Palm down, 20 cm above the origin of G."""
        n = len(t)
        bend = (1 - np.cos(2 * np.pi * FREQUENCY * t)) / 2  # 0..1, starts at rest
        flexed = posture(self.hand, _flexion(self.part))
        angles = np.outer(bend, flexed)
        R_GB = np.tile(np.eye(3), (n, 1, 1))
        if self.part == "hand":
            R_GB = so3.exp(np.outer(bend * TIP, [0.0, 1.0, 0.0]))
        return Poses(angles, R_GB, np.tile([0.0, 0.0, 0.2], (n, 1)))


def _flexion(part: str) -> dict[str, float]:
    """Angles in degrees of the bent finger; its neighbours follow partially."""
    if part == "thumb":
        return {"thumb_cmc_flexion": 20, "thumb_mcp_flexion": 45, "thumb_ip_flexion": 40}
    if part not in FINGERS:
        return {}
    out: dict[str, float] = {}
    at = FINGERS.index(part)
    for k, finger in enumerate(FINGERS):
        share = {0: 1.0, 1: COUPLING}.get(abs(k - at), 0.0)
        out |= {f"{finger}_mcp_flexion": 50 * share, f"{finger}_pip_flexion": 70 * share}
    return out


def wiggling_wearer(hand: HandModel, glove: GloveModel, part: str, seed: int) -> Wearer:
    """A random wearer; the cloth does not slip while the hand lies on the table."""
    return Wearer.random(hand, glove, seed, WearerParams(wobble_deg=0.0) if part == REST else None)


class InstructedWearer:
    """Packets of a wearer who performs ``part``, which may be changed at any time."""

    def __init__(self, hand: HandModel, glove: GloveModel, seed: int = 1) -> None:
        self.part = REST
        self._make: Callable[[str], ImuSimulator] = lambda part: ImuSimulator(
            wiggling_wearer(hand, glove, part, seed), Wiggle(hand, part), seed
        )

    def samples(self) -> Iterator[ImuSample]:
        """Endless; a block of each part is simulated once and repeated."""
        blocks: dict[str, list[ImuSample]] = {}
        period = 0.0
        k = 0
        while True:
            part = self.part
            if part not in blocks:
                simulator = self._make(part)
                period = simulator.period
                blocks[part] = list(simulator.samples(0.0, BLOCK * period))
            block = blocks[part]
            sample = block[k % len(block)]
            t = k * period
            yield replace(sample, t=t, t_arrival=t, t_device=t, seq=k)
            k += 1
