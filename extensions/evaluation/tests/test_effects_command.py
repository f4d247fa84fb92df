"""`evaluate effects` on a small scale, and the errors of the simulated devices."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from extensions.evaluation.effects.command import EffectsRow, rows_of, summary, table
from extensions.evaluation.effects.trial import EffectsFigures
from tracker.cli import main


def test_each_row_is_the_mean_of_the_people_relative_to_the_first_row() -> None:
    figures = [
        EffectsFigures(0, 3.0, 1.0, 0), EffectsFigures(1, 5.0, 0.9, 0),
        EffectsFigures(0, 4.0, 0.8, 2), EffectsFigures(1, 5.0, 1.0, 1),
    ]  # fmt: skip
    rows = rows_of(["clean", "all"], figures)
    assert rows == [EffectsRow("clean", 4.0, 1.0, 0.9, 0), EffectsRow("all", 4.5, 1.125, 0.8, 3)]
    assert len(table(rows)) == 3
    assert not summary(rows)["ok"], "wrong keypoints are not allowed"
    assert summary([rows[0], replace_row(rows[1], wrong=0)])["ok"]
    assert not summary([rows[0], replace_row(rows[1], wrong=0, ratio=1.16)])["ok"]


def replace_row(row: EffectsRow, **changes: float) -> EffectsRow:
    return row._replace(**changes)


@pytest.mark.long
@pytest.mark.usefixtures("workers_here")
def test_the_short_form(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """5 s are too short for the goal."""
    out = tmp_path / "rows.json"
    words = ["--short", "--participants", "1", "--seconds", "5", "--fps", "15"]
    main(["evaluate", "effects", *words, "--json", str(out)])
    rows = json.loads(out.read_text())["rows"]
    assert [r["name"] for r in rows] == ["clean", "all"]
    assert all(0.0 < r["error_mm"] < 15.0 and r["wrong"] == 0 for r in rows)
    assert rows[0]["error_mm"] != rows[1]["error_mm"]
    assert main(["evaluate", "effects", "--seconds", "1"]) != 0
