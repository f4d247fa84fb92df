"""What the user should know about an import: limits of the time alignment and registration."""

from __future__ import annotations

import numpy as np

from extensions.reference.session import Described
from tracker.base.notices import Notice, notice, warning

COVERED = 0.9  # share of the session's instants
SCATTER = 0.005  # s
APART = 0.02  # m
UNCERTAIN = 0.005  # m


def remarks(about: Described, with_drift: bool = True) -> list[Notice]:
    """The most important first. ``with_drift``: the drift was to be estimated."""
    timing, registered = about.timing, about.with_offsets
    out: list[Notice] = []
    if registered.residual > APART:
        out.append(warning("reference.large_residual", residual_mm=1e3 * registered.residual))
    if about.covered < COVERED:
        out.append(warning("reference.partly_covered", share=100 * about.covered))
    if timing.residual > SCATTER:
        out.append(warning("reference.time_scatters", residual_ms=1e3 * timing.residual))
    if with_drift and timing.by != "clock" and not np.isfinite(timing.drift_sd):
        out.append(notice("reference.drift_unknown"))
    out += _of_offsets(about)
    if about.missing:
        out.append(notice("reference.not_drawn", keypoints=about.missing))
    return out


def _of_offsets(about: Described) -> list[Notice]:
    out: list[Notice] = []
    sd = about.with_offsets.offset_sd.max(axis=1)
    uncertain = [k for k, s in zip(about.keypoints, sd, strict=True) if s > UNCERTAIN]
    if uncertain:
        worst = 1e3 * float(np.nanmax(sd))
        out.append(warning("reference.offsets_uncertain", keypoints=uncertain, sd_mm=worst))
    inferred = [k for k, s in zip(about.keypoints, sd, strict=True) if np.isnan(s)]
    if inferred:
        out.append(notice("reference.offsets_inferred", keypoints=inferred))
    return out
