"""The state machine that leads through the trials: pause, interruption, repetition, manual end."""

from __future__ import annotations

from pathlib import Path

import pytest

from extensions.study.conductor import Conductor, TrialPhase
from extensions.study.folder import start_study
from extensions.study.progress import ACCEPTED, DONE, FAILED, OPEN, Progress
from extensions.study.schedule import REST
from extensions.study.tests.studies import SHORT, write_protocol
from extensions.study.verdict import MeasuredRecording, TrialVerdict
from tracker.base.errors import DeviceError
from tracker.base.notices import warning

GOOD = TrialVerdict(MeasuredRecording(duration=6.0))
BAD = TrialVerdict(MeasuredRecording(), (warning("study.unfinished"),))


class FakeStation:
    """Writes the names of calls into the file."""

    def __init__(self) -> None:
        self.calls: list[str] = []
        self.refuses = False

    def begin(self, path: Path, step) -> None:
        if self.refuses:
            raise DeviceError("no glove")
        self.calls.append("begin")
        path.write_text("begun")

    def note(self, text: str, data) -> None:
        self.calls.append(text)

    def end(self) -> None:
        self.calls.append("end")

    def stamp(self) -> str:
        return "2026-01-01T00:00:00+00:00"


@pytest.fixture
def progress(tmp_path: Path) -> Progress:
    text = SHORT.replace("seed = 3", 'seed = 3\norder = "fixed"')
    return start_study(write_protocol(tmp_path, text), tmp_path / "s").progress("P01")


@pytest.fixture
def station() -> FakeStation:
    return FakeStation()


@pytest.fixture
def conductor(progress: Progress, station: FakeStation) -> Conductor:
    return Conductor(progress, station)


def run(conductor: Conductor, t: float, seconds: float) -> float:
    """Let time pass in steps of 50 ms."""
    for _ in range(round(seconds / 0.05)):
        t += 0.05
        conductor.tick(t)
    return t


def to_first_trial(conductor: Conductor) -> float:
    """Practice is over."""
    conductor.go_on(0.0)
    t = run(conductor, 0.0, 1.5 + 2.1)
    assert conductor.phase is TrialPhase.READY and conductor.step is not None
    return t


def test_practice_is_not_recorded(conductor: Conductor, station: FakeStation) -> None:
    assert conductor.phase is TrialPhase.READY
    conductor.go_on(0.0)
    assert conductor.phase is TrialPhase.COUNTDOWN and conductor.countdown_left == 1.5
    t = run(conductor, 0.0, 1.6)
    assert conductor.phase is TrialPhase.RUNNING and conductor.cue is not None
    first = conductor.progress.steps[0]
    run(conductor, t, 2.1)
    assert station.calls == [] and conductor.progress.entry(first).state == DONE


def test_a_trial_is_recorded_judged_and_accepted(
    conductor: Conductor, station: FakeStation
) -> None:
    t = to_first_trial(conductor)
    step = conductor.step
    assert step is not None
    conductor.go_on(t)
    t = run(conductor, t, 1.6)
    assert station.calls == ["begin", step.cues[0].what]
    assert conductor.next_cue_in == pytest.approx(2.0, abs=0.16)
    t = run(conductor, t, 6.1)
    assert conductor.phase is TrialPhase.CHECKING
    assert station.calls[1:] == [*(c.what for c in step.cues), "end"]
    conductor.recorded()
    conductor.judged(GOOD)
    assert conductor.phase is TrialPhase.VERDICT and conductor.verdict == GOOD
    conductor.go_on(t)
    assert conductor.progress.entry(step).state == ACCEPTED
    assert conductor.phase is TrialPhase.REST and conductor.rest_left == 10.0


def test_a_rest_ends_in_time_and_not_during_a_pause(conductor: Conductor) -> None:
    t = to_first_trial(conductor)
    conductor.go_on(t)
    t = run(conductor, t, 8.0)
    conductor.recorded()
    conductor.judged(GOOD)
    conductor.go_on(t)
    t = run(conductor, t, 4.0)
    assert conductor.rest_left == pytest.approx(6.0, abs=0.01)
    conductor.pause(t)
    t = run(conductor, t, 60.0)
    assert conductor.rest_left == pytest.approx(6.0, abs=0.01) and conductor.paused
    conductor.pause(t)
    t = run(conductor, t, 5.9)
    assert conductor.phase is TrialPhase.REST
    run(conductor, t, 0.2)
    assert conductor.phase is TrialPhase.READY and conductor.step is not None
    assert conductor.step.kind != REST


def test_a_pause_interrupts_a_trial_which_is_repeated(
    conductor: Conductor, station: FakeStation
) -> None:
    t = to_first_trial(conductor)
    step = conductor.step
    assert step is not None
    conductor.go_on(t)
    t = run(conductor, t, 3.0)
    conductor.pause(t)
    assert station.calls[-1] == "end" and conductor.phase is TrialPhase.CHECKING
    assert conductor.progress.path(step).is_file(), "it is still being written"
    conductor.recorded()
    assert conductor.phase is TrialPhase.READY and conductor.step == step
    entry = conductor.progress.entry(step)
    assert entry.state == OPEN and entry.tries[0].outcome == "interrupted"
    assert (conductor.progress.root / entry.tries[0].file).read_text() == "begun"
    conductor.go_on(t)
    assert conductor.phase is TrialPhase.READY, "paused"
    conductor.pause(t)
    conductor.go_on(t)
    assert conductor.phase is TrialPhase.COUNTDOWN and conductor.progress.tries == 0


def test_a_trial_can_be_repeated_or_excluded(conductor: Conductor) -> None:
    t = to_first_trial(conductor)
    step = conductor.step
    assert step is not None
    for attempt in (1, 2):
        conductor.go_on(t)
        t = run(conductor, t, 8.0)
        conductor.recorded()
        conductor.judged(BAD)
        assert conductor.progress.tries == attempt
        if attempt == 1:
            conductor.repeat(t)
            assert conductor.step == step and conductor.phase is TrialPhase.READY
    conductor.give_up()
    entry = conductor.progress.entry(step)
    assert entry.state == FAILED and [x.outcome for x in entry.tries] == ["repeated", "failed"]
    assert conductor.step != step


def test_a_timed_trial_is_ended_manually(conductor: Conductor, station: FakeStation) -> None:
    t = to_first_trial(conductor)
    conductor.go_on(t)
    t = run(conductor, t, 8.0)
    conductor.recorded()
    conductor.judged(GOOD)
    conductor.go_on(t)
    conductor.go_on(t)  # no rest
    step = conductor.step
    assert step is not None and step.task == "pegs"
    conductor.go_on(t)
    t = run(conductor, t, 5.0)
    assert conductor.phase is TrialPhase.RUNNING and conductor.elapsed == pytest.approx(
        3.5, abs=0.06
    )
    conductor.go_on(t)
    assert conductor.phase is TrialPhase.CHECKING and station.calls[-1] == "end"
    conductor.recorded()
    conductor.judged(GOOD)
    conductor.go_on(t)
    assert conductor.phase is TrialPhase.DONE and conductor.step is None


def test_a_trial_that_cannot_be_recorded_does_not_begin(
    conductor: Conductor, station: FakeStation
) -> None:
    t = to_first_trial(conductor)
    step = conductor.step
    assert step is not None
    station.refuses = True
    conductor.go_on(t)
    with pytest.raises(DeviceError):
        run(conductor, t, 1.6)
    assert conductor.phase is TrialPhase.READY and conductor.step == step
    entry = conductor.progress.entry(step)
    assert entry.state == OPEN and entry.tries == []
    station.refuses = False
    conductor.go_on(t + 2)
    run(conductor, t + 2, 1.6)
    assert conductor.phase is TrialPhase.RUNNING
