"""``glovetrack fill``: fills gaps of a session by interpolation, in a new file that marks them."""

from __future__ import annotations

import getpass
import math
import tempfile
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tracker import __version__
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import check_target, sha256, whole_file
from tracker.base.notices import Notice, notice
from tracker.offline.options import TrackOptions
from tracker.offline.track import track
from tracker.session import edits
from tracker.session.description import SessionInfo
from tracker.session.edits import Edit, Filled, edits_text
from tracker.session.encode import Encoder, ImageCoding, Out
from tracker.session.export.mcap import copy_extras
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.gaps.fill import FillOptions, HandFill, Left, choose, fill_hand
from tracker.session.gaps.find import INFERRED_LIMIT, KINDS, Gap, session_gaps
from tracker.session.gaps.methods import METHODS, SMOOTH
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, topics

Watch = Callable[[float], None]
_READING, _TRACKING = 0.2, 0.6  # shares of the work: finding gaps, smoothing the sensors
_WRITING = 0.9  # of it, when the new file is begun


@dataclass(frozen=True)
class Signature:
    """Who edits, and when (ISO 8601, UTC)."""

    who: str
    when: str

    @staticmethod
    def now(who: str = "") -> Signature:
        """The user of this computer unless another one is named."""
        if not who:
            try:
                who = getpass.getuser()
            except (KeyError, OSError):  # a user without a name
                who = ""
        return Signature(who, datetime.now(UTC).isoformat(timespec="seconds"))


@dataclass(frozen=True)
class FillReport:
    """What was written to ``file``."""

    file: Path
    method: str
    filled: tuple[Filled, ...]
    left: tuple[Left, ...] = field(default=())

    def to_json(self) -> dict[str, Any]:
        return {
            "file": str(self.file),
            "method": self.method,
            "filled": [asdict(f) | {"length_s": f.length} for f in self.filled],
            "left": [gap_json(left.gap) | {"why": left.why} for left in self.left],
        }

    @property
    def summary(self) -> str:
        total = sum(f.length for f in self.filled)
        text = f"{len(self.filled)} gap{'s' * (len(self.filled) != 1)} interpolated "
        text += f"({self.method}, {total:.2f} s in all)"
        return text + (f", {len(self.left)} left as they were" if self.left else "")


def gap_json(gap: Gap) -> dict[str, Any]:
    """As `glovetrack gaps --json` lists it."""
    return asdict(gap) | {"length": gap.length}


def fill(
    source: Path,
    out: Path,
    options: FillOptions | None = None,
    signature: Signature | None = None,
    wanted: Sequence[Gap] | None = None,
    limit: float = INFERRED_LIMIT,
    watch: Watch = lambda share: None,
    force: bool = False,
) -> FillReport:
    """Fills gaps of ``source`` in the new file ``out``, which is complete or absent.

    ``wanted``: these gaps of `session_gaps` (with its ``limit``) alone. ``force`` replaces a file
    that is there, but never ``source``. Raises ConfigError for options that do not exist, FileError
    where no gap can be filled.
    """
    options = options or FillOptions()
    _check(options)
    check_target(out, force, [source])
    gaps = session_gaps(source, limit, lambda share: watch(_READING * share))
    if wanted is not None:
        gaps = _matched(gaps, wanted, source)
    chosen, left = choose(gaps, options)
    if not chosen:
        raise FileError(_nothing(source, gaps, options))
    shapes = _smoothed(source, out, watch) if options.method == SMOOTH else {}
    fills = _fill_hands(source, chosen, options.method, shapes, watch)
    filled = tuple(f for fill in fills.values() for f in fill.filled)
    left = [*left, *(each for fill in fills.values() for each in fill.left)]
    if not filled:
        raise FileError(notice("gaps.none_filled", file=source.name, why=left[0].why))
    edit = _edit(source, options, signature or Signature.now(), filled)
    with whole_file(out, force, [source]) as part, SessionReader(source) as reader:
        write_filled(reader, part, fills, edit)
    watch(1.0)
    return FillReport(out, options.method, filled, tuple(left))


def _fill_hands(
    source: Path,
    chosen: Sequence[Gap],
    method: str,
    shapes: Mapping[str, EstimateSeries],
    watch: Watch,
) -> dict[str, HandFill]:
    """Returns the values for the ``chosen`` gaps of each hand, by its side."""
    begun = _READING + _TRACKING * (method == SMOOTH)
    sides = sorted({gap.side for gap in chosen})

    def filling(n: int, share: float) -> None:
        watch(begun + (_WRITING - begun) * (n + share) / len(sides))

    fills = {}
    for n, side in enumerate(sides):
        with SessionReader(source, side=side) as reader:
            mine = [gap for gap in chosen if gap.side == side]
            hand = recorded_series(reader, segments=False)
            shape = shapes.get(side)
            fills[side] = fill_hand(reader, hand, mine, method, shape, partial(filling, n))
    return fills


def _check(options: FillOptions) -> None:
    if options.method not in METHODS:
        raise ConfigError(
            notice("option.choice", option="--method", known=METHODS, value=options.method)
        )
    if not (math.isfinite(options.max_gap) and options.max_gap > 0):
        raise ConfigError(notice("gaps.max_gap", max_gap_s=options.max_gap))
    unknown = [kind for kind in options.kinds if kind not in KINDS]
    if unknown or not options.kinds:
        raise ConfigError(
            notice("option.choice", option="--kinds", known=KINDS, value=", ".join(unknown))
        )


def _matched(gaps: Sequence[Gap], wanted: Sequence[Gap], source: Path) -> list[Gap]:
    """Those gaps that are wanted. Raises FileError for one that the session does not have."""
    known = {_key(gap): gap for gap in gaps}
    for gap in wanted:
        if _key(gap) not in known:
            raise FileError(
                notice(
                    "gaps.no_such_gap",
                    file=source.name,
                    side=gap.side,
                    part=gap.part,
                    start_s=gap.start,
                    stop_s=gap.stop,
                )
            )
    return [known[key] for key in dict.fromkeys(map(_key, wanted))]


def _key(gap: Gap) -> tuple[object, ...]:
    return gap.side, gap.part, gap.keypoints, gap.kind, gap.start_ns, gap.stop_ns


def _nothing(source: Path, gaps: Sequence[Gap], options: FillOptions) -> Notice:
    kinds = [gap for gap in gaps if gap.kind in options.kinds]
    short = sum(gap.fillable for gap in kinds)
    if not kinds:
        return notice("gaps.none_of_kind", file=source.name, kinds=options.kinds)
    if short:
        return notice("gaps.all_longer", count=short, file=source.name, max_gap_s=options.max_gap)
    return notice("gaps.no_estimates", file=source.name)


def _smoothed(source: Path, out: Path, watch: Watch) -> Mapping[str, EstimateSeries]:
    """The sensors of a session tracked again and smoothed, by side."""

    def forward(share: float) -> None:
        watch(_READING + _TRACKING * share)

    with tempfile.TemporaryDirectory(prefix=".fill-", dir=out.absolute().parent) as folder:
        made = Path(folder) / "smooth.mcap"
        track(source, made, TrackOptions(smooth=True), forward)
        with SessionReader(made) as reader:
            sides = [hand.side for hand in reader.info.hands]
        shapes = {}
        for side in sides:
            with SessionReader(made, side=side if len(sides) > 1 else "") as reader:
                shapes[side] = recorded_series(reader, segments=False)
    return shapes


def _edit(
    source: Path, options: FillOptions, signature: Signature, filled: tuple[Filled, ...]
) -> Edit:
    return Edit(
        method=options.method,
        who=signature.who,
        when=signature.when,
        program=f"glovetrack {__version__}",
        source=source.name,
        source_sha256=sha256(source),
        parameters={"max_gap_s": options.max_gap, "kinds": list(options.kinds)},
        filled=filled,
    )


# ---- writes a session with filled gaps: a copy in which only these estimates differ

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
