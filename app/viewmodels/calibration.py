"""Estimated parameters with their uncertainty and how far each has settled."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.messages import Array, Calibration

# Prior standard deviations and those at which a parameter counts as settled: the bar runs between
# them on a logarithmic scale, as a filter's uncertainty falls by factors.
RANGES = {
    "scale": (0.07, 0.01),
    "mounting": (np.deg2rad(8.0), np.deg2rad(2.0)),
    "gyro_bias": (np.deg2rad(3.0), np.deg2rad(0.1)),
    "accel_bias": (0.4, 0.03),
}
ADVICE = {
    "scale": "Spread the fingers and turn the hand before the camera: sizes settle.",
    "mounting": "Bend and stretch the fingers and turn the wrist: the mounting of IMUs settles.",
    "gyro_bias": "Hold the hand still for three seconds: gyro biases settle.",
    "accel_bias": "Hold the hand at several slants: accelerometer biases settle.",
}
SETTLED = 0.9


@dataclass(frozen=True)
class Cell:
    """One parameter of one segment: its text, tooltip and convergence 0..1 (NaN: has none)."""

    text: str
    tip: str
    convergence: float


@dataclass(frozen=True)
class Row:
    segment: str
    cells: tuple[Cell, ...]  # scale, mounting, gyro bias, accel bias


@dataclass(frozen=True)
class CalibrationView:
    rows: tuple[Row, ...]
    hand_length: str
    convergence: float
    advice: str


def convergence(sd: Array, kind: str) -> float:
    """0 at the prior's uncertainty, 1 where settled; the worst of the known components."""
    known = sd[np.isfinite(sd) & (sd > 0)]
    if len(known) == 0:
        return float("nan")
    start, end = RANGES[kind]
    share = np.log(start / known.max()) / np.log(start / end)
    return float(np.clip(share, 0.0, 1.0))


def _figures(values: Array, sd: Array, factor: float, pattern: str) -> str:
    parts = [
        f"{pattern.format(v * factor)} ± {2 * s * factor:.2g}"
        for v, s in zip(values, sd, strict=True)
        if np.isfinite(v) and np.isfinite(s)
    ]
    return ", ".join(parts)


def _cell(values: Array, sd: Array, kind: str) -> Cell:
    """The norm (scale: the component along the bone) in the cell, all components in the tip."""
    known = np.isfinite(values)
    if not known.any():
        return Cell("", "", float("nan"))
    deg = np.rad2deg(1.0)
    factor, pattern, unit = {
        "scale": (1.0, "{:.3f}", ""),
        "mounting": (deg, "{:.1f}", "°"),
        "gyro_bias": (deg, "{:.2f}", "°/s"),
        "accel_bias": (1000 / 9.80665, "{:.0f}", "mg"),
    }[kind]
    if kind == "scale":
        value, spread = float(values[known][0]), float(sd[known][0])
    else:
        value, spread = float(np.linalg.norm(values[known])), float(np.nanmax(sd))
    text = f"{pattern.format(value * factor)} ± {2 * spread * factor:.2g} {unit}".strip()
    return Cell(text, _figures(values, sd, factor, pattern), convergence(sd, kind))


def calibration_view(c: Calibration) -> CalibrationView:
    kinds = tuple(RANGES)
    rows = tuple(
        Row(
            segment.replace("_", " "),
            tuple(_cell(getattr(c, k)[i], getattr(c, f"{k}_sd")[i], k) for k in kinds),
        )
        for i, segment in enumerate(c.segments)
    )
    means = {k: _mean([r.cells[j].convergence for r in rows]) for j, k in enumerate(kinds)}
    known = {k: m for k, m in means.items() if np.isfinite(m)}
    overall = _mean(list(known.values()))
    worst = min(known, key=lambda k: known[k], default=None)
    settled = worst is None or known[worst] >= SETTLED
    advice = "Everything has settled." if settled or worst is None else ADVICE[worst]
    length = "–"
    if np.isfinite(c.hand_length):
        length = f"{c.hand_length * 1000:.1f} ± {2 * c.hand_length_sd * 1000:.1f} mm"
    return CalibrationView(rows, length, overall, advice)


def _mean(values: list[float]) -> float:
    known = [v for v in values if np.isfinite(v)]
    return float(np.mean(known)) if known else float("nan")
