"""Tables, report and data set of a study, compared with independent computations and readers."""

from __future__ import annotations

import csv
import json
import shutil
import subprocess
import sys
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from extensions.study.errors import TrueKeypoints, read_truth, trial_of
from extensions.study.folder import Study
from extensions.study.retrack import RECORDED, chosen, retracked, variants
from extensions.study.tables import ALL, Evaluated, evaluate, rows_of
from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.cli import main
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Estimate
from tracker.session.compare import truth_error_mm
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.long


@pytest.fixture(scope="module")
def recorded(short_study: Study) -> list[Evaluated]:
    return evaluate(short_study, chosen((RECORDED,)), processes=1)


def test_errors_are_those_of_another_comparison(short_study: Study) -> None:
    """`compare` computes means over the whole session; here the first third is left out."""
    path = short_study.accepted()[0].path
    truth = read_truth(path)
    assert truth is not None and truth.source == "truth"
    trial = trial_of(path, chosen((RECORDED,))[0], truth, 0)
    known = truth_error_mm(path, path)
    assert trial.t[0] > 0.5 and len(trial.t) > 100
    for k, name in enumerate(MARKED_KEYPOINTS):
        assert 1e3 * trial.error[:, k].mean() == pytest.approx(known[name], rel=0.5, abs=1.0)


def test_rows_have_the_figures_of_their_instants(recorded: list[Evaluated]) -> None:
    rows = rows_of(recorded)
    assert [(r.condition, r.keypoint) for r in rows[:5]] == [
        (rows[0].condition, name) for name in (ALL, *MARKED_KEYPOINTS)
    ]
    for row in rows:
        trials = [e.trial for e in recorded if e.condition == row.condition]
        error = 1e3 * np.concatenate([t.error for t in trials])
        if row.keypoint != ALL:
            error = error[:, [MARKED_KEYPOINTS.index(row.keypoint)]]
        assert row.participants == 2 and row.trials == 2
        assert row.mean_mm == pytest.approx(np.nanmean(error))
        assert row.sd_mm == pytest.approx(np.nanstd(error))
        assert row.pck20 == pytest.approx(100 * np.mean(error.max(axis=1) <= 20.0))
        means = [np.nanmean(1e3 * t.error[:, : error.shape[1]]) for t in trials]
        if row.keypoint == ALL:
            assert row.between_sd_mm == pytest.approx(np.std(means, ddof=1))
            assert row.ci95_low_mm <= row.mean_mm <= row.ci95_high_mm


def test_tracking_again_is_deterministic_and_images_are_needed(short_study: Study) -> None:
    path = short_study.accepted()[0].path
    first, again = (retracked(path, chosen(("chain",))[0]) for _ in range(2))
    assert all(
        np.array_equal(a.keypoints, b.keypoints, equal_nan=True)
        for a, b in zip(first.estimates, again.estimates, strict=True)
    )
    assert len(first.t) == len(first.seen) and first.seen.max() > 4
    (blind,) = chosen(("chain vision-only",))
    without = retracked(path, blind)
    after = np.array(without.t) > 4.2
    same = [
        np.array_equal(a.keypoints, b.keypoints, equal_nan=True)
        for a, b in zip(first.estimates, without.estimates, strict=True)
    ]
    assert all(s for s, late in zip(same, after, strict=True) if not late and without.t[0] < 4.0)
    assert not any(s for s, late in zip(same, after, strict=True) if late)


def test_variants_are_those_that_a_recording_allows() -> None:
    names = set(variants())
    assert {RECORDED, "chain", "vist", "chain vision-only", "vist loose"} <= names
    assert {"chain imu-only-5s", "chain imu-only-60s", "chain no-finger-accelerometers"} <= names
    assert not any("10fps" in n or "camera" in n for n in names)
    with raises(ConfigError, "study.unknown_variant"):
        chosen(("chain of thought",))


def test_a_reference_is_interpolated_but_not_over_gaps() -> None:
    t = np.array([0.0, 0.1, 0.2, 1.0, 1.1])
    keypoints = np.zeros((5, 1, 3))
    keypoints[:, 0, 0] = t
    at, _ = TrueKeypoints(t, keypoints, np.zeros((5, 3, 3)), "reference").at(
        np.array([-0.05, 0.05, 0.2, 0.6, 1.05, 1.2])
    )
    assert at[:, 0, 0] == pytest.approx([np.nan, 0.05, 0.2, np.nan, 1.05, np.nan], nan_ok=True)


def test_a_laboratorys_recording_is_the_reference(short_study: Study, tmp_path: Path) -> None:
    """The estimates themselves, exported as C3D and imported again: the errors are almost zero."""
    path = next(a.path for a in short_study.accepted() if a.step.task == "postures")
    with SessionReader(path) as reader:
        first = next(iter(reader.messages([Estimate])))
        start = datetime.fromtimestamp(reader.anchor.wall(first.t) * 1e-9, UTC).isoformat()
    c3d, whole = tmp_path / "lab.c3d", tmp_path / "with.mcap"
    assert main(["export", str(path), "--format", "c3d", "-o", str(c3d)]) == 0
    command = ["import-reference", str(c3d), str(path), "-o", str(whole), "--no-drift"]
    assert main([*command, "--by", "clock", "--start", start]) == 0
    truth = read_truth(whole)
    assert truth is not None and truth.source == "reference"
    trial = trial_of(whole, chosen((RECORDED,))[0], truth, 0)
    assert len(trial.t) > 100 and np.nanmean(1e3 * trial.error) < 1.0
    true = trial_of(path, chosen((RECORDED,))[0], read_truth(path) or truth, 0)
    assert np.nanmean(1e3 * true.error) > 2.0


def test_tables_and_report(
    short_study: Study, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, table = str(short_study.folder), tmp_path / "t.csv"
    numbers = tmp_path / "t.json"
    command = ["study", "tables", folder, "-o", str(table), "--processes", "1"]
    assert main([*command, "--json", str(numbers), "--variants", "recorded, chain"]) == 0
    rows = list(csv.DictReader(table.open()))
    assert {r["variant"] for r in rows} == {"recorded", "chain"} and len(rows) == 20
    assert len(json.loads(numbers.read_text())["rows"]) == 20
    out = capsys.readouterr().out
    assert "Lee et al. 2021" in out and "10.69" in out
    assert main(["study", "report", folder, "-o", str(tmp_path / "r"), "--movement"]) == 0
    assert "P02" in (tmp_path / "r" / "movement.html").read_text("utf-8")
    page = (tmp_path / "r" / "report.html").read_text("utf-8")
    assert "4 of 4 trials accepted, 2 of 2 participants" in page
    assert page.count("sub-P0") == 4 and "SD between participants" in page
    assert "Errors against the reference" in page and "Lee et al. 2021" in page


def test_no_command_replaces_a_file_without_force(short_study: Study, tmp_path: Path) -> None:
    folder, mine = str(short_study.folder), tmp_path / "mine.txt"
    full = tmp_path / "full"
    full.mkdir()
    for path in (mine, full / "report.html"):
        path.write_text("mine")
    protocol = str(short_study.folder / "protocol" / "protocol.toml")
    for words in (
        ["check", protocol, "--json", str(mine)],
        ["status", folder, "--json", str(mine)],
        ["tables", folder, "-o", str(mine)],
        ["tables", folder, "-o", str(tmp_path / "t.csv"), "--json", str(mine)],
        ["report", folder, "-o", str(full)],
        ["export", folder, "-o", str(full)],
        ["export", folder, "-o", str(tmp_path / "new"), "--json", str(mine)],
    ):
        assert main(["study", *words]) == 1, words
    assert mine.read_text() == (full / "report.html").read_text() == "mine"
    assert main(["study", "status", folder, "--json", str(mine), "--force"]) == 0
    assert "participants" in json.loads(mine.read_text())


def test_the_official_validator_accepts_the_data_set(short_study: Study, tmp_path: Path) -> None:
    out = tmp_path / "bids"
    assert main(["study", "export", str(short_study.folder), "-o", str(out)]) == 0
    motion = out / "sub-P02" / "ses-timed" / "motion"
    stem = "sub-P02_ses-timed_task-pegs_tracksys-hand_run-01"
    said = json.loads((motion / f"{stem}_motion.json").read_text())
    assert said["TaskName"] == "pegs" and said["TaskDescription"] == "Put the pegs into the holes."
    scans = (out / "sub-P02" / "ses-timed" / "sub-P02_ses-timed_scans.tsv").read_text()
    assert f"motion/{stem}_motion.tsv\t2025-01-01T" in scans
    people = (out / "participants.tsv").read_text().splitlines()
    assert people == ["participant_id\thand", "sub-P01\tright", "sub-P02\tright"]
    events = out / "sub-P01/ses-free/motion/sub-P01_ses-free_task-postures_run-01_events.tsv"
    assert len(events.read_text().splitlines()) == 1 + 3
    with raises(FileError, "file.folder_not_empty"):
        from extensions.study.export import export_study

        export_study(short_study, out)
    validator = shutil.which("bids-validator-deno", path=str(Path(sys.executable).parent))
    if validator is None:
        pytest.skip("bids-validator-deno is not installed")
    done = subprocess.run(
        [validator, str(out), "--format", "json"], capture_output=True, text=True, check=False
    )
    found = json.loads(done.stdout)
    assert [i for i in found["issues"]["issues"] if i["severity"] == "error"] == []
    assert sorted(found["summary"]["subjects"]) == ["P01", "P02"]
    assert sorted(found["summary"]["sessions"]) == ["free", "timed"]
    assert sorted(found["summary"]["tasks"]) == ["pegs", "postures"]
