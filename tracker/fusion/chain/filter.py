"""The filter itself: a state with its covariance, propagated by packets, corrected by measurements.

The accelerometer measurements are in `tilt`, those from anatomy in `constraints`. Equation numbers
are those of docs/chain.md.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.constraints import Constraints
from tracker.fusion.chain.layout import ChainLayout, V
from tracker.fusion.chain.params import ChainParams, PriorParams, without_random_walks
from tracker.fusion.chain.pose_reset import PASSES, flat_rows
from tracker.fusion.chain.prior import initial_covariance, reset_pose
from tracker.fusion.chain.propagate import Coasting, carry, propagate
from tracker.fusion.chain.start.search import Pose
from tracker.fusion.chain.state import ChainState, initial_state, inject
from tracker.fusion.chain.tape import Tape
from tracker.fusion.chain.tilt import tilt_rows
from tracker.fusion.kalman import correct, joined, products
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals
from tracker.messages import Array, IntArray

Rows = tuple[Array, Array, Array, Array]
"""Terms of an update: H (m, N), H P (m, N), innovation r (m,) and its noise R (m, m)."""

RATIO_LASTS = 0.4  # s over which corrections of the velocity are averaged
RATIO_LEAST = 0.02  # share of the velocity's variance that a correction has to remove to count

STAY_VARIANCE = np.repeat([2.0**2, 2.0**2], 3)
"""m² and m²/s² of one use of `ChainFilter.stay`: more than an arm's reach and speed, since the hand
may stay away for a second, in which thirty uses are not thirty independent measurements."""


@record("chain.filter")
@dataclass(eq=False)
class FilterSavedState:
    """The complete state of the filter, and the times (s) when tilt and anatomy were last used."""

    state: ChainState
    last_tilt: float = -np.inf
    last_constraint: float = -np.inf


class MovedStates:
    """States with the hand at other poses, which a search compares with the filter's own."""

    def __init__(self, layout: ChainLayout, prior: PriorParams) -> None:
        self._layout, self._prior = layout, prior

    def at_pose(self, state: ChainState, pose: Pose) -> ChainState:
        """A copy of ``state`` with the hand at another pose, at rest, with the initial
        uncertainty."""
        trial = state.copy()
        trial.R_GB, trial.p, trial.v = pose.R_GB, pose.p, np.zeros(3)
        trial.velocity_ratio = 1.0
        reset_pose(trial.P, self._layout, self._prior)
        return trial

    def shifted(self, state: ChainState, shift: Array, sd: float) -> ChainState:
        """A copy of ``state`` with the hand shifted by (3,) m, with standard deviation ``sd`` m."""
        trial = state.copy()
        HP = trial.P[:3].copy()
        dx = correct(trial.P, HP, HP[:, :3].copy(), shift, sd**2 * np.eye(3))
        inject(trial, self._layout, dx)
        return trial

    def moving(self, moved: ChainState, v: Array) -> None:
        """Sets v (3,) m/s of a state from `at_pose`, computed from two searches."""
        moved.v = v
        moved.P[V : V + 3, V : V + 3] = self._prior.found_velocity**2 * np.eye(3)


class ChainFilter:
    """The filter of one hand. ``tape`` records each step and update; with a tape, intervals are
    processed one at a time."""

    def __init__(
        self, layout: ChainLayout, params: ChainParams, buffer: ImuBuffer, tape: Tape | None = None
    ) -> None:
        self._layout, self._params, self._buffer, self._tape = layout, params, buffer, tape
        self._shaken, self._held_shaken = params, without_random_walks(params)
        self._vibration = (0.0, 0.0)
        self._constraints = Constraints(layout, params.constraint)
        with_image = replace(params.constraint, rotation=params.constraint.rotation_seen)
        self._constraints_seen = Constraints(layout, with_image)
        state = initial_state(layout)
        state.P = initial_covariance(layout, params.prior)
        self.saved = FilterSavedState(state)
        self.moved = MovedStates(layout, params.prior)

    @property
    def state(self) -> ChainState:
        """The present state with its covariance."""
        return self.saved.state

    # ---- propagation

    def set_vibration(self, gyro: float, accel: float) -> None:
        """From now on the IMUs have this noise in addition, rad/s/√Hz and m/s²/√Hz."""
        if (gyro, accel) == self._vibration:
            return
        self._vibration = (gyro, accel)
        noise = self._params.noise
        larger = replace(
            noise, gyro=math.hypot(noise.gyro, gyro), accel=math.hypot(noise.accel, accel)
        )
        self._shaken = replace(self._params, noise=larger)
        self._held_shaken = without_random_walks(self._shaken)

    def step(self, way: Intervals, first: int, last_good: float, held: bool) -> int:
        """Processes the interval ``first`` of ``way`` and the next ones until tilt is due; returns
        the number of the next interval.

        ``last_good`` s is the time of the last image with enough matches; ``held``: the calibration
        is frozen.
        """
        params = self._held_shaken if held else self._shaken
        end = self._step_end(way, first)
        if self._tape is not None:
            dt = float(way.stop[first] - way.start[first])
            self._tape.step(self.state, way.mean(first), dt)
        coasting = Coasting(last_good, params.match.lost_after)
        propagate(self.state, self._layout, params, way.part(first, end), coasting)
        if self.state.t - last_good > params.match.lost_after:
            self.state.velocity_ratio = 1.0
        self._tilt()
        return end

    def _step_end(self, way: Intervals, first: int) -> int:
        """One past the first interval at whose end relative tilt is due, or past the last one."""
        end = first + 1
        while (
            self._tape is None
            and end < len(way.stop)
            and not _is_due(self.saved, self._params, float(way.stop[end - 1]))
        ):
            end += 1
        return end

    def carry(self, state: ChainState, t: float, coasting: bool) -> None:
        """Propagate a nominal state to ``t`` through the packets in between."""
        carry(state, self._layout, self._buffer, t, coasting)

    # ---- another state

    def adopt(self, state: ChainState) -> None:
        """Replace the state by an unrelated one."""
        if self._tape is not None:
            self._tape.forgotten(self._layout.blocks.size)
        self.saved.state = state

    def move(self, moved: ChainState) -> None:
        """Continue from a state of `moved`."""
        if self._tape is not None:
            self._tape.forgotten(self._layout.n_dynamic)
        self.saved.state = moved

    def doubt(self, imus: IntArray) -> None:
        """Inflates the orientation covariance of segments whose IMUs (k,) were not valid for a
        while: their rotation meanwhile is unknown."""
        for j in imus:
            rows = self._layout.blocks.theta + 3 * self._layout.imu_segment[j] + np.arange(3)
            self.state.P[rows, rows] += self._params.prior.returned**2

    # ---- measurements

    def _tilt(self) -> None:
        """Relative tilt from the accelerometers, at most once per ``period``."""
        t = self.state.t
        around = self._buffer.around(t) if _is_due(self.saved, self._params, t) else None
        if around is None:
            return
        rows = tilt_rows(self.state, self._layout, self._params.constraint, around)
        if rows is not None:
            self.saved.last_tilt = t
            self.use(*rows)

    def constrain(self, t: float) -> bool:
        """Applies anatomy alone while no image arrives, at most once per ``period``; returns
        whether it did."""
        if t - self.saved.last_constraint < self._params.constraint.period:
            return False
        self.saved.last_constraint = t
        self.use(*self._constraints.rows(self.state))
        return True

    def stay(self) -> None:
        """Without images: a wearer remains near the same position and comes to rest now and then;
        to be used as often as anatomy (eq. 57)."""
        H = np.eye(6, len(self.state.P))
        self.use(H, -np.concatenate([self.state.p, self.state.v]), STAY_VARIANCE)

    def straighten(self) -> None:
        """Corrects all joints with an IMU towards a hand that the wearer holds flat.

        Iterated, each pass linearised at the result of the one before: drift may be large.
        """
        for _ in range(PASSES):
            H, r, variance = flat_rows(self.state, self._layout)
            self.use(H, r, PASSES * variance)

    def correct(self, seen: Rows) -> Array:
        """One stacked update: matches and anatomy, linearised at the same state; returns (N,) its
        correction."""
        H, r, variance = self._constraints_seen.rows(self.state)
        since = max(self.state.t - self.saved.last_constraint, 1e-3)
        # at twice the usual rate each use carries half the information
        variance = variance * max(1.0, self._params.constraint.period / since)  # eq. 37
        v, v_variance = self.state.v.copy(), velocity_trace(self.state)
        dx = self._update(*joined(*seen, H, r, variance, self.state.P))
        self._judge_velocity(v, v_variance, since)
        self.saved.last_constraint = self.state.t
        return dx

    def _judge_velocity(self, v: Array, variance: float, since: float) -> None:
        """Compares a correction of the velocity, which was v (3,) m/s with the ``variance`` (trace,
        m²/s²) before an image ``since`` s after the last one, with its variance by P (eq. 77)."""
        state = self.state
        removed = variance - velocity_trace(state)
        if removed > RATIO_LEAST * variance:
            change = state.v - v
            weight = 1.0 - math.exp(-min(since, RATIO_LASTS) / RATIO_LASTS)
            state.velocity_ratio += weight * (
                float(change @ change) / removed - state.velocity_ratio
            )

    def corrected(self, seen: Rows, state: ChainState | None = None) -> ChainState:
        """Returns ``state`` (default: its own) corrected as by `correct` without anatomy; changes
        nothing."""
        trial = (state or self.state).copy()
        H, HP, r, R = seen
        inject(trial, self._layout, correct(trial.P, HP, H @ HP.T + R, r, np.zeros_like(R)))
        return trial

    def learn(self, H: Array, r: Array, R: Array) -> None:
        """Applies rows H (m, C) on the calibration alone, with innovation r (m,) and noise R
        (m, m)."""
        full = np.zeros((len(H), len(self.state.P)))
        full[:, self._layout.n_dynamic :] = H
        HP = full @ self.state.P
        self._update(full, HP, HP @ full.T, r, R)

    def use(self, H: Array, r: Array, variance: Array) -> None:
        """Applies a few rows H (m, N), with innovation r (m,) and variance (m,)."""
        HP, HPH = products(H, self.state.P)
        self._update(H, HP, HPH, r, np.diag(variance))

    def _update(self, H: Array, HP: Array, HPH: Array, r: Array, R: Array) -> Array:
        """One update with H (m, N), H P, H P Hᵀ, innovation r (m,) and its noise R (m, m); returns
        the correction (N,)."""
        if self._tape is not None:
            self._tape.update(H, HP, HPH + R, r)
        dx = correct(self.state.P, HP, HPH, r, R)  # eq. 38
        inject(self.state, self._layout, dx)
        return dx


def velocity_trace(state: ChainState) -> float:
    """m²/s², summed over three axes, by P."""
    return float(state.P[3, 3] + state.P[4, 4] + state.P[5, 5])


def _is_due(saved: FilterSavedState, params: ChainParams, t: float) -> bool:
    """Whether relative tilt is due."""
    return t - saved.last_tilt >= params.constraint.period
