"""Runs a study's trials with simulated participants, without a screen."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from extensions.study.conductor import Conductor, TrialPhase
from extensions.study.progress import Progress, locked
from extensions.study.protocol import Protocol
from extensions.study.schedule import ScheduleStep
from extensions.study.simulated import SimulatedStation
from extensions.study.verdict import TrialVerdict, judge

TICK = 0.1  # s of simulated time
Say = Callable[[str], None]


def run_headless(progress: Progress, say: Say = lambda line: None) -> None:
    """Run the remaining steps of one participant.

    A trial without a good verdict is repeated, up to the protocol's number of tries. Rests are
    skipped. ``say`` gets a line for each event. Raises FileError if another program runs the
    participant.
    """
    with locked(progress):
        for step in progress.resume():
            say(f"{step.name}: was interrupted; it is repeated")
        Run(progress, say).run()


class Run:
    """The loop around a `Conductor`."""

    def __init__(self, progress: Progress, say: Say) -> None:
        self._progress, self._say = progress, say
        self._protocol: Protocol = progress.protocol
        self._station = SimulatedStation(self._protocol)
        self._conductor = Conductor(progress, self._station)
        self._t = 0.0

    def run(self) -> None:
        """Until the last step is over."""
        conductor = self._conductor
        while (step := conductor.step) is not None:
            match conductor.phase:
                case TrialPhase.READY:
                    self._get_ready(step)
                case TrialPhase.COUNTDOWN | TrialPhase.RUNNING:
                    self._move(step)
                case TrialPhase.CHECKING:
                    self._check(step)
                case TrialPhase.VERDICT:
                    self._decide(step)
                case _:
                    conductor.go_on(self._t)

    def _get_ready(self, step: ScheduleStep) -> None:
        self._station.prepare(step, self._conductor.progress.tries)
        self._t = 0.0
        self._conductor.go_on(self._t)

    def _move(self, step: ScheduleStep) -> None:
        self._t = round(self._t + TICK, 6)
        self._station.advance(self._t)
        conductor = self._conductor
        running = conductor.phase is TrialPhase.RUNNING and step.duration == 0
        if running and conductor.elapsed >= self._station.finishes_after(step):
            conductor.go_on(self._t)
        else:
            conductor.tick(self._t)

    def _check(self, step: ScheduleStep) -> None:
        self._conductor.recorded()
        path, limits = self._progress.path(step), self._protocol.limits
        if self._protocol.tasks[step.task].kind == "touch":  # simulated: estimates alone
            limits = replace(limits, packet_rate=0.0, image_rate=0.0, images_missed=1.0)
        self._conductor.judged(judge(path, step, limits))

    def _decide(self, step: ScheduleStep) -> None:
        conductor, verdict = self._conductor, self._conductor.verdict
        assert verdict is not None
        if verdict.is_good:
            self._say(f"{step.name}: accepted ({summary(verdict)})")
            conductor.go_on(self._t)
        elif conductor.progress.tries < self._protocol.tries:
            self._say(f"{step.name}: repeated. {_why(verdict)}")
            conductor.repeat(self._t)
        else:
            self._say(f"{step.name}: failed. {_why(verdict)}")
            conductor.give_up()


def summary(verdict: TrialVerdict) -> str:
    """Figures of a recording in a few words."""
    m = verdict.measured
    return (
        f"{m.duration:.1f} s, tracked {100 * m.tracked:.0f} %, measured {100 * m.measured:.0f} %, "
        f"{m.packets_lost} packets lost"
    )


def _why(verdict: TrialVerdict) -> str:
    return " ".join(str(finding) for finding in verdict.findings)
