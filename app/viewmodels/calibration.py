"""Estimated calibration parameters with their uncertainty and convergence."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.engines.snapshot import Snapshot
from app.viewmodels.names import bone, display_name
from app.words import local, mark, tr
from tracker import GRAVITY
from tracker.messages import Array, Calibration, Status

# Prior standard deviations and those at which a parameter counts as settled: the bar shows the
# range between them on a logarithmic scale, since a filter's uncertainty decreases by factors.
RANGES = {
    "scale": (0.07, 0.01),
    "mounting": (np.deg2rad(8.0), np.deg2rad(2.0)),
    "gyro_bias": (np.deg2rad(3.0), np.deg2rad(0.1)),
    "accel_bias": (0.4, 0.03),
}
ADVICE = {
    "scale": mark(
        "Spread the fingers and turn the hand in front of the camera so that sizes settle "
        "(least certain: {})."
    ),
    "mounting": mark(
        "Bend and stretch the fingers and turn the wrist so that the mounting of IMUs settles "
        "(least certain: {})."
    ),
    "gyro_bias": mark(
        "Hold the hand still for three seconds so that gyro biases settle (least certain: {})."
    ),
    "accel_bias": mark(
        "Hold the hand at several tilts so that accelerometer biases settle (least certain: {})."
    ),
}
MEASURE = mark(
    "A single camera cannot determine the size of the hand. Measure it with a ruler and "
    "enter it under Hand length…"
)
SETTLED = 0.9
MEASURED = 0.02  # relative to the hand's length: the accuracy of a ruler


@dataclass(frozen=True)
class CalibrationCell:
    """One parameter of one segment: its text, tool tip and convergence 0..1 (NaN: no such
    parameter)."""

    text: str
    tip: str
    convergence: float


@dataclass(frozen=True)
class CalibrationRow:
    """``bone``: the name of the segment for use in a sentence."""

    segment: str
    bone: str
    cells: tuple[CalibrationCell, ...]  # scale, mounting, gyro bias, accel bias


@dataclass(frozen=True)
class CalibrationView:
    rows: tuple[CalibrationRow, ...]
    hand_length: str
    convergence: float
    advice: str


def convergence(sd: Array, kind: str) -> float:
    """0 at the prior's uncertainty, 1 when settled; the worst of the known components."""
    known = sd[np.isfinite(sd) & (sd > 0)]
    if len(known) == 0:
        return float("nan")
    start, end = RANGES[kind]
    share = np.log(start / known.max()) / np.log(start / end)
    return float(np.clip(share, 0.0, 1.0))


@dataclass(frozen=True)
class _Kind:
    """Format of a parameter: ``factor`` converts from SI to the displayed unit."""

    factor: float
    pattern: str
    unit: str


_KINDS = {
    "scale": _Kind(1.0, "{:.3f}", ""),
    "mounting": _Kind(float(np.rad2deg(1.0)), "{:.1f}", "°"),
    "gyro_bias": _Kind(float(np.rad2deg(1.0)), "{:.2f}", "°/s"),
    "accel_bias": _Kind(1000 / GRAVITY, "{:.0f}", "mg"),
}


def _figures(values: Array, sd: Array, kind: _Kind) -> str:
    """All known components with 2σ."""
    parts = [
        f"{kind.pattern.format(local(v * kind.factor))} ± {local(2 * s * kind.factor):.2g}"
        for v, s in zip(values, sd, strict=True)
        if np.isfinite(v) and np.isfinite(s)
    ]
    return f"{', '.join(parts)} {kind.unit}".strip()


def _one(values: Array, name: str) -> float:
    """One value for the components (3,): the scale along the bone, otherwise the norm."""
    known = values[np.isfinite(values)]
    return float(known[0]) if name == "scale" else float(np.linalg.norm(known))


def _cell(c: Calibration, i: int, name: str, reference: Calibration | None) -> CalibrationCell:
    """A cell with one value, and all components in the tool tip; with ``reference`` the change
    since then."""
    values, sd = getattr(c, name)[i], getattr(c, f"{name}_sd")[i]
    if not np.isfinite(values).any():
        return CalibrationCell("", "", float("nan"))
    kind, worst = _KINDS[name], float(np.nanmax(sd))
    if name == "scale":
        worst = float(sd[0])
    settled = convergence(sd, name)
    figures = _figures(values, sd, kind)
    before = _row_of(reference, c.segments[i], name) if reference is not None else None
    if before is not None:
        old, old_sd = before
        return _change(values - old, np.hypot(sd, old_sd), name, figures, settled)
    one, worst_sd = _one(values, name) * kind.factor, 2 * worst * kind.factor
    text = f"{kind.pattern.format(local(one))} ± {local(worst_sd):.2g}"
    return CalibrationCell(f"{text} {kind.unit}".strip(), figures, settled)


def _row_of(c: Calibration, segment: str, name: str) -> tuple[Array, Array] | None:
    """Values and standard deviations (3,) of a segment, if they are known."""
    if segment not in c.segments:
        return None
    i = c.segments.index(segment)
    values = getattr(c, name)[i]
    return (values, getattr(c, f"{name}_sd")[i]) if np.isfinite(values).any() else None


def _change(
    difference: Array, sd: Array, name: str, figures: str, settled: float
) -> CalibrationCell:
    """The change; marked if it exceeds the uncertainties of both."""
    kind = _KINDS[name]
    clear = bool(np.any(np.abs(difference) > 2 * sd))
    one = _one(difference, name) * kind.factor
    sign = "+" if name == "scale" and one >= 0 else ""
    text = f"{'▲ ' if clear else ''}Δ {sign}{kind.pattern.format(local(one))} {kind.unit}".strip()
    word = tr("more than 2σ of both") if clear else tr("within 2σ of both")
    change = _figures(difference, sd, kind)
    tip = tr("now {}\nchange {}: {}").format(figures, change, word)
    return CalibrationCell(text, tip, settled)


def calibration_view(
    c: Calibration, reference: Calibration | None = None, one_camera: bool = False
) -> CalibrationView:
    """``reference``: an earlier fit for comparison. ``one_camera``: the hand's size comes from a
    ruler or an earlier session, not from motion."""
    kinds = tuple(RANGES)
    rows = tuple(
        CalibrationRow(
            display_name(segment), bone(segment), tuple(_cell(c, i, k, reference) for k in kinds)
        )
        for i, segment in enumerate(c.segments)
    )
    shares = {k: [r.cells[j].convergence for r in rows] for j, k in enumerate(kinds)}
    means = {k: _mean(v) for k, v in shares.items()}
    overall = _mean(list(means.values()))
    if one_camera and not is_measured(c):
        advice = tr(MEASURE)
    else:
        if one_camera:
            del means["scale"]  # cannot improve any further
        advice = _advice(rows, means, shares)
    return CalibrationView(rows, _length(c, reference), overall, advice)


def has_one_camera(view: Snapshot) -> bool:
    """Whether only one camera provides positions: there is no other, or its images show no markers,
    as those of an infrared camera."""
    if view.setup.camera.rig.one_camera:
        return True
    in_both = view.status.values.get("stereo_points") if view.status is not None else None
    return in_both == 0 and view.calibration is not None and not is_measured(view.calibration)


def is_measured(c: Calibration) -> bool:
    """Whether the hand's length is known at least as accurately as from a ruler."""
    return bool(c.hand_length_sd <= MEASURED * c.hand_length)


def _advice(
    rows: tuple[CalibrationRow, ...], means: dict[str, float], shares: dict[str, list[float]]
) -> str:
    """The motion that helps the least certain parameter, and its segment."""
    known = {k: m for k, m in means.items() if np.isfinite(m)}
    worst = min(known, key=lambda k: known[k], default=None)
    if worst is None or known[worst] >= SETTLED:
        return tr("Everything has settled.")
    least = int(np.nanargmin(shares[worst]))
    return tr(ADVICE[worst]).format(rows[least].bone)


def _length(c: Calibration, reference: Calibration | None) -> str:
    if not np.isfinite(c.hand_length):
        return "–"
    text = f"{local(c.hand_length * 1000):.1f} ± {local(2 * c.hand_length_sd * 1000):.1f} mm"
    if reference is None or not np.isfinite(reference.hand_length):
        return text
    return f"{text}, Δ {local((c.hand_length - reference.hand_length) * 1000):+.1f}"


def _mean(values: list[float]) -> float:
    known = [v for v in values if np.isfinite(v)]
    return float(np.mean(known)) if known else float("nan")


def camera_time(status: Status | None) -> str:
    """Delay of the image time stamps relative to the glove, with 2σ, and whether it is
    corrected."""
    v = status.values if status is not None else {}
    late_ms, sd_ms = v.get("camera_offset_ms"), v.get("camera_offset_sd_ms")
    if late_ms is None or sd_ms is None:
        return tr("not known yet; turn the hand")
    word = tr("late") if late_ms >= 0 else tr("early")
    taken_off = v.get("camera_offset_applied_ms", 0.0)
    if not taken_off and abs(late_ms) <= 2 * sd_ms:
        return tr("none (± {:.1f} ms)").format(local(2 * sd_ms))
    applied = tr("corrected") if taken_off else tr("not corrected")
    size = tr("{:.1f} ± {:.1f} ms").format(local(abs(late_ms)), local(2 * sd_ms))
    return tr("{} {}, {}").format(size, word, applied)


def right_camera_time(status: Status | None) -> str:
    """Delay of the right one of two separate cameras; empty if they are synchronized or it is
    unknown."""
    v = status.values if status is not None else {}
    late_ms, applied_ms = v.get("right_camera_late_ms"), v.get("right_camera_late_applied_ms")
    if late_ms is None or not applied_ms:
        return ""
    word = tr("later") if late_ms >= 0 else tr("earlier")
    return tr("both images arrive, the right one {:.1f} ms {} (corrected)").format(
        local(abs(late_ms)), word
    )
