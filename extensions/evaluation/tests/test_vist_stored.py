"""Finished trials are stored when an evaluation is ended, and are used only in the tables of their
case."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest

from extensions.evaluation.vist.cases import Case
from extensions.evaluation.vist.metrics import Trial, WholeHandErrors
from extensions.evaluation.vist.run import run_cases
from extensions.evaluation.vist.stored import PROGRAM, StoredTrials
from tests.notices import raises
from tracker.base.errors import ConfigError, FileError

CASES = [Case("free", "chain"), Case("free", "vist", ablation="loose")]


class Participants:
    """Replaces `run_trial`: trials of noise that identify their participant; ends after ``end``
    runs."""

    def __init__(self, end: int = 1000) -> None:
        self.ran: list[tuple[Case, int]] = []
        self._end = end

    def __call__(self, case: Case, participant: int) -> Trial:
        if len(self.ran) == self._end:
            raise KeyboardInterrupt
        self.ran.append((case, participant))
        rng = np.random.default_rng(CASES.index(case) * 10 + participant)
        error = np.where(rng.random((7, 4)) < 0.2, np.nan, rng.random((7, 4)))
        return Trial(
            participant=participant, hand_length=0.18, t=np.arange(7.0), error=error, sd=error,
            joints=rng.random((7, 9)), seen=np.arange(7), matches=5, wrong_matches=1,
            core_s=0.25, duration=7.5, whole=whole(rng) if participant else None,
        )  # fmt: skip


def whole(rng: np.random.Generator) -> WholeHandErrors:
    error, sd = rng.random((2, 7, 5))
    return WholeHandErrors(tuple("abcde"), error, sd, rng.integers(0, 3, (7, 5)))


def run(
    monkeypatch: pytest.MonkeyPatch, stored: StoredTrials, cases: list[Case], end: int = 1000
) -> tuple[list[list[Trial]], list[tuple[Case, int]]]:
    people = Participants(end)
    monkeypatch.setattr("extensions.evaluation.vist.run.run_trial", people)
    return run_cases(cases, 3, stored=stored), people.ran


def test_an_interrupted_run_is_resumed(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    first, done = run(monkeypatch, StoredTrials(tmp_path / "stored"), CASES, end=4)
    assert [len(trials) for trials in first] == [3, 1]
    second, ran = run(monkeypatch, StoredTrials(tmp_path / "stored"), CASES)
    assert set(done).isdisjoint(ran) and len(done) + len(ran) == 6
    people = Participants()
    for case, trials in zip(CASES, second, strict=True):
        for participant, trial in enumerate(trials):
            expected = people(case, participant)
            assert_same_fields(trial, expected)


def assert_same_fields(a: Trial | WholeHandErrors, b: Trial | WholeHandErrors) -> None:
    for field in fields(a):
        x, y = getattr(a, field.name), getattr(b, field.name)
        assert type(x) is type(y)
        if isinstance(x, WholeHandErrors):
            assert_same_fields(x, y)
        else:
            np.testing.assert_array_equal(x, y)


def test_trials_of_another_case_are_not_taken(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Every field of a case counts, and so does the content of its files."""
    stored, profile = StoredTrials(tmp_path / "stored"), tmp_path / "wearer.toml"
    profile.write_text("one")
    case = replace(CASES[0], wearer=str(profile))
    stored.add(case, Participants()(CASES[0], 0))
    assert stored.find(case, 0) is not None
    assert stored.find(case, 1) is None
    assert stored.find(replace(case, seed=1), 0) is None
    profile.write_text("another")
    assert stored.find(case, 0) is None


def test_trials_of_another_version_and_damaged_trials_are_rejected(tmp_path: Path) -> None:
    stored = StoredTrials(tmp_path)
    stored.add(CASES[0], Participants()(CASES[0], 0))
    (file,) = tmp_path.glob("free-chain-*-00.npz")
    file.write_bytes(file.read_bytes()[:-100])
    with raises(FileError, "vist.damaged_trial"):
        stored.find(CASES[0], 0)
    (tmp_path / PROGRAM).write_text("glovetrack 0.0.9 abc\n")
    with raises(ConfigError, "vist.other_version"):
        StoredTrials(tmp_path)
