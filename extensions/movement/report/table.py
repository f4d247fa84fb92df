"""The values of a report as CSV: one line per take and quantity, with a column for the unit."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence

import numpy as np

from extensions.movement.report.angles import RECORDED, SEQUENCE
from extensions.movement.report.measure import MeasuredTake, Row
from tracker.session.motion import Units

COLUMNS = (
    "take", "wearer", "side", "name", "unit", "sequence", "min", "max", "range", "range_sd",
    "mean", "sd", "claimed_sd", "peak_speed_per_s", "peak_speed_at_s", "greatest_at_s",
    "spectral_arc_length", "log_dimensionless_jerk", "repetitions",
    "range_of_one", "sd_of_one", "measured_percent", "inferred_percent", "lost_percent",
    "interpolated_percent",
)  # fmt: skip
_UNITS = Units()


def table(takes: Sequence[MeasuredTake]) -> str:
    """CSV text: angles in degrees, distances in mm, empty cells for unknown values."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(COLUMNS)
    for measured in takes:
        for row in measured.rows:
            writer.writerow([measured.name, measured.wearer, measured.side, *_cells(row)])
    return out.getvalue()


def _cells(row: Row) -> list[str]:
    m, c = row.measure, row.course
    sequence = (SEQUENCE if row.isb else RECORDED) if m.is_angle else ""
    spread = (m.least, m.greatest, m.range, row.range_sd, m.mean, m.sd, m.claimed_sd, c.fastest)
    numbers = [text(scaled(row, v)) for v in spread]
    plain = [text(v) for v in (c.at, row.peak_at, c.arc, c.jerk)]
    shares = [text(100 * v, 2) for v in (m.measured, m.inferred, m.lost, m.interpolated)]
    each = [text(scaled(row, v)) for v in (c.each, c.each_sd)]
    unit = _UNITS.name(m.is_angle)
    return [m.name, unit, sequence, *numbers, *plain, str(c.repetitions), *each, *shares]


def scaled(row: Row, value: float) -> float:
    """An angle in degrees, a distance in mm."""
    return _UNITS.of(value, row.measure.is_angle)


def text(value: float, digits: int = 4) -> str:
    return f"{value:.{digits}f}" if np.isfinite(value) else ""
