"""Gaps of a replayed session as listed and as shown on the timeline."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from app.viewmodels.names import display_name
from app.viewmodels.recording import position_text
from app.viewmodels.states import BLUE, GREY, ORANGE, VERMILION, StateLook
from app.words import mark, tr
from tracker.base.clock import NS
from tracker.session.edits import Filled
from tracker.session.gaps.cause import (
    NO_IMAGES,
    NO_IMU,
    NO_PACKETS,
    NO_SENSOR,
    NOT_COMPUTED,
    NOT_SEARCHED,
    OCCLUDED,
    PAUSED,
    UNKNOWN,
)
from tracker.session.gaps.find import HOLE, INFERRED, LOST
from tracker.session.gaps.find import Gap as Gap
from tracker.session.gaps.methods import CUBIC, LINEAR, SMOOTH

KINDS = {
    HOLE: StateLook(GREY, "○", mark("hole")),
    LOST: StateLook(VERMILION, "▲", mark("lost")),
    INFERRED: StateLook(ORANGE, "◐", mark("inferred")),
}
INTERPOLATED = StateLook(BLUE, "≈", mark("interpolated"))
CAUSES = {
    OCCLUDED: mark("hidden from the camera"),
    NOT_SEARCHED: mark("images not searched"),
    NO_IMAGES: mark("no images"),
    NO_PACKETS: mark("packets missing"),
    NO_IMU: mark("an IMU did not respond"),
    NO_SENSOR: mark("no sensor on this part"),
    PAUSED: mark("nothing was recorded"),
    NOT_COMPUTED: mark("no estimate was computed"),
    UNKNOWN: mark("unknown"),
}
METHODS = {
    LINEAR: mark("Linear"),
    CUBIC: mark("Cubic"),
    SMOOTH: mark("Sensors, smoothed"),
}
_SIDES = {"left": mark("left"), "right": mark("right"), "hand": mark("hand")}


@dataclass(frozen=True)
class SessionGaps:
    """The gaps of a session, and those that an edit filled. ``start_ns``: its first time stamp
    since 1970, the origin of positions."""

    path: Path
    gaps: tuple[Gap, ...]
    filled: tuple[Filled, ...]
    start_ns: int

    @property
    def sides(self) -> tuple[str, ...]:
        return tuple(sorted({gap.side for gap in self.gaps}))

    @property
    def parts(self) -> tuple[str, ...]:
        """Parts of the hand, in order of their first gap."""
        return tuple(dict.fromkeys(gap.part for gap in self.gaps))

    def is_interpolated(self, position: float) -> bool:
        """Whether an edit filled a gap of any hand at a position, s."""
        at = self.start_ns + position * NS
        return any(f.start_ns < at < f.stop_ns for f in self.filled)


@dataclass(frozen=True)
class Stretch:
    """An interval of the timeline from ``start`` to ``stop`` s, with its tool tip."""

    start: float
    stop: float
    colour: str
    text: str


@dataclass(frozen=True)
class FilledSession:
    """A new session with ``filled`` gaps; ``left`` of the selected ones were not filled."""

    path: Path
    filled: int
    left: int


@dataclass(frozen=True)
class GapFilter:
    """Criteria of listed gaps; an empty word matches all. Parts without a sensor are listed on
    request."""

    kind: str = ""
    part: str = ""
    unsensed: bool = False

    def shown(self, gaps: Sequence[Gap]) -> list[Gap]:
        return [
            gap
            for gap in gaps
            if self.kind in ("", gap.kind)
            and self.part in ("", gap.part)
            and (self.unsensed or gap.cause != NO_SENSOR)
        ]


def part_text(part: str) -> str:
    """Name of a part: the whole hand, its wrist or a finger."""
    return tr(_SIDES[part]) if part in _SIDES else display_name(part)


def side_text(side: str) -> str:
    return tr(_SIDES.get(side, side))


def cause_text(gap: Gap) -> str:
    return tr(CAUSES.get(gap.cause, gap.cause))


def tip_of(gap: Gap) -> str:
    """The missing keypoints, and why the gap cannot be filled, if so."""
    text = ", ".join(display_name(name) for name in gap.keypoints)
    if gap.fillable:
        return text
    reason = tr("It cannot be filled: there is no data on one side of the gap.")
    return f"{text}\n{reason}"


def stretches(found: SessionGaps, shown: Sequence[Gap]) -> list[Stretch]:
    """Intervals for the timeline: the listed gaps, then interpolated ones."""
    out = []
    for gap in shown:
        look = KINDS[gap.kind]
        where = f"{side_text(gap.side)} {part_text(gap.part)}"
        text = f"{look.sign} {tr(look.word)}, {where}: {cause_text(gap)}"
        out.append(Stretch(gap.start, gap.stop, look.colour, text))
    for one in found.filled:
        start, stop = ((ns - found.start_ns) / NS for ns in (one.start_ns, one.stop_ns))
        text = f"{INTERPOLATED.sign} {tr(INTERPOLATED.word)}, {position_text(start)}"
        out.append(Stretch(start, stop, INTERPOLATED.colour, text))
    return out


def filled_text(made: FilledSession, source: str) -> str:
    """A message about the new session."""
    text = tr("Filled {} gaps of {} by interpolation in {}; the original is unchanged.")
    message = text.format(made.filled, source, made.path.name)
    return f"{message} {tr('Not filled: {}.').format(made.left)}" if made.left else message
