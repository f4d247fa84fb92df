"""A hand's estimates as columns, without segments: an hour of them in seconds.

What `recorded_series` gives of keypoints and angles, to the last bit. Messages of a topic differ in
their numbers alone, so that the words before these are read once, and again where they change.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.messages import Array, IntArray, Validity
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, topics

_STAMP = struct.Struct("<iI")
_AFTER_STAMP = 12  # bytes: the header of CDR and the stamp
_BODY = 4  # where alignment is counted from
_LITTLE_ENDIAN = 1
_WATCH_EVERY = 2000  # messages
States = NDArray[np.int8]


class HandColumns(NamedTuple):
    """N estimates by their stamps: stamp_ns (N,) since 1970, keypoints (N, K, 3) m, q (N, K, 4),
    state (N, K) of Validity, angles (N, J) rad, angle_state (N, J); NaN where lost."""

    stamp_ns: IntArray
    keypoints: Array
    q: Array
    state: States
    angles: Array
    angle_state: States

    def rows(self, rows: NDArray[Any]) -> HandColumns:
        """Some of the estimates."""
        return HandColumns(
            self.stamp_ns[rows], self.keypoints[rows], self.q[rows], self.state[rows],
            self.angles[rows], self.angle_state[rows],
        )  # fmt: skip


class NamedNumbers(NamedTuple):
    """Rows of numbers with a name each: stamp_ns (N,), values (N, C) NaN where not told."""

    stamp_ns: IntArray
    names: tuple[str, ...]
    values: Array


def read_hand(
    reader: SessionReader, watch: Callable[[float], None] = lambda share: None
) -> HandColumns:
    """All estimates of the reader's hand. Raises FileError where there is none.

    ``watch`` hears the share that has been read, and may raise to end it.
    """
    side, info = reader.info.side, reader.info
    poses, joints = NumberRows(8 * 7), NumberRows(8)
    said = _States(info.keypoint_names, info.hand.joint_names)
    feed = {
        topics.hand(side, "keypoints"): poses.feed_poses,
        topics.hand(side, "joint_states"): joints.feed_joints,
    }
    states = topics.hand(side, "states")
    first, last = reader.span_ns
    for n, raw in enumerate(ordered(reader.source, frozenset([*feed, states]))):
        if n % _WATCH_EVERY == 0:
            watch(min(max((raw.log_time - first) / max(last - first, 1), 0.0), 1.0))
        with reader.source.left_out.reading(raw.topic, raw.log_time):
            if raw.topic == states:
                said.feed(raw.data, len(poses.stamps))
            else:
                feed[raw.topic](raw.data)
    if not poses.stamps:
        raise FileError(f"{reader.path} holds no estimates; track it first.")
    return _columns(poses, joints, said, info.hand.joint_names)


def read_joints(reader: SessionReader, topic: str) -> NamedNumbers:
    """All JointState messages of a topic, by their stamps; names as they first came."""
    joints = NumberRows(8)
    for raw in ordered(reader.source, frozenset([topic])):
        with reader.source.left_out.reading(topic, raw.log_time):
            joints.feed_joints(raw.data)
    names = tuple(dict.fromkeys(name for run in joints.runs for name in run.names))
    stamps, values = joints.by_name(names)
    order = np.argsort(stamps, kind="stable")
    return NamedNumbers(stamps[order], names, values[order])


@dataclass
class _Run:
    """Messages in a row whose words are the same: the numbers stand at ``at``."""

    head: bytes
    length: int
    at: int
    names: tuple[str, ...]
    parts: list[bytes] = field(default_factory=list)


class NumberRows:
    """Numbers of one topic's messages, ``size`` bytes for each thing that has a row."""

    def __init__(self, size: int) -> None:
        self._size = size
        self.stamps: list[int] = []
        self.runs: list[_Run] = []

    def feed_poses(self, data: bytes) -> None:
        if not self._known(data):
            found = motion.unpack_poses(data)
            numbers = np.hstack([found.position, found.orientation])
            self._begin(data, found.stamp, (), numbers)

    def feed_joints(self, data: bytes) -> None:
        if not self._known(data):
            found = motion.unpack_joints(data)
            self._begin(data, found.stamp, tuple(found.names), found.position)

    def _known(self, data: bytes) -> bool:
        if not self.runs:
            return False
        run = self.runs[-1]
        if len(data) != run.length or data[:4] + data[_AFTER_STAMP : run.at] != run.head:
            return False
        second, nano = _STAMP.unpack_from(data, 4)
        self.stamps.append(second * NS + nano)
        run.parts.append(data[run.at :])
        return True

    def _begin(self, data: bytes, stamp: int, names: tuple[str, ...], numbers: Array) -> None:
        """The first of a run; where the numbers cannot be found again its head is never met."""
        raw = np.asarray(numbers, "<f8").tobytes()
        at = _aligned(data, raw) if raw else -1
        plain = at >= 0 and data[1] == _LITTLE_ENDIAN
        head = data[:4] + data[_AFTER_STAMP:at] if plain else b""
        tail = len(data) - at - len(raw) if plain else 0
        run = _Run(head, len(data) if plain else -1, at, names, [raw + bytes(tail)])
        self.stamps.append(stamp)
        self.runs.append(run)

    def rows(self, run: _Run) -> Array:
        """(n, rows, numbers of each) of a run."""
        each = self._size // 8
        table = np.frombuffer(b"".join(run.parts), np.uint8).reshape(len(run.parts), -1)
        whole = table.shape[1] // self._size * self._size
        if run.names:
            whole = min(whole, len(run.names) * self._size)
        numbers = np.ascontiguousarray(table[:, :whole]).view("<f8")
        return np.asarray(numbers.reshape(len(run.parts), -1, each), np.float64)

    def by_name(self, names: tuple[str, ...]) -> tuple[IntArray, Array]:
        """Stamps (N,) and the values (N, C) of ``names``."""
        out = []
        for run in self.runs:
            found = self.rows(run)[:, :, 0]
            values = np.full((len(run.parts), len(names)), np.nan)
            for column, name in enumerate(run.names[: found.shape[1]]):
                if name in names:
                    values[:, names.index(name)] = found[:, column]
            out.append(values)
        table = np.concatenate(out) if out else np.zeros((0, len(names)))
        return np.array(self.stamps, np.int64), table


def _aligned(data: bytes, numbers: bytes) -> int:
    """Where doubles stand in a message, at eight bytes as CDR puts them; -1 where nowhere."""
    at = data.find(numbers, _AFTER_STAMP)
    while at >= 0 and (at - _BODY) % 8:
        at = data.find(numbers, at + 1)
    return at


class _States:
    """States as they were said, and from which estimate on they hold."""

    def __init__(self, keypoints: tuple[str, ...], joints: tuple[str, ...]) -> None:
        self._names = {"keypoints": keypoints, "joints": joints}
        self._said = {what: self._numbers(what, {}) for what in self._names}
        self._from = [0]
        self._rows = {what: [values] for what, values in self._said.items()}

    def feed(self, data: bytes, row: int) -> None:
        for told in motion.unpack_diagnostics(data)[1]:
            if told.name in self._names:
                self._said[told.name] = self._numbers(told.name, told.values)
        self._from.append(row)
        for what, rows in self._rows.items():
            rows.append(self._said[what])

    def _numbers(self, what: str, words: dict[str, str]) -> States:
        """Measured where nothing was said, lost for a word that is none."""
        said = [words.get(n, "measured").upper() for n in self._names[what]]
        known = Validity.__members__
        return np.array([known.get(w, Validity.LOST) for w in said], np.int8)

    def of(self, what: str, n: int) -> States:
        """(n, rows) of n estimates."""
        counts = np.diff(np.minimum([*self._from, n], n))
        return np.repeat(np.array(self._rows[what]), counts, axis=0)


def _columns(
    poses: NumberRows, joints: NumberRows, said: _States, names: tuple[str, ...]
) -> HandColumns:
    k = said.of("keypoints", 0).shape[1]
    n = len(poses.stamps)
    table = np.full((n, k, 7), np.nan)
    first = 0
    for run in poses.runs:
        rows = poses.rows(run)
        table[first : first + len(rows), : rows.shape[1]] = rows[:, :k]
        first += len(rows)
    stamp = np.array(poses.stamps, np.int64)
    angles = _at_stamps(stamp, *joints.by_name(names))
    state, angle_state = said.of("keypoints", n), said.of("joints", n)
    state[~np.isfinite(table[:, :, :3]).all(axis=2)] = Validity.LOST
    angle_state[~np.isfinite(angles)] = Validity.LOST
    found = HandColumns(stamp, table[:, :, :3], table[:, :, 3:], state, angles, angle_state)
    order = np.argsort(stamp, kind="stable")
    return found if (order == np.arange(n)).all() else found.rows(order)


def _at_stamps(stamp: IntArray, told: IntArray, values: Array) -> Array:
    """The row told with each stamp (N,); NaN where none was."""
    if not len(told):
        return np.full((len(stamp), values.shape[1]), np.nan)
    order = np.argsort(told, kind="stable")
    at = np.clip(np.searchsorted(told[order], stamp, side="right") - 1, 0, None)
    same = told[order][at] == stamp
    return np.where(same[:, None], values[order][at], np.nan)
