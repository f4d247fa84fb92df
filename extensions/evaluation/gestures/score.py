"""Scores gesture recognition: simulated people hold each gesture on request, then move freely.

Labels are the requested gestures, not those recognised in the true hand. A gesture that is detected
in free motion is false unless the true hand shows it as well.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tracker.engine.pipeline import Pipeline
from tracker.geometry import so3
from tracker.gestures.recogniser import GestureRecogniser, Phase
from tracker.gestures.shape import ShapeReader
from tracker.gestures.values import BEGINS_AT, ENDS_AT, GESTURES, GestureParams, values
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, Estimate, Event, ImuSample, Message, Tracking, Validity
from tracker.simulation.guided import GuidedPoses, HeldPose, with_events
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, Truth
from tracker.simulation.wearer import Wearer

SHOWN_BY = {"flat": "open_palm", "spread": "open_palm"}
"""The gesture of a guided pose with a different name."""
JUDGED_FROM = 0.2  # s after the pose is reached
STEP = 0.01  # s


class Held(NamedTuple):
    """A held gesture: the share of time in which only it was detected; the delay in s from the
    first instant at which the true hand's value exceeds the threshold (it must last `WAIT`); NaN if
    it was not detected."""

    gesture: str
    right: float
    delay: float


@dataclass
class GestureScore:
    """Score of one wearer."""

    held: list[Held] = field(default_factory=list)
    false_starts: Counter[str] = field(default_factory=Counter)
    free_time: float = 0.0  # s

    @property
    def false_per_minute(self) -> float:
        return 60 * self.false_starts.total() / max(self.free_time, 1e-9)


def score(
    seed: int, free: float = 60.0, on_truth: bool = False, glove_name: str = ""
) -> GestureScore:
    """Score one simulated wearer, including ``free`` s of free motion.

    ``on_truth``: use the true hand, which shows the errors of the rules alone.
    """
    hand, glove = library.load(glove_name or library.DEFAULT_GLOVE)
    wearer = Wearer.random(hand, glove, seed)
    motion = GuidedPoses(wearer, RandomPostures(hand, seed, duration=free), seed)
    simulation = Simulation(hand, glove, motion, seed)
    true, names = true_hand(simulation), glove.keypoint_names(hand)
    estimates = true if on_truth else tracked(simulation)
    recogniser = GestureRecogniser(hand, names)
    phases, shown = [], []
    for estimate in estimates:
        phases += recogniser.feed(estimate)
        shown.append(recogniser.active)
    t = np.array([e.t for e in estimates])
    truth = TrueValues(true, hand, names)
    out = GestureScore(free_time=simulation.duration - motion.free_from)
    for pose in motion.held:
        out.held.append(_judged(pose, t, shown, phases, truth))
    for phase in phases:
        if phase.begins and phase.t > motion.free_from and not truth.shows(phase.gesture, phase.t):
            out.false_starts[phase.gesture] += 1
    return out


def _judged(
    pose: HeldPose,
    t: Array,
    shown: list[tuple[str, ...]],
    phases: list[Phase],
    truth: TrueValues,
) -> Held:
    gesture = SHOWN_BY.get(pose.name, pose.name)
    during = np.flatnonzero((t >= pose.reached + JUDGED_FROM) & (t <= pose.left))
    right = float(np.mean([shown[i] == (gesture,) for i in during]))
    begins = [p.t for p in phases if p.begins and p.gesture == gesture]
    begins = [b for b in begins if pose.begin - 1.5 < b < pose.left]
    first = truth.first(gesture, pose.begin - 1.5, pose.left)
    return Held(gesture, right, begins[0] - first if begins else np.nan)


class TrueValues:
    """Gestures of the true hand in steps of `STEP` s."""

    def __init__(self, hand: Sequence[Estimate], model: HandModel, names: tuple[str, ...]) -> None:
        reader, params = ShapeReader(model, names), GestureParams()
        rows = [values(reader.read(estimate), params) for estimate in hand]
        self._values = {name: np.array([row[name] for row in rows]) for name in GESTURES}

    def _rows(self, gesture: str, t: Array) -> Array:
        values = self._values[gesture]
        return values[np.clip(np.round(t / STEP).astype(int), 0, len(values) - 1)]

    def shows(self, gesture: str, t: float) -> bool:
        """Whether the gesture is shown or was shown in the last tenth of a second."""
        return bool((self._rows(gesture, t - np.array([0.0, 0.05, 0.1])) >= ENDS_AT).any())

    def first(self, gesture: str, start: float, stop: float) -> float:
        """First time at which the true hand's value exceeds the threshold; NaN if it never does."""
        instants = np.arange(start, stop, STEP)
        begun = instants[self._rows(gesture, instants) > BEGINS_AT]
        return float(begun[0]) if len(begun) else float("nan")


def tracked(simulation: Simulation, end: float = np.inf) -> list[Estimate]:
    """Estimates of a simulated hand up to ``end`` s; the tracker receives the guided poses."""
    pipeline = Pipeline(simulation.hand, simulation.glove, simulation.rig)
    messages: Iterable[Message] = simulation.feed()
    if isinstance(simulation.motion, GuidedPoses):
        messages = with_events(simulation.feed(), simulation.motion.events)
    out = []
    for message in messages:
        if message.t >= end:
            break
        if isinstance(message, ImuSample):
            out.append(pipeline.feed_imu(message))
        elif isinstance(message, Event):
            pipeline.feed_event(message)
        else:
            pipeline.feed_frame(message)  # type: ignore[arg-type]
    return out


def true_hand(simulation: Simulation) -> list[Estimate]:
    """The true hand at 100 Hz."""
    t = np.arange(0.0, simulation.duration - 0.02, STEP)
    truths = simulation.truths(t)
    return [
        as_estimate(float(s), true, simulation.hand, simulation.glove)
        for s, true in zip(t, truths, strict=True)
    ]


def phases_of(
    estimates: Sequence[Estimate], hand: HandModel, names: tuple[str, ...]
) -> list[Phase]:
    """Beginnings and ends of gestures in estimates."""
    recogniser = GestureRecogniser(hand, names)
    return [phase for estimate in estimates for phase in recogniser.feed(estimate)]


def as_estimate(t: float, true: Truth, hand: HandModel, glove: GloveModel) -> Estimate:
    """The truth as an estimate without error."""
    keypoints, joints = len(true.keypoints), len(true.angles)
    segments = list(hand.keypoint_segment)
    segments += [hand.root] * (keypoints - len(segments))
    return Estimate(
        t=t,
        tracking=Tracking.TRACKING,
        keypoints=true.keypoints.copy(),
        keypoint_q=so3.quat_from_matrix(true.R_GB)[segments],
        keypoint_state=np.full(keypoints, int(Validity.MEASURED), np.int64),
        keypoint_sd=np.full(keypoints, 1e-3),
        angles=true.angles.copy(),
        angle_state=np.full(joints, int(Validity.MEASURED), np.int64),
        segment_R=true.R_GB.copy(),
        segment_p=true.p_GB.copy(),
    )
