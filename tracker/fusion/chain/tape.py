"""The record of a chain filter's operations, for a smoother."""

from __future__ import annotations

from typing import Protocol

from tracker.fusion.chain.state import ChainState
from tracker.fusion.output.output import Sensed
from tracker.fusion.time.imu_buffer import Moment
from tracker.messages import Array


class Tape(Protocol):
    """Receives operations in order. Arrays and states belong to the filter: copy them to store
    them, unless stated otherwise."""

    def step(self, state: ChainState, readings: Moment, dt: float) -> None:
        """``state`` is about to be propagated by ``dt`` s with these mean readings."""

    def update(self, H: Array, HP: Array, S: Array, r: Array) -> None:
        """The state is about to be corrected: H (m, N), H P (m, N), the innovation's covariance S
        (m, m) and the innovation r (m,), all of which may be stored."""

    def forgotten(self, rows: int) -> None:
        """The first ``rows`` error states are reset: later ones are independent of earlier ones."""

    def shown(self, state: ChainState, sensed: Sensed, tip_sd: Array) -> None:
        """``state`` is at the time of a packet; tip_sd (A,) m of each segment's end may be
        stored."""
