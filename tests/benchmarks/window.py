"""The running app: latency, start and memory, measured by ``python -m app.tools.soak``; and what a
refresh of the window costs, by ``python -m app.tools.paint_profile``."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from tests.benchmarks.rows import BenchRow, row

FULL_ROUNDS = 9  # from which on the demo runs as long as the memory's goal says
MINUTES, QUICK_MINUTES = 10.0, 0.5
PAINT_GOALS = {"right": "<= 4 ms", "both": "<= 6 ms"}
PATIENCE_S = 300.0  # beyond the minutes, for a first start


def app_rows(rounds: int) -> list[BenchRow]:
    """The demo for ten minutes, half a minute in a quick run; no rows where there is no window."""
    minutes = MINUTES if rounds >= FULL_ROUNDS else QUICK_MINUTES
    figures = soak(minutes)
    if figures is None:
        return []
    painted = [paint_row(hands) for hands in ("right", "both")]
    return rows_of(figures) + [made for made in painted if made is not None]


def soak(minutes: float) -> dict[str, Any] | None:
    """What the app measured of itself; None where it does not run."""
    found = _measured("soak", ["--minutes", str(minutes)], 60.0 * minutes)
    figures: dict[str, Any] | None = found["soak"] if found is not None else None
    return figures


def paint_row(hands: str) -> BenchRow | None:
    """What all panels need of Python's lock, against a fixed loop of Python."""
    found = _measured("paint_profile", ["--hands", hands], 0.0)
    if found is None:
        return None
    name = f"Python of a refresh of all panels, hands: {hands}"
    return row(name, found["locked_ms"], "ms", "fixed loop", found["loop_ms"], PAINT_GOALS[hands])


def _measured(tool: str, options: list[str], lasts_s: float) -> dict[str, Any] | None:
    """What a tool writes; None, with its last words, where it does not run."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "measured.json"
        done = subprocess.run(
            [sys.executable, "-m", f"app.tools.{tool}", *options, "--json", str(out)],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            timeout=lasts_s + PATIENCE_S,
            check=False,
        )
        if done.returncode != 0:
            print(f"The app was not measured: {done.stderr.strip()[-300:]}", file=sys.stderr)
            return None
        found: dict[str, Any] = json.loads(out.read_text("utf-8"))
        return found


def rows_of(figures: dict[str, Any]) -> list[BenchRow]:
    """Rows of a soak's figures; memory is this process's, the simulated camera has its own."""
    latency, memory = figures["latency_ms"], figures["memory_mb"]
    minutes = figures["minutes"]
    return [
        _plain("sample to pose in the app, median", latency["latency_imu_ms"], "ms", "<= 8"),
        _plain("sample to pose in the app, 99 %", latency["latency_imu_p99_ms"], "ms", "<= 25"),
        _plain("start to first tracked frame", figures["start_to_tracked_s"], "s", "<= 3 s"),
        _plain(f"memory after {minutes:g} min", memory[-1], "MB", "<= 700"),
        _plain("  of it since the first minute", memory[-1] - memory[min(1, len(memory) - 1)],
               "MB", "-"),
    ]  # fmt: skip


def _plain(name: str, value: float, unit: str, goal: str) -> BenchRow:
    return row(name, value, unit, "-", None, goal)
