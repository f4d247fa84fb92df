"""Verifies a session and reports its faults."""

from __future__ import annotations

import statistics
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from tracker.base.damage import DAMAGE, gather
from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, failure, notice, plain, warning
from tracker.messages import EYES, Validity
from tracker.session import description
from tracker.session.edits import NAME, lines, masks
from tracker.session.export.series import recorded_series
from tracker.session.mcap.check import index_damage
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap_session import MEASURED
from tracker.session.message_check import check_message
from tracker.session.reader import SessionReader
from tracker.session.ros import sensors, topics
from tracker.session.ros.cdr import CdrReader

_GAP_PERIODS = 3.5
_CLOCK_JUMP_NS = 500_000_000
MOST_NAMED = 5  # damaged messages of a topic
_COMPARED = 64  # messages of an IMU that are compared with the next one


@dataclass(frozen=True)
class FileFinding:
    """``severity``: error, warning or note; ``where``: a topic, a device, an attachment or an
    offset. ``silence``: total s without messages from a device, 0 for other findings.
    """

    severity: str
    what: Notice
    where: str
    silence: float = 0.0

    def to_json(self) -> dict[str, object]:
        return {
            "severity": self.severity, "what": str(self.what), "code": self.what.code,
            "where": self.where, "silence": self.silence,
        }  # fmt: skip


@dataclass
class _Track:
    """The state of one topic while its messages are read."""

    last_stamp: int | None = None
    last_delay: int = 0
    usual_delay: int = 0  # before messages began to arrive late
    steps: list[tuple[int, int]] = field(default_factory=list)  # ns, from this stamp
    backward: int = 0
    jumps: int = 0
    late: list[int] = field(default_factory=list)  # ns by which the delay increased at once
    log_times: list[int] = field(default_factory=list)
    damaged: list[int] = field(default_factory=list)  # log times
    repeated: int = 0
    recent: deque[bytes] = field(default_factory=lambda: deque(maxlen=_COMPARED))
    count: int = 0


def verify(path: Path, progress: Callable[[float], None] = lambda share: None) -> list[FileFinding]:
    """Returns all faults of a session. Raises FileError if it is not an MCAP.

    ``progress`` is called with the share (0..1) that was read, and may raise to stop.
    """
    with gather(), SessionReader(path) as reader:  # damaged messages are among the findings
        out = _container(reader)
        out += _description(reader)
        tracks, damage = _read_all(reader, progress)
        out += damage
        for topic, track in sorted(tracks.items()):
            out += _judge(topic, track, reader.span_ns[0])
        out += _missing(reader, tracks)
        out += _edits(reader)
        log_times = {topic: track.log_times for topic, track in tracks.items()}
        for device, seconds in silences(log_times, reader.span_ns).items():
            what = warning("check.silent", silent_s=seconds)
            out.append(FileFinding("warning", what, device, seconds))
        return out


def verify_one(path: Path, progress: Callable[[float], None]) -> list[FileFinding]:
    """`verify` as a task of `tracker.base.workers`."""
    return verify(path, progress)


def is_ok(findings: list[FileFinding]) -> bool:
    """Returns whether no finding is an error."""
    return all(f.severity != "error" for f in findings)


def _container(reader: SessionReader) -> list[FileFinding]:
    contents = reader.source.contents
    damage = [*contents.damage]
    if contents.finished and not damage:
        damage += index_damage(reader.path, contents)
    out = [FileFinding("error", d.what, f"byte {d.offset}") for d in damage]
    if not contents.finished:
        out.append(FileFinding("error", failure("check.unfinished"), "file"))
    if contents.profile != "ros2":
        what = warning("check.profile", profile=contents.profile)
        out.append(FileFinding("warning", what, "file"))
    if not reader.metadata:
        out.append(FileFinding("note", notice("check.foreign"), "file"))
    return out


def _description(reader: SessionReader) -> list[FileFinding]:
    """Checks whether hand, glove and camera are present, readable and consistent."""
    names = [description.HAND, description.GLOVE]
    if reader.sides:
        names = [description.of_side(name, side) for name in names for side in reader.sides]
    for name in names:
        try:
            reader.attachment(name)
        except GlovetrackError as error:
            return [FileFinding("error", error.notice, name)]
    try:
        info = reader.info
    except GlovetrackError as error:
        return [FileFinding("error", error.notice, "attachments")]
    if info.rig is None and any(t.startswith("/camera/") for t in reader.topic_names):
        return [FileFinding("warning", warning("check.no_rig"), "camera")]
    return []


def _read_all(
    reader: SessionReader, progress: Callable[[float], None]
) -> tuple[dict[str, _Track], list[FileFinding]]:
    tracks: dict[str, _Track] = {}
    out: list[FileFinding] = []
    spans = reader.source.contents.spans
    for i in range(len(spans)):
        progress(i / len(spans))
        try:
            messages = reader.source.messages_in(spans[i])
        except GlovetrackError as error:
            out.append(FileFinding("error", error.notice, f"byte {spans[i].offset}"))
            continue
        for m in messages:
            track = tracks.setdefault(m.topic, _Track())
            if _is_sound(m):
                _track(track, m)
            else:
                track.damaged.append(m.log_time)
    return tracks, out


def _is_sound(m: RawMessage) -> bool:
    try:
        check_message(m)
        if m.type in MEASURED:
            CdrReader(m.data).time()
    except DAMAGE:
        return False
    return True


def _track(track: _Track, m: RawMessage) -> None:
    track.count += 1
    track.log_times.append(m.log_time)
    if m.type not in MEASURED:
        return
    stamp = CdrReader(m.data).time()
    if m.type == sensors.IMU:
        if m.data in track.recent:
            track.repeated += 1
            return
        track.recent.append(m.data)
    delay = m.log_time - stamp
    if track.last_stamp is not None:
        step = stamp - track.last_stamp
        track.backward += step < 0
        _judge_delay(track, step, delay)
        track.steps.append((step, track.last_stamp))
    else:
        track.usual_delay = delay
    track.last_stamp, track.last_delay = stamp, delay


def _judge_delay(track: _Track, step: int, delay: int) -> None:
    """Distinguishes late arrivals from a clock that jumps.

    On an overloaded host, a message arrives late while the stamps continue; the delay then returns
    to normal, immediately if messages were lost. A clock that jumps changes the stamps: backwards,
    or so far ahead that the delay falls below normal.
    """
    change = delay - track.last_delay
    if abs(change) <= _CLOCK_JUMP_NS:
        track.usual_delay = min(track.usual_delay, delay)
    elif change > 0 and step >= 0:
        track.late.append(change)
    elif step < 0 or delay < track.usual_delay - _CLOCK_JUMP_NS:
        track.jumps += 1
        track.usual_delay = delay


def _judge(topic: str, track: _Track, start_ns: int) -> list[FileFinding]:
    out: list[FileFinding] = []
    if track.damaged:
        out.append(FileFinding("error", _damaged(track.damaged, start_ns), topic))
    if track.repeated:
        out.append(FileFinding("warning", warning("check.repeated", count=track.repeated), topic))
    if track.backward:
        out.append(FileFinding("warning", warning("check.backward", count=track.backward), topic))
    if track.jumps:
        out.append(FileFinding("warning", warning("check.jumps", count=track.jumps), topic))
    if track.late:
        late = warning("check.late", late_s=max(track.late) / 1e9, count=len(track.late))
        out.append(FileFinding("warning", late, topic))
    if topic.startswith(("/glove/", "/camera/")) and len(track.steps) > 10:
        out += _gaps(topic, track)
    return out


def _damaged(log_times: list[int], start_ns: int) -> Notice:
    """Returns the number of damaged messages, and the times of the first (s from the start)."""
    after = [max(t - start_ns, 0) / 1e9 for t in sorted(log_times)]
    first = ", ".join(f"{s:.2f} s" for s in after[:MOST_NAMED])
    at = f"{first}, …" if len(after) > MOST_NAMED else first
    return failure("check.damaged_messages", count=len(after), at=at)


def _gaps(topic: str, track: _Track) -> list[FileFinding]:
    period = statistics.median(s for s, _ in track.steps)
    gaps = [(s, at) for s, at in track.steps if s > _GAP_PERIODS * max(period, 1)]
    if not gaps:
        return []
    longest, at = max(gaps)
    after = (at - track.steps[0][1]) / 1e9
    what = warning("check.gaps", count=len(gaps), longest_s=longest / 1e9, after_s=after)
    return [FileFinding("warning", what, topic)]


def _edits(reader: SessionReader) -> list[FileFinding]:
    """Lists interpolated values; an error if one has the state measured."""
    try:
        found = [FileFinding("note", plain(line), NAME) for line in lines(reader.edits)]
        sides = {f.side for edit in reader.edits for f in edit.filled}
        wrong = sum(_is_stored_as_measured(reader.path, side) for side in sorted(sides))
    except GlovetrackError as error:
        return [FileFinding("error", error.notice, NAME)]
    if wrong:
        found.append(FileFinding("error", failure("check.interpolated", count=wrong), NAME))
    return found


def _is_stored_as_measured(path: Path, side: str) -> int:
    with SessionReader(path, side=side) as reader:
        hand, info = recorded_series(reader, segments=False), reader.info
        names = info.keypoint_names, info.hand.joint_names
        points, _ = masks(reader.edits, side, hand.stamp_ns, *names)
        return int((points & (hand.state == Validity.MEASURED)).sum())


def _missing(reader: SessionReader, tracks: dict[str, _Track]) -> list[FileFinding]:
    """Topics that a session of this glove should have but lacks."""
    try:
        info = reader.info
    except GlovetrackError:
        return []
    tracked_only = "source" in reader.metadata
    if tracked_only:
        return []
    wanted = [topics.imu(hand.side, n) for hand in info.hands for n in hand.glove.imu_names]
    missing = (t for t in wanted if t not in tracks)
    out = [FileFinding("warning", warning("check.no_imu"), t) for t in missing]
    seen = any(f(c) in tracks for c in EYES for f in (topics.image, topics.blobs))
    if not seen:
        out.append(FileFinding("warning", warning("check.no_camera"), "/camera"))
    return out


# ---- finds times without messages from a device of a session
#
# A glove that was disconnected has not lost packets by its counter, which restarts.

SILENT = 1.0  # s without a message after which a device counts as not responding
IMAGES = ("compressed", "blobs")  # the ends of their topics' names
PAUSED = 2.5  # s without a status (one a second): the recording was paused


def silences(log_times: Mapping[str, Sequence[int]], span_ns: tuple[int, int]) -> dict[str, float]:
    """Returns seconds without messages by device (``/glove/right``, ``/camera``).

    ``log_times``: ns, by topic. A device does not respond while none of its topics has a message,
    also at the session's ends; a device without topics is not part of the session.
    """
    devices: dict[str, list[Sequence[int]]] = {}
    for topic, times in log_times.items():
        device = _device(topic)
        if device:
            devices.setdefault(device, []).append(times)
    pauses = _pauses(log_times.get(topics.STATUS, ()))
    found = {name: _silence(times, span_ns, pauses) for name, times in devices.items()}
    return {name: seconds for name, seconds in found.items() if seconds > 0.0}


def _device(topic: str) -> str:
    """The device of a sensor's topic; empty for other topics."""
    parts = topic.split("/")
    if topic.startswith("/glove/") and "imu" in parts:
        return "/".join(parts[:3])
    return "/camera" if topic.startswith("/camera/") and parts[-1] in IMAGES else ""


def _pauses(status: Sequence[int]) -> np.ndarray:
    """(n, 2) ns from a status to the next, if that is late."""
    t = np.sort(np.asarray(status, np.int64))
    late = np.diff(t) > PAUSED * 1e9
    return np.column_stack((t[:-1][late], t[1:][late])) if len(t) else np.empty((0, 2), np.int64)


def _silence(times: list[Sequence[int]], span_ns: tuple[int, int], pauses: np.ndarray) -> float:
    """Returns the seconds in gaps longer than `SILENT`, without pauses."""
    t = np.unique(np.concatenate([np.asarray(ts, np.int64) for ts in times]))
    edges = np.concatenate(([span_ns[0]], t, [span_ns[1]]))
    late = np.diff(edges) > SILENT * 1e9
    total = 0.0
    for a, b in zip(edges[:-1][late], edges[1:][late], strict=True):
        of_pauses = np.minimum(pauses[:, 1], b) - np.maximum(pauses[:, 0], a)
        rest = float(b - a - of_pauses.clip(0).sum()) / 1e9
        total += rest if rest > SILENT else 0.0
    return total
