"""The result of a touch test: errors of each finger and of all, with confidence intervals.

Axes of the sheet: *right* along its longer side, *away* from its lower edge, *up* out of the paper.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from extensions.touch.contact import Pulp, base_contacts, fit_pulp
from extensions.touch.lengths import Closure, Lengths, Stillness, return_test, ruler_test
from extensions.touch.pose import SheetPose
from extensions.touch.protocol import FINGERS, TouchCue
from extensions.touch.rest import CrossTouch
from extensions.touch.statistics import (
    ConfidenceInterval,
    agreement_limits,
    bootstrap,
    mean_interval,
    sd_interval,
    share_interval,
    slope,
)
from tracker.base.errors import ConfigError
from tracker.base.notices import Notice, failure, warning
from tracker.messages import Array

AXES = ("right", "away", "up")
LEAST_TOUCHES = 4
"""For one finger: with fewer, bias and spread cannot be separated."""
NORMAL = (0.6827, 0.9545, 0.9973)
OFFSET_LIMIT = 0.003  # m, of the pulp from the hand file's, above which the glove file is suspect


@dataclass(frozen=True, eq=False)
class FingerResult:
    """One finger. error_S (n, 3) m, tracked contact less cross, in the axes of the sheet.

    ``sd`` is per axis, pooled over the three; ``distance`` the mean length of the errors, ``p95``
    their 95th percentile; ``unfitted`` the length of the bias if the pulp were exactly as the hand
    file has it; ``limits`` per axis.
    """

    finger: str
    touches: tuple[CrossTouch, ...]
    pulp: Pulp
    error_S: Array
    bias: tuple[ConfidenceInterval, ...]
    bias_length: ConfidenceInterval
    sd_axes: Array
    sd: ConfidenceInterval
    limits: tuple[tuple[ConfidenceInterval, ConfidenceInterval], ...]
    distance: ConfidenceInterval
    p95: ConfidenceInterval
    unfitted: float

    @property
    def count(self) -> int:
        return len(self.touches)


@dataclass(frozen=True, eq=False)
class TouchResult:
    """Everything that a report shows. ``claims``: share of errors per axis within 1, 2 and 3
    claimed standard deviations; ``slope`` m per m of distance from the camera; ``depth`` and
    ``across``: (bias, sd) m along the camera's line of sight and across it (per axis)."""

    pose: SheetPose
    fingers: tuple[FingerResult, ...]
    missed: tuple[TouchCue, ...]
    bias_length: ConfidenceInterval
    sd: ConfidenceInterval
    distance: ConfidenceInterval
    p95: ConfidenceInterval
    claims: tuple[ConfidenceInterval, ...]
    claimed_sd: float
    slope: ConfidenceInterval
    depth: tuple[ConfidenceInterval, ConfidenceInterval]
    across: tuple[ConfidenceInterval, ConfidenceInterval]
    by_how: Mapping[str, ConfidenceInterval]
    ruler: Lengths | None
    returned: ConfidenceInterval | None
    closure: Closure | None = None
    still: tuple[Stillness, ...] = ()
    notices: tuple[Notice, ...] = ()
    session: Mapping[str, str] = field(default_factory=dict)

    @property
    def count(self) -> int:
        return sum(f.count for f in self.fingers)

    @property
    def touches(self) -> list[CrossTouch]:
        return [t for f in self.fingers for t in f.touches]

    @property
    def error_S(self) -> Array:
        """(n, 3) m, in the order of `touches`."""
        return np.concatenate([f.error_S for f in self.fingers])

    @property
    def line(self) -> str:
        """One line to quote."""
        mm, names = 1000.0, ", ".join(f.finger for f in self.fingers)
        simulated = " simulated" if self.session.get("simulated") == "true" else ""
        bias, sd, far = self.bias_length.value, self.sd, self.distance.value
        return (
            f"Fingertip accuracy by{simulated} touch test: bias {mm * bias:.1f} mm, "
            f"SD {mm * sd.value:.1f} mm per axis (95 % CI {mm * sd.low:.1f} to "
            f"{mm * sd.high:.1f}), mean distance {mm * far:.1f} mm, "
            f"95 % within {mm * self.p95.value:.1f} mm ({self.count} touches: {names})"
        )


def evaluate(
    touches: Sequence[CrossTouch],
    missed: Sequence[TouchCue],
    pose: SheetPose,
    camera_G: Array,
) -> TouchResult:
    """The figures of touches; ``camera_G`` (3,) m is the left lens. Raises ConfigError with too few
    touches of every finger."""
    touches = [replace(t, distance=float(np.linalg.norm(t.target_G - camera_G))) for t in touches]
    by_finger = {f: [t for t in touches if t.cue.finger == f] for f in FINGERS}
    enough = {f: some for f, some in by_finger.items() if len(some) >= LEAST_TOUCHES}
    if not enough:
        raise ConfigError(failure("touch.too_few", count=len(touches), least=LEAST_TOUCHES))
    up_G = -pose.R_GS[:, 2]
    pulps = {f: fit_pulp(some, up_G) for f, some in enough.items()}
    fingers = tuple(_finger(f, enough[f], pulps[f], pose) for f in enough)
    some = [t for f in fingers for t in f.touches]
    error_G = np.concatenate([f.pulp.error for f in fingers])
    length = np.linalg.norm(error_G, axis=1)
    distance = np.array([t.distance for t in some])
    depth, across = _directions(some, error_G, camera_G)
    return TouchResult(
        pose=pose,
        fingers=fingers,
        missed=tuple(missed),
        bias_length=bootstrap(error_G, _norm_of_mean),
        sd=_pooled_sd(fingers),
        distance=mean_interval(length),
        p95=bootstrap(length, _p95),
        claims=_claims(some, error_G),
        claimed_sd=float(np.mean([t.sd for t in some])),
        slope=slope(distance, length),
        depth=depth,
        across=across,
        by_how=_by_how(some, length),
        ruler=ruler_test(enough, pulps),
        returned=return_test(enough, pulps),
        notices=(*pose.notices(), *_notices(fingers, missed)),
    )


def _finger(
    finger: str, touches: Sequence[CrossTouch], pulp: Pulp, pose: SheetPose
) -> FingerResult:
    axes = pose.R_GS @ np.diag([1.0, -1.0, -1.0])
    error_S = pulp.error @ axes
    n = len(touches)
    sd_axes = np.std(error_S, axis=0, ddof=1)
    length = np.linalg.norm(error_S, axis=1)
    bias_S = error_S.mean(axis=0)
    variance = np.diag(axes.T @ _offset_cov(touches, pulp) @ axes)
    bias = []
    for k in range(3):
        half = mean_interval(error_S[:, k])
        wide = float(np.hypot(half.high - half.value, 1.96 * np.sqrt(variance[k])))
        bias.append(ConfidenceInterval(half.value, half.value - wide, half.value + wide))
    own = base_contacts(touches, axes[:, 2])
    unfitted = np.mean([t.p_G - t.target_G for t in touches], axis=0) + own.mean(axis=0)
    return FingerResult(
        finger=finger,
        touches=tuple(touches),
        pulp=pulp,
        error_S=error_S,
        bias=tuple(bias),
        bias_length=bootstrap(error_S, _norm_of_mean),
        sd_axes=sd_axes,
        sd=sd_interval(float(np.sqrt(np.mean(sd_axes**2))), 3 * (n - 1)),
        limits=tuple(agreement_limits(float(bias_S[k]), float(sd_axes[k]), n) for k in range(3)),
        distance=mean_interval(length),
        p95=bootstrap(length, _p95),
        unfitted=float(np.linalg.norm(unfitted)),
    )


def _offset_cov(touches: Sequence[CrossTouch], pulp: Pulp) -> Array:
    """(3, 3) m² in G: what the offset's uncertainty adds to that of the mean contact."""
    R = np.mean([t.R_GB for t in touches], axis=0)
    return R @ np.diag(pulp.held.offset_sd**2) @ R.T


def _norm_of_mean(error: Array) -> Array:
    """(k,) of k samples (k, n, m)."""
    return np.asarray(np.linalg.norm(error.mean(axis=1), axis=-1))


def _p95(length: Array) -> Array:
    """(k,) of k samples (k, n)."""
    return np.asarray(np.percentile(length, 95, axis=1))


def _pooled_sd(fingers: Sequence[FingerResult]) -> ConfidenceInterval:
    """Per axis, about each finger's own bias."""
    dof = sum(3 * (f.count - 1) for f in fingers)
    total = sum(3 * (f.count - 1) * f.sd.value**2 for f in fingers)
    return sd_interval(float(np.sqrt(total / dof)), dof)


def _directions(
    touches: Sequence[CrossTouch], error_G: Array, camera_G: Array
) -> tuple[
    tuple[ConfidenceInterval, ConfidenceInterval], tuple[ConfidenceInterval, ConfidenceInterval]
]:
    """(bias, sd) along the line of sight, positive away from the camera, and across it."""
    ray = np.array([t.target_G - camera_G for t in touches])
    ray /= np.linalg.norm(ray, axis=1, keepdims=True)
    along = np.sum(error_G * ray, axis=1)
    rest = error_G - along[:, None] * ray
    n = len(along)
    spread = float(np.sqrt(np.sum((rest - rest.mean(axis=0)) ** 2) / (2 * (n - 1))))
    return (
        (mean_interval(along), sd_interval(float(np.std(along, ddof=1)), n - 1)),
        (bootstrap(rest, _norm_of_mean), sd_interval(spread, 2 * (n - 1))),
    )


def _claims(touches: Sequence[CrossTouch], error_G: Array) -> tuple[ConfidenceInterval, ...]:
    sd = np.array([t.sd for t in touches])[:, None]
    known = np.isfinite(sd) & (sd > 0)
    ratio = np.abs(error_G) / np.where(known, sd, np.nan)
    ratio = ratio[np.isfinite(ratio)]
    return tuple(share_interval(int(np.sum(ratio < k)), len(ratio)) for k in (1, 2, 3))


def _by_how(touches: Sequence[CrossTouch], length: Array) -> dict[str, ConfidenceInterval]:
    names = dict.fromkeys(t.cue.how for t in touches)
    return {
        how: mean_interval(length[[k for k, t in enumerate(touches) if t.cue.how == how]])
        for how in names
    }


def _notices(fingers: Sequence[FingerResult], missed: Sequence[TouchCue]) -> list[Notice]:
    out = []
    if missed:
        numbers = [str(c.number) for c in missed]
        out.append(warning("touch.missed", count=len(missed), numbers=numbers))
    for f in fingers:
        free = f.pulp.free
        off, sd = (float(np.linalg.norm(v)) for v in (free.offset, free.offset_sd))
        if off > max(OFFSET_LIMIT, 3 * sd):
            off_mm = 1000 * off
            out.append(warning("touch.pulp_far", finger=f.finger, off_mm=off_mm))
        wrong = [t for t in f.touches if t.asked != t.cue.target]
        out += [
            warning("touch.other_cross", number=t.cue.number, asked=t.asked, touched=t.cue.target)
            for t in wrong
        ]
    return out
