"""The command ``evaluate touch``: the touch test's figures beside the true error of the tracker."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from extensions.touch.command import EvaluateTouchArguments
from extensions.touch.simulated.trial import FAULTS, WearerFigures, run_trial
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.base.workers import WorkItem, run_all, some_workers
from tracker.engine.kinds import ENGINES

BIAS_GOAL_MM, SD_GOAL = 0.5, 0.15
"""Goals: mean difference of the bias along each axis, and relative difference of the pooled
standard deviation."""


TURNS = (0, 1, 2, 3, 0)
"""Number of the fault of each of five wearers, one after the other: two have none."""


def evaluate_touch(args: EvaluateTouchArguments) -> int:
    """Let the wearers take the test and print the figures."""
    check_json(args)
    ENGINES.get(args.engine)  # raises ConfigError if the name is unknown
    if args.wearers < 1:
        raise ConfigError(notice("option.least", option="--wearers", least=1))
    tasks = [
        WorkItem(run_trial, (args.seed + k, FAULTS[TURNS[k % len(TURNS)]], args.engine))
        for k in range(args.wearers)
    ]
    with some_workers(max(1, min(args.processes, args.wearers))) as workers:
        outcomes = run_all(tasks, workers, progress_line(f"tracking {args.wearers} wearers"))
    failed = [outcome.error for outcome in outcomes if outcome.error]
    if failed:
        raise ConfigError(failed[0])
    rows = [outcome.value for outcome in outcomes]
    found = summary(rows)
    finish(args, found, table(rows, found))
    return 0 if found["ok"] else 1


def summary(rows: Sequence[WearerFigures]) -> dict[str, Any]:
    """JSON values: each wearer, the differences pooled over all, and whether the goals are met."""
    fingers = [f for r in rows for f in r.fingers]
    off = np.array([f.bias_found for f in fingers]) - np.array([f.bias_true for f in fingers])
    dof = np.array([f.touches - 1 for f in fingers])
    pooled = [
        float(np.sqrt(dof @ np.array([getattr(f, name) ** 2 for f in fingers]) / dof.sum()))
        for name in ("sd_found", "sd_true")
    ]
    faulty = {name: [r for r in rows if r.fault == name] for name in ("print", "camera")}
    right = [r for r in rows if r.fault in ("none", "glove")]
    mean = off.mean(axis=0)
    lengths = np.array([[np.linalg.norm(f.bias_found), np.linalg.norm(f.bias_true)]
                        for f in fingers])  # fmt: skip
    ratio = pooled[0] / pooled[1]
    return {
        "rows": [asdict(r) for r in rows],
        "bias_off_mm": [float(v) for v in mean],
        "bias_off_rms_mm": float(np.sqrt(np.mean(off**2))),
        "bias_length_found_mm": float(lengths[:, 0].mean()),
        "bias_length_true_mm": float(lengths[:, 1].mean()),
        "sd_found_mm": pooled[0],
        "sd_true_mm": pooled[1],
        "sd_ratio": ratio,
        "touches": sum(f.touches for f in fingers),
        "missed": sum(r.missed for r in rows),
        "print_said": _contradicting(faulty["print"], "touch.print_scale"),
        "print_said_with_ruler": _contradicting(faulty["print"], "touch.print_scale", ruler=True),
        "camera_said": _contradicting(faulty["camera"], "touch.print_scale"),
        "camera_said_with_ruler": _contradicting(
            faulty["camera"], "touch.camera_scale", ruler=True
        ),
        "said_wrongly": _contradicting(right, "touch.print_scale"),
        "ok": bool(np.abs(mean).max() <= BIAS_GOAL_MM and abs(ratio - 1) <= SD_GOAL),
    }


def _contradicting(rows: Sequence[WearerFigures], code: str, ruler: bool = False) -> list[int]:
    """Number of wearers with a notice, and of all wearers."""
    given = [code in (r.codes_ruler if ruler else r.codes) for r in rows]
    return [sum(given), len(given)]


def table(rows: Sequence[WearerFigures], found: dict[str, Any]) -> list[str]:
    """The table as lines of text."""
    lines = [f"{'wearer':>6} {'wrong':<7}{'finger':<8}{'bias found, mm':>21}{'true, mm':>21}"
             f"{'sd found':>10}{'sd true':>9}"]  # fmt: skip
    for r in rows:
        for f in r.fingers:
            bias = ["".join(f"{v:7.1f}" for v in b) for b in (f.bias_found, f.bias_true)]
            lines.append(
                f"{r.seed:>6} {r.fault:<7}{f.finger:<8}{bias[0]}{bias[1]}"
                f"{f.sd_found:>10.2f}{f.sd_true:>9.2f}"
            )
    off = ", ".join(f"{v:.2f}" for v in found["bias_off_mm"])
    said = {k: "{} of {}".format(*found[k]) for k in found if "said" in k}
    return [
        *lines,
        f"bias found less true, mean along x, y, z: {off} mm, "
        f"RMS {found['bias_off_rms_mm']:.2f} mm",
        f"pooled sd: found {found['sd_found_mm']:.2f}, true {found['sd_true_mm']:.2f} mm, "
        f"ratio {found['sd_ratio']:.2f}; {found['missed']} touches missed",
        f"wrong print reported: {said['print_said']}; wrong camera, as a difference of scale: "
        f"{said['camera_said']}, with a ruler as the camera's: {said['camera_said_with_ruler']}; "
        f"reported without reason: {said['said_wrongly']}",
    ]
