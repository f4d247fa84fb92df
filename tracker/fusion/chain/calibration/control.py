"""User commands on a chain filter's calibration: reset, freeze, reuse in a later session."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import PriorParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import WearerProfile, profile_of
from tracker.fusion.chain.state import ChainState, initial_state
from tracker.messages import IntArray


@dataclass(frozen=True)
class RenewParams:
    """Standard deviations of what changes between two sessions of the same wearer."""

    gyro_bias: float = 0.01  # rad/s: varies between power cycles, and with temperature
    accel_bias: float = 0.1  # m/s²
    mounting: float = 0.05  # rad: the glove was put on again


def calibration_rows(layout: ChainLayout, segments: Sequence[str]) -> IntArray:
    """Rows of the error state that calibrate the named segments. Raises ConfigError."""
    rows: list[IntArray] = []

    def block(start: int, number: int, size: int = 3) -> None:
        rows.append(start + size * number + np.arange(size))

    for name in segments:
        if name not in layout.names:
            raise ConfigError(notice("calibration.no_segment", segment=name))
        a = layout.names.index(name)
        block(layout.blocks.scale, a, 2)
        if (j := int(layout.imu_of[a])) >= 0:
            for start in (layout.blocks.bg, layout.blocks.phi, layout.blocks.ba):
                block(start, j)
        if (b := int(layout.base_of[a])) >= 0:
            block(layout.blocks.joint, b)
        for m in np.flatnonzero(layout.marker_segment == a):
            block(layout.blocks.marker, int(m))
        for k in _axes_of(layout, a):
            block(layout.blocks.axis, k, 1)
    return np.sort(np.concatenate(rows)) if rows else np.zeros(0, np.int64)


def _axes_of(layout: ChainLayout, segment: int) -> list[int]:
    """The fixed axes of the joint at an active segment."""
    return [k for k, axis in enumerate(layout.fixed_axes) if axis.child == segment]


def reset_calibration(
    state: ChainState, layout: ChainLayout, prior: PriorParams, segments: Sequence[str]
) -> None:
    """Resets the named segments to the files' values with the initial uncertainty.

    The pose is unchanged; its correlation with these parameters is discarded.
    """
    rows = calibration_rows(layout, segments)
    fresh, P = initial_state(layout), initial_covariance(layout, prior)
    for name in segments:
        a = layout.names.index(name)
        state.scale[a] = fresh.scale[a]
        if (j := int(layout.imu_of[a])) >= 0:
            state.bg[j], state.ba[j], state.R_IB[j] = fresh.bg[j], fresh.ba[j], fresh.R_IB[j]
        if (b := int(layout.base_of[a])) >= 0:
            state.joint[b] = fresh.joint[b]
        state.marker[layout.marker_segment == a] = 0.0
        state.axis[_axes_of(layout, a)] = 0.0
    state.P[rows, :] = 0.0
    state.P[:, rows] = 0.0
    state.P[np.ix_(rows, rows)] = P[np.ix_(rows, rows)]


def hold_calibration(state: ChainState, layout: ChainLayout) -> None:
    """Treats the calibration as known: with zero covariance, no measurement changes it."""
    n = layout.n_dynamic
    state.P[n:, :] = 0.0
    state.P[:, n:] = 0.0


def with_held(state: ChainState, layout: ChainLayout, held: WearerProfile) -> ChainState:
    """A view of ``state`` with the covariance that the frozen calibration had."""
    n = layout.n_dynamic
    P = state.P.copy()
    P[n:, n:] = held.P
    return replace(state, P=P)


def renewed(
    profile: WearerProfile, layout: ChainLayout, params: RenewParams | None = None
) -> WearerProfile:
    """Adapts a profile to a new session: bones are unchanged, the glove was put on again, and
    sensor biases have drifted."""
    params, n = params or RenewParams(), layout.n_dynamic
    P = profile.P.copy()
    diagonal = np.arange(len(P))
    for first, last, sd in (
        (layout.blocks.bg, layout.blocks.phi, params.gyro_bias),
        (layout.blocks.phi, layout.blocks.ba, params.mounting),
        (layout.blocks.ba, layout.blocks.scale, params.accel_bias),
    ):
        rows = diagonal[first - n : last - n]
        P[rows, rows] += sd**2
    return replace(profile, P=P)


def fits(profile: WearerProfile, layout: ChainLayout) -> bool:
    """Whether a profile has the layout of this glove and hand."""
    like = profile_of(initial_state(layout), layout)
    arrays = {k: v for k, v in vars(like).items() if isinstance(v, np.ndarray)}
    return all(getattr(profile, k).shape == v.shape for k, v in arrays.items())
