"""Trials by simulated participants: verdicts, repetitions, and a run that is killed and resumed."""

from __future__ import annotations

import json
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from extensions.study.command_runs import run_headless
from extensions.study.folder import Study, open_study, start_study
from extensions.study.progress import ACCEPTED, DONE, FAILED, OPEN, RECORDING, Progress, locked
from extensions.study.schedule import TRIAL
from extensions.study.tests.studies import SHORT, write_protocol
from extensions.study.verdict import judge, stored
from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.cli import main
from tracker.messages import Event
from tracker.offline.options import TrackOptions
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.reader import SessionReader
from tracker.session.recover import needs_recovery

pytestmark = pytest.mark.long

ROOT = Path(__file__).parents[3]


@pytest.fixture
def done(short_study: Study) -> Progress:
    """The first participant's trials."""
    return short_study.progress("P01")


def notes(path: Path) -> list[Event]:
    with SessionReader(path) as reader:
        return [m for m in reader.messages([Event]) if isinstance(m, Event) and m.kind == "note"]


def test_every_trial_is_recorded_under_its_name_and_accepted(done: Progress) -> None:
    assert done.step is None
    assert {done.entry(s).state for s in done.trials} == {ACCEPTED}
    assert {done.entry(s).state for s in done.steps if s.kind != TRIAL} == {DONE}
    files = {p.relative_to(done.root).as_posix() for p in done.root.rglob("*.mcap")}
    assert files == {f"ses-{s.condition}/{s.name}.mcap" for s in done.trials}


def test_cues_are_notes_at_their_times(done: Progress) -> None:
    (step,) = (s for s in done.trials if s.task == "postures")
    found = notes(done.path(step))
    assert [n.text for n in found] == [c.what for c in step.cues] and len(found) == 3
    assert [n.data["study_cue"] for n in found] == [1, 2, 3]
    assert [n.t - found[0].t for n in found] == pytest.approx([0.0, 1.7, 3.4], abs=0.11)
    with SessionReader(done.path(step)) as reader:
        assert reader.info.participant == "P01" and reader.info.notes == "postures"
        assert reader.duration == pytest.approx(5.0, abs=0.2)
        assert any(reader.truth())


def test_a_trial_can_be_tracked_again_bit_for_bit(done: Progress, tmp_path: Path) -> None:
    path = done.path(done.trials[0])
    track(path, tmp_path / "again.mcap", TrackOptions())
    assert compare(path, tmp_path / "again.mcap")["identical"]


def test_a_timed_trial_ends_when_the_participant_has_finished(done: Progress) -> None:
    (step,) = (s for s in done.trials if s.task == "pegs")
    (one,) = done.entry(step).tries
    verdict = stored(one.verdict or {})
    assert 1.5 < verdict.measured.duration < 3.6  # 0.3 to 0.7 of the longest time
    assert verdict.is_good


def test_a_verdict_has_the_figures_of_the_recording(done: Progress) -> None:
    (step,) = (s for s in done.trials if s.task == "postures")
    m = judge(done.path(step), step, done.protocol.limits).measured
    assert m.packet_rate == pytest.approx(100, rel=0.02) and m.packets_lost == 0
    assert m.image_rate == pytest.approx(30, rel=0.05)
    assert m.measured + m.inferred + m.lost == pytest.approx(1.0)
    assert 0.9 < m.tracked <= 1.0 and m.duration == pytest.approx(5.0, abs=0.1)


@pytest.mark.parametrize(
    ("limits", "code"),
    [
        ("packet_rate = 150.0", "study.packet_rate"),
        ("image_rate = 50.0", "study.image_rate"),
        ("measured = 0.99", "study.unmeasured"),
        ("tracked = 1.0", "study.untracked"),
    ],
)
def test_a_verdict_names_what_is_missing(
    done: Progress, tmp_path: Path, limits: str, code: str
) -> None:
    study = start_study(write_protocol(tmp_path, f"{SHORT}\n[verdict]\n{limits}\n"), tmp_path / "s")
    (step,) = (s for s in done.trials if s.task == "postures")
    verdict = judge(done.path(step), step, study.protocol.limits)
    assert [f.code for f in verdict.findings] == [code]
    assert stored(json.loads(json.dumps(verdict.as_json()))).findings == verdict.findings


def test_a_truncated_file_is_rejected(done: Progress, tmp_path: Path) -> None:
    (step,) = (s for s in done.trials if s.task == "postures")
    whole = done.path(step).read_bytes()
    (tmp_path / "cut.mcap").write_bytes(whole[: len(whole) // 2])
    codes = [f.code for f in judge(tmp_path / "cut.mcap", step, done.protocol.limits).findings]
    assert codes[0] == "study.unfinished" and "study.short" in codes
    (tmp_path / "none.mcap").write_bytes(b"")
    (only,) = judge(tmp_path / "none.mcap", step, done.protocol.limits).findings
    assert only.code == "study.unreadable"


def test_a_bad_trial_is_repeated_and_then_fails(tmp_path: Path) -> None:
    text = SHORT.replace("participants = 2", "participants = 1\ntries = 2")
    text = text.replace('tasks = ["pegs"]', 'tasks = ["postures"]').replace("[tasks.pegs]", "[x]")
    text = text.replace("practice = 1", "").replace("duration = 6.0", "duration = 1.0")
    text = text[: text.index("[x]")] + "[verdict]\npacket_rate = 1000.0\n"
    progress = start_study(write_protocol(tmp_path, text), tmp_path / "s").progress("P01")
    lines: list[str] = []
    run_headless(progress, lines.append)
    assert [line.split(": ")[1].split(".")[0] for line in lines] == ["repeated", "failed"] * 2
    for step in progress.trials:
        entry = progress.entry(step)
        assert entry.state == FAILED and [t.outcome for t in entry.tries] == ["repeated", "failed"]
        assert entry.tries[0].file == f"superseded/{step.name}_try-1.mcap"
        assert all((progress.root / t.file).is_file() for t in entry.tries)
    with raises(ConfigError, "study.no_trials"):
        open_study(tmp_path / "s").accepted()


def test_a_killed_run_is_resumed(tmp_path: Path) -> None:
    """Killed in the middle of the second trial: that one alone is repeated."""
    text = SHORT.replace("participants = 2", "participants = 1").replace("practice = 1", "")
    text = text.replace("seed = 3", 'seed = 3\norder = "fixed"')
    protocol = write_protocol(tmp_path, text)
    folder = tmp_path / "study"
    command = [sys.executable, "-m", "app", "study", "run", str(protocol), "--folder", str(folder)]
    command += ["--simulated", "--headless"]
    second = folder / "sub-P01" / "ses-timed" / "sub-P01_ses-timed_task-pegs_run-01.mcap"
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL) as run:
        while not (second.exists() and second.stat().st_size > 450_000):
            assert run.poll() is None, "it ended before it could be killed"
            time.sleep(0.01)
        run.send_signal(signal.SIGKILL)
        run.wait()
    assert needs_recovery(second)
    study = open_study(folder)
    first = study.progress("P01").trials[0]
    before = study.progress("P01").path(first)
    stamp, content = before.stat().st_mtime_ns, before.read_bytes()
    assert study.progress("P01").entry(study.progress("P01").trials[1]).state == RECORDING
    assert subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL).returncode == 0
    progress = study.progress("P01")
    assert {progress.entry(s).state for s in progress.trials} == {ACCEPTED}
    assert (before.stat().st_mtime_ns, before.read_bytes()) == (stamp, content)
    assert len(progress.entry(first).tries) == 1
    lost, good = progress.entry(progress.trials[1]).tries
    assert (lost.outcome, good.outcome) == ("interrupted", "accepted")
    assert needs_recovery(progress.root / lost.file)
    recovered = progress.root / lost.recovered
    assert not needs_recovery(recovered) and notes(recovered) == []
    with SessionReader(recovered) as reader:
        assert reader.duration > 0.2


def test_a_complete_recording_without_a_decision_is_judged_again(
    done: Progress, tmp_path: Path
) -> None:
    """The program ended between the end of the recording and the decision."""
    shutil.copytree(done.root.parent, tmp_path / "study")
    progress = open_study(tmp_path / "study").progress("P01")
    step = progress.trials[-1]
    entry = progress.entry(step)
    entry.state, entry.tries[-1].outcome, entry.tries[-1].verdict = "recorded", "", None
    progress.save()
    lines: list[str] = []
    run_headless(progress, lines.append)
    assert len(lines) == 1 and "accepted" in lines[0]
    assert len(progress.entry(step).tries) == 1
    assert progress.path(step).read_bytes() == done.path(step).read_bytes()


def test_one_program_runs_a_participant(done: Progress, tmp_path: Path) -> None:
    progress = start_study(write_protocol(tmp_path), tmp_path / "s").progress("P02")
    with locked(progress), raises(FileError, "study.in_use"):
        run_headless(progress)
    assert all(progress.entry(s).state == OPEN for s in progress.trials)


def test_another_protocol_is_refused_in_the_same_folder(tmp_path: Path) -> None:
    start_study(write_protocol(tmp_path), tmp_path / "s")
    with raises(FileError, "study.other_protocol"):
        start_study(write_protocol(tmp_path, SHORT.replace("seed = 3", "seed = 4")), tmp_path / "s")
    with raises(FileError, "study.no_study"):
        open_study(tmp_path)


def test_a_damaged_progress_file_is_reported(tmp_path: Path) -> None:
    study = start_study(write_protocol(tmp_path), tmp_path / "s")
    for content in ("", "[1]", '{"steps": {"a": {"state": "x", "tries": []}}}'):
        (study.folder / "sub-P01").mkdir(exist_ok=True)
        (study.folder / "sub-P01" / "progress.json").write_text(content)
        with raises(FileError, "study.progress_damaged"):
            study.progress("P01")
    with raises(FileError, "study.no_participant"):
        study.progress("P99")


def test_commands(
    done: Progress, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    protocol = write_protocol(tmp_path)
    assert main(["study", "check", str(protocol), "--json", "steps.json"]) == 0
    assert "2 participants, 2 trials each, 1 practice trials" in capsys.readouterr().out
    steps = json.loads(Path("steps.json").read_text())["participants"]["P02"]["steps"]
    assert [s["kind"] for s in steps].count("trial") == 2
    assert main(["study", "status", str(done.root.parent)]) == 0
    out = capsys.readouterr().out
    assert "P01: 2 of 2 trials accepted; finished" in out and "P02: 2 of 2" in out
    assert main(["study", "status", str(done.root.parent), "--json", "-"]) == 0
    found = json.loads(capsys.readouterr().out)["participants"]
    assert found["P01"]["next"] is None and found["P01"]["accepted"] == 2
    with pytest.raises(SystemExit) as stopped:
        main(["study", "run", str(protocol), "--headless"])
    assert stopped.value.code == 2
    assert {p.name for p in Path().iterdir()} == {"protocol.toml", "steps.json"}
