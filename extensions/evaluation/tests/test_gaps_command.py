"""`evaluate gaps` on a small scale."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from extensions.evaluation.gaps.command import GapsFigures, row_of, summary, table
from tracker.cli import main


def test_a_row_pools_the_people() -> None:
    good = GapsFigures(0, 100, 99.0, 0, (0.05, 0.06), 1000, 0, 0)
    late = GapsFigures(1, 100, 95.0, 100, (0.2,), 1000, 8, 0)
    row = row_of(1.0, True, [good, late])
    assert (row.gaps, row.true, row.position) == (3, 0.97, pytest.approx(2 / 3))
    assert (row.back_s, row.longest_s, row.lost) == (0.06, 0.2, 0.004)
    assert len(table([row])) == 2
    assert summary([row_of(1.0, False, [good])])["ok"] and not summary([row])["ok"]
    assert not summary([row_of(1.0, False, [good._replace(wrong=1)])])["ok"]


@pytest.mark.long
def test_a_hand_is_out_of_view_and_returns(tmp_path: Path) -> None:
    out = tmp_path / "rows.json"
    words = ["--gaps", "0.3", "--participants", "1", "--fps", "15", "--devices", "real"]
    assert main(["evaluate", "gaps", *words, "--json", str(out)]) == 0
    rows = json.loads(out.read_text())["rows"]
    assert [(r["gaps"], r["errors"], r["wrong"]) for r in rows] == [(2, True, 0)]
    assert all(0.0 < r["back_s"] <= r["longest_s"] <= 0.15 and r["lost"] == 0 for r in rows)
    assert main(["evaluate", "gaps", "--gaps", "0"]) != 0
