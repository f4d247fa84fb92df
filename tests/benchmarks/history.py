"""The history of benchmark runs: one JSON object a line, so that a later run has a former one.

    {"when": ISO 8601 UTC, "version": str, "machine": str, "rounds": int, "load": float|null,
     "rows": [{"name", "value", "unit", "peer", "peer_value", "ratio", "goal"}]}

Ratios compare across machines, values only on one machine.
"""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Sequence
from dataclasses import asdict, dataclass, fields
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import tracker
from tests.benchmarks.rows import BenchRow
from tracker.base.errors import FileError


@dataclass(frozen=True)
class Run:
    """One run of the benchmark; ``load`` is the machine's mean load of the last minute."""

    when: str
    version: str
    machine: str
    rounds: int
    load: float | None
    rows: tuple[BenchRow, ...]


def this_run(rows: Sequence[BenchRow], rounds: int) -> Run:
    """A run that ends now, on this machine."""
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else None
    machine = f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores"
    when = datetime.now(UTC).isoformat(timespec="seconds")
    return Run(when, tracker.__version__, machine, rounds, load, tuple(rows))


def append(path: Path, run: Run) -> None:
    """Add a run. Raises FileError where the file cannot be written."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(asdict(run), ensure_ascii=False, allow_nan=False) + "\n")
    except OSError as error:
        raise FileError(f"The history {path} could not be written: {error}.") from error


def read(path: Path) -> list[Run]:
    """All runs, oldest first; none if there is no file. Raises FileError naming a damaged line."""
    if not path.exists():
        return []
    runs = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        try:
            runs.append(_run(json.loads(line)))
        except (ValueError, KeyError, TypeError) as error:
            raise FileError(f"{path}, line {number}, is not a run of the benchmark.") from error
    return runs


def _run(data: dict[str, Any]) -> Run:
    rows = tuple(BenchRow(**r) for r in data["rows"])
    return Run(rows=rows, **{f.name: data[f.name] for f in fields(Run) if f.name != "rows"})


def change(now: BenchRow, former: Sequence[Run]) -> float | None:
    """This run's figure over that of the latest former run with such a row.

    Ratios where both have one, else values; None where there is nothing to compare with.
    """
    rows = (r for run in reversed(former) for r in run.rows if r.name == now.name)
    old = next(rows, None)
    if old is None:
        return None
    if now.ratio is not None and old.ratio:
        return now.ratio / old.ratio
    return now.value / old.value if old.value else None
