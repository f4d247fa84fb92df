"""The table of `glovetrack evaluate vist`: rows for JSON and lines of text."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from extensions.evaluation.session_names import SESSIONS
from extensions.evaluation.vist.agreement import agreement
from extensions.evaluation.vist.cases import GUIDED, PAPERS_GLOVE, Case
from extensions.evaluation.vist.metrics import Summary, Trial, summarise
from extensions.evaluation.vist.paper import PAPER


def row_of(case: Case, trials: Sequence[Trial]) -> dict[str, Any]:
    """One row for ``--json``; missing figures are null."""
    summary = summarise(trials)
    row: dict[str, Any] = {
        "experiment": case.experiment,
        "engine": case.engine,
        "ablation": case.ablation,
        "level": case.level,
        "motion": "recorded" if case.motion_files else "postures",
        "minutes": case.minutes,
        "fps": case.fps,
        "seed": case.seed,
        "distractors": case.distractors,
        "light": case.light or None,
        "guided": case.guided,
        "glove": case.glove,
        "wearer": case.wearer,
        "lenses": case.lenses,
        "measured": case.measured,
        "session": case.session,
        "smoothed": case.smoothed,
        "all_keypoints": [asdict(a) for a in agreement(trials)],
    }
    row.update(asdict(summary))
    row["paper"] = PAPER.get(case.experiment)
    return {key: _plain(value) for key, value in row.items()}


def _plain(value: Any) -> Any:
    """The value with NaN replaced by None, since JSON has no NaN."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    return value


HEAD = (
    "experiment  engine  variant                            mean ± sd       tips joints  pck20"
    "  pck35  seen  wrong%  nees  3sd%   deg  core"
)


def line_of(case: Case, summary: Summary) -> str:
    """One row as text."""
    return (
        f"{case.experiment:<11} {case.engine:<7} {_variant(case):<32} "
        f"{summary.mean_mm:6.2f} ± {summary.sd_mm:5.2f} mm "
        f"{summary.tips_mm:6.2f} {summary.joints_mm:6.2f} {summary.pck20:6.1f} "
        f"{summary.pck35:6.1f} {summary.matched_mean:5.1f} "
        f"{_known(100 * summary.wrong_match_rate, 7)} {_known(summary.nees_per_dof, 5)} "
        f"{_known(100 * summary.within_3sd, 5)} {_known(summary.angles_deg, 5)} "
        f"{summary.core_s_per_s:5.3f}"
    )


def _known(value: float, width: int) -> str:
    """The value with two decimals, or a dash if it is unknown."""
    return f"{value:{width}.2f}" if math.isfinite(value) else f"{'–':>{width}}"


def _variant(case: Case) -> str:
    parts = [case.ablation] if case.ablation else []
    if case.lenses != "both":
        parts.append("one camera" if case.lenses == "one" else "no camera")
    if case.measured:
        parts.append("hand measured")
    if case.session:
        parts.append(SESSIONS[case.session])
    if case.smoothed:
        parts.append("smoothed")
    if case.guided:
        parts.append(GUIDED[case.guided])
    if case.wearer:
        parts.append(f"profile {Path(case.wearer).stem}")
    if case.glove != PAPERS_GLOVE:
        parts.append(case.glove)
    if case.level == "images":
        parts.append(f"images, {case.light} light" if case.light else "images")
    if case.distractors:
        parts.append(f"{case.distractors} balls")
    return ", ".join(parts) or "-"


def paper_line(experiment: str) -> str:
    """The published figures of an experiment, in the columns of `line_of`."""
    p = PAPER[experiment]
    sd = p.get("sd_mm")
    plus_minus = f"± {sd:5.2f} mm" if isinstance(sd, float) else "          "
    seen = p.get("matched_mean")
    return (
        f"{experiment:<11} {'paper':<7} {'(people)':<32} {p['mean_mm']:6.2f} {plus_minus} "
        f"{'':13} {p['pck20']:6.1f} {p['pck35']:6.1f} {seen if seen is not None else '':>5}"
    )
