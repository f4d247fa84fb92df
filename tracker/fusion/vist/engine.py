"""The vist engine: Lee et al. 2021 on packets and pictures, with an automatic start.

The filter lives at the exposure of the last picture, or a fixed lag behind the newest packet when
no picture comes; the ring buffer of packets carries a copy of it to the present. A late picture
therefore needs no rolling back: it waits until packets cover its exposure.
"""

from __future__ import annotations

import copy
from typing import Any

import numpy as np

from tracker.fusion.health import ImuHealth
from tracker.fusion.imu_buffer import ImuBuffer
from tracker.fusion.output import HandOutput, Sensed
from tracker.fusion.params import ChainParams
from tracker.fusion.pixels import SeenBlobs, seen_blobs
from tracker.fusion.start import Starter
from tracker.fusion.vist.filter import VistFilter
from tracker.fusion.vist.layout import VistLayout
from tracker.fusion.vist.markers import Expected, MarkerModel, Matched
from tracker.fusion.vist.params import VistParams
from tracker.fusion.vist.points import positions
from tracker.fusion.vist.propagate import propagate
from tracker.fusion.vist.reports import calibration_of, frame_result
from tracker.fusion.vist.rest import is_still
from tracker.fusion.vist.state import (
    VistState,
    as_chain,
    blank_state,
    from_chain,
    initial_covariance,
    reset_motion,
)
from tracker.fusion.vist.track import Track, is_better
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
from tracker.vision.correspondence import both_cameras
from tracker.vision.rig import StereoRig

SEEN_LATELY = 0.5  # s
LONGEST_STEP = 0.25  # s between packets, beyond which the glove counts as silent

Seen = tuple[SeenBlobs, ...]


class VistEngine:
    """The paper's filter for one hand; an `Engine`.

    Raises ConfigError for a glove that leaves a segment of a chain without IMU.
    """

    _KEPT = ("_state", "_head", "_track", "_guide", "_waiting", "_results")

    def __init__(
        self, hand: HandModel, glove: GloveModel, rig: StereoRig, params: VistParams
    ) -> None:
        self._params, self._rig = params, rig
        self._layout = VistLayout(hand, glove)
        self._filter = VistFilter(self._layout, params)
        self._markers = MarkerModel(self._layout, rig, params.noise, params.match)
        self._starter = Starter(self._layout.chain, rig, ChainParams())
        self._output = HandOutput(self._layout.chain)
        self._buffer = ImuBuffer()
        self._health = ImuHealth(len(glove.imus))
        self._state = blank_state(self._layout)
        self._head = self._state.copy_nominal()
        self._track = Track(
            seen=np.full(len(self._layout.kept), -np.inf),
            felt=np.full(len(glove.imus), -np.inf),
            tip_sd=np.zeros(self._layout.n),
        )
        self._guide: Expected | None = None  # markers after the last picture
        self._waiting: list[BlobFrame] = []
        self._results: list[FrameResult] = []

    # ---- messages in

    def feed_imu(self, sample: ImuSample) -> Estimate:
        sample = self._health.check(sample)
        if not self._buffer.add(sample):
            return self.predict(sample.t)
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
        while self._waiting and self._ready(self._waiting[0]):
            self._process(self._waiting.pop(0))
            self._rebuild_head()

    def _ready(self, frame: BlobFrame) -> bool:
        """Covered by packets, or the glove has been silent for too long to wait for them."""
        if self._buffer.covers(frame.t):
            return True
        newest, now = self._buffer.newest, self._waiting[-1].t_arrival
        return newest is not None and now - newest.t > self._params.tracking.lost_after

    def _keep_up(self, now: float) -> None:
        """Without pictures the filter follows at a fixed lag, held together by anatomy."""
        target = now - self._params.tracking.max_frame_delay
        searching = self._track.tracking == Tracking.SEARCHING
        if searching or self._waiting or target <= self._state.t:
            return
        self._advance(target)
        self._track.judge(target, False, self._params.tracking)
        if target - self._track.last_constraint >= self._params.constraint.period:
            self._filter.constrain(self._state)
            self._rest()
            self._track.last_constraint = target
            self._track.tip_sd = self._filter.tip_sd(self._state)
            self._rebuild_head()

    def _advance(self, t: float) -> None:
        """Move the filter, with its covariance, to ``t`` through every packet on the way."""
        self._move(self._state, t, covariance=True)

    def _carry(self, state: VistState, t: float) -> None:
        """Move a nominal state to ``t``."""
        self._move(state, t, covariance=False)

    def _move(self, state: VistState, t: float, covariance: bool) -> None:
        coasting = self._track.is_coasting(self._state.t, self._params.tracking)
        while t - state.t > 1e-9:
            sample, stop = self._next_interval(state.t, t)
            propagate(
                state,
                self._layout,
                self._params.noise,
                sample,
                stop - state.t,
                coasting=coasting,
                covariance=covariance,
            )
            state.t = stop

    def _next_interval(self, start: float, end: float) -> tuple[ImuSample, float]:
        """Mean readings from ``start`` to the next packet or ``end``, and that instant."""
        later = self._buffer.after(start)
        stop = min(later[0].t, end) if later else end
        middle = self._buffer.at((start + stop) / 2)
        if middle is None or not later or later[0].t - start > LONGEST_STEP:
            n = len(self._layout.imu_of)
            zero = np.zeros((n, 3))
            return ImuSample(stop, stop, np.nan, -1, zero, zero, np.zeros(n, bool)), stop
        return middle, stop

    def _rebuild_head(self) -> None:
        self._head = self._state.copy_nominal()
        newest = self._buffer.newest
        if newest is not None and self._track.tracking != Tracking.SEARCHING:
            self._carry(self._head, newest.t)

    def _rest(self) -> None:
        """While nothing is seen, a hand that keeps still does not drift."""
        t, root = self._state.t, int(self._layout.imu_of[0])
        coasting = self._track.is_coasting(t, self._params.tracking)
        if coasting and is_still(list(self._buffer), t, root, self._state.bg[0]):
            self._filter.rest(self._state)

    # ---- pictures

    def _process(self, frame: BlobFrame) -> None:
        seen = seen_blobs(frame, self._rig, self._layout.chain.glove.hues)
        pose = frame.pose or self._rig.pose
        if self._track.tracking == Tracking.SEARCHING:
            self._start(frame, seen, pose)
            return
        if frame.t <= self._state.t:
            return  # later than the longest delay: the filter has gone on without it
        self._advance(frame.t)
        self._rest()
        expected, matched = self._look(self._state, seen, pose, self._guide)
        likely = float(both_cameras(expected.prior).sum())
        if self._track.should_search(frame.t, len(matched), likely, self._params.tracking):
            self._track.last_search = frame.t
            expected, matched = self._search_again(seen, pose, expected, matched)
        enough = len(matched) >= self._params.tracking.min_markers
        if not enough and self._track.is_coasting(frame.t, self._params.tracking):
            matched = matched.none()  # in a wide gate a point or two may be anything
        since = max(frame.t - self._track.last_constraint, 1e-3)
        often = max(1.0, self._params.constraint.period / since)
        self._filter.correct(self._state, expected, matched, often)
        self._track.judge(frame.t, enough, self._params.tracking)
        self._finish(frame, seen, pose, expected, matched)

    def _look(
        self, state: VistState, seen: Seen, pose: CameraPose, previous: Expected | None
    ) -> tuple[Expected, Matched]:
        expected = self._markers.expect(state, pose)
        guide = expected
        if self._params.match.guide == "previous" and previous is not None:
            guide = previous
        return expected, self._markers.match(expected, guide, seen, pose)

    def _start(self, frame: BlobFrame, seen: Seen, pose: CameraPose) -> None:
        """Look for the hand from nothing, at most every ``search_period``."""
        if frame.t - self._track.last_search < self._params.tracking.search_period:
            return
        self._track.last_search = frame.t
        found = self._starter.first(self._buffer, seen, pose, frame.t)
        if found is None:
            return
        # the search takes gyro biases from a hand at rest, but tremor turns a finger at 0.1 rad/s:
        # over so short a time that is no bias
        found.bg[:] = 0.0
        self._state = from_chain(self._layout, found)
        self._state.P = initial_covariance(self._layout, self._params.prior)
        self._track.tracking, self._track.last_good = Tracking.TRACKING, frame.t
        for _ in range(2):  # the second pass matches and linearises at a better place
            expected, matched = self._look(self._state, seen, pose, None)
            self._filter.correct(self._state, expected, matched)
        self._finish(frame, seen, pose, expected, matched)

    def _search_again(
        self, seen: Seen, pose: CameraPose, expected: Expected, matched: Matched
    ) -> tuple[Expected, Matched]:
        """Move to a better place where the pictures show one; else all stays as it is."""
        chain = as_chain(self._layout, self._state)
        found = self._starter.again(chain, seen, pose, len(matched))
        if found is None:
            return expected, matched
        chain.R_GB, chain.p, chain.v = found.R_GB, found.p, np.zeros(3)
        placed = from_chain(self._layout, chain)
        trial = self._state.copy()
        trial.p_GI, trial.R_GI, trial.v_GI = placed.p_GI, placed.R_GI, placed.v_GI
        reset_motion(trial.P, self._layout, self._params.prior)
        there, recognised = self._look(trial, seen, pose, None)
        likely = float(both_cameras(there.prior).sum())
        if not is_better(len(recognised), len(matched), likely):
            return expected, matched
        self._state = trial
        return there, recognised

    def _finish(
        self, frame: BlobFrame, seen: Seen, pose: CameraPose, expected: Expected, matched: Matched
    ) -> None:
        self._track.last_constraint = frame.t
        self._track.seen[matched.marker] = frame.t
        self._track.tip_sd = self._filter.tip_sd(self._state)
        if self._params.match.guide == "previous":
            self._guide = self._markers.expect(self._state, pose)
        self._results.append(
            frame_result(
                frame,
                self._layout,
                self._rig,
                pose,
                self._track.tracking,
                expected,
                matched,
                seen,
            )
        )

    # ---- messages out

    def predict(self, t: float) -> Estimate:
        state = self._head.copy_nominal()
        if self._track.tracking != Tracking.SEARCHING:
            self._carry(state, t)
        return self._estimate(state, t)

    def _estimate(self, state: VistState, t: float) -> Estimate:
        return self._output.estimate(
            t,
            state.R_GB,
            state.p_GB(self._layout),
            state.scale,
            Sensed(self._sensed(t), self._track.tracking),
            self._track.tip_sd,
        )

    def _sensed(self, t: float) -> IntArray:
        out = (t - self._track.felt[self._layout.imu_of] < SEEN_LATELY).astype(np.int64)
        out[self._layout.chain.marker_segment[t - self._track.seen < SEEN_LATELY]] = 1
        return out

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        if self._track.tracking in (Tracking.SEARCHING, Tracking.LOST):
            return None
        state = self._head.copy_nominal()
        self._carry(state, t)
        segment = self._layout.chain.marker_segment
        p_G = positions(state, segment, self._layout.marker_lever)
        return p_G, self._track.tip_sd[segment], self._layout.kept.copy()

    def calibration(self) -> Calibration:
        return calibration_of(self._layout, self._state)

    # ---- saving

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
