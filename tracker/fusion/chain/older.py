"""States of recordings made before the values of fixed axes were estimated.

They continue as if nothing about the axes had been learned: with the files' values and the initial
uncertainty, independent of everything else. A keyframe solution in progress is started again.
"""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from tracker.fusion.chain.bundle.solver import BundleWork
from tracker.fusion.chain.guided.holds import ReducedRows
from tracker.fusion.chain.guided.learning import CALIBRATION
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import PriorParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.state import ChainState
from tracker.messages import Array


def complete_axes(saved: Any, layout: ChainLayout, prior: PriorParams) -> None:
    """Adds the values of fixed axes to all parts of ``saved`` that lack them, in place."""
    if layout.fixed_axes:
        variance = np.diag(initial_covariance(layout, prior))[layout.blocks.axis :].copy()
        _complete(saved, variance)


def _complete(part: Any, variance: Array) -> None:
    if isinstance(part, ChainState | WearerProfile):
        _complete_state(part, variance)
    elif isinstance(part, ReducedRows):
        _complete_rows(part, len(variance))
    elif isinstance(part, list | tuple):
        for inside in part:
            _complete(inside, variance)
    elif is_dataclass(part):
        if isinstance(part, BundleWork):
            _start_again(part)
        for field in fields(part):
            _complete(getattr(part, field.name), variance)


def _complete_state(part: ChainState | WearerProfile, variance: Array) -> None:
    if len(part.axis):
        return
    k = len(variance)
    object.__setattr__(part, "axis", np.zeros(k))  # a profile is frozen
    if len(part.P):
        P = np.zeros((len(part.P) + k, len(part.P) + k))
        P[:-k, :-k], P[-k:, -k:] = part.P, np.diag(variance)
        object.__setattr__(part, "P", P)


def _complete_rows(rows: ReducedRows, k: int) -> None:
    if len(rows.calibration) < len(CALIBRATION):
        rows.H = np.column_stack([rows.H, np.zeros((len(rows.H), k))])
        rows.calibration = [*rows.calibration, np.zeros(k)]


def _start_again(work: BundleWork) -> None:
    if work.calibration is not None and not len(work.calibration.axis):
        fresh = replace(BundleWork(), asked_at=work.asked_at, next_at=work.next_at)
        for name in ("calibration", "frames", "p", "R_GB", "back", "sweep", "N", "g"):
            setattr(work, name, getattr(fresh, name))
