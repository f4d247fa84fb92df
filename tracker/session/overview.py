"""Overview of the sessions in a folder: their content, quality and preview."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import FileError, GlovetrackError
from tracker.base.notices import notice
from tracker.messages import Tracking
from tracker.session.decode_estimate import tracking_of
from tracker.session.encode import status_name
from tracker.session.images import decode_image
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import last_before, ordered
from tracker.session.message_check import sound
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, sensors, topics

WITHOUT_POSITION = "inertial"  # the engine that does not track positions
STATUS_WINDOW_NS = 1_500_000_000  # longer than the interval between two statuses of a hand (1 s)


def sessions_in(sources: Sequence[Path], leave_out: Path | None = None) -> list[tuple[Path, Path]]:
    """Returns (session, name for its output) for files and folders, which are searched recursively.

    ``leave_out`` is a folder that is not searched. Raises FileError for a folder without sessions.
    """
    found: list[tuple[Path, Path]] = []
    for source in sources:
        if not source.is_dir():
            found.append((source, Path(source.name)))
            continue
        inside = [
            p for p in sorted(source.rglob("*.mcap")) if leave_out not in p.parents and p.is_file()
        ]
        if not inside:
            raise FileError(notice("session.none_in", path=source))
        found += [(p, p.relative_to(source)) for p in inside]
    return found


def session_summary(path: Path) -> dict[str, Any]:
    """Length, topics with rates, engine and whether the file is whole (see `commands`' --json)."""
    with SessionReader(path) as reader:
        duration = reader.duration
        counts = _counts(reader)
        held = {
            channel.topic: {
                "type": reader.source.type_of(channel),
                "count": counts.get(i, 0),
                "rate_hz": round(counts.get(i, 0) / duration, 3) if duration else 0.0,
            }
            for i, channel in sorted(
                reader.source.contents.channels.items(), key=lambda c: c[1].topic
            )
        }
        metadata = reader.metadata
        return {
            "duration_s": duration,
            "topics": held,
            "engine": metadata.get("engine", ""),
            "version": metadata.get("version", ""),
            "simulated": metadata.get("simulated") == "true",
            "integrity": _integrity(reader),
            "edits": [asdict(edit) for edit in reader.edits],
        }


def _integrity(reader: SessionReader) -> str:
    contents = reader.source.contents
    if not contents.finished:
        return "unfinished"
    return "damaged" if contents.damage else "ok"


def _counts(reader: SessionReader) -> dict[int, int]:
    """Messages by channel id; counted one by one if the file has no summary."""
    contents = reader.source.contents
    if contents.counts is not None:
        return contents.counts
    ids = {c.topic: i for i, c in contents.channels.items()}
    counts: dict[int, int] = {}
    for i in range(len(contents.spans)):
        try:
            messages = reader.source.messages_in(contents.spans[i])
        except FileError:
            continue  # a damaged chunk contains no message; `verify` reports it
        for m in messages:
            counts[ids[m.topic]] = counts.get(ids[m.topic], 0) + 1
    return counts


class HandShare(NamedTuple):
    """``tracked``: share of the time in which this hand was tracked; None if the session was not
    tracked."""

    side: str
    tracked: float | None


@dataclass(frozen=True)
class Quality:
    """``tracked`` as in `HandShare`, in a session of both ``hands`` the smaller one.
    ``packets_lost``: of this session, by all gloves; None if no status contains it. ``by_imus``:
    the hand's position is not tracked, for lack of a camera or by choice, so that ``tracked`` has
    no meaning.
    """

    tracked: float | None
    packets_lost: int | None
    by_imus: bool = False
    hands: tuple[HandShare, ...] = ()  # of a session of both, the left one first


def quality(reader: SessionReader) -> Quality:
    """Reads only changes of the state: an hour takes little longer than a minute."""
    hands = tuple(HandShare(h.side, _tracked(reader, h.side)) for h in reader.info.hands)
    known = any(hand.tracked is not None for hand in hands)
    least = min(hand.tracked or 0.0 for hand in hands) if known else None
    is_placeless = reader.metadata.get("engine") == WITHOUT_POSITION
    both = hands if len(hands) > 1 else ()
    return Quality(least, _packets_lost(reader), is_placeless, both)


def _tracked(reader: SessionReader, side: str) -> float | None:
    """Returns the tracked share of the session's time; before the first state nothing was
    tracked."""
    states = topics.hand(side, "states")  # at each change; a status is once a second
    topic = states if states in reader.topic_names else topics.STATUS
    changes = [
        (raw.log_time, tracking_of(status.message) == Tracking.TRACKING)
        for raw in sound(ordered(reader.source, frozenset([topic])), reader.source.left_out)
        for status in motion.unpack_diagnostics(raw.data)[1]
        if status.name in (status_name(reader.info, side), "tracking")
    ]
    if not changes:
        return None
    first, last = reader.span_ns
    if first == last:
        return float(changes[-1][1])
    at = [min(max(t, first), last) for t, _ in changes] + [last]
    tracked = [b - a for (_, on), (a, b) in zip(changes, itertools.pairwise(at), strict=True) if on]
    return sum(tracked) / (last - first)


def _packets_lost(reader: SessionReader) -> int | None:
    """Lost packets from the first status to the last, because older recordings counted from the
    start of the engine."""
    status = frozenset([topics.STATUS])
    first = next(ordered(reader.source, status), None)
    last = last_before(reader.source, topics.STATUS, reader.span_ns[1] + 1)
    if first is None or last is None:
        return None
    left_out = reader.source.left_out
    early = sound(ordered(reader.source, status, end=first.log_time + STATUS_WINDOW_NS), left_out)
    before = dict(reversed(list(_lost_by_glove(early))))
    late = sound(ordered(reader.source, status, last.log_time - STATUS_WINDOW_NS), left_out)
    after = dict(_lost_by_glove(late))
    if not before and not after:
        return None
    return round(sum(lost - before.get(name, lost) for name, lost in after.items()))


def _lost_by_glove(statuses: Iterable[RawMessage]) -> Iterator[tuple[str, float]]:
    """Yields the name of each of a hand's statuses and the number of packets lost until then."""
    for raw in statuses:
        for status in motion.unpack_diagnostics(raw.data)[1]:
            if "imu_lost" in status.values:
                yield status.name, float(status.values["imu_lost"])


def thumbnail(reader: SessionReader, width: int) -> NDArray[np.uint8] | None:
    """Returns (h, width, 3) BGR from the middle of the left images; None without images."""
    wanted = frozenset([topics.image("left")])
    middle = sum(reader.span_ns) // 2
    for start in (middle, 0):
        for raw in sound(ordered(reader.source, wanted, start), reader.source.left_out):
            encoded = sensors.unpack_image(raw.data)
            try:
                image = decode_image(encoded.data, encoded.frame)
            except GlovetrackError:
                continue  # a damaged image; the next one may be whole
            height = max(1, round(image.shape[0] * width / image.shape[1]))
            small = cv2.resize(image, (width, height), interpolation=cv2.INTER_AREA)
            return np.asarray(small, np.uint8)
    return None
