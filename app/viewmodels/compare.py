"""Two trackings of one movement as a table."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from app.viewmodels.names import display_name, engine_name
from app.words import local, notice_text, tr
from tracker.base.notices import Notice

SHOWN = 0.005  # mm; smaller differences are not visible in the figures


@dataclass(frozen=True, eq=False)
class Comparison:
    """``first`` and ``second`` are trackings of one movement; figures as in
    `tracker.session.compare`.

    ``errors_mm``: mean distance of each keypoint from the truth, for both; empty without truth.
    ``engines``: the engines that tracked them; ``unused``: parts of the recording that the second
    tracking did not use.
    """

    first: Path
    second: Path
    figures: dict[str, Any]
    errors_mm: tuple[dict[str, float], dict[str, float]]
    engines: tuple[str, str] = ("", "")
    unused: tuple[Notice, ...] = ()

    @property
    def names(self) -> tuple[str, str]:
        """Names that distinguish them: their engines or, if these are the same, the file names."""
        first, second = self.engines
        if first and second and first != second:
            return engine_name(first), engine_name(second)
        return self.stems

    @property
    def stems(self) -> tuple[str, str]:
        return self.first.stem, self.second.stem


@dataclass(frozen=True)
class CompareRow:
    """``difference`` between both, and the ``error`` of each against the truth, with units."""

    name: str
    difference: str
    first_error: str
    second_error: str


def rows(c: Comparison) -> list[CompareRow]:
    """All keypoints and joints, then each keypoint (mm), then each joint (degrees)."""
    f, (first, second) = c.figures, c.errors_mm
    out = [
        CompareRow(
            tr("all keypoints, mean"), _mm(f["mean_mm"]), _mm(_mean(first)), _mm(_mean(second))
        ),
        CompareRow(tr("all keypoints, largest"), _mm(f["max_mm"]), "", ""),
        CompareRow(tr("all joints, rms"), _deg(f["rms_deg"]), "", ""),
    ]
    for name, value in f["keypoints_mm"].items():
        errors = _mm(first.get(name, math.nan)), _mm(second.get(name, math.nan))
        out.append(CompareRow(display_name(name), _mm(value), *errors))
    for name, value in f["joints_rms_deg"].items():
        out.append(CompareRow(display_name(name), _deg(value), "", ""))
    return out


def summary(c: Comparison) -> str:
    """One sentence about both, and the unused data."""
    return " ".join([_in_common(c), *map(notice_text, c.unused)])


def _in_common(c: Comparison) -> str:
    f = c.figures
    if f["identical"]:
        return tr("Both are bit-identical ({} instants).").format(f["compared"])
    text = tr(
        "{} instants in common; keypoints differ by {} on average, joints by {} (rms)."
    ).format(f["compared"], _mm(f["mean_mm"]), _deg(f["rms_deg"]))
    first, second = (_mean(e) for e in c.errors_mm)
    if abs(first - second) >= SHOWN:  # false if either is unknown
        better = c.names[second < first]
        nearer = tr("{} is closer to the truth: {} on average.")
        text = f"{text} {nearer.format(better, _mm(min(first, second)))}"
    return text


def _mean(errors: dict[str, float]) -> float:
    known = [e for e in errors.values() if math.isfinite(e)]
    return sum(known) / len(known) if known else math.nan


def _mm(value: float) -> str:
    return f"{local(value):.2f} mm" if math.isfinite(value) else "–"


def _deg(value: float) -> str:
    return f"{local(value):.2f}°" if math.isfinite(value) else "–"
