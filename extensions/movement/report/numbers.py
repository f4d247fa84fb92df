"""The values of a report as JSON: angles in degrees, distances in mm."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from extensions.movement.report.measure import MeasuredTake, Row
from extensions.movement.report.table import scaled


def as_json(takes: Sequence[MeasuredTake]) -> dict[str, Any]:
    """``hand`` by side for one session; for several, ``sessions`` is a list of such objects."""
    sessions: dict[int, dict[str, Any]] = {}
    for measured in takes:
        found = sessions.setdefault(measured.session, {"hand": {}})
        found["hand"][measured.side] = _hand(measured)
    if len(sessions) == 1:
        return next(iter(sessions.values()))
    return {"sessions": list(sessions.values())}


def _hand(measured: MeasuredTake) -> dict[str, Any]:
    recorded = [r for r in measured.rows if r.measure.is_angle and not r.isb]
    isb = [r for r in measured.rows if r.isb]
    apart = [r for r in measured.rows if not r.measure.is_angle]
    return {
        "take": measured.name,
        "duration_s": measured.seconds,
        "angles": {r.measure.name: _row(r, "deg") for r in recorded},
        "isb_angles": {r.measure.name: _row(r, "deg") for r in isb},
        "aperture_mm": {r.measure.name: _row(r, "mm") for r in apart},
        "measured_percent": _percent([r.measure.measured for r in recorded]),
        "lost_percent": _percent([r.measure.lost for r in recorded]),
    }


def _row(row: Row, unit: str) -> dict[str, float | int]:
    m, c = row.measure, row.course
    values = {"min": m.least, "max": m.greatest, "range": m.range, "sd": m.sd}
    named = {f"{name}_{unit}": scaled(row, value) for name, value in values.items()}
    peak = scaled(row, c.fastest)
    return {**named, f"peak_{unit}_s": peak, "repetitions": int(c.repetitions)}


def _percent(shares: Sequence[float]) -> float:
    """Mean over the recorded angles in percent."""
    return 100.0 * float(np.mean(shares)) if shares else float("nan")
