"""``python -m tests.benchmarks.locks``: what a packet and an image need of Python's lock.

One second of the schedule goes through `Pipeline`, with every kernel counted: how often the lock is
released and acquired again (by kernels that release it), the processor time in them, the time in
the other kernels, and the rest, which is Python and numpy. Counting takes about 0.3 µs per kernel.
A Markdown table.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tracker.kernels.library import Library

REPEATS = 5


@dataclass
class Use:
    """Of one message: kernels that release the lock, the others, and s of both and in all."""

    released: int = 0
    held: int = 0
    unlocked_s: float = 0.0
    held_s: float = 0.0
    all_s: float = 0.0


@dataclass
class Counter:
    """Counts the kernels that are called for a message."""

    now: Use | None = None
    by_kind: dict[str, list[Use]] = field(default_factory=dict)

    def watch(self) -> None:
        """From now on, modules that are imported get counted kernels."""
        make, counter = Library.kernel, self

        def counted(library: Library, function: Any, options: dict[str, Any]) -> Any:
            made = make(library, function, options)
            return CountedKernel(counter, made, options.get("nogil", True))

        Library.kernel = counted  # type: ignore[method-assign]

    def message(self, kind: str, call: Callable[[], object]) -> None:
        """Calls, and counts what the call uses."""
        self.now = use = Use()
        begun = time.thread_time()
        call()
        use.all_s = time.thread_time() - begun
        self.now = None
        self.by_kind.setdefault(kind, []).append(use)


class CountedKernel:
    """A kernel that is counted while a message is processed."""

    def __init__(self, counter: Counter, kernel: Any, releases: bool) -> None:
        self._counter, self._kernel, self._releases = counter, kernel, releases

    def __getattr__(self, name: str) -> Any:
        return getattr(self._kernel, name)

    def __call__(self, *args: Any, **named: Any) -> Any:
        use = self._counter.now
        if use is None:
            return self._kernel(*args, **named)
        begun = time.thread_time()
        try:
            return self._kernel(*args, **named)
        finally:
            spent = time.thread_time() - begun
            if self._releases:
                use.released, use.unlocked_s = use.released + 1, use.unlocked_s + spent
            else:
                use.held, use.held_s = use.held + 1, use.held_s + spent


def count(engine: str, repeats: int = REPEATS) -> dict[str, list[Use]]:
    """Uses by kind of message. For a fresh process: imports everything with counted kernels."""
    counter = Counter()
    counter.watch()
    from tests.benchmarks.schedule import make_second  # deferred: counted from here on
    from tracker.engine.pipeline import Pipeline
    from tracker.engine.settings import Settings
    from tracker.messages import ImuSample

    second = make_second(1, images=0)
    sim, settings = second.sim, Settings(engine=engine)
    for _ in range(repeats):
        pipeline = Pipeline(sim.hand, sim.glove, sim.rig, settings)

        def feed(message: Any, pipeline: Any = pipeline) -> None:
            if isinstance(message, ImuSample):
                pipeline.feed_imu(message)
            else:
                pipeline.feed_frame(message)
                pipeline.take_results()

        for message in second.before:
            feed(message)
        for message in second.messages:
            kind = "packet" if isinstance(message, ImuSample) else "image"
            counter.message(kind, lambda message=message: feed(message))  # type: ignore[misc]
    return counter.by_kind


def markdown(found: dict[str, list[Use]]) -> str:
    """Medians, and the 99th percentile of all."""
    lines = [
        "| | lock released | kernels that keep it | without it, ms | in those that keep it, ms "
        "| Python and numpy, ms | all, 99 %, ms |",
        "|---|--:|--:|--:|--:|--:|--:|",
    ]
    for kind, uses in found.items():
        free, held, total = (
            1e3 * np.array([getattr(use, name) for use in uses])
            for name in ("unlocked_s", "held_s", "all_s")
        )
        counts = [np.median([getattr(u, name) for u in uses]) for name in ("released", "held")]
        lines.append(
            f"| {kind} | {counts[0]:.0f} | {counts[1]:.0f} | {np.median(free):.2f} "
            f"| {np.median(held):.2f} | {np.median(total - free - held):.2f} "
            f"| {np.percentile(total, 99):.2f} |"
        )
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> int:
    """The command; returns the exit code."""
    p = argparse.ArgumentParser(prog="python -m tests.benchmarks.locks")
    p.add_argument("--engine", default="chain", help="engine to measure")
    args = p.parse_args(arguments)
    print(markdown(count(args.engine)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
