"""``python -m tests.benchmarks.profile``: where the time of one second of data goes.

A Markdown table of the functions that cost most by themselves. The profiler slows small Python
functions more than numpy and compiled ones; shares are for finding hot spots, not for budgets.
"""

from __future__ import annotations

import argparse
import cProfile
import pstats
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import tracker
from tests.benchmarks.schedule import make_second, pipeline_call
from tracker.engine.kinds import ENGINES

ROOT = Path(tracker.__file__).parents[1]


@dataclass(frozen=True)
class Cost:
    """One function: calls a second, own and total time in ms per second of data."""

    place: str
    calls: int
    own_ms: float
    total_ms: float


def profile(engine: str, repeats: int = 3, seed: int = 1) -> list[Cost]:
    """Costs of the pipeline for one second of data, most expensive first by own time."""
    call = pipeline_call(make_second(seed, images=0), engine)
    call()
    profiler = cProfile.Profile(time.process_time)  # waiting on a loaded machine does not count
    profiler.enable()
    for _ in range(repeats):
        call()
    profiler.disable()
    entries = pstats.Stats(profiler).stats.items()  # type: ignore[attr-defined]
    costs = [
        Cost(_place(file, line, name), n // repeats, 1e3 * own / repeats, 1e3 * total / repeats)
        for (file, line, name), (_, n, own, total, _) in entries
    ]
    return sorted(costs, key=lambda c: -c.own_ms)


def _place(file: str, line: int, name: str) -> str:
    """As the project's path where it is ours, the package's file otherwise."""
    if line == 0:
        return name.strip("<>").replace("built-in method ", "")
    path = Path(file)
    packages = "site-packages"
    if packages in path.parts:
        return f"{'/'.join(path.parts[path.parts.index(packages) + 1 :])}: {name}"
    if path.is_relative_to(ROOT):
        return f"{path.relative_to(ROOT)}: {name}"
    return f"{path.name}: {name}"


def markdown(costs: Sequence[Cost], rows: int) -> str:
    """The ``rows`` most expensive, with their share of the whole."""
    whole = sum(c.own_ms for c in costs)
    lines = ["| function | calls | own, ms | own, % | with callees, ms |", "|---|--:|--:|--:|--:|"]
    lines += [
        f"| `{c.place}` | {c.calls} | {c.own_ms:.1f} | {100 * c.own_ms / whole:.1f} "
        f"| {c.total_ms:.1f} |"
        for c in costs[:rows]
    ]
    return "\n".join([*lines, f"| everything | | {whole:.0f} | 100 | |"])


def main(arguments: Sequence[str] | None = None) -> int:
    """The command; returns the exit code."""
    p = argparse.ArgumentParser(prog="python -m tests.benchmarks.profile")
    p.add_argument("--engine", choices=ENGINES.names(), default="chain")
    p.add_argument("--rows", type=int, default=20, help="functions to show")
    args = p.parse_args(arguments)
    print(markdown(profile(args.engine), args.rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
