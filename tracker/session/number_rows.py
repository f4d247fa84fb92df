"""Reads the numbers of recorded messages as columns: an hour of estimates within seconds.

Messages of one topic differ mostly in their numbers, so the part before the numbers is parsed once,
and again if it changes.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.clock import NS
from tracker.base.damage import LeftOut
from tracker.geometry import so3
from tracker.messages import Array, IntArray, Validity
from tracker.session.mcap.input import RawMessage
from tracker.session.ros import motion

_STAMP = struct.Struct("<iI")
_AFTER_STAMP = 12  # bytes: the header of CDR and the stamp
_BODY = 4  # offset from which alignment is counted
_LITTLE_ENDIAN = 1
_BLOCK = 4096  # transform messages that are decoded together
States = NDArray[np.int8]


@dataclass
class _Run:
    """Consecutive messages with the same texts; their numbers are at ``at``."""

    head: bytes
    length: int
    at: int
    names: tuple[str, ...]
    parts: list[bytes] = field(default_factory=list)


class NumberRows:
    """Numbers of one topic's messages; each row has ``size`` bytes."""

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
        """Begins a run with its first message. If the position of the numbers is unknown, no other
        message joins the run."""
        raw = np.asarray(numbers, "<f8").tobytes()
        at = _aligned(data, raw) if raw else -1
        plain = at >= 0 and data[1] == _LITTLE_ENDIAN
        head = data[:4] + data[_AFTER_STAMP:at] if plain else b""
        tail = len(data) - at - len(raw) if plain else 0
        run = _Run(head, len(data) if plain else -1, at, names, [raw + bytes(tail)])
        self.stamps.append(stamp)
        self.runs.append(run)

    def table(self, columns: int) -> Array:
        """(N, columns, numbers of each) of all messages; NaN where a message has fewer rows."""
        out = np.full((len(self.stamps), columns, self._size // 8), np.nan)
        first = 0
        for run in self.runs:
            rows = self.rows(run)
            out[first : first + len(rows), : rows.shape[1]] = rows[:, :columns]
            first += len(rows)
        return out

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
    """Returns the offset of doubles in a message, aligned to eight bytes as in CDR; else -1."""
    at = data.find(numbers, _AFTER_STAMP)
    while at >= 0 and (at - _BODY) % 8:
        at = data.find(numbers, at + 1)
    return at


class StateRows:
    """States, and the estimates from which they apply."""

    def __init__(self, keypoints: tuple[str, ...], joints: tuple[str, ...]) -> None:
        self._names = {"keypoints": keypoints, "joints": joints}
        self._states = {what: self._numbers(what, {}) for what in self._names}
        self._from = [0]
        self._rows = {what: [values] for what, values in self._states.items()}

    def feed(self, data: bytes, row: int) -> None:
        for status in motion.unpack_diagnostics(data)[1]:
            if status.name in self._names:
                self._states[status.name] = self._numbers(status.name, status.values)
        self._from.append(row)
        for what, rows in self._rows.items():
            rows.append(self._states[what])

    def _numbers(self, what: str, names: dict[str, str]) -> States:
        """Measured by default, lost for an unknown state."""
        stored = [names.get(n, "measured").upper() for n in self._names[what]]
        known = Validity.__members__
        return np.array([known.get(w, Validity.LOST) for w in stored], np.int8)

    def of(self, what: str, n: int) -> States:
        """(n, rows) of n estimates."""
        counts = np.diff(np.minimum([*self._from, n], n))
        return np.repeat(np.array(self._rows[what]), counts, axis=0)


def at_stamps(stamp: IntArray, stamps: IntArray, values: Array) -> Array:
    """Returns the last row of ``values`` (M, …) with each stamp (N,); NaN if there is none."""
    if not len(stamps):
        return np.full((len(stamp), *values.shape[1:]), np.nan)
    order = np.argsort(stamps, kind="stable")
    at = np.clip(np.searchsorted(stamps[order], stamp, side="right") - 1, 0, None)
    same = (stamps[order][at] == stamp).reshape(-1, *[1] * (values.ndim - 1))
    return np.where(same, values[order[at]], np.nan)


class DeviationRows:
    """The last standard deviations before each estimate; their messages have no stamp."""

    def __init__(self) -> None:
        self._rows: list[int] = []
        self._values: list[Array] = []

    def feed(self, data: bytes, row: int) -> None:
        """A message before the estimate ``row``."""
        values = motion.unpack_numbers(data)
        self._rows.append(row)
        self._values.append(values)

    def table(self, shape: tuple[int, int]) -> Array:
        """Returns (N, K) m; NaN if it is missing or has another length."""
        out = np.full(shape, np.nan)
        for row, values in zip(self._rows, self._values, strict=True):
            if row < len(out):
                out[row] = values if len(values) == shape[1] else np.nan
        return out


class _Layout(NamedTuple):
    """Layout of a transform message: the bytes (L,) bool that are the same in all of its kind; byte
    order; offsets of each child's stamp and numbers."""

    fixed: NDArray[np.bool_]
    order: str
    places: list[tuple[str, int, int]]


def _layout(data: bytes) -> _Layout:
    """Raises one of `tracker.base.damage.DAMAGE` for a message that cannot be decoded."""
    fixed = np.ones(len(data), bool)
    order = "<" if data[1] == _LITTLE_ENDIAN else ">"
    at, places = _BODY + 4, []
    for transform in motion.unpack_transforms(data):
        stamp_at = at
        at += _STAMP.size
        for _ in ("frame", "child"):
            at += -(at - _BODY) % 4
            at += 4 + int(struct.unpack_from(f"{order}I", data, at)[0])
        at += -(at - _BODY) % 8
        places.append((transform.child, stamp_at, at))
        fixed[stamp_at : stamp_at + _STAMP.size] = fixed[at : at + 56] = False
        at += 56
    return _Layout(fixed, order, places)


class TransformRows:
    """Poses of ``children`` (row by frame) from transform messages, by stamp.

    Messages of one layout are decoded together.
    """

    def __init__(self, children: Mapping[str, int], left_out: LeftOut) -> None:
        self._children, self._left_out = children, left_out
        self._waiting: list[RawMessage] = []
        self._count = 0
        self._blocks: list[tuple[IntArray, IntArray, Array, Array]] = []

    def feed(self, raw: RawMessage) -> None:
        self._waiting.append(raw)
        if len(self._waiting) >= _BLOCK:
            self._decode()

    def at(self, stamp: IntArray) -> tuple[Array, Array]:
        """Positions (N, S, 3) m and rotations (N, S, 3, 3) at the stamps; NaN where unknown."""
        self._decode()
        if not self._blocks:
            empty = np.full((len(stamp), len(self._children), 3), np.nan)
            return empty, np.full((*empty.shape, 3), np.nan)
        number, stamps, p, R = (np.concatenate(part) for part in zip(*self._blocks, strict=True))
        order = np.argsort(number)
        return at_stamps(stamp, stamps[order], p[order]), at_stamps(stamp, stamps[order], R[order])

    def _decode(self) -> None:
        by_length: dict[int, list[int]] = {}
        for k, raw in enumerate(self._waiting):
            by_length.setdefault(len(raw.data), []).append(k)
        for numbers in by_length.values():
            self._decode_equal(np.array(numbers))
        self._count += len(self._waiting)
        self._waiting.clear()

    def _decode_equal(self, numbers: IntArray) -> None:
        """Decodes messages of one length."""
        data = b"".join(self._waiting[k].data for k in numbers)
        table = np.frombuffer(data, np.uint8).reshape(len(numbers), -1)
        rows = np.arange(len(numbers))
        while len(rows):
            first = self._waiting[numbers[rows[0]]]
            same = np.zeros(len(rows), bool)
            same[0] = True
            with self._left_out.reading(first.topic, first.log_time):
                layout = _layout(first.data)
                fixed = table[rows][:, layout.fixed]
                same = (fixed == fixed[0]).all(axis=1)
                self._collect(numbers[rows[same]], table[rows[same]], layout)
            rows = rows[~same]

    def _collect(self, numbers: IntArray, table: NDArray[np.uint8], layout: _Layout) -> None:
        mine = [part for part in layout.places if part[0] in self._children]
        if not mine:
            return
        stamps = table[:, mine[0][1] : mine[0][1] + _STAMP.size]
        second = np.ascontiguousarray(stamps[:, :4]).view(f"{layout.order}i4")[:, 0]
        nano = np.ascontiguousarray(stamps[:, 4:]).view(f"{layout.order}u4")[:, 0]
        poses = np.full((len(table), len(self._children), 7), np.nan)
        for child, _, at in mine:
            numbers_of = np.ascontiguousarray(table[:, at : at + 56])
            poses[:, self._children[child]] = numbers_of.view(f"{layout.order}f8")
        stamp = second.astype(np.int64) * NS + nano.astype(np.int64)
        R = so3.matrix_from_quat(poses[:, :, 3:])
        self._blocks.append((self._count + numbers, stamp, poses[:, :, :3], R))
