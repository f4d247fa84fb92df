"""`evaluate fingers` on a small scale."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from extensions.evaluation.fingers.command import rows_of, table
from extensions.evaluation.fingers.trial import TIPS, TipErrors
from tracker.cli import main


def test_rows_separate_the_states_and_pool_the_sessions() -> None:
    seen = TipErrors(np.array([0.004, 0.03]), np.array([0.003, 0.02]), np.array([True, False]))
    hidden = TipErrors(np.array([0.05]), np.array([0.01]), np.array([False]))
    (row,) = rows_of([{"ring_tip": seen}, {"ring_tip": hidden}], cloth=True)
    assert (row.tip, row.error_mm) == ("ring_tip", pytest.approx(28.0))
    assert row[3:] == pytest.approx((1 / 3, 4.0, 40.0, 2 / 3))
    (other,) = rows_of([{"ring_tip": hidden}], cloth=False)
    assert other.measured_mm is None
    assert [line.split()[1] for line in table([row, other])[1:]] == ["with", "without"]


def test_sessions_without_cloth_are_tracked_the_same_both_times(tmp_path: Path) -> None:
    session, out = tmp_path / "s.mcap", tmp_path / "rows.json"
    short = ["--blobs-only", "--duration", "2.5", "--fps", "15"]
    assert main(["simulate", "-o", str(session), *short]) == 0
    assert main(["evaluate", "fingers", str(session), "--json", str(out)]) == 0
    rows = json.loads(out.read_text())["rows"]
    assert [(r["tip"], r["cloth"]) for r in rows] == [(t, c) for c in (False, True) for t in TIPS]
    for with_cloth, without in zip(rows[5:], rows[:5], strict=True):
        assert {**with_cloth, "cloth": False} == without
        assert with_cloth["measured"] == 0.0 or "ring" not in with_cloth["tip"]
