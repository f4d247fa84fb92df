"""Reads takes from sessions, records and the simulator, and judges them."""

from __future__ import annotations

import struct
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from heapq import merge
from pathlib import Path
from typing import NamedTuple

import numpy as np
from mcap.exceptions import McapError
from mcap.reader import make_reader

from extensions.conformance.finding import FAIL, UNKNOWN, LayerJudge, RuleFinding
from extensions.conformance.isaac.record import HandRecord, Stamps, decode, joints_of
from extensions.conformance.isaac.schema import NAME
from extensions.conformance.isaac.writer import IsaacWriter
from extensions.conformance.placement import judge_placement
from extensions.conformance.shape import judge_shape, judge_steps
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
from tracker.base.files import check_regular
from tracker.base.notices import notice
from tracker.hand.names import SIDES
from tracker.hand.openxr import OpenXrHand, joint_radii, openxr_joints
from tracker.messages import Array, CameraPose, Event, ImuSample, IntArray, Message
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, build
from tracker.offline.track import track
from tracker.session.export.load import load_series
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import topics
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


# ---- rules on the signal: finite values, ordered time stamps, no gaps, no jumps

UNIT = 1e-3  # tolerance of a quaternion's norm
PRESENT = 0.95  # share of records with a hand
IRREGULAR = 0.2  # median deviation of the interval relative to its median
GAP = 5.0  # periods
FASTEST = 20.0  # m/s
SHORTEST = 0.004  # s: shorter intervals reflect the clock, not the hand


def judge_signal(take: RecordTake) -> list[RuleFinding]:
    judge = LayerJudge("signal", take)
    _numbers(take, judge)
    _stamps(take, judge)
    _speed(take, judge)
    return judge.found


def _numbers(take: RecordTake, judge: LayerJudge) -> None:
    values = np.concatenate([take.position, take.orientation], axis=2)[take.valid]
    bad = int((~np.isfinite(values)).any(axis=1).sum()) if len(values) else 0
    judge.say("finite", None if not len(values) else bad == 0, f"{bad} joints not finite", "0")
    length = np.linalg.norm(take.orientation[take.valid], axis=1)
    off = float(np.nanmax(np.abs(length - 1))) if len(length) else np.nan
    ok = None if not len(length) else off <= UNIT
    judge.say("unit quaternions", ok, f"{off:.1e} off 1", f"≤ {UNIT:g}")
    share = float(take.active.mean()) if len(take) else 0.0
    judge.say("a hand in the records", share >= PRESENT, f"{share:.1%}", f"≥ {PRESENT:.0%}")


def _stamps(take: RecordTake, judge: LayerJudge) -> None:
    steps = np.diff(take.sample)
    back = int((steps <= 0).sum() + (np.diff(take.available) < 0).sum())
    judge.say("stamps rise", None if len(take) < 2 else back == 0, f"{back} go back", "0")
    early = int((take.available < take.sample).sum())
    judge.say("available after sampled", early == 0, f"{early} before", "0")
    forward = steps[steps > 0] / NS
    if len(forward) < 10:
        judge.say("regular intervals", None, f"{len(forward)} intervals", f"≤ {IRREGULAR:g}")
        judge.say("no gaps", None, f"{len(forward)} intervals", f"≤ {GAP:g} periods")
        return
    period = float(np.median(forward))
    deviation = float(np.median(np.abs(forward - period))) / period
    plot = (forward * 1e3, "ms", (period * 1e3 * GAP,))
    figure = f"{deviation:.3f} of {period * 1e3:.1f} ms"
    judge.say("regular intervals", deviation <= IRREGULAR, figure, f"≤ {IRREGULAR:g}")
    longest = float(forward.max()) / period
    judge.say("no gaps", longest <= GAP, f"{longest:.1f} periods", f"≤ {GAP:g} periods", plot)


def _speed(take: RecordTake, judge: LayerJudge) -> None:
    dt = np.diff(take.sample) / NS
    steps = np.linalg.norm(np.diff(take.position, axis=0), axis=2)
    speed = np.where((dt >= SHORTEST)[:, None], steps / np.maximum(dt, SHORTEST)[:, None], np.nan)
    known = np.isfinite(speed).any(axis=1)
    most = np.full(len(speed), np.nan)
    most[known] = np.nanmax(speed[known], axis=1)
    top = float(np.nanmax(most)) if known.any() else np.nan
    ok = None if not known.any() else top <= FASTEST
    judge.say("joint speed", ok, f"{top:.1f} m/s", f"≤ {FASTEST:g} m/s", (most, "m/s", (FASTEST,)))


# ---- reads records from files of this or other programs


def read_records(path: Path) -> Iterator[tuple[str, HandRecord]]:
    """Yields (side, record) in the order of log times. Raises FileError for other files."""
    try:
        check_regular(Path(path))
        with Path(path).open("rb") as file:
            for schema, channel, message in make_reader(file).iter_messages():
                leaf = channel.topic.rsplit("/", 1)[-1]
                side = next((s for s in SIDES if leaf.startswith(s)), None)
                if side is not None and schema is not None and schema.name == NAME:
                    yield side, decode(message.data)
    except (McapError, struct.error, EOFError) as error:
        raise FileError(notice("isaac.not_mcap", path=path)) from error
    except OSError as error:
        raise FileError(notice("file.not_readable", path=path, why=error.strerror)) from error


# ---- exports a session as a hand record of NVIDIA's Isaac tools (`extensions.conformance.isaac`)


class ArrivalTimes(NamedTuple):
    """Times (N,) ns since 1970 at which estimates were available, and times on the glove's
    clock."""

    available_ns: IntArray
    device_ns: IntArray


def export_isaac(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write both hands to one file; returns the estimates of the main one."""
    hands: dict[str, tuple[EstimateSeries, ArrivalTimes]] = {}
    for one in readers_of_hands(reader):
        with one:
            m = load_series(one, options)
            hands[m.info.side] = (m, arrivals(one, m))
    with path.open("wb") as file:
        write_hands(IsaacWriter(file), hands)
    return hands[reader.info.side][0]


def readers_of_hands(reader: SessionReader) -> Iterator[SessionReader]:
    """A reader of the session per hand, left first; the caller closes them."""
    for side in reader.sides or ("",):
        yield SessionReader(reader.path, side=side)


def write_hands(
    writer: IsaacWriter, hands: Mapping[str, tuple[EstimateSeries, ArrivalTimes]]
) -> None:
    """Write one series per side, in G, in the order of available times."""
    streams = [hand_records(side, *given) for side, given in hands.items()]
    for _, side, record in merge(*streams, key=lambda item: item[0]):
        writer.write(side, record)
    writer.finish()


def hand_records(
    side: str, m: EstimateSeries, arrivals: ArrivalTimes
) -> Iterator[tuple[int, str, HandRecord]]:
    """Yields (available time in ns, side, record) in order for a series in G."""
    to_monotonic = m.info.anchor.monotonic_ns - m.info.anchor.wall_ns + m.zero_ns
    radii = joint_radii(m.info.hand)
    hand = openxr_joints(m.keypoints, m.q, m.state, m.keypoint_names, radii)
    sample = m.stamp_ns + to_monotonic
    available = np.maximum.accumulate(np.maximum(arrivals.available_ns + to_monotonic, sample))
    for i in range(len(m)):
        one = OpenXrHand(
            np.nan, hand.position[i], hand.orientation[i], hand.state[i], hand.radius[i]
        )
        stamps = Stamps(int(available[i]), int(sample[i]), int(arrivals.device_ns[i]))
        yield stamps.available, side, HandRecord(stamps, joints_of(one))


def arrivals(reader: SessionReader, m: EstimateSeries) -> ArrivalTimes:
    """Arrival times from the log times of a session's keypoints and the glove's packets.

    Times of estimates between recorded ones are interpolated; without a glove clock the sample time
    is used.
    """
    topic = frozenset([topics.hand(m.info.side, "keypoints")])
    found = [(r.publish_time, r.log_time) for r in ordered(reader.source, topic)]
    stamp, log = np.array(sorted(found), np.int64).reshape(-1, 2).T
    at = m.stamp_ns + m.zero_ns
    delay = np.interp(at - stamp[0], stamp - stamp[0], (log - stamp).astype(float))
    available = m.stamp_ns + np.maximum(np.round(delay), 0).astype(np.int64)
    return ArrivalTimes(available, _device_ns(reader, m, at))


def _device_ns(reader: SessionReader, m: EstimateSeries, at: IntArray) -> IntArray:
    """The instants ``at`` (N,) ns since 1970 on the glove's clock, ns."""
    packets = [s for s in reader.messages([ImuSample]) if isinstance(s, ImuSample)]
    t = np.array([s.t for s in packets])
    device = np.array([s.t_device for s in packets])
    known = np.isfinite(device)
    seconds: Array = (at - m.info.anchor.wall_ns + m.info.anchor.monotonic_ns) / NS
    if not known.any():
        return np.asarray(np.round(seconds * NS), np.int64)
    order = np.argsort(t[known])
    return np.asarray(
        np.round(np.interp(seconds, t[known][order], device[known][order]) * NS), np.int64
    )
