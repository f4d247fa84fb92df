"""``python -m tests.benchmarks.__main__``: speed against the goals, each peer in the same rounds.

Prints a table, writes the rows as JSON, a plot, and a line of history that the next run is
compared with. Timings of one group alternate within a round; a figure is the median of the rounds.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path

from tests.benchmarks import history as bench_history
from tests.benchmarks import output as bench_output
from tests.benchmarks.fusion import fusion_rows
from tests.benchmarks.inertial import inertial_rows
from tests.benchmarks.rows import BenchRow
from tests.benchmarks.schedule import schedule_rows
from tests.benchmarks.vision import bench_vision
from tests.benchmarks.window import app_rows
from tracker.base.errors import FileError, GlovetrackError

ROUNDS, QUICK_ROUNDS = 9, 3
Group = Callable[[int], list[BenchRow]]
GROUPS: dict[str, Group] = {
    "vision": bench_vision,
    "fusion": fusion_rows,
    "inertial": inertial_rows,
    "schedule": schedule_rows,
    "app": app_rows,
}


def measure(names: Sequence[str], rounds: int) -> list[BenchRow]:
    """The rows of the named groups, in the order of `GROUPS`."""
    rows: list[BenchRow] = []
    for name, group in GROUPS.items():
        if name in names:
            rows += group(rounds)
    return rows


def write_json(path: Path, rows: Sequence[BenchRow]) -> None:
    """{"rows": [...]}. Raises FileError."""
    text = json.dumps({"rows": [asdict(r) for r in rows]}, indent=1, ensure_ascii=False)
    try:
        path.write_text(text + "\n", encoding="utf-8")
    except OSError as error:
        raise FileError(f"{path} could not be written: {error}.") from error


def main(arguments: Sequence[str] | None = None) -> int:
    """The command; returns the exit code."""
    args = _parser().parse_args(arguments)
    rounds = QUICK_ROUNDS if args.quick else args.rounds
    try:
        history = args.out / "history.jsonl"
        former = bench_history.read(history)
        run = bench_history.this_run(measure(args.only or list(GROUPS), rounds), rounds)
        print(bench_output.table(run.rows, former))
        write_json(args.json, run.rows)
        bench_output.plot(run.rows, args.out / "bench.png")
        bench_history.append(history, run)
    except GlovetrackError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


def _parser() -> argparse.ArgumentParser:
    p = argparse.ArgumentParser(prog="python -m tests.benchmarks.__main__", description=__doc__)
    p.add_argument("--json", type=Path, default=Path("bench.json"), help="where the rows go")
    p.add_argument("--out", type=Path, default=Path("bench"), help="folder of plot and history")
    p.add_argument("--rounds", type=_rounds, default=ROUNDS, help="at least 9 for a fair median")
    p.add_argument("--quick", action="store_true", help=f"{QUICK_ROUNDS} rounds")
    p.add_argument("--only", nargs="+", choices=list(GROUPS), help="these groups alone")
    return p


def _rounds(text: str) -> int:
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError("one round is the least")
    return value


if __name__ == "__main__":
    sys.exit(main())
