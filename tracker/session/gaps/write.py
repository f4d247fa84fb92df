"""Writes a session with filled gaps: a copy in which only these estimates differ."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tracker.session import edits
from tracker.session.description import SessionInfo
from tracker.session.edits import Edit, edits_text
from tracker.session.encode import Encoder, ImageCoding, Out
from tracker.session.export.mcap import copy_extras
from tracker.session.gaps.fill import HandFill
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, topics

_OF_ESTIMATE = ("keypoints", "keypoint_sd", "joint_states", "states")


def write_filled(
    reader: SessionReader, path: Path, fills: Mapping[str, HandFill], edit: Edit
) -> None:
    """Copy ``reader``'s session to ``path`` with the estimates of ``fills``, by side.

    ``edit`` is added to the record of earlier edits. All other messages are copied byte for byte.
    """
    out = McapOutput(path, sync=False)
    try:
        copy_extras(reader, out, without=(edits.NAME,))
        text = edits_text([*reader.edits, edit])
        out.attach_bytes(edits.NAME, edits.MEDIA_TYPE, text.encode(), reader.span_ns[0])
        hands = [
            _HandCopy(info, fills[info.side], _log_times(reader, info.side))
            for info in reader.info.hands
            if info.side in fills and fills[info.side].spans
        ]
        copier = Copier(reader.source, out)
        for raw in ordered(reader.source):
            for hand in hands:
                hand.write_before(raw, copier)
            copied: RawMessage | None = raw
            for hand in hands:
                copied = hand.unreplaced(copied) if copied is not None else None
            if copied is not None:
                copier.copy(copied)
        for hand in hands:
            hand.write_rest(copier)
    finally:
        out.finish()


def _log_times(reader: SessionReader, side: str) -> dict[int, int]:
    """Log time of each estimate by its stamp, both in ns."""
    topic = frozenset([topics.hand(side, "keypoints")])
    return {raw.publish_time: raw.log_time for raw in ordered(reader.source, topic)}


class _NewMessage(NamedTuple):
    """A message that is sorted by log time and, among a hand's estimates, by stamp."""

    log_time: int
    stamp: int
    out: Out


class _HandCopy:
    """Replaces the estimates in the spans of one hand by new ones."""

    def __init__(self, info: SessionInfo, fill: HandFill, log_times: Mapping[int, int]) -> None:
        self._spans = np.array(fill.spans, np.int64).reshape(-1, 2)
        self._topics = {topics.hand(info.side, what) for what in _OF_ESTIMATE}
        self._segments = {f"{info.side}_{name}" for name in info.hand.segment_names}
        self._next_message = deque(_encoded(info, fill, log_times))

    def _is_mine(self, raw: RawMessage) -> bool:
        if raw.topic == topics.TF:
            return any(t.child in self._segments for t in motion.unpack_transforms(raw.data))
        return raw.topic in self._topics

    def write_before(self, raw: RawMessage, copier: Copier) -> None:
        """Returns the new messages before a message of the session."""
        while self._next_message and self._next_message[0].log_time <= raw.log_time:
            first = self._next_message[0]
            if first.log_time == raw.log_time and not (
                self._is_mine(raw) and first.stamp < raw.publish_time
            ):
                return
            _put(self._next_message.popleft(), copier)

    def write_rest(self, copier: Copier) -> None:
        while self._next_message:
            _put(self._next_message.popleft(), copier)

    def unreplaced(self, raw: RawMessage) -> RawMessage | None:
        """Returns the message to copy; None for an estimate that is replaced."""
        at = int(np.searchsorted(self._spans[:, 0], raw.publish_time)) - 1
        inside = at >= 0 and self._spans[at, 0] < raw.publish_time < self._spans[at, 1]
        if not inside or not self._is_mine(raw):
            return raw
        if raw.topic != topics.TF:
            return None
        others = [t for t in motion.unpack_transforms(raw.data) if t.child not in self._segments]
        return raw._replace(data=motion.pack_transforms(others)) if others else None


def _put(new: _NewMessage, copier: Copier) -> None:
    out = new.out
    copier.write(RawMessage(out.topic, out.type, new.log_time, out.stamp, out.sequence, out.data))


def _encoded(info: SessionInfo, fill: HandFill, log_times: Mapping[int, int]) -> list[_NewMessage]:
    """The messages of the filled estimates; after each span, the original states are repeated."""
    stamps = np.array(sorted(log_times), np.int64)
    out: list[_NewMessage] = []
    for (start, stop), after in zip(fill.spans, fill.afterwards, strict=True):
        encoder = Encoder(info, ImageCoding())
        earliest = log_times[start]
        for e in fill.estimates:
            stamp = info.anchor.wall(e.t)
            if not start < stamp < stop:
                continue
            latest = log_times[int(stamps[np.searchsorted(stamps, stamp)])]
            earliest = min(max(log_times.get(stamp, stamp), earliest), latest)
            out += [_NewMessage(earliest, stamp, o) for o in encoder.estimate(e)]
        states = topics.hand(info.side, "states")
        again = [o for o in encoder.estimate(after) if o.topic == states]
        out += [_NewMessage(log_times[stop], stop - 1, o) for o in again]
    return out
