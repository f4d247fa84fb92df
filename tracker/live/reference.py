"""A second engine on the live messages, to compare with: in its own thread, never in the way."""

from __future__ import annotations

import threading

from tracker.channels import Closed, Fifo
from tracker.errors import GlovetrackError
from tracker.messages import BlobFrame, Estimate, ImuSample
from tracker.pipeline import Pipeline

WAIT = 0.05  # s that the thread waits before it looks whether it should end
MOST_WAITING = 500  # messages, 4 s: a machine too slow for two engines loses some here


class ReferenceEngine:
    """Feeds a pipeline with what `put` is given, in that order; started at once."""

    def __init__(self, pipeline: Pipeline) -> None:
        self._pipeline = pipeline
        self._inbox: Fifo[ImuSample | BlobFrame] = Fifo(MOST_WAITING)
        self._estimate: Estimate | None = None
        self._thread = threading.Thread(target=self._run, name="glovetrack-reference", daemon=True)
        self._thread.start()

    @property
    def engine(self) -> str:
        """The engine's name."""
        return self._pipeline.settings.engine

    @property
    def estimate(self) -> Estimate | None:
        """The latest of the second engine."""
        return self._estimate

    def put(self, message: ImuSample | BlobFrame) -> None:
        """A message that the first engine has just been fed with."""
        self._inbox.put(message)

    def close(self, wait: bool = True) -> None:
        """End the thread, which may have a message to finish. May be called again."""
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
        except (Closed, GlovetrackError):
            self._estimate = None  # it shows no hand any more rather than an old one

    def _feed(self, message: ImuSample | BlobFrame) -> None:
        if isinstance(message, ImuSample):
            self._estimate = self._pipeline.feed_imu(message)
        else:
            self._pipeline.feed_frame(message)
            self._pipeline.take_results()
