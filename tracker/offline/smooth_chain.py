"""A chain filter that keeps a tape of what it did, and the way back along the tape.

Fixed-interval smoothing after Bryson and Frazier (G. J. Bierman: Fixed interval smoothing with
discrete measurements. Int. J. Control 18 (1), 65-75, 1973, doi:10.1080/00207177308932487), on error
states. The adjoint λ (N,) gathers what later measurements say: the best correction of a state with
covariance P is P λ. Nothing is inverted, and the estimates' own linearisation serves the way back.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import cho_factor, cho_solve

from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.kinematics import segment_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pixels import Prediction, SeenBlobs
from tracker.fusion.chain.propagate import transition
from tracker.fusion.chain.state import ChainState, inject
from tracker.fusion.output.output import Sensed
from tracker.fusion.time.imu_buffer import Intervals
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, CameraPose, Estimate, ImuSample, IntArray, Tracking
from tracker.vision.rig import StereoRig


@dataclass(frozen=True, eq=False)
class Step:
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
    return np.r_[layout.p : layout.v, layout.theta : layout.n_dynamic, layout.scale : layout.marker]


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
        thumb_abduction=4 * c.thumb_abduction,
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


class TapedChain(ChainEngine):
    """The chain filter with a tape; an estimate is put on it for the instant of every packet."""

    _KEPT = (*ChainEngine._KEPT, "_due")

    def __init__(
        self, hand: HandModel, glove: GloveModel, rig: StereoRig, params: ChainParams
    ) -> None:
        super().__init__(hand, glove, rig, smoothing_params(params))
        self._due: deque[float] = deque()  # s, packets that the filter has not come to
        self._tape: list[Step | Update | Forgotten | _Shown] = []
        self._rows = shown_rows(self._layout)
        self.taping = False

    def will_show(self, sample: ImuSample) -> bool:
        """Whether an estimate for this packet, the last one fed, is or will be on the tape."""
        newest = self._buffer.newest
        return self.tracking != Tracking.SEARCHING and newest is not None and newest.t == sample.t

    def come_to_the_end(self) -> None:
        """Move the filter itself to the newest packet: no image will come any more."""
        newest = self._buffer.newest
        if newest is not None and self.tracking != Tracking.SEARCHING:
            self._advance(newest.t)

    def back(self, adjoint: Array) -> tuple[list[Estimate], Array]:
        """Go back along the tape, which is empty then.

        ``adjoint`` (N,) is λ at the tape's end. Returns the smoothed estimates, earliest first, and
        λ at the tape's start.
        """
        out = []
        for entry in reversed(self._tape):
            if isinstance(entry, _Shown):
                out.append(self._smoothed(entry, adjoint))
            else:
                adjoint = entry.back(adjoint)
        self._tape.clear()
        return out[::-1], adjoint

    def _smoothed(self, shown: _Shown, adjoint: Array) -> Estimate:
        dx = np.zeros(self._layout.size)
        dx[self._rows] = shown.P_rows @ adjoint
        state = shown.state.copy()
        inject(state, self._layout, dx)
        p_GB = segment_positions(state, self._layout)
        return self._output.estimate(
            state.t, state.R_GB, p_GB, state.scale3(), shown.sensed, shown.tip_sd
        )

    # ---- what goes on the tape

    def _note(self, entry: Step | Update | Forgotten | _Shown) -> None:
        if self.taping:
            self._tape.append(entry)

    def _heard(self, sample: ImuSample) -> None:
        super()._heard(sample)
        self._due.append(sample.t)

    def _step(self, way: Intervals, first: int) -> int:
        if self.taping:
            dt = float(way.stop[first] - way.start[first])
            self._note(Step(transition(self._state, self._layout, way.mean(first), dt)))
        return super()._step(way, first)

    def _step_end(self, way: Intervals, first: int) -> int:
        return first + 1

    def _stepped(self) -> None:
        super()._stepped()
        while self._due and self._due[0] < self._state.t:
            self._due.popleft()  # from before the hand was found
        if self._due and self._due[0] == self._state.t:
            self._due.popleft()
            self._show()

    def _show(self) -> None:
        if not self.taping:
            return
        nominal = replace(self._state, P=np.zeros((0, 0)))
        P_rows = self._state.P[self._rows]
        sensed = Sensed(self._sensed(self._state.t), self._track.tracking)
        self._note(_Shown(nominal.copy(), P_rows, sensed, self._track.tip_sd))

    def _learn(self, H: Array, HP: Array, HPH: Array, r: Array, R: Array) -> None:
        self._note(Update(H, HP, HPH + R, r))
        super()._learn(H, HP, HPH, r, R)

    def _adopt(self, state: ChainState) -> None:
        self._note(Forgotten(self._layout.size))
        super()._adopt(state)

    def _search_again(
        self,
        seen: tuple[SeenBlobs, ...],
        pose: CameraPose,
        prediction: Prediction,
        match: IntArray,
    ) -> tuple[Prediction, IntArray]:
        before = self._state
        out = super()._search_again(seen, pose, prediction, match)
        if self._state is not before:
            self._note(Forgotten(self._layout.n_dynamic))
        return out
