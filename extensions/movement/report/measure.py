"""Measures of one take for a report."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from extensions.movement.report.angles import angle_sd, isb_angles
from extensions.movement.report.course import LEAST_M, LEAST_RAD, Course, course
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array, Validity
from tracker.session.edits import Edit
from tracker.session.motion import Measure, Take, distance, measures, pair_name, read_take
from tracker.session.reader import SessionReader

THUMB = "thumb_tip"


@dataclass(frozen=True)
class Row:
    """One quantity of a take: its measure, its course, and whether it is an ISB angle."""

    measure: Measure
    course: Course
    isb: bool = False
    peak_at: float = float("nan")  # s, time of the maximum

    @property
    def range_sd(self) -> float:
        """Standard deviation of the range: two values with errors assumed to be independent."""
        return self.measure.claimed_sd * np.sqrt(2.0)


@dataclass(frozen=True, eq=False)
class MeasuredTake:
    """A take with its rows. ``wearer`` is empty if unknown or omitted; ``session``: number of the
    session in the report, from 0."""

    name: str
    wearer: str
    side: str
    engine: str
    version: str
    seconds: float
    simulated: bool
    take: Take
    rows: tuple[Row, ...]
    session: int = 0
    edits: tuple[Edit, ...] = ()

    def row(self, name: str) -> Row | None:
        return next((r for r in self.rows if r.measure.name == name), None)


def measure_hands(path: Path, anonymous: bool = False) -> list[MeasuredTake]:
    """Measures of each hand of a session."""
    with SessionReader(path) as reader:
        sides = reader.sides or ("",)
    return [measure(path, anonymous, side) for side in sides]


def measure(path: Path, anonymous: bool = False, side: str = "") -> MeasuredTake:
    """Measures of one hand; ``side`` selects it in a session with both. Raises FileError if the
    session contains no estimates."""
    with SessionReader(path, side=side) as reader:
        take, info, edits = read_take(reader), reader.info, reader.edits
    return MeasuredTake(
        name="" if anonymous else f"{path.stem} {side}".strip(),
        wearer="" if anonymous else info.participant,
        side=info.side,
        engine=info.engine,
        version=info.version,
        seconds=float(take.t[-1] - take.t[0]),
        simulated=info.simulated,
        take=take,
        rows=tuple(rows(take, info.hand)),
        edits=tuple(replace(e, who="", source="") if anonymous else e for e in edits),
    )


def rows(take: Take, hand: HandModel) -> list[Row]:
    """Rows of the recorded angles, ISB angles of joints with several axes, and thumb apertures."""
    sd = angle_sd(take, hand)
    out = [_angle_row(take, m, j, take.angles[:, j], sd) for j, m in _angles(take)]
    names, values, of = isb_angles(take, hand)
    isb = replace(
        take,
        angle_names=tuple(names),
        angles=values,
        angle_state=take.angle_state[:, of],
        angle_filled=None if take.angle_filled is None else take.angle_filled[:, of],
    )
    for k, m in _angles(isb):
        out.append(replace(_angle_row(isb, m, k, values[:, k], sd[:, of]), isb=True))
    pairs = [(THUMB, f"{f}_tip") for f in FINGERS if f"{f}_tip" in take.point_names]
    for pair in pairs if THUMB in take.point_names else []:
        away, _, state = distance(take, pair)
        away = np.where(state == Validity.LOST, np.nan, away)
        found = measures(take, [pair])[-1]
        assert found.name == pair_name(pair)
        out.append(Row(found, course(take.t, away, LEAST_M), peak_at=_peak(take.t, away)))
    return out


def _angles(take: Take) -> list[tuple[int, Measure]]:
    return list(enumerate(measures(take, [])))


def _angle_row(take: Take, m: Measure, j: int, values: Array, sd: Array) -> Row:
    known_values = np.where(take.angle_state[:, j] == Validity.LOST, np.nan, values)
    known = sd[np.isfinite(known_values) & np.isfinite(sd[:, j]), j]
    claimed = float(known.mean()) if len(known) else float("nan")
    found = course(take.t, known_values, LEAST_RAD)
    return Row(replace(m, claimed_sd=claimed), found, peak_at=_peak(take.t, known_values))


def _peak(t: Array, values: Array) -> float:
    return float(t[np.nanargmax(values)]) if np.isfinite(values).any() else float("nan")
