"""The chain engine: one root position, one orientation per segment, joints that hold exactly.

The filter lives at the exposure of the last picture (or a fixed lag behind the newest packet when
no picture comes); what it shows is that state carried on with the packets since. Late pictures
therefore need no rolling back: a picture waits until IMU data cover its exposure.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tracker.fusion.chain_kinematics import marker_positions, point_jacobians, segment_positions
from tracker.fusion.constraints import Constraints
from tracker.fusion.health import ImuHealth
from tracker.fusion.imu_buffer import ImuBuffer
from tracker.fusion.kalman import update_with
from tracker.fusion.layout import ChainLayout
from tracker.fusion.output import HandOutput, Sensed
from tracker.fusion.params import ChainParams
from tracker.fusion.pixels import PixelModel, Prediction, SeenBlobs, seen_blobs
from tracker.fusion.prior import initial_covariance, reset_pose
from tracker.fusion.profile import WearerProfile, profile_of, wear
from tracker.fusion.propagate import propagate
from tracker.fusion.reports import calibration_of, frame_result
from tracker.fusion.start import Starter
from tracker.fusion.state import ChainState, initial_state, inject
from tracker.fusion.tilt import tilt_rows
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    CameraPose,
    Estimate,
    FrameResult,
    ImuSample,
    IntArray,
    Tracking,
)
from tracker.vision.rig import StereoRig

SEEN_LATELY = 0.5  # s
LATE_MARGIN = 0.03  # s beyond the latest picture so far
RETURN_AFTER = 0.15  # s of silence after which a segment is doubted


@dataclass(eq=False)
class _Track:
    """What changes beside the filter itself."""

    tracking: Tracking = Tracking.SEARCHING
    last_good: float = -np.inf  # last picture with enough matches
    last_search: float = -np.inf
    last_tilt: float = -np.inf
    last_constraint: float = -np.inf
    doubtful_since: float = np.inf
    seen: Array = field(default_factory=lambda: np.zeros(0))  # (M,) when each marker was seen last
    felt: Array = field(default_factory=lambda: np.zeros(0))  # (n,) when each IMU answered last
    lag: float = 0.0  # s that the filter stays behind while no picture comes
    last_frame: float = -np.inf  # exposure of the last picture that was processed
    tip_sd: Array = field(default_factory=lambda: np.zeros(0))  # (A,)


class ChainEngine:
    """Visual-inertial filter on a chain of segments. One instance per hand."""

    def __init__(
        self, hand: HandModel, glove: GloveModel, rig: StereoRig, params: ChainParams
    ) -> None:
        self._params, self._rig = params, rig
        self._layout = ChainLayout(hand, glove)
        self._pixels = PixelModel(self._layout, rig, params.noise)
        self._constraints = Constraints(self._layout, params.constraint)
        self._starter = Starter(self._layout, rig, params)
        self._output = HandOutput(self._layout)
        self._buffer = ImuBuffer()
        self._health = ImuHealth(len(glove.imus))
        self._filter = initial_state(self._layout)
        self._filter.P = initial_covariance(self._layout, params.prior)
        self._head = self._filter.copy_nominal()
        self._track = _Track(
            seen=np.full(len(glove.markers), -np.inf),
            felt=np.full(len(glove.imus), -np.inf),
            tip_sd=np.zeros(len(self._layout.active)),
            lag=params.match.max_frame_delay,
        )
        self._waiting: list[BlobFrame] = []
        self._results: list[FrameResult] = []

    # ---- messages in

    def feed_imu(self, sample: ImuSample) -> Estimate:
        sample = self._health.check(sample)
        if not self._buffer.add(sample):
            return self.predict(sample.t)
        self._welcome(sample)
        self._track.felt[sample.valid] = sample.t
        self._process_waiting()
        self._keep_up(sample.t)
        if self._track.tracking != Tracking.SEARCHING:
            self._carry(self._head, sample.t)
        return self._estimate(self._head, sample.t)

    def feed_frame(self, frame: BlobFrame) -> None:
        self._waiting.append(frame)
        self._process_waiting()

    def take_results(self) -> list[FrameResult]:
        out, self._results = self._results, []
        return out

    # ---- time

    def _process_waiting(self) -> None:
        while self._waiting:
            frame = self._waiting[0]
            if not self._ready(frame):
                return
            self._waiting.pop(0)
            self._process(frame)
            self._rebuild_head()

    def _ready(self, frame: BlobFrame) -> bool:
        """Covered by packets, or the glove has been silent for too long to wait for them."""
        if self._buffer.covers(frame.t):
            return True
        newest, now = self._buffer.newest, self._waiting[-1].t_arrival
        return newest is not None and now - newest.t > self._params.match.lost_after

    def _welcome(self, sample: ImuSample) -> None:
        """A segment whose IMU was away may stand anywhere: doubt it, its own weight aside."""
        away = np.asarray(sample.valid) & (sample.t - self._track.felt > RETURN_AFTER)
        for j in np.flatnonzero(away & np.isfinite(self._track.felt)):
            rows = self._layout.theta + 3 * self._layout.imu_segment[j] + np.arange(3)
            self._filter.P[rows, rows] += self._params.prior.returned**2

    def _keep_up(self, now: float) -> None:
        """Without pictures the filter follows at a fixed lag, held together by anatomy."""
        if self._track.tracking == Tracking.SEARCHING or self._waiting:
            return
        target = now - self._track.lag
        if target <= self._filter.t:
            return
        self._advance(target)
        self._judge(target, enough=False)
        if target - self._track.last_constraint >= self._params.constraint.tilt_period:
            self._constrain(target)
        if self._head.t < self._filter.t:
            self._rebuild_head()

    def _advance(self, t: float) -> None:
        """Move the filter to ``t`` through every packet on the way."""
        while self._filter.t < t:
            step = self._next_interval(self._filter.t, t)
            propagate(self._filter, self._layout, self._params, *step, coasting=self._is_coasting())
            self._filter.t = min(self._filter.t, t)
            if t - self._filter.t < 1e-9:
                self._filter.t = t
            self._tilt()

    def _next_interval(self, start: float, end: float) -> tuple[ImuSample, float]:
        """Mean readings and length of the interval from ``start`` to the next packet or ``end``."""
        later = self._buffer.after(start)
        stop = min(later[0].t, end) if later else end
        middle = self._buffer.at((start + stop) / 2)
        if middle is None or not later or later[0].t - start > 0.25:
            return self._silence(stop), stop - start
        return middle, stop - start

    def _silence(self, t: float) -> ImuSample:
        n = len(self._layout.glove.imus)
        zero = np.zeros((n, 3))
        return ImuSample(t, t, np.nan, -1, zero, zero.copy(), np.zeros(n, bool))

    def _is_coasting(self) -> bool:
        return self._filter.t - self._track.last_good > self._params.match.lost_after

    def _carry(self, state: ChainState, t: float) -> None:
        """Move a nominal state (no covariance) to ``t``."""
        while t - state.t > 1e-9:
            sample, dt = self._next_interval(state.t, t)
            propagate(
                state,
                self._layout,
                self._params,
                sample,
                dt,
                coasting=self._is_coasting(),
                covariance=False,
            )

    def _rebuild_head(self) -> None:
        self._head = self._filter.copy_nominal()
        newest = self._buffer.newest
        if newest is not None and self._track.tracking != Tracking.SEARCHING:
            self._carry(self._head, newest.t)

    # ---- measurements

    def _tilt(self) -> None:
        """Relative tilt from the accelerometers, at most every ``tilt_period``."""
        t = self._filter.t
        if t - self._track.last_tilt < self._params.constraint.tilt_period:
            return
        before, now, after = (self._buffer.at(t + d) for d in (-0.01, 0.0, 0.01))
        if before is None or now is None or after is None or not before.t < now.t < after.t:
            return
        rows = tilt_rows(self._filter, self._layout, self._params.constraint, before, now, after)
        if rows is not None:
            self._track.last_tilt = t
            self._update(*rows)

    def _constrain(self, t: float) -> None:
        self._track.last_constraint = t
        self._update(*self._constraints.rows(self._filter))

    def _update(self, H: Array, r: Array, variance: Array) -> None:
        HP = H @ self._filter.P
        dx, self._filter.P = update_with(self._filter.P, HP, HP @ H.T, r, np.diag(variance))
        inject(self._filter, self._layout, dx)

    def _process(self, frame: BlobFrame) -> None:
        seen = seen_blobs(frame, self._rig, self._layout.glove.hues)
        pose = frame.pose or self._rig.pose
        if self._track.tracking == Tracking.SEARCHING:
            self._start(frame, seen, pose)
            return
        if frame.t <= self._filter.t:
            self._wait_longer(frame.t)
            return
        self._advance(frame.t)
        prediction = self._predict(self._filter, pose)
        match = self._pixels.match(prediction, seen)
        if self._should_search(frame.t, prediction, match):
            self._track.last_search = frame.t
            prediction, match = self._search_again(seen, pose, prediction, match)
        self._correct(prediction, seen, match)
        self._judge(frame.t, self._count(match) >= self._params.match.min_markers)
        self._finish(frame, seen, prediction, match)

    def _wait_longer(self, t: float) -> None:
        """A picture came after the filter had gone on without it: the next ones are waited for."""
        newest = self._buffer.newest
        if newest is not None and t > self._track.last_frame:
            late = newest.t - t + LATE_MARGIN
            self._track.lag = min(max(self._track.lag, late), self._params.match.longest_delay)

    def _search_again(
        self,
        seen: tuple[SeenBlobs, ...],
        pose: CameraPose,
        prediction: Prediction,
        match: IntArray,
    ) -> tuple[Prediction, IntArray]:
        """Move to a better place where the pictures show one; else all stays as it is."""
        found = self._starter.again(self._filter, seen, pose, self._count(match))
        if found is None:
            return prediction, match
        before = self._filter
        self._filter = before.copy()
        self._filter.R_GB, self._filter.p, self._filter.v = found.R_GB, found.p, np.zeros(3)
        reset_pose(self._filter.P, self._layout, self._params.prior)
        there = self._predict(self._filter, pose)
        matched = self._pixels.match(there, seen)
        if self._count(matched) <= 1.2 * self._count(match):
            self._filter = before
            return prediction, match
        return there, matched

    def _start(self, frame: BlobFrame, seen: tuple[SeenBlobs, ...], pose: CameraPose) -> None:
        if frame.t - self._track.last_search < self._params.match.search_period:
            return
        self._track.last_search = frame.t
        started = self._starter.first(self._buffer, seen, pose, frame.t)
        if started is None:
            return
        self._filter = started
        self._track.tracking = Tracking.TRACKING
        self._track.last_good = frame.t
        for _ in range(2):  # the second pass matches and linearises at a better place
            prediction = self._predict(self._filter, pose)
            match = self._pixels.match(prediction, seen)
            self._correct(prediction, seen, match)
        self._finish(frame, seen, prediction, match)

    def _predict(self, state: ChainState, pose: CameraPose) -> Prediction:
        p_GB = segment_positions(state, self._layout)
        R_all, p_all, *_ = self._output.complete(state.R_GB, p_GB, state.scale3())
        return self._pixels.predict(state, pose, R_all, p_all)

    def _correct(
        self, prediction: Prediction, seen: tuple[SeenBlobs, ...], match: IntArray
    ) -> None:
        """One stacked update: pixels and anatomy, linearised at the same place."""
        H, r, variance = self._constraints.rows(self._filter)
        HP, R = H @ self._filter.P, np.diag(variance)
        if np.any(match >= 0):
            H_px, HP_px, r_px, R_px = self._pixels.rows(prediction, seen, match)
            H, HP, r = (
                np.concatenate([H_px, H]),
                np.concatenate([HP_px, HP]),
                np.concatenate([r_px, r]),
            )
            R_px, R = R, R_px
            both = np.zeros((len(r), len(r)))
            both[: len(R), : len(R)] = R
            both[len(R) :, len(R) :] = R_px
            R = both
        dx, self._filter.P = update_with(self._filter.P, HP, HP @ H.T, r, R)
        inject(self._filter, self._layout, dx)
        self._track.last_constraint = self._filter.t

    # ---- state of tracking

    @staticmethod
    def _count(match: IntArray) -> int:
        """Markers matched in at least one picture."""
        return int(np.sum(np.any(match >= 0, axis=0)))

    def _should_search(self, t: float, prediction: Prediction, match: IntArray) -> bool:
        """Lost, or too few of the expected markers are there for too long."""
        p = self._params.match
        expected = float(prediction.prior.max(axis=0).sum())
        doubtful = self._count(match) < max(p.min_markers, 0.35 * expected)
        self._track.doubtful_since = min(self._track.doubtful_since, t) if doubtful else np.inf
        return (
            t - self._track.doubtful_since >= p.lost_after or self._is_coasting()
        ) and t - self._track.last_search >= p.search_period / 10

    def _judge(self, t: float, enough: bool) -> None:
        if enough:
            self._track.last_good = t
            self._track.tracking = Tracking.TRACKING
            return
        gap = t - self._track.last_good
        if gap > self._params.match.coast_limit:
            self._track.tracking = Tracking.LOST
        elif gap > self._params.match.lost_after:
            self._track.tracking = Tracking.COASTING

    def _finish(
        self,
        frame: BlobFrame,
        seen: tuple[SeenBlobs, ...],
        prediction: Prediction,
        match: IntArray,
    ) -> None:
        self._track.last_frame = frame.t
        self._track.seen[np.any(match >= 0, axis=0)] = frame.t
        self._track.tip_sd = self._tip_sd()
        self._results.append(
            frame_result(frame, self._rig, self._track.tracking, prediction, seen, match)
        )

    def _tip_sd(self) -> Array:
        """(A,) m: root of the mean variance of each active segment's end."""
        lay = self._layout
        rows = np.arange(len(lay.active))
        nominal = np.zeros((len(rows), 3))
        nominal[:, 0] = [lay.hand.segments[h].length for h in lay.active]
        none = np.full(len(rows), -1, np.int64)
        H = point_jacobians(self._filter, lay, rows, nominal, np.zeros_like(nominal), none)
        HP = (H.reshape(-1, lay.size) @ self._filter.P).reshape(H.shape)
        return np.sqrt(np.maximum(np.einsum("akn,akn->a", HP, H) / 3, 0))

    # ---- messages out

    def predict(self, t: float) -> Estimate:
        state = self._head.copy_nominal()
        if self._track.tracking != Tracking.SEARCHING:
            self._carry(state, t)
        return self._estimate(state, t)

    def _estimate(self, state: ChainState, t: float) -> Estimate:
        p_GB = segment_positions(state, self._layout)
        tracking = self._track.tracking
        return self._output.estimate(
            t,
            state.R_GB,
            p_GB,
            state.scale3(),
            Sensed(self._sensed(t), tracking),
            self._track.tip_sd,
        )

    def _sensed(self, t: float) -> IntArray:
        lay = self._layout
        out = np.zeros(len(lay.active), np.int64)
        out[lay.imu_segment[t - self._track.felt < SEEN_LATELY]] = 1
        out[lay.marker_segment[t - self._track.seen < SEEN_LATELY]] = 1
        return out

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        if self._track.tracking in (Tracking.SEARCHING, Tracking.LOST):
            return None
        state = self._head.copy_nominal()
        self._carry(state, t)
        p_G = marker_positions(state, self._layout)
        sd = self._track.tip_sd[self._layout.marker_segment]
        return p_G, sd, np.arange(len(p_G))

    def calibration(self) -> Calibration:
        return calibration_of(self._layout, self._filter)

    def profile(self) -> WearerProfile:
        """What has been learned of the wearer."""
        return profile_of(self._filter, self._layout)

    def put_on(self, profile: WearerProfile) -> None:
        """Take what is known of the wearer, now and at each new start."""
        self._starter.profile = profile
        wear(self._filter, self._layout, profile)
        self._rebuild_head()

    @property
    def layout(self) -> ChainLayout:
        return self._layout

    # ---- saving

    _KEPT = ("_filter", "_head", "_track", "_waiting", "_results")

    def get_state(self) -> dict[str, Any]:
        out = {name: copy.deepcopy(getattr(self, name)) for name in self._KEPT}
        out["buffer"] = self._buffer.state()
        out["health"] = self._health.state()
        return out

    def set_state(self, state: dict[str, Any]) -> None:
        for name in self._KEPT:
            setattr(self, name, copy.deepcopy(state[name]))
        self._buffer.restore(state["buffer"])
        self._health.restore(state["health"])
