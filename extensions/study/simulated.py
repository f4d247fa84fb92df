"""A simulated participant, tracked and recorded without devices, faster than in real time.

Each trial begins with the countdown, in which the hand is found. Files contain sensor data,
estimates and the truth.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from itertools import count
from pathlib import Path

from extensions.study.protocol import Protocol
from extensions.study.schedule import ScheduleStep, digest
from tracker.base.clock import ClockAnchor
from tracker.base.errors import ConfigError
from tracker.base.notices import failure
from tracker.engine.hands import Hands
from tracker.engine.kinds import settings_text
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove import library
from tracker.messages import BlobFrame, EngineState, Event, ImuSample
from tracker.offline.simulate import GLOVES
from tracker.offline.track_report import Counter, StatusClock
from tracker.session.description import SessionInfo, describe
from tracker.session.writer import SessionRecorder
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Message, Simulation, SimulationParams
from tracker.simulation.truth_recorder import TruthfulRecorder

EPOCH_NS = 1_735_689_600 * 10**9  # 2025-01-01, as other simulated sessions
FPS = 30.0  # as the simulated camera of the window
MARGIN = 2.0  # s of movement after the trial
PEOPLE = 2**31  # seeds


def write_touch_test(path: Path, seed: int) -> None:
    """A simulated wearer takes the touch test. Raises ConfigError without that extension."""
    try:
        # deferred: another extension
        from extensions.touch.simulated.session import write_session
        from extensions.touch.simulated.trial import SimulatedTrial
    except ModuleNotFoundError as error:
        raise ConfigError(failure("study.needs_extension", name="touch")) from error
    trial = SimulatedTrial(seed)
    estimates, calibration = trial.track()
    write_session(path, trial, estimates, calibration)


class SimulatedStation:
    """One hand of each participant of a protocol. `prepare` a step, then `advance` its time."""

    def __init__(self, protocol: Protocol) -> None:
        self._protocol = protocol
        side = protocol.hand if protocol.hand in GLOVES else "right"
        self._texts = library.texts(GLOVES[side])
        self._side, self._trials, self._is_touch = side, count(), False
        self._recorder: TruthfulRecorder | None = None
        self._feed: Iterator[Message] = iter(())
        self._waiting: Message | None = None

    def prepare(self, step: ScheduleStep, attempt: int) -> None:
        """The wearer gets ready for a trial; time starts from 0 again."""
        protocol = self._protocol
        task = protocol.tasks[step.task]
        self._is_touch = task.kind == "touch"
        if self._is_touch:
            self._now = 0.0
            self._feed, self._waiting = iter(()), None
            return
        lasts = protocol.countdown + (step.duration or task.longest) + MARGIN
        seed = digest(protocol.seed, step.name, str(attempt)) % PEOPLE
        person = digest(protocol.seed, "person", step.participant) % PEOPLE
        wall = EPOCH_NS + next(self._trials) * 3600 * 10**9
        self._info = self._described(step, wall)
        hand, glove = self._info.hand, self._info.glove
        motion = RandomPostures(hand, seed, period=task.cue_every, duration=lasts)
        params = SimulationParams(person=person)
        self._simulation = Simulation(hand, glove, motion, seed, params, FPS)
        rig = self._simulation.rig
        self._info = replace(self._info, rig=rig)
        settings = Settings()
        self._hands = Hands({self._side: partial(Pipeline, hand, glove, rig, settings)})
        self._feed, self._waiting = self._simulation.feed(), None
        self._now = 0.0
        self._counter, self._clock = Counter(), StatusClock()

    def finishes_after(self, step: ScheduleStep) -> float:
        """s after which the participant finishes a trial without a fixed duration."""
        task = self._protocol.tasks[step.task]
        if task.kind == "touch":
            return 0.0  # its file is complete at once
        longest = task.longest
        return longest * (0.3 + 0.4 * (digest(self._protocol.seed, "speed", step.name) / 2**64))

    def advance(self, t: float) -> None:
        """Feed and record all messages that arrive until ``t`` s."""
        self._now = t
        while True:
            message = self._waiting if self._waiting is not None else next(self._feed, None)
            self._waiting = None
            if message is None:
                return
            if message.t_arrival > t:
                self._waiting = message
                return
            self._take(message)

    # ---- a `Station`

    def begin(self, path: Path, step: ScheduleStep) -> None:
        """Begin a file with the engine's state; of a touch test, write it completely."""
        if self._is_touch:
            write_touch_test(path, digest(self._protocol.seed, step.name) % PEOPLE)
            return
        info = replace(self._info, anchor=self._info.anchor.at(self._now))
        duration = self._simulation.duration
        self._recorder = TruthfulRecorder(
            SessionRecorder(path, info), self._simulation, 0.0, duration
        )
        self._recorder.write(EngineState(self._now, "chain", self._hands.get_state()))
        self._counter, self._clock = Counter(), StatusClock()

    def note(self, text: str, data: Mapping[str, object]) -> None:
        """Write a note, stamped now."""
        if self._recorder is not None:
            self._recorder.write(Event(self._now, "note", text, dict(data)))

    def end(self) -> None:
        """Complete the file."""
        recorder, self._recorder = self._recorder, None
        if recorder is not None:
            recorder.write(self._pipeline.calibration())
            recorder.close()

    def stamp(self) -> str:
        """The real date: simulated time begins at 0 in each trial."""
        return datetime.now(UTC).isoformat(timespec="seconds")

    # ----

    @property
    def _pipeline(self) -> Pipeline:
        return self._hands.pipelines[self._side]

    def _described(self, step: ScheduleStep, wall_ns: int) -> SessionInfo:
        return describe(
            *self._texts,
            ClockAnchor(wall_ns, 0),
            colours_text=library.text("colours", library.DEFAULT_COLOURS),
            settings_text=settings_text(Settings()),
            participant=step.participant,
            notes=step.task,
            simulated=True,
        )

    def _take(self, message: Message) -> None:
        recorder = self._recorder
        if recorder is not None:
            recorder.write(message)
        if isinstance(message, ImuSample):
            estimate = self._hands.feed_imu(self._side, message)
            if recorder is not None:
                recorder.write(estimate)
                self._counter.count(message, estimate.tracking)
                status = self._clock.packet(message, estimate.tracking, self._counter.report)
                if status is not None:
                    recorder.write(status)
        elif isinstance(message, BlobFrame):
            self._hands.feed_frame(message)
            self._clock.frame(message)
        self._hands.take_results(self._side)
