"""Threads around the outputs: each has a slot of one, so that none waits for another.

An estimate that a client had no time for is merely old: the newer one takes its place and the loss
is counted. Nothing here is ever called by the engine's threads.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from tracker.channels import Closed, Latest
from tracker.messages import Estimate
from tracker.streaming.publisher import Publisher

END_WAIT = 1.0  # s that `close` gives an output to finish what it is sending


@dataclass(frozen=True)
class StreamCounts:
    """What became of the estimates offered to one output."""

    name: str
    sent: int
    dropped: int  # overtaken by a newer one before the output was ready
    failed: int
    error: str  # of the last failure; empty while the last one went out
    clients: int | None = None  # connected now; None where the protocol does not know its readers


class Streams:
    """Hands estimates to all outputs, each in a thread of its own.

    ``say`` gets a sentence when an output begins to fail and when it works again. Publishers are
    closed by `close`.
    """

    def __init__(
        self, publishers: Sequence[Publisher], say: Callable[[str], None] = lambda _: None
    ) -> None:
        self._outputs = [_Output(p, say) for p in publishers]

    def offer(self, estimate: Estimate) -> None:
        """Leave an estimate for every output; never waits."""
        for output in self._outputs:
            output.slot.put(estimate)

    def counts(self) -> tuple[StreamCounts, ...]:
        return tuple(output.counts() for output in self._outputs)

    def close(self) -> None:
        """End all outputs; one that hangs is left behind after a second. May be called again."""
        for output in self._outputs:
            output.slot.close()
        for output in self._outputs:
            output.thread.join(END_WAIT)


class _Output:
    """One publisher, its slot and its thread."""

    def __init__(self, publisher: Publisher, say: Callable[[str], None]) -> None:
        self._publisher, self._say = publisher, say
        self.slot: Latest[Estimate] = Latest()
        self._sent = self._failed = 0
        self._error = ""
        name = f"glovetrack-stream-{publisher.name}"
        self.thread = threading.Thread(target=self._run, name=name, daemon=True)
        self.thread.start()

    def counts(self) -> StreamCounts:
        return StreamCounts(
            self._publisher.name,
            self._sent,
            self.slot.dropped,
            self._failed,
            self._error,
            getattr(self._publisher, "clients", None),
        )

    def _run(self) -> None:
        try:
            while True:
                estimate = self.slot.get(None)
                if estimate is not None:
                    self._send(estimate)
        except Closed:
            self._publisher.close()

    def _send(self, estimate: Estimate) -> None:
        try:
            self._publisher.send(estimate)
        except Exception as error:  # noqa: BLE001 - one output's fault must not end the others
            self._failed += 1
            self._tell(str(error) or type(error).__name__)
        else:
            self._sent += 1
            self._tell("")

    def _tell(self, error: str) -> None:
        """Say where sending begins or ceases to fail, once each."""
        before, self._error = self._error, error
        if error and not before:
            self._say(f"The stream {self._publisher.name} fails: {error.rstrip('.')}.")
        elif before and not error:
            self._say(f"The stream {self._publisher.name} works again.")
