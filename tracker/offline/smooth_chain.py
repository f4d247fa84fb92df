"""A tape of what a chain filter did, and the way back along it.

Fixed-interval smoothing after Bryson and Frazier (G. J. Bierman: Fixed interval smoothing with
discrete measurements. Int. J. Control 18 (1), 65-75, 1973, doi:10.1080/00207177308932487), on error
states. The adjoint λ (N,) gathers what later measurements say: the best correction of a state with
covariance P is P λ. Nothing is inverted, and the estimates' own linearisation serves the way back.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import cho_factor, cho_solve

from tracker.fusion.chain.distal import DistalSegments
from tracker.fusion.chain.layout import ChainLayout, P, V
from tracker.fusion.chain.params import ChainParams, NoiseParams, SynergyParams
from tracker.fusion.chain.propagate import transition
from tracker.fusion.chain.shown import ShownHand
from tracker.fusion.chain.state import ChainState, inject
from tracker.fusion.output.output import Sensed
from tracker.fusion.time.imu_buffer import Moment
from tracker.messages import Array, Estimate, IntArray


@dataclass(frozen=True, eq=False)
class SmootherStep:
    """Phi (D, w): the dynamic rows of a transition against the first w columns."""

    Phi: Array

    def back(self, adjoint: Array) -> Array:
        D, width = self.Phi.shape
        out = adjoint.copy()
        out[:D] = 0.0
        out[:width] += self.Phi.T @ adjoint[:D]
        return out


@dataclass(frozen=True, eq=False)
class Update:
    """H (m, N), H P (m, N), the innovation's covariance S (m, m), innovation r (m,)."""

    H: Array
    HP: Array
    S: Array
    r: Array

    def back(self, adjoint: Array) -> Array:
        """λ + Hᵀ S⁻¹ (r - H P λ): the step through (I - K H)ᵀ and the innovation at once."""
        weighed = cho_solve(cho_factor(self.S, lower=True), self.r - self.HP @ adjoint)
        return adjoint + self.H.T @ weighed


@dataclass(frozen=True, eq=False)
class Forgotten:
    """The first ``rows`` error states were set anew: later ones say nothing of earlier ones."""

    rows: int

    def back(self, adjoint: Array) -> Array:
        out = adjoint.copy()
        out[: self.rows] = 0.0
        return out


@dataclass(frozen=True, eq=False)
class _Shown:
    """An instant whose estimate is wanted: nominal state and the rows of P that it shows."""

    state: ChainState
    P_rows: Array  # (k, N)
    sensed: Sensed
    tip_sd: Array


def shown_rows(layout: ChainLayout) -> IntArray:
    """Error states that an estimate depends on: place, orientations, scales and joint offsets."""
    at = layout.blocks
    return np.r_[P:V, at.theta : layout.n_dynamic, at.scale : at.marker]


def smoothing_params(params: ChainParams) -> ChainParams:
    """The filter's settings as its smoothing needs them.

    What is wrong with a marker's place or with anatomy hardly changes from one image to the next,
    although the filter takes it for new each time. A filter forgets the older ones; smoothing adds
    them all up, and so each has to weigh less. Factors from simulated wearers.
    """
    c, prior, noise = params.constraint, params.prior, params.noise
    constraint = replace(
        c,
        rotation=4 * c.rotation,
        stiff_abduction=4 * c.stiff_abduction,
        synergy=4 * c.synergy,
        limit=8 * c.limit,
        tilt=0.7 * c.tilt,
    )
    return replace(
        params,
        constraint=constraint,
        prior=replace(prior, marker=1.5 * prior.marker),
        noise=replace(noise, marker=1.3 * noise.marker),
    )


class ChainTape:
    """A `Tape` of a chain filter with this layout; an estimate is put on it for each packet.

    Nothing is taken while ``recording`` is off.
    """

    def __init__(self, layout: ChainLayout) -> None:
        self._layout = layout
        self._shown_hand = ShownHand(layout, NoiseParams(), DistalSegments(layout, SynergyParams()))
        self._rows = shown_rows(layout)
        self._entries: list[SmootherStep | Update | Forgotten | _Shown] = []
        self.recording = False

    def wear(self, gains: Array, aside: Array) -> None:
        """Smooth the hand of a wearer with these synergies, as `Completion.wear`."""
        self._shown_hand.wear(gains, aside)

    # ---- what goes on the tape

    def step(self, state: ChainState, readings: Moment, dt: float) -> None:
        if self.recording:
            self._entries.append(SmootherStep(transition(state, self._layout, readings, dt)))

    def update(self, H: Array, HP: Array, S: Array, r: Array) -> None:
        if self.recording:
            self._entries.append(Update(H, HP, S, r))

    def forgotten(self, rows: int) -> None:
        if self.recording:
            self._entries.append(Forgotten(rows))

    def shown(self, state: ChainState, sensed: Sensed, tip_sd: Array) -> None:
        if self.recording:
            nominal = replace(state, P=np.zeros((0, 0)))
            self._entries.append(_Shown(nominal.copy(), state.P[self._rows], sensed, tip_sd))

    # ---- the way back

    def back(self, adjoint: Array) -> tuple[list[Estimate], Array]:
        """Go back along the tape, which is empty then.

        ``adjoint`` (N,) is λ at the tape's end. Returns the smoothed estimates, earliest first, and
        λ at the tape's start.
        """
        out = []
        for entry in reversed(self._entries):
            if isinstance(entry, _Shown):
                out.append(self._smoothed(entry, adjoint))
            else:
                adjoint = entry.back(adjoint)
        self._entries.clear()
        return out[::-1], adjoint

    def _smoothed(self, shown: _Shown, adjoint: Array) -> Estimate:
        dx = np.zeros(self._layout.blocks.size)
        dx[self._rows] = shown.P_rows @ adjoint
        state = shown.state.copy()
        inject(state, self._layout, dx)
        return self._shown_hand.estimate_of(state, state.t, shown.sensed, shown.tip_sd)
