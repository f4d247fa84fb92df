"""What the dialogs show, as texts in the user's language."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from app.viewmodels.names import display_name
from app.viewmodels.recording import position_text
from app.viewmodels.states import VALIDITY, WARN
from app.words import SIDES, local, mark, notice_text, tr
from extensions.reference.recognition import RecognisedPoints
from extensions.reference.session import Described
from extensions.reference.window.jobs import WorstInstant
from tracker.base.notices import Notice, Severity
from tracker.messages import Validity

WAYS = {
    "movement": mark("By movement"),
    "pulse": mark("By pulses"),
    "clock": mark("By clock"),
}
REGISTRATIONS = {
    "offsets": mark("Rigid, with marker offsets"),
    "rigid": mark("Rigid"),
    "none": mark("None (coordinates of the session)"),
}
STATES = {state.name.lower(): VALIDITY[state] for state in Validity}
MOST_NAMES = 8  # of keypoints in a sentence


def recognised_text(found: RecognisedPoints) -> str:
    """Format, length, and which keypoints the file has."""
    total = len(found.keypoints) + len(found.missing)
    parts = [
        tr("{}: {:.1f} s at {:.6g} Hz, {} points, {} of {} keypoints.").format(
            found.kind,
            local(found.duration),
            local(found.rate),
            len(found.points),
            len(found.keypoints),
            total,
        )
    ]
    if found.problem is not None:
        parts.append(notice_text(found.problem))
    elif found.missing:
        parts.append(tr("Without: {}.").format(_some([display_name(k) for k in found.missing])))
    others = [
        f"{display_name(k)} = {', '.join(points)}"
        for k, points in zip(found.keypoints, found.assigned, strict=True)
        if points != (k,)
    ]
    if others:
        parts.append(tr("Assigned: {}.").format(_some(others)))
    parts.append(tr("With start time.") if found.has_clock else tr("Without a start time."))
    if found.pulses:
        parts.append(tr("Pulses: {}.").format(found.pulses))
    return " ".join(parts)


def _some(names: Sequence[str]) -> str:
    shown = ", ".join(names[:MOST_NAMES])
    more = len(names) - MOST_NAMES
    return tr("{} and {} more").format(shown, more) if more > 0 else shown


def result_text(about: Described) -> str:
    """Time alignment and registration."""
    timing = about.timing
    text = tr("Time offset {:+.1f} ms").format(local(1e3 * timing.offset))
    if np.isfinite(timing.drift_sd):
        drift, sd = local(1e6 * timing.drift), local(1e6 * timing.drift_sd)
        text += tr(", drift {:+.1f} ± {:.1f} ppm").format(drift, sd)
    if np.isfinite(timing.residual):
        text += tr(", residual {:.1f} ms").format(local(1e3 * timing.residual))
    registered = tr("Registration: residual {:.1f} mm rigid, {:.1f} mm with marker offsets.")
    residuals = about.rigid.residual, about.with_offsets.residual
    return f"{text}.\n" + registered.format(*(local(1e3 * r) for r in residuals))


def remark_text(remark: Notice) -> str:
    """With a sign for warnings."""
    text = notice_text(remark)
    return f"{WARN.sign} {text}" if remark.severity is Severity.WARNING else text


def residual_rows(about: Described) -> list[tuple[str, str, str, str]]:
    """For each keypoint: residuals rigid and with marker offset, and the offset, in mm."""
    offsets = np.linalg.norm(about.with_offsets.offsets, axis=1)
    shown = np.where(offsets > 0, offsets, np.nan)
    rows = zip(about.keypoints, *about.residuals, shown, strict=True)
    return [(display_name(k), _mm(1e3 * a), _mm(1e3 * b), _mm(1e3 * d)) for k, a, b, d in rows]


def _mm(value: float) -> str:
    return f"{local(value):.1f}" if np.isfinite(value) else "–"


def worst_row(worst: WorstInstant) -> tuple[str, ...]:
    """Time, keypoint, error mm, state, claimed sd mm, hand, recording."""
    look = STATES[worst.state]
    return (
        position_text(worst.t),
        display_name(worst.keypoint),
        _mm(1e3 * worst.error),
        f"{look.sign} {tr(look.word)}",
        _mm(1e3 * worst.sd),
        tr(SIDES[worst.side]) if worst.side in SIDES else worst.side,
        worst.session.stem,
    )
