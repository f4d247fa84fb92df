"""Repeatability: the touch test of one person after putting the glove on again.

One-way random effects (ISO 5725-2:2019, 7.4): the bias of a session is that of one wearing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from extensions.touch.result import FingerResult, TouchResult
from extensions.touch.statistics import ConfidenceInterval, sd_interval
from tracker.base.errors import ConfigError
from tracker.base.notices import failure

AGREEMENT = 1.96 * np.sqrt(2.0)
"""For the standard deviation of one touch: two touches differ by less in 95 % of cases."""


@dataclass(frozen=True)
class Repeated:
    """One finger over several wearings, m per axis of the sheet.

    ``within`` is the SD of touches in one wearing, ``between`` that of the bias from wearing to
    wearing as it was found, ``wearing`` what remains of it without the part that the number of
    touches explains, ``limit`` the 95 % limit for the difference of two touches in two wearings.
    """

    finger: str
    sessions: int
    within: ConfidenceInterval
    between: ConfidenceInterval
    wearing: float
    limit: float


def repeatability(results: Sequence[TouchResult]) -> list[Repeated]:
    """For the fingers that all sessions have. Raises ConfigError without any, or with sessions of
    several persons or hands."""
    for what in ("participant", "side"):
        found = {r.session.get(what, "") for r in results} - {""}
        if len(found) > 1:
            raise ConfigError(failure("touch.several_people", found=sorted(found)))
    by_finger = [{f.finger: f for f in r.fingers} for r in results]
    common = [name for name in by_finger[0] if all(name in fingers for fingers in by_finger)]
    if not common:
        raise ConfigError(failure("touch.no_common_finger"))
    return [_repeated(name, [fingers[name] for fingers in by_finger]) for name in common]


def _repeated(finger: str, sessions: Sequence[FingerResult]) -> Repeated:
    """Mean squares of one-way analysis of variance, pooled over the three axes."""
    counts = np.array([f.count for f in sessions], float)
    means = np.array([f.error_S.mean(axis=0) for f in sessions])
    rest = sum(float(np.sum((f.error_S - m) ** 2)) for f, m in zip(sessions, means, strict=True))
    dof_within = 3 * float(np.sum(counts - 1))
    grand = np.average(means, axis=0, weights=counts)
    dof_between = 3 * (len(sessions) - 1)
    ms_within = rest / dof_within
    ms_between = float(np.sum(counts[:, None] * (means - grand) ** 2)) / dof_between
    effective = (counts.sum() - np.sum(counts**2) / counts.sum()) / (len(sessions) - 1)
    wearing = max(0.0, (ms_between - ms_within) / effective)
    spread = float(np.sqrt(np.mean(np.var(means, axis=0, ddof=1))))
    return Repeated(
        finger=finger,
        sessions=len(sessions),
        within=sd_interval(float(np.sqrt(ms_within)), dof_within),
        between=sd_interval(spread, dof_between),
        wearing=float(np.sqrt(wearing)),
        limit=float(AGREEMENT * np.sqrt(wearing + ms_within)),
    )
