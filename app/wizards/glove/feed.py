"""Samples for the glove set-up: from the open session, from a port, or simulated."""

from __future__ import annotations

import logging
import threading
import time
from collections import deque
from collections.abc import Callable, Sequence
from typing import Protocol

from app.engines.engine_host import EngineHost
from app.words import event_text, tr
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Event, ImuSample
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.link_params import LinkParams
from tracker.sensors.protocol import BAUD
from tracker.simulation.glove_device import SimulatedGlove
from tracker.simulation.wiggles import InstructedWearer

_log = logging.getLogger(__name__)

KEPT = 12.0  # s of samples
WAIT = 0.05


class GloveFeed(Protocol):
    """The interface to a glove during set-up."""

    @property
    def trouble(self) -> str:
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
    def trouble(self) -> str:
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
        ask: Callable[[str], None] | None = None,
        free: Callable[[], None] | None = None,
        baud: int = BAUD,
    ) -> None:
        self._link = GloveLink(GlovePort(path, baud), imu_count, LinkParams(baud=baud))
        self._ask, self._free = ask, free
        self._samples: deque[ImuSample] = deque()
        self._lock = threading.Lock()
        self._stopping = threading.Event()
        self.trouble = ""
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
        if self._ask is not None:
            self._ask(part)

    def stop(self) -> None:
        self._stopping.set()
        self._thread.join()
        self._link.close()
        if self._free is not None:
            self._free()

    def _run(self) -> None:
        while not self._stopping.is_set():
            for item in self._link.poll(WAIT):
                if isinstance(item, Event):
                    _log.info("The glove's link: %s", item.code)
                    self.trouble = event_text(item)
                else:
                    self._keep(item)

    def _keep(self, sample: ImuSample) -> None:
        self.trouble = ""
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
