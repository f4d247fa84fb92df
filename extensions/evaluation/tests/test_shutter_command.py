"""`evaluate shutter` on a small scale, and the computation of its figures."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from extensions.evaluation.shutter.command import (
    ShutterCase,
    ShutterFigures,
    ShutterRow,
    rows_of,
    run_trial,
    summary,
    table,
)
from tracker.cli import main

FAST = ShutterCase(2.0, 0.0, 0.018, fps=30.0, seconds=4.0)


def test_the_rows_are_means_of_people_in_the_order_of_the_trials() -> None:
    figures = [ShutterFigures(0, float(k), 1.0, 0.0) for k in range(12)]
    rows = rows_of([(1.0, 0.0), (0.5, 200.0)], figures, 2)
    assert rows == [ShutterRow(1.0, 0.0, 0.5, 2.5, 4.5), ShutterRow(0.5, 200.0, 6.5, 8.5, 10.5)]
    assert len(table(rows)) == 3


def test_the_goal_is_for_the_worst_row() -> None:
    good, bad = ShutterRow(1.0, 0.0, 3.0, 4.0, 3.05), ShutterRow(2.0, 0.0, 3.0, 9.0, 3.3)
    assert summary([good])["ok"] and not summary([good, bad])["ok"]
    assert summary([good, bad])["ratio"] == pytest.approx(1.1)


@pytest.mark.long
def test_a_known_line_time_removes_most_of_the_error_of_a_fast_hand() -> None:
    """One person at 2 m/s, long enough to be found: without the line time several millimetres."""
    at_once, unknown, known = (
        run_trial(case, 1)
        for case in (replace(FAST, readout=0.0), replace(FAST, compensated=False), FAST)
    )
    assert known.tracked == 1.0
    assert unknown.error_mm > at_once.error_mm + 1.0
    assert known.error_mm < at_once.error_mm + 0.3 * (unknown.error_mm - at_once.error_mm)


@pytest.mark.long
@pytest.mark.usefixtures("workers_here")
def test_a_short_run_of_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "rows.json"
    words = ["--participants", "1", "--seconds", "5", "--fps", "15", "--speeds", "1"]
    main(["evaluate", "shutter", *words, "--json", str(out)])
    rows = json.loads(out.read_text())["rows"]
    assert [(r["speed"], r["turning_deg"]) for r in rows] == [(1.0, 0.0), (1.0, 200.0)]
    assert all(r["known_mm"] < 15 for r in rows)
    before = out.read_bytes()
    assert main(["evaluate", "shutter", *words, "--json", str(out)]) != 0
    assert out.read_bytes() == before, "an existing file is not replaced"
    assert main(["evaluate", "shutter", "--readout-ms", "0"]) != 0
