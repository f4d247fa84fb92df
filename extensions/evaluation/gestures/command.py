"""``glovetrack evaluate gestures``.

Recordings of human motion have no labels, so the gestures recognised in the recorded hand itself
serve as labels. The score states how many of them are recognised after tracking through simulated
sensors, with which delay, and how many additional gestures are recognised.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from extensions.evaluation.commands import EvaluateGesturesArguments
from tracker.base.terminal import check_json, finish, progress_line
from tracker.engine.pipeline import Pipeline
from tracker.geometry import so3
from tracker.gestures.recogniser import GestureRecogniser, Phase
from tracker.gestures.shape import ShapeReader
from tracker.gestures.values import BEGINS_AT, ENDS_AT, GESTURES, GestureParams, values
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, Estimate, Event, ImuSample, Message, Tracking, Validity
from tracker.offline.simulate import SimulateOptions, build
from tracker.simulation.guided import GuidedPoses, HeldPose, with_events
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, Truth
from tracker.simulation.wearer import Wearer


def evaluate_gestures(args: EvaluateGesturesArguments) -> int:
    """Score gesture recognition and print the result."""
    check_json(args, args.motion)
    if args.motion:
        return _evaluate_recorded(args)
    watch = progress_line("evaluating")
    scores = []
    for i in range(args.people):
        scores.append(score(args.seed + i, args.seconds, args.on_truth, args.glove))
        watch((i + 1) / args.people)
    report = _report(scores)
    finish(args, report, _lines(report), [])
    return 0


def _evaluate_recorded(args: EvaluateGesturesArguments) -> int:
    watch = progress_line("evaluating")
    scores = []
    for i, path in enumerate(args.motion):
        scores.append(score_recorded(path, args.seed + i, args.seconds, args.glove))
        watch((i + 1) / len(args.motion))
    found = [*scores, together(scores)] if len(scores) > 1 else scores
    finish(args, {"recordings": [s.to_json() for s in found]}, [s.line() for s in found], [])
    return 0


def _report(scores: list[GestureScore]) -> dict[str, Any]:
    by_name: dict[str, list[Held]] = defaultdict(list)
    for one in scores:
        for pose in one.held:
            by_name[pose.gesture].append(pose)
    rows = {}
    for name, held in by_name.items():
        delays = [h.delay for h in held if np.isfinite(h.delay)]
        rows[name] = {
            "held": len(held),
            "right_percent": 100 * float(np.mean([h.right for h in held])),
            "reported_in_time": len(delays),
            "delay_ms": 1e3 * float(np.median(delays)) if delays else None,
        }
    minutes = sum(one.free_time for one in scores) / 60
    false = {n: sum(s.false_starts[n] for s in scores) for s in scores for n in s.false_starts}
    total = sum(false.values())
    return {"gestures": rows, "false_per_minute": total / max(minutes, 1e-9), "false": false}


def _lines(report: dict[str, Any]) -> list[str]:
    lines = [f"{'gesture':<14}{'held':>5}{'right %':>9}{'delay ms':>10}"]
    for name, row in report["gestures"].items():
        delay = "-" if row["delay_ms"] is None else f"{row['delay_ms']:.0f}"
        lines.append(f"{name:<14}{row['held']:>5}{row['right_percent']:>9.1f}{delay:>10}")
    false = ", ".join(f"{n} {k}" for n, k in report["false"].items()) or "none"
    lines.append(
        f"false detections per minute of free motion: {report['false_per_minute']:.2f} ({false})"
    )
    return lines


EARLY, LATE = 0.15, 0.6  # s before and after a true beginning in which a detection counts
LASTS = 0.15  # s: shorter gestures are transitions, not labels
SETTLING = 1.0  # s from the first image, while tracking starts


@dataclass
class RecordedScore:
    """Score of one or several recordings: gestures of the hand, detected ones with their delays
    (s), and false detections, in ``seconds`` of motion."""

    name: str
    seconds: float = 0.0
    shown: Counter[str] = field(default_factory=Counter)
    detected: Counter[str] = field(default_factory=Counter)
    false: Counter[str] = field(default_factory=Counter)
    delays: list[float] = field(default_factory=list)

    def to_json(self) -> dict[str, Any]:
        delays = 1e3 * np.array(self.delays)
        return {
            "name": self.name,
            "seconds": self.seconds,
            "shown": dict(self.shown),
            "reported": dict(self.detected),
            "false": dict(self.false),
            "false_per_minute": 60 * self.false.total() / max(self.seconds, 1e-9),
            "delay_ms_median": float(np.median(delays)) if len(delays) else None,
            "delay_ms_90": float(np.percentile(delays, 90)) if len(delays) else None,
        }

    def line(self) -> str:
        """One line of text."""
        data = self.to_json()
        delay = data["delay_ms_median"]
        late = "" if delay is None else f", {delay:.0f} ms late (90 %: {data['delay_ms_90']:.0f})"
        false = ", ".join(f"{n} {k}" for n, k in self.false.items()) or "none"
        shown = ", ".join(f"{n} {self.detected[n]}/{k}" for n, k in self.shown.items()) or "none"
        return (
            f"{self.name}: {self.seconds:.0f} s, detected {shown}{late}; false {false} "
            f"({data['false_per_minute']:.2f} a minute)"
        )


def score_recorded(path: Path, seed: int, most: float, glove: str = "") -> RecordedScore:
    """Score the first ``most`` s of a recording with a simulated wearer. Raises FileError."""
    options = SimulateOptions(glove=glove, motion=str(path), seed=seed, images=False)
    simulation, _ = build(options)
    end = min(most, simulation.duration - 0.05)
    hand, glove_model = simulation.hand, simulation.glove
    names = glove_model.keypoint_names(hand)
    true = [e for e in true_hand(simulation) if e.t < end]
    wanted = phases_of(true, hand, names)
    found = phases_of(tracked(simulation, end), hand, names)
    truth = TrueValues(true, hand, names)
    out = RecordedScore(path.stem, seconds=max(end - SETTLING, 0.0))
    for phase in _lasting(wanted, end):
        if phase.t < SETTLING:
            continue
        out.shown[phase.gesture] += 1
        delay = _delay(phase, found)
        if delay is not None:
            out.detected[phase.gesture] += 1
            out.delays.append(delay)
    for phase in found:
        if phase.begins and phase.t >= SETTLING and not truth.shows(phase.gesture, phase.t):
            out.false[phase.gesture] += 1
    return out


def together(scores: Sequence[RecordedScore]) -> RecordedScore:
    """The combined score."""
    out = RecordedScore("all")
    for one in scores:
        out.seconds += one.seconds
        out.shown += one.shown
        out.detected += one.detected
        out.false += one.false
        out.delays += one.delays
    return out


def _lasting(phases: Sequence[Phase], end: float) -> list[Phase]:
    """Beginnings of gestures that last at least `LASTS`."""
    out = []
    for i, phase in enumerate(phases):
        if phase.begins:
            ends = (p.t for p in phases[i + 1 :] if p.gesture == phase.gesture and not p.begins)
            if next(ends, end) - phase.t >= LASTS:
                out.append(phase)
    return out


def _delay(phase: Phase, found: Sequence[Phase]) -> float | None:
    """Delay in s from the true beginning to the detection; 0 if the gesture is already detected,
    None if it is not detected."""
    same = [p for p in found if p.gesture == phase.gesture]
    near = [p.t - phase.t for p in same if p.begins and -EARLY <= p.t - phase.t <= LATE]
    if near:
        return min(near, key=abs)
    before = [p for p in same if p.t < phase.t - EARLY]
    return 0.0 if before and before[-1].begins else None


# ---- scores gesture recognition: simulated people hold each gesture on request, then move freely
#
# Labels are the requested gestures, not those recognised in the true hand. A gesture that is
# detected in free motion is false unless the true hand shows it as well.

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
