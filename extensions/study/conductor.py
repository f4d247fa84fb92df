"""Leads a participant through the steps: a state machine that has neither a clock nor a screen.

Its owner calls `Conductor.tick` with the time in s and shows what the properties say. A `Station`
records; its owner reports when a file is complete (`recorded`) and the verdict on it (`judged`).
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum
from pathlib import Path
from typing import Protocol as Interface

from extensions.study.progress import RECORDED, Progress
from extensions.study.schedule import PRACTICE, REST, TRIAL, Cue, ScheduleStep
from extensions.study.verdict import TrialVerdict


class TrialPhase(StrEnum):
    """``READY``: the instruction is shown until the experimenter continues; ``RUNNING``: cues;
    ``CHECKING``: the file is being completed and judged; ``VERDICT``: accept or repeat."""

    READY = "ready"
    COUNTDOWN = "countdown"
    RUNNING = "running"
    CHECKING = "checking"
    VERDICT = "verdict"
    REST = "rest"
    DONE = "done"


class Station(Interface):
    """What records the trials."""

    def begin(self, path: Path, step: ScheduleStep) -> None:
        """Begin a file. Raises GlovetrackError."""

    def note(self, text: str, data: Mapping[str, object]) -> None:
        """Write an event into the file."""

    def end(self) -> None:
        """End the file, which may take some time."""

    def stamp(self) -> str:
        """The present date and time, UTC (ISO 8601)."""


class Conductor:
    """The participant's remaining steps; interrupted trials have been opened again before."""

    def __init__(self, progress: Progress, station: Station) -> None:
        self.progress, self._station = progress, station
        self.phase = TrialPhase.READY
        self.verdict: TrialVerdict | None = None
        self.rest_left = 0.0  # s
        self.paused = False
        self._since = self._last = 0.0
        self._shown = 0  # cues so far
        self._interrupted = False
        self._enter()

    # ---- what to show

    @property
    def step(self) -> ScheduleStep | None:
        """The present step; None at the end."""
        return self.progress.step

    @property
    def cue(self) -> Cue | None:
        """What the participant is to do now."""
        step = self.step
        if self.phase is not TrialPhase.RUNNING or step is None or not self._shown:
            return None
        return step.cues[self._shown - 1]

    @property
    def next_cue_in(self) -> float:
        """s until the next cue, or the end of the trial; infinite if it is ended manually."""
        step = self.step
        if step is None or self.phase is not TrialPhase.RUNNING:
            return float("inf")
        if self._shown < len(step.cues):
            return max(step.cues[self._shown].t - self.elapsed, 0.0)
        return max(step.duration - self.elapsed, 0.0) if step.duration else float("inf")

    @property
    def elapsed(self) -> float:
        """s since the phase began."""
        return self._last - self._since

    @property
    def countdown_left(self) -> float:
        """s until the trial begins."""
        return max(self.progress.protocol.countdown - self.elapsed, 0.0)

    # ---- what the experimenter does

    def go_on(self, t: float) -> None:
        """Begin the trial, end one that has no fixed duration, accept it, or end a rest."""
        self._last = t
        match self.phase:
            case TrialPhase.READY if not self.paused:
                self._change(TrialPhase.COUNTDOWN, t)
                self.tick(t)
            case TrialPhase.RUNNING if self.step is not None and self.step.duration == 0:
                self._end_trial(t)
            case TrialPhase.VERDICT if self.step is not None:
                self.progress.accept(self.step)
                self._enter()
            case TrialPhase.REST:
                self._finish()

    def repeat(self, t: float) -> None:
        """Record the judged trial again."""
        if self.phase is TrialPhase.VERDICT and self.step is not None:
            self.progress.repeat(self.step)
            self._since = self._last = t
            self._enter()

    def give_up(self) -> None:
        """The judged trial counts as failed: its recording remains, and is not evaluated."""
        if self.phase is TrialPhase.VERDICT and self.step is not None:
            self.progress.accept(self.step, failed=True)
            self._enter()

    def pause(self, t: float) -> None:
        """Pauses or continues. A running trial is interrupted, and repeated after the pause; a rest
        does not count down meanwhile."""
        self._last = t
        self.paused = not self.paused
        if self.phase is TrialPhase.COUNTDOWN:
            self._change(TrialPhase.READY, t)
        elif self.phase is TrialPhase.RUNNING:
            self.interrupt(t)

    def interrupt(self, t: float) -> None:
        """Stop a running trial: its recording is superseded when it is complete."""
        step, self._last = self.step, t
        if step is None or self.phase is not TrialPhase.RUNNING:
            return
        self._change(TrialPhase.READY, t)
        if step.kind == TRIAL:
            self.phase, self._interrupted = TrialPhase.CHECKING, True
            self._station.end()

    # ---- time, and what the owner reports

    def tick(self, t: float) -> None:
        """Time is now ``t`` s."""
        passed, self._last = max(t - self._last, 0.0), t
        if self.phase is TrialPhase.COUNTDOWN and self.countdown_left <= 0:
            self._begin_trial(t)
        elif self.phase is TrialPhase.RUNNING:
            self._show_cues(t)
        elif self.phase is TrialPhase.REST and not self.paused:
            self.rest_left -= passed
            if self.rest_left <= 0:
                self._finish()

    def recorded(self) -> None:
        """The file of the trial is complete."""
        step, interrupted, self._interrupted = self.step, self._interrupted, False
        if self.phase is not TrialPhase.CHECKING or step is None:
            return
        if interrupted:
            self.progress.repeat(step, "interrupted")
            self._enter()
        else:
            self.progress.recorded(step)

    def judged(self, verdict: TrialVerdict) -> None:
        """The verdict on the trial's file."""
        if self.phase is TrialPhase.CHECKING and self.step is not None:
            self.progress.judged(self.step, verdict.as_json())
            self.verdict, self.phase = verdict, TrialPhase.VERDICT

    # ----

    def _enter(self) -> None:
        """Enter the first phase of the present step."""
        step, self.verdict, self._shown = self.step, None, 0
        self._since = self._last
        if step is None:
            self.phase = TrialPhase.DONE
        elif step.kind == REST:
            self.phase, self.rest_left = TrialPhase.REST, step.duration
        elif self.progress.entry(step).state == RECORDED:
            self.phase = TrialPhase.CHECKING  # the program ended before the decision
        else:
            self.phase = TrialPhase.READY

    def _change(self, phase: TrialPhase, t: float) -> None:
        self.phase, self._since, self._last, self._shown = phase, t, t, 0

    def _begin_trial(self, t: float) -> None:
        step = self.step
        assert step is not None
        if step.kind == TRIAL:
            self._change(TrialPhase.READY, t)  # in case the recording cannot begin
            path = self.progress.begin(step, self._station.stamp())
            try:
                self._station.begin(path, step)
            except BaseException:
                self.progress.withdraw(step)
                raise
        self._change(TrialPhase.RUNNING, t)
        self._show_cues(t)

    def _show_cues(self, t: float) -> None:
        step = self.step
        assert step is not None
        while self._shown < len(step.cues) and step.cues[self._shown].t <= self.elapsed + 1e-9:
            cue, self._shown = step.cues[self._shown], self._shown + 1
            if step.kind == TRIAL:
                self._station.note(
                    cue.what,
                    {"study_cue": self._shown, "trial": step.name},
                )
        task = self.progress.task
        assert task is not None
        if self.elapsed >= (step.duration or task.longest) and task.kind == "cues":
            self._end_trial(t)

    def _end_trial(self, t: float) -> None:
        if self.step is not None and self.step.kind == PRACTICE:
            self._finish()
            return
        self._change(TrialPhase.CHECKING, t)
        self._station.end()

    def _finish(self) -> None:
        """Finish a step without a recording."""
        assert self.step is not None
        self.progress.done(self.step)
        self._enter()
