"""The benchmark's command: valid rows, correct evaluation of goals, a comparable history."""

import json
from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks import __main__ as bench
from tests.benchmarks import history as bench_history
from tests.benchmarks import output as bench_output
from tests.benchmarks import profile as bench_profile
from tests.benchmarks.fusion import difference, update_case, update_rows
from tests.benchmarks.peers_fusion import dense_joseph
from tests.benchmarks.rows import BenchRow, row
from tracker.base.errors import FileError

KEYS = {"name", "value", "unit", "peer", "peer_value", "ratio", "goal"}


@pytest.fixture
def cheap(monkeypatch: pytest.MonkeyPatch) -> None:
    """Few calls a round: the arithmetic of the command is tested, not the machine."""
    groups = {
        "fusion": lambda rounds: update_rows(rounds, 1, inner=2),
        "inertial": lambda rounds: bench.inertial_rows(rounds, inner=20),
    }
    monkeypatch.setattr(bench, "GROUPS", groups)


def run(folder: Path) -> int:
    return bench.main(["--quick", "--json", str(folder / "b.json"), "--out", str(folder / "out")])


@pytest.mark.usefixtures("cheap")
def test_quick_run_writes_rows_plot_and_history(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path) == 0
    rows = json.loads((tmp_path / "b.json").read_text())["rows"]
    assert len(rows) == 3
    for r in rows:
        assert set(r) == KEYS
        assert np.isfinite(r["value"]) and r["value"] >= 0
        if r["ratio"] is not None:
            assert r["ratio"] == pytest.approx(r["value"] / r["peer_value"])
    assert (tmp_path / "out" / "bench.png").read_bytes()[:4] == b"\x89PNG"
    assert "vs last" in capsys.readouterr().out
    (stored,) = bench_history.read(tmp_path / "out" / "history.jsonl")
    assert [r.name for r in stored.rows] == [r["name"] for r in rows]
    assert stored.rounds == bench.QUICK_ROUNDS


@pytest.mark.usefixtures("cheap")
def test_second_run_is_compared_with_the_first(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run(tmp_path)
    assert "  x " not in capsys.readouterr().out
    run(tmp_path)
    assert capsys.readouterr().out.count("  x ") == 3
    assert len(bench_history.read(tmp_path / "out" / "history.jsonl")) == 2


@pytest.mark.usefixtures("cheap")
def test_damaged_history_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "history.jsonl").write_text('{"rows": []}\n')
    assert run(tmp_path) == 1
    assert "line 1, is not a run of the benchmark" in capsys.readouterr().err


def test_unwritable_json_is_reported(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="b.json"):
        bench.write_json(tmp_path / "absent" / "b.json", [])


@pytest.mark.parametrize(
    ("made", "expected"),
    [
        (row("r", 1.0, "ms", "peer", 10.0, "0.10"), True),
        (row("r", 1.1, "ms", "peer", 10.0, "0.10"), False),
        (row("r", 1.1, "ms", "peer", None, "0.10"), None),
        (row("r", 1.1, "ms", "peer", 10.0, "-"), None),
        (row("r", 0.2, "s", "-", None, "<= 0.15 s"), False),
        (row("r", 0.1, "s", "-", None, "<= 0.15 s"), True),
        (row("r", 1e-12, "", "-", None, "1e-10"), True),
        (row("r", 1e-9, "", "-", None, "1e-10"), False),
        (row("r", 0.98, "of all", "peer", 0.5, ">= 0.97"), True),
        (row("r", 0.96, "of all", "peer", 0.5, ">= 0.97"), False),
        (row("r", 98.6, "%", "peer", 99.0, ">= peer - 0.5"), True),
        (row("r", 98.4, "%", "peer", 99.0, ">= peer - 0.5"), False),
        (row("r", 0.6, "", "peer", 0.0, "<= peer + 0.5"), False),
        (row("r", 0.5, "", "peer", 0.0, "<= peer + 0.5"), True),
    ],
)
def test_goals(made: BenchRow, expected: bool | None) -> None:
    assert bench_output.reached(made) is expected


def test_missing_peer_is_reported() -> None:
    absent = row("filters", 1.0, "µs", "vqf", None, "0.25")
    assert "not compared, vqf is not here" in bench_output.table([absent])


def test_change_is_of_ratios_where_there_are_any() -> None:
    """A computer half as fast leaves the ratio unchanged."""
    earlier = bench_history.this_run([row("r", 9.0, "ms", "p", 10.0, "-")], 3)
    latest = bench_history.this_run([row("r", 1.0, "ms", "p", 10.0, "-")], 3)
    partial = bench_history.this_run([row("q", 5.0, "ms", "p", 10.0, "-")], 3)
    before = [earlier, latest, partial]
    assert bench_history.change(row("r", 2.0, "ms", "p", 20.0, "-"), before) == pytest.approx(1.0)
    assert bench_history.change(row("r", 2.0, "ms", "p", None, "-"), before) == pytest.approx(2.0)
    assert bench_history.change(row("other", 2.0, "ms", "p", None, "-"), before) is None


def test_joseph_is_the_information_form() -> None:
    """The peer computes the right thing: P⁻¹ + Hᵀ R⁻¹ H is the inverse of its new P."""
    u = update_case(np.random.default_rng(3), states=21 * 4)
    dx, P = dense_joseph(u.P, u.H, u.r, u.R)
    information = np.linalg.inv(u.P) + u.H.T @ np.linalg.inv(u.R) @ u.H
    expected = np.linalg.inv(information)
    assert np.abs(P - expected).max() < 1e-9 * np.abs(u.P).max()
    assert np.abs(dx - expected @ u.H.T @ np.linalg.solve(u.R, u.r)).max() < 1e-8


def test_ours_equals_joseph() -> None:
    assert difference(update_case(np.random.default_rng(4))) < 1e-10


def test_profile_table_adds_up() -> None:
    costs = [
        bench_profile.Cost("a", 2, 3.0, 4.0),
        bench_profile.Cost("b", 1, 1.0, 1.0),
    ]
    text = bench_profile.markdown(costs, 1)
    assert "| `a` | 2 | 3.0 | 75.0 | 4.0 |" in text
    assert "`b`" not in text and "| 4 | 100 |" in text
