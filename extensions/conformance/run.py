"""Reads takes from sessions, records and the simulator, and judges them."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from extensions.conformance.export import arrivals, hand_records, readers_of_hands
from extensions.conformance.finding import FAIL, UNKNOWN, RuleFinding
from extensions.conformance.isaac.reader import read_records
from extensions.conformance.isaac.record import HandRecord
from extensions.conformance.placement import judge_placement
from extensions.conformance.shape import judge_shape
from extensions.conformance.signal import judge_signal
from extensions.conformance.steps import judge_steps
from extensions.conformance.take import (
    BEAT,
    BEATS,
    GRASPS,
    SCRIPT,
    RecordTake,
    ScriptStep,
    labels_path,
    read_labels,
    take_of,
)
from tracker.base.clock import NS
from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice
from tracker.hand.names import SIDES
from tracker.messages import CameraPose, Event, Message
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, build
from tracker.offline.track import track
from tracker.session.export.series import recorded_series
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, new_session
from tracker.simulation.demo import TABLE
from tracker.simulation.gestures import GestureCue, Gestures
from tracker.simulation.scenario import Simulation
from tracker.simulation.wearer import Wearer
from tracker.vision.rig import default_pose, ideal_rig

GLOVES = {"right": "vist-small", "left": "vist-small-left"}
WARM_UP = (GestureCue("fist", 1.5, 1.0), GestureCue("open", 1.0, 1.0)) * 2
"""Shown before the first step, while the hand size is estimated."""


@dataclass(frozen=True, eq=False)
class TakeVerdict:
    """Findings on the hands of a take. ``ok``: all rules except advice passed."""

    name: str
    findings: tuple[RuleFinding, ...]
    takes: tuple[RecordTake, ...]
    steps: tuple[ScriptStep, ...]

    @property
    def ok(self) -> bool:
        bad = (FAIL, UNKNOWN)
        return not any(f.status in bad and not f.advice for f in self.findings)


def judge(name: str, takes: Sequence[RecordTake], steps: Sequence[ScriptStep]) -> TakeVerdict:
    """Apply all rules to all hands. Raises FileError without records."""
    if not takes or not any(len(take) for take in takes):
        raise FileError(notice("conformance.no_records", name=name))
    findings: list[RuleFinding] = []
    with np.errstate(invalid="ignore", divide="ignore"):
        for take in takes:
            findings += judge_signal(take)
            findings += judge_shape(take)
            findings += judge_placement(take, steps)
            findings += judge_steps(take, steps)
    return TakeVerdict(name, tuple(findings), tuple(takes), tuple(steps))


def read_take(path: Path, sides: Sequence[str] = ()) -> tuple[list[RecordTake], list[ScriptStep]]:
    """The hands of a session or of an Isaac record, and its steps.

    Steps are read from ``TAKE.labels.json`` next to it, or are notes of the session with the names
    of steps, each starting at its note. Raises FileError.
    """
    with SessionReader(path) as reader:
        if reader.metadata:
            records = session_records(reader)
            steps = read_labels(labels_path(path)) or noted_steps(reader)
        else:
            records = {side: [] for side in SIDES}
            for side, record in read_records(path):
                records[side].append(record)
            steps = read_labels(labels_path(path))
    takes = [take_of(side, found) for side, found in records.items() if found]
    missing = [s for s in sides if s not in {take.side for take in takes}]
    if missing:
        raise FileError(notice("conformance.no_hand", path=path, sides=missing))
    return [take for take in takes if not sides or take.side in sides], steps


def session_records(reader: SessionReader) -> dict[str, list[HandRecord]]:
    """The records, by hand, that an export of the session would write."""
    found = {}
    for one in readers_of_hands(reader):
        with one:
            m = recorded_series(one, segments=False)
            records = hand_records(m.info.side, m, arrivals(one, m))
            found[m.info.side] = [record for _, _, record in records]
    return found


def noted_steps(reader: SessionReader) -> list[ScriptStep]:
    """Windows of the script, each starting at a note with the step's name."""
    notes = [m for m in reader.messages([Event]) if isinstance(m, Event)]
    found = [(m.text.strip(), round(m.t * NS)) for m in notes if m.text.strip() in SCRIPT]
    return [ScriptStep(label, at, at + round(SCRIPT[label] * NS)) for label, at in found]


def cues(side: str) -> tuple[list[GestureCue], list[str]]:
    """Cues of a simulated wearer of one glove, and the step of each cue ("" for none)."""
    out, labels = list(WARM_UP), [""] * len(WARM_UP)
    for label, hold in SCRIPT.items():
        gesture = {"open_hand_open": "open", "open_hand_close": "open", "wrist_rotate": "turn"}
        shown = gesture.get(label, label)
        if label in GRASPS:
            shown = "fist" if GRASPS[label] == side else "grip"
        out.append(GestureCue(shown, BEATS * BEAT, hold))
        labels.append(label)
    return out, labels


Change = Callable[[Message], Message]


def simulated(
    side: str,
    seed: int = 1,
    glove: str = "",
    progress: Callable[[float], None] = lambda share: None,
    change: Change = lambda message: message,
) -> tuple[list[HandRecord], list[ScriptStep]]:
    """Records of a simulated wearer who performs the script, tracked like a session, and the steps.

    ``change`` modifies the sensor data. Raises ConfigError for a glove of the other side.
    """
    options = SimulateOptions(glove=glove or GLOVES[side], seed=seed, images=False)
    _, info = build(options)
    if info.side != side:
        raise ConfigError(notice("conformance.glove_side", glove=options.glove, side=info.side))
    stand = default_pose()
    camera = CameraPose(stand.R_GC, stand.p_GC + np.array([0.0, 0.0, TABLE]))
    shown, labels = cues(side)
    motion = Gestures(info.hand, shown, seed, camera, Wearer.random(info.hand, info.glove, seed))
    sim = Simulation(info.hand, info.glove, motion, seed, rig=ideal_rig(pose=camera))
    info = replace(info, rig=sim.rig)
    with tempfile.TemporaryDirectory(prefix="glovetrack-") as folder:
        raw, tracked = Path(folder) / "raw.mcap", Path(folder) / "tracked.mcap"
        params = RecorderParams(images="none", sync=False)
        with new_session(raw, info, params=params) as recorder:
            for message in sim.messages():
                recorder.write(change(message))
        track(raw, tracked, TrackOptions(), progress)
        with SessionReader(tracked) as reader:
            records = session_records(reader)[side]
    zero = info.anchor.monotonic_ns
    steps = [
        ScriptStep(label, zero + round(start * NS), zero + round((start + cue.hold) * NS))
        for cue, label, start in zip(shown, labels, motion.starts, strict=True)
        if label
    ]
    return records, steps


def simulated_takes(
    sides: Sequence[str], seed: int, glove: str, progress: Callable[[float], None]
) -> tuple[Mapping[str, list[HandRecord]], list[ScriptStep]]:
    """Takes of one or both hands on one clock, showing the same step at the same time."""
    records: dict[str, list[HandRecord]] = {}
    steps: list[ScriptStep] = []
    for k, side in enumerate(sides):
        records[side], steps = simulated(
            side,
            seed + k,
            glove,
            lambda share, k=k: progress((k + share) / len(sides)),  # type: ignore[misc]
        )
    return records, steps
