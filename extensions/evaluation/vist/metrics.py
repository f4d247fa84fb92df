"""Errors of tracked keypoints against the truth, as Lee et al. 2021 report them.

The paper's 3D-PCK is the share of instants at which the *worst* of the four keypoints is within a
bound. Means are over all keypoints and instants, so that long trials do not outweigh their people.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from scipy import stats

from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Array, IntArray

TIPS = 3  # number of fingertips, which are the first keypoints

JOINTS = (
    "thumb_cmc",
    "thumb_mcp",
    "thumb_ip",
    *(f"{f}_{joint}" for f in ("index", "middle") for joint in ("mcp", "pip", "dip")),
)
"""Joints of the digits that the paper's glove measures."""

DIGITS = ("thumb", "index", "middle")
"""Digits whose joint angles are evaluated."""

PCK_BOUNDS_MM = np.arange(0.0, 51.0)


@dataclass(frozen=True, eq=False)
class WholeHandErrors:
    """All K keypoints of a trial by ``names``: error (n, K) m, NaN where lost, sd (n, K) m per
    coordinate, and state (n, K), a `Validity`."""

    names: tuple[str, ...]
    error: Array
    sd: Array
    state: IntArray


@dataclass(frozen=True, eq=False)
class Trial:
    """One participant tracked once, n evaluated instants; columns as in `MARKED_KEYPOINTS`.

    error (n, 4) m, NaN where lost; joints (n, 9) m, errors of `JOINTS`; angles (n, j) rad, errors
    of the joint angles of `DIGITS`; sd (n, 4) m, the engine's standard deviation per coordinate;
    seen (n,), markers matched in both images of the latest exposure; matches and wrong_matches
    count blobs; core_s is the processor time of the tracker; ``whole``: all keypoints, where their
    positions are evaluated in the world.
    """

    participant: int
    hand_length: float
    t: Array
    error: Array
    sd: Array
    joints: Array
    seen: IntArray
    matches: int
    wrong_matches: int
    core_s: float
    duration: float
    angles: Array = field(default_factory=lambda: np.zeros((0, 0)))
    whole: WholeHandErrors | None = None


@dataclass(frozen=True)
class Summary:
    """Figures of several participants; lengths in mm, shares in percent unless stated."""

    participants: int
    mean_mm: float
    tips_mm: float
    joints_mm: float
    sd_mm: float
    within_sd_mm: float
    between_sd_mm: float
    ci95_mm: tuple[float, float]
    pck20: float
    pck35: float
    keypoints: dict[str, float]
    keypoints_ci95_mm: dict[str, tuple[float, float]]
    matched_mean: float
    wrong_match_rate: float  # share, 0..1
    nees_per_dof: float
    within_3sd: float  # share of keypoints, 0..1, see `within_3sd`
    angles_deg: float
    worst_angles_deg: float  # of the participant with the largest errors
    core_s_per_s: float
    lost: float  # share of instants without an estimate, 0..1


def summarise(trials: Sequence[Trial]) -> Summary:
    """The paper's figures over all participants. Raises ValueError without any."""
    if not trials:
        raise ValueError("no trials to summarise")
    pooled = np.concatenate([_present(t) for t in trials]) * 1000
    of_each = [_present(t) * 1000 for t in trials if len(_present(t))]
    means = np.array([e.mean() for e in of_each])
    by_keypoint = np.array([e.mean(axis=0) for e in of_each]).reshape(-1, len(MARKED_KEYPOINTS))
    instants = sum(len(t.t) for t in trials)
    angles = _finite(np.rad2deg([_mean(_finite(t.angles.ravel())) for t in trials]))
    matches = sum(t.matches for t in trials)
    return Summary(
        participants=len(trials),
        mean_mm=_mean(pooled),
        tips_mm=_mean(pooled[:, :TIPS]),
        joints_mm=_mean(1000 * _finite(np.concatenate([t.joints.ravel() for t in trials]))),
        sd_mm=float(pooled.std()) if pooled.size else np.nan,
        within_sd_mm=_mean(np.array([e.std() for e in of_each])),
        between_sd_mm=float(means.std(ddof=1)) if len(means) > 1 else np.nan,
        ci95_mm=confidence_interval(means),
        pck20=pck(trials, 20.0),
        pck35=pck(trials, 35.0),
        keypoints={k: _mean(pooled[:, i]) for i, k in enumerate(MARKED_KEYPOINTS)},
        keypoints_ci95_mm={
            k: confidence_interval(by_keypoint[:, i]) for i, k in enumerate(MARKED_KEYPOINTS)
        },
        matched_mean=_mean(np.concatenate([t.seen for t in trials]).astype(float)),
        wrong_match_rate=sum(t.wrong_matches for t in trials) / matches if matches else np.nan,
        nees_per_dof=nees_per_dof(trials),
        within_3sd=within_3sd(trials),
        angles_deg=_mean(angles),
        worst_angles_deg=float(angles.max()) if angles.size else np.nan,
        core_s_per_s=sum(t.core_s for t in trials) / sum(t.duration for t in trials),
        lost=1 - len(pooled) / instants if instants else np.nan,
    )


def _present(trial: Trial) -> Array:
    """Errors (k, 4) m of the instants at which no keypoint is lost."""
    return trial.error[np.all(np.isfinite(trial.error), axis=1)]


def _finite(values: Array) -> Array:
    return values[np.isfinite(values)]


def _mean(values: Array) -> float:
    return float(values.mean()) if values.size else float("nan")


def confidence_interval(means: Array, level: float = 0.95) -> tuple[float, float]:
    """Student's interval of the mean over participants; NaN with fewer than two."""
    if len(means) < 2:
        return (float("nan"), float("nan"))
    half = stats.t.ppf(0.5 + level / 2, len(means) - 1) * stats.sem(means)
    return float(means.mean() - half), float(means.mean() + half)


def pck(trials: Sequence[Trial], bound_mm: float) -> float:
    """3D-PCK in percent: instants with all keypoints within the bound; lost ones are outside."""
    worst = np.concatenate([t.error.max(axis=1) for t in trials]) * 1000
    return float(np.mean(worst <= bound_mm) * 100) if len(worst) else float("nan")


def pck_curve(trials: Sequence[Trial]) -> Array:
    """3D-PCK (51,) at each of `PCK_BOUNDS_MM`."""
    return np.array([pck(trials, float(b)) for b in PCK_BOUNDS_MM])


def nees_per_dof(trials: Sequence[Trial]) -> float:
    """Normalised estimation error squared (NEES) per coordinate; 1 if the variance is correct.

    ``sd`` is per coordinate, so a keypoint's squared distance is divided by three variances.
    """
    ratio = np.concatenate(
        [(t.error**2 / (3 * np.maximum(t.sd, 1e-9) ** 2)).ravel() for t in trials]
    )
    ratio = ratio[np.isfinite(ratio)]
    return _mean(ratio)


def within_3sd(trials: Sequence[Trial]) -> float:
    """Share of keypoints with errors of at most three of the engine's standard deviations.

    ``sd`` is the root of the mean variance over three axes; the standard deviation of the distance
    is √3 times larger, also for an error along a single axis, as with one camera along its ray.
    """
    off = np.concatenate(
        [(t.error / (np.sqrt(3) * np.maximum(t.sd, 1e-9))).ravel() for t in trials]
    )
    return _mean((_finite(off) <= 3.0).astype(float))


@dataclass(frozen=True, eq=False)
class BySeen:
    """Share of instants and mean error (mm) by the number of matched markers."""

    seen: IntArray
    share: Array
    mean_mm: Array


def by_seen(trials: Sequence[Trial]) -> BySeen:
    """The paper's Fig. 3E."""
    seen = np.concatenate([t.seen for t in trials])
    error = np.concatenate([t.error.mean(axis=1) for t in trials]) * 1000
    values = np.arange(int(seen.max()) + 1 if len(seen) else 0)
    share = np.array([np.mean(seen == v) for v in values])
    mean = np.array([_mean(error[(seen == v) & np.isfinite(error)]) for v in values])
    return BySeen(values, share, mean)
