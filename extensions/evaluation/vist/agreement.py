"""Whether standard deviations agree with errors, for every keypoint of the hand and each state.

If errors are normal with the stated standard deviation on every axis, 97.1 % of them are within
three standard deviations (the distribution of Maxwell), and the normalised squared error (NEES per
coordinate) is 1 on average.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from extensions.evaluation.vist.metrics import Trial
from tracker.messages import Array, Validity


@dataclass(frozen=True)
class KeypointAgreement:
    """For one keypoint in one state, "all" for both: share of the instants of the trials in it,
    mean error and median sd (mm), NEES per coordinate, and share within 3 sd."""

    keypoint: str
    state: str
    share: float
    mean_mm: float
    sd_mm: float
    nees: float
    within_3sd: float


STATES = {
    "all": (Validity.INFERRED, Validity.MEASURED),
    "measured": (Validity.MEASURED,),
    "inferred": (Validity.INFERRED,),
}


def agreement(trials: Sequence[Trial]) -> list[KeypointAgreement]:
    """For each keypoint and state that occurs, "hand" for all keypoints together last. Empty if the
    trials do not contain the whole hand."""
    whole = [t.whole for t in trials if t.whole is not None]
    if not whole:
        return []
    names = whole[0].names
    error = np.concatenate([w.error for w in whole])
    sd = np.concatenate([w.sd for w in whole])
    state = np.concatenate([w.state for w in whole])
    columns = [(name, [k]) for k, name in enumerate(names)] + [("hand", list(range(len(names))))]
    out: list[KeypointAgreement] = []
    for name, k in columns:
        for label, states in STATES.items():
            chosen = np.isin(state[:, k], [int(s) for s in states]) & np.isfinite(error[:, k])
            if chosen.any():
                out.append(_agreement(name, label, chosen, error[:, k], sd[:, k]))
    return out


def _agreement(
    name: str, label: str, chosen: NDArray[np.bool_], error: Array, sd: Array
) -> KeypointAgreement:
    e, s = error[chosen], sd[chosen]
    return KeypointAgreement(
        keypoint=name,
        state=label,
        share=float(chosen.mean()),
        mean_mm=float(1e3 * e.mean()),
        sd_mm=float(1e3 * np.median(s)),
        nees=float(np.mean(e**2 / (3 * np.maximum(s, 1e-9) ** 2))),
        within_3sd=float(np.mean(e <= 3 * s)),
    )


def lines_of(trials: Sequence[Trial]) -> list[str]:
    """The table as text."""
    out = ["keypoint      state      share %  mean mm   sd mm   nees  within 3 sd % (normal: 97.1)"]
    for a in agreement(trials):
        out.append(
            f"{a.keypoint:<13} {a.state:<10} {100 * a.share:7.1f} {a.mean_mm:8.2f} {a.sd_mm:7.2f} "
            f"{a.nees:6.2f} {100 * a.within_3sd:8.1f}"
        )
    return out
