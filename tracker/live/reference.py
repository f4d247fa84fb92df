"""A second engine on the live messages, for comparison, in a thread of its own."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable

from tracker.base.channels import Closed, Fifo
from tracker.base.errors import GlovetrackError
from tracker.engine.hands import Hands, Sided
from tracker.messages import BlobFrame, Estimate, WristPose

Fed = Sided | BlobFrame | WristPose

_log = logging.getLogger(__name__)

WAIT = 0.05  # s between checks whether the thread should end
MOST_WAITING = 500  # messages, 4 s: a machine too slow for two engines loses some here


class ReferenceEngine:
    """Feeds ``hands`` with the messages of `put`, in their order; started immediately."""

    def __init__(self, hands: Hands) -> None:
        self._hands = hands
        self._inbox: Fifo[Fed] = Fifo(MOST_WAITING)
        self._estimates: dict[str, Estimate] = {}
        self._thread = threading.Thread(target=self._run, name="glovetrack-reference", daemon=True)
        self._thread.start()

    @property
    def engine(self) -> str:
        """The engine's name."""
        return self._hands.engine

    def estimate(self, side: str) -> Estimate | None:
        """Returns the second engine's latest estimate of a hand."""
        return self._estimates.get(side)

    def put(self, message: Fed) -> None:
        """Queues a message that was just fed to the first engine."""
        self._inbox.put(message)

    def close(self, wait: bool = True) -> None:
        """Ends the thread after its current message. May be called again."""
        self._inbox.close()
        self._inbox.drain()
        if wait:
            self._thread.join()

    def _run(self) -> None:
        try:
            while True:
                message = self._inbox.get(WAIT)
                if message is not None:
                    self._feed(message)
        except Closed:
            self._estimates = {}
        except GlovetrackError as error:
            _log.warning("The second engine has ended: %s", error, exc_info=True)
            self._estimates = {}  # it shows no hand any more rather than an old one

    def _feed(self, message: Fed) -> None:
        if isinstance(message, Sided):
            estimate = self._hands.feed_imu(message.side, message.sample)
            self._estimates[message.side] = estimate
        elif isinstance(message, WristPose):
            self._hands.feed_wrist(message)
        else:
            self._hands.feed_frame(message)
            for side in self._hands.pipelines:
                self._hands.take_results(side)


class ReferenceSlot:
    """The second engine of a loop, if it has one; ``make`` returns hands with an engine.

    May be used from any thread.
    """

    def __init__(self, make: Callable[[str], Hands]) -> None:
        self._make = make
        self._engine: ReferenceEngine | None = None

    def use(self, name: str | None, wait: bool = False) -> None:
        """Feeds the same messages to a second engine, for comparison; None ends it.

        ``wait``: until the previous one has ended. Raises ConfigError for an unknown name.
        """
        engine = ReferenceEngine(self._make(name)) if name else None
        before, self._engine = self._engine, engine
        if before is not None:
            before.close(wait)

    def put(self, message: Fed) -> None:
        """Queues a message that was just fed to the first engine."""
        engine = self._engine
        if engine is not None:
            engine.put(message)

    def estimate(self, side: str) -> Estimate | None:
        """Returns the second engine's estimate of a hand; None without a second engine."""
        engine = self._engine
        return engine.estimate(side) if engine is not None else None
