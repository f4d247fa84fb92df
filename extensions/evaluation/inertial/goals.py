"""The goals of the experiment with their measured figures."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from extensions.evaluation.inertial.broad import BroadRow
from extensions.evaluation.inertial.experiment import ErrorRow, crossover, curve
from tracker.messages import Array

RATE_HZ = 100.0  # the paper's own figures
PAPER = ("gravity", "integration", "switching", "madgwick", "madgwick_adaptive")
GLOVE_QUARTER = 0.25


@dataclass(frozen=True)
class Goal:
    """A goal, its measured figure and whether it is reached."""

    what: str
    wanted: str
    measured: str
    reached: bool


def goals(rows: list[ErrorRow], broad: list[BroadRow], cost_us: dict[str, float]) -> list[Goal]:
    """All goals that the rows can verify."""
    out = [*_crossing(rows), *_envelope(rows), *_ours(rows), *_beta(rows), *_compensation(rows)]
    return [*out, *_broad(broad), *_cost(cost_us)]


def _has(rows: list[ErrorRow], series: str, rate_hz: float) -> bool:
    return any(r.series == series and r.rate_hz == rate_hz for r in rows)


def _crossing(rows: list[ErrorRow]) -> list[Goal]:
    t = crossover(rows, "both", RATE_HZ)
    if t is None:
        return []
    return [Goal("integration and gravity cross", "1.2 to 1.4 s", f"{t:.2f} s", 1.2 <= t <= 1.4)]


def _envelope(rows: list[ErrorRow]) -> list[Goal]:
    if not _has(rows, "both", RATE_HZ):
        return []
    better = _best(rows, ("gravity", "integration"))
    ratio = curve(rows, "both", RATE_HZ, "switching_offset")[1] / better
    worst = float(ratio.max())
    return [
        Goal(
            "switching with the offset term against the better of gravity and integration",
            "at most 1.05 at every duration",
            f"at most {worst:.3f}",
            worst <= 1.05,
        )
    ]


def _ours(rows: list[ErrorRow]) -> list[Goal]:
    if not _has(rows, "both", RATE_HZ):
        return []
    t_m, ours = curve(rows, "both", RATE_HZ, "learned")
    ratio = ours / _best(rows, PAPER)
    late = float(ratio[t_m >= 0.3].max())
    worst = float(ratio.max())
    return [
        Goal(
            "learned against the best of the paper's, t_m from 0.3 s",
            "at most a tenth",
            f"at most {late:.4f}",
            late <= 0.1,
        ),
        Goal("and anywhere", "no worse", f"at most {worst:.3f}", worst <= 1.0),
    ]


def _best(rows: list[ErrorRow], names: tuple[str, ...]) -> Array:
    return np.min([curve(rows, "both", RATE_HZ, n)[1] for n in names], axis=0)


def _beta(rows: list[ErrorRow]) -> list[Goal]:
    """Small β against large β at the shortest and at the longest motion."""
    if not _has(rows, "both", RATE_HZ):
        return []
    small = curve(rows, "both", RATE_HZ, "madgwick_central_0.033")[1]
    large = curve(rows, "both", RATE_HZ, "madgwick_central_0.33")[1]
    return [
        Goal(
            "β trade-off: error with β 0.033 over error with β 0.33",
            "below 1 on the fastest motion, above on the slowest",
            f"{small[0] / large[0]:.2f} and {small[-1] / large[-1]:.1f}",
            bool(small[0] < large[0] and small[-1] > large[-1]),
        )
    ]


def _compensation(rows: list[ErrorRow]) -> list[Goal]:
    """Compensated over plain Madgwick, noise only, at the duration next to 1 s."""
    out = []
    for rate_hz, wanted in ((1000.0, 0.2), (100.0, None)):
        for beta in ("0.1", "0.33") if _has(rows, "white", rate_hz) else ():
            t_m, plain = curve(rows, "white", rate_hz, f"madgwick_plain_{beta}")
            i = int(np.argmin(np.abs(np.log(t_m))))
            central = curve(rows, "white", rate_hz, f"madgwick_central_{beta}")[1][i] / plain[i]
            backward = curve(rows, "white", rate_hz, f"madgwick_backward_{beta}")[1][i] / plain[i]
            out.append(
                Goal(
                    f"compensated over plain Madgwick, noise only, {rate_hz:g} Hz, β {beta},"
                    f" t_m {t_m[i]:.2f} s",
                    "below 0.2" if wanted else "said",
                    f"{central:.3f} (backward differences {backward:.3f})",
                    wanted is None or bool(central < wanted),
                )
            )
    return out


def _broad(broad: list[BroadRow]) -> list[Goal]:
    by = {(r.trial, r.estimator): r.inclination_deg for r in broad}
    ratios = {
        trial: by[trial, "segments"] / by[trial, "vqf"]
        for trial, name in by
        if name == "vqf" and "undisturbed" in trial and (trial, "segments") in by
    }
    if not ratios:
        return []
    worst = max(ratios.values())
    each = ", ".join(f"{trial.split('_')[0]} {ratio:.3f}" for trial, ratio in ratios.items())
    return [
        Goal(
            "inclination on undisturbed BROAD trials over VQF's", "at most 1.1", each, worst <= 1.1
        )
    ]


def _cost(cost_us: dict[str, float]) -> list[Goal]:
    if "vqf_7" not in cost_us:
        return []
    ratio = cost_us["segments_7"] / cost_us["vqf_7"]
    return [
        Goal(
            "seven sensors, one update, over seven of VQF's",
            "at most 0.25",
            f"{ratio:.3f} ({cost_us['segments_7']:.2f} over {cost_us['vqf_7']:.2f} µs)",
            ratio <= GLOVE_QUARTER,
        )
    ]
