"""`evaluate hands` on a small scale, and the computation of its figures."""

import json
from concurrent.futures import Future
from pathlib import Path

import numpy as np
import pytest

from extensions.evaluation.hands.command import HandFigures, longest, summary, table
from tests.notices import shows
from tracker.base.workers import WorkItem, run_all
from tracker.cli import main

GOOD = HandFigures(1, "left", 4.0, 4.0, 4.0, 1.0, 1.0, 0.0)
PULLED = HandFigures(1, "right", 6.0, 4.0, 5.0, 0.9, 0.8, 1.5)


def test_the_longest_run_counts_not_the_sum() -> None:
    t = np.arange(8) * 0.1
    wrong = np.array([1, 1, 0, 1, 1, 1, 0, 1], bool)
    assert longest(t, wrong) == pytest.approx(0.2)
    assert longest(t, np.zeros(8, bool)) == 0.0


def test_goals_are_met_by_good_pairs_and_missed_by_one_that_is_pulled() -> None:
    assert summary([GOOD, GOOD])["ok"]
    found = summary([GOOD, PULLED])
    assert not found["ok"] and found["ratio"] == pytest.approx(1.25)
    assert found["confusion"] == pytest.approx(10 / 9)
    assert found["longest_off_s"] == 1.5
    assert len(table([GOOD, PULLED], found)) == 4


@pytest.mark.long
@pytest.mark.usefixtures("workers_here")
def test_a_pair_is_tracked_by_the_command(tmp_path: Path) -> None:
    said = tmp_path / "said.json"
    words = ["--pairs", "1", "--seconds", "4", "--fps", "30", "--seed", "5", "--json", str(said)]
    assert main(["evaluate", "hands", *words]) == 0
    found = json.loads(said.read_text())
    assert [row["side"] for row in found["rows"]] == ["left", "right"]
    for row in found["rows"]:
        assert row["together_mm"] < 15
        assert row["confusion"] < 1.1, "what the other hand's markers cost"


def test_an_unknown_engine_is_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["evaluate", "hands", "--engine", "none"]) != 0
    assert shows(capsys.readouterr().err, "part.unknown", name="none")


class NoWorkers:
    """Workers whose process was ended by the same signal as this one."""

    @property
    def board(self) -> "NoWorkers":
        return self

    @property
    def stop(self) -> "NoWorkers":
        return self

    def submit(self, *_: object) -> Future[None]:
        return Future()

    def qsize(self) -> int:
        return 1

    def get(self, timeout: float) -> tuple[int, float]:
        raise KeyboardInterrupt

    def put(self, note: tuple[int, float]) -> None: ...

    def is_set(self) -> bool:
        return False

    def set(self) -> None:
        raise BrokenPipeError


def test_stopped_workers_are_not_reported_as_a_disk_error() -> None:
    with pytest.raises(KeyboardInterrupt):
        run_all([WorkItem(print, ())], NoWorkers(), lambda share: None)
