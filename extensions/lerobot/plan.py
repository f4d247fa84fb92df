"""Plans the episodes of a data set before any session is read completely."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from extensions.lerobot.layout import DatasetCamera, HandNames, Layout
from tracker.base.clock import NS
from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice
from tracker.messages import EYES
from tracker.session.export.options import NONE, VIDEO, ExportOptions
from tracker.session.images import image_size
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import last_before, ordered
from tracker.session.message_check import sound
from tracker.session.raw_imu import read_notes
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, sensors, topics

JUDGED = 200
"""Messages from which a rate is estimated."""
FEWEST = 2  # frames of an episode
DEFAULT_TASK = "Move the hand."
ROBOT = re.compile(r"/robot/([^/]+)/joint_states")


class Episode(NamedTuple):
    """``frames`` frames from ``start_ns`` on; the first is the data set's frame ``first``. ``size``
    is their share of the session file in bytes."""

    number: int
    source: Path
    start_ns: int
    frames: int
    first: int
    task: str
    size: float


class _PlanPart(NamedTuple):
    start_ns: int
    frames: int
    note: str


def plan(
    sources: Sequence[Path], options: ExportOptions
) -> tuple[Layout, list[Episode], tuple[str, ...]]:
    """The layout, the episodes in the order of the sessions, and the tasks.

    Raises FileError for a session without estimates, ConfigError if sessions differ in content or
    the rate is not an integer.
    """
    layout: Layout | None = None
    episodes: list[Episode] = []
    for source in sources:
        with SessionReader(source) as reader:
            found = _layout(reader, options, None if layout is None else layout.fps)
            if layout is not None:
                _check_same(sources[0], layout, source, found)
            layout = found
            episodes += _episodes(reader, layout.fps, options, episodes)
    if layout is None or not episodes:
        raise FileError(notice("lerobot.no_episode"))
    return layout, episodes, tuple(dict.fromkeys(e.task for e in episodes))


def hand_sides(reader: SessionReader) -> tuple[str, ...]:
    """The hands of a session with one or two hands."""
    return reader.sides or (reader.info.side,)


def robot_topics(reader: SessionReader) -> dict[str, str]:
    """Topics of robots' joints by the robot's name."""
    found = ((ROBOT.fullmatch(t), t) for t in sorted(reader.topic_names))
    return {match[1]: topic for match, topic in found if match}


def _layout(reader: SessionReader, options: ExportOptions, fps: int | None) -> Layout:
    hands = tuple(
        HandNames(info.side, info.hand.joint_names)
        for info in reader.info.hands
        if info.side in hand_sides(reader)
    )
    wanted = options.dataset.images
    cameras = tuple(_cameras(reader)) if wanted != NONE else ()
    rate = fps or _whole_rate(options.rate) or _rate(reader, cameras)
    return Layout(rate, hands, cameras, _robot_names(reader), wanted == VIDEO and bool(cameras))


def _whole_rate(rate: float | None) -> int | None:
    if rate is not None and rate != round(rate):
        raise ConfigError(notice("lerobot.rate", rate_hz=rate))
    return None if rate is None else round(rate)


def _rate(reader: SessionReader, cameras: Sequence[DatasetCamera]) -> int:
    """Rate of the images, or of the estimates without images."""
    if cameras:
        topic = topics.image(cameras[0].name)
    else:
        topic = topics.hand(hand_sides(reader)[0], "keypoints")
    stamps = []
    for raw in ordered(reader.source, frozenset([topic])):
        stamps.append(raw.publish_time)
        if len(stamps) == JUDGED:
            break
    steps = np.diff(stamps)
    steps = steps[steps > 0]
    return max(round(NS / float(np.median(steps))), 1) if len(steps) else 100


def _first_sound(reader: SessionReader, topic: str) -> RawMessage | None:
    """The first undamaged message of a topic."""
    stored = ordered(reader.source, frozenset([topic]))
    return next(sound(stored, reader.source.left_out), None)


def _cameras(reader: SessionReader) -> Iterator[DatasetCamera]:
    for name in EYES:
        raw = _first_sound(reader, topics.image(name))
        if raw is None:
            continue
        data = sensors.unpack_image(raw.data).data
        size = image_size(data)
        if size is None:
            raise FileError(notice("lerobot.image_kind", camera=name, path=reader.path))
        kind = "png" if data[:4] == b"\x89PNG" else "jpeg"
        yield DatasetCamera(name, size[1], size[0], kind)


def _robot_names(reader: SessionReader) -> tuple[str, ...]:
    """Joint names of all robots, prefixed with the robot's name if there are several."""
    topics_of = robot_topics(reader)
    names: list[str] = []
    for robot, topic in topics_of.items():
        raw = _first_sound(reader, topic)
        joints = motion.unpack_joints(raw.data).names if raw is not None else ()
        names += [f"{robot}/{joint}" if len(topics_of) > 1 else joint for joint in joints]
    return tuple(names)


def _check_same(first: Path, layout: Layout, source: Path, found: Layout) -> None:
    for what, ours, theirs in (
        ("hands", layout.hands, found.hands),
        ("cameras", layout.cameras, found.cameras),
        ("robots", layout.robot, found.robot),
    ):
        if ours != theirs:
            raise ConfigError(
                notice("lerobot.layouts_differ", first=first, other=source, what=what)
            )


def _episodes(
    reader: SessionReader, fps: int, options: ExportOptions, before: Sequence[Episode]
) -> list[Episode]:
    number, first = len(before), before[-1].first + before[-1].frames if before else 0
    parts = list(_parts(reader, fps, options))
    total = sum(p.frames for p in parts) or 1
    size = reader.path.stat().st_size
    own = "" if "notes" in options.anonymous else " ".join(reader.info.notes.split())
    out = []
    for part in parts:
        task = options.dataset.task or part.note or own or DEFAULT_TASK
        share = size * part.frames / total
        out.append(Episode(number, reader.path, part.start_ns, part.frames, first, task, share))
        number, first = number + 1, first + part.frames
    return out


def _parts(reader: SessionReader, fps: int, options: ExportOptions) -> Iterator[_PlanPart]:
    start, stop = tracked_span(reader)
    zero = start
    if options.start is not None:
        start = max(start, zero + round(options.start * NS))
    if options.stop is not None:
        stop = min(stop, zero + round(options.stop * NS))
    notes = sorted(read_notes(reader)) if options.dataset.split else []
    cuts = [(start, ""), *((t, text) for t, text in notes if start < t <= stop)]
    ends = [t - 1 for t, _ in cuts[1:]] + [stop]
    for (begin, text), end in zip(cuts, ends, strict=True):
        frames = int((end - begin) * fps // NS) + 1
        if frames >= FEWEST:
            yield _PlanPart(begin, frames, "" if "notes" in options.anonymous else text)


def tracked_span(reader: SessionReader) -> tuple[int, int]:
    """Stamps in ns of the first and last estimate of any hand. Raises FileError without any."""
    stamps = []
    for side in hand_sides(reader):
        topic = topics.hand(side, "keypoints")
        first = next(ordered(reader.source, frozenset([topic])), None)
        last = last_before(reader.source, topic, reader.span_ns[1] + 1)
        stamps += [m.publish_time for m in (first, last) if m is not None]
    if not stamps:
        raise FileError(notice("session.not_tracked", path=reader.path))
    return min(stamps), max(stamps)
