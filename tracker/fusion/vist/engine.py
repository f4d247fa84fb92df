"""The vist engine: Lee et al. 2021 on packets and images, with an automatic start.

The ring buffer that brings late images and the present together: `tracker.fusion.time.lagged`.
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.ablations.variants import check_variant
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pixels import SeenBlobs, seen_blobs
from tracker.fusion.chain.start.start import Starter
from tracker.fusion.output.output import HandOutput, Sensed
from tracker.fusion.time.imu_buffer import Intervals, Readings
from tracker.fusion.time.lagged import LaggedEngine
from tracker.fusion.vist.filter import VistFilter
from tracker.fusion.vist.layout import VistLayout
from tracker.fusion.vist.markers import Expected, MarkerModel, Matched, Previous
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
    ImuSample,
    IntArray,
    Tracking,
)
from tracker.vision.rig import StereoRig
from tracker.vision.visibility import both_cameras

SEEN_LATELY = 0.5  # s

Seen = tuple[SeenBlobs, ...]


class VistEngine(LaggedEngine[VistState]):
    """The paper's filter for one hand; an `Engine`.

    Raises ConfigError for a glove that leaves a segment of a chain without IMU, and for settings
    without meaning.
    """

    _KEPT = (*LaggedEngine._KEPT, "_track", "_guide")

    def __init__(
        self, hand: HandModel, glove: GloveModel, rig: StereoRig, params: VistParams
    ) -> None:
        check_variant(params.match.guide, params.coupling)
        self._params, self._rig = params, rig
        self._layout = VistLayout(hand, glove)
        timing = params.tracking
        super().__init__(
            len(glove.imus), blank_state(self._layout), timing.lost_after, timing.max_frame_delay
        )
        self._filter = VistFilter(self._layout, params)
        self._markers = MarkerModel(self._layout, rig, params.noise, params.match)
        self._starter = Starter(self._layout.chain, rig, ChainParams())
        self._output = HandOutput(self._layout.chain)
        self._track = Track(
            seen=np.full(len(self._layout.kept), -np.inf),
            felt=np.full(len(glove.imus), -np.inf),
            tip_sd=np.zeros(self._layout.n),
        )
        self._guide: Previous | None = None  # only where correspondence is made from it

    @property
    def tracking(self) -> Tracking:
        return self._track.tracking

    # ---- time

    def _heard(self, sample: ImuSample) -> None:
        self._track.felt[sample.valid] = sample.t

    def _step(self, way: Intervals, first: int) -> int:
        stop = float(way.stop[first])
        self._move(self._state, way.mean(first), stop - self._state.t, covariance=True)
        self._state.t = stop
        return first + 1

    def _carry(self, state: VistState, t: float) -> None:
        for sample, stop in self._buffer.intervals(state.t, t):
            self._move(state, sample, stop - state.t, covariance=False)
            state.t = stop

    def _move(self, state: VistState, sample: Readings, dt: float, covariance: bool) -> None:
        coasting = self._track.is_coasting(self._state.t, self._params.tracking)
        noise = self._params.noise
        propagate(state, self._layout, noise, sample, dt, coasting=coasting, covariance=covariance)

    def _without_image(self, t: float) -> None:
        """Held together by anatomy."""
        self._track.judge(t, False, self._params.tracking)
        if t - self._track.last_constraint >= self._params.constraint.period:
            self._filter.constrain(self._state)
            self._rest()
            self._track.last_constraint = t
            self._track.tip_sd = self._filter.tip_sd(self._state)
            self._rebuild_head()

    def _rest(self) -> None:
        """While nothing is seen, a hand that keeps still does not drift."""
        t, root = self._state.t, int(self._layout.imu_of[0])
        coasting = self._track.is_coasting(t, self._params.tracking)
        if coasting and is_still(list(self._buffer), t, root, self._state.bg[0]):
            self._filter.rest(self._state)

    # ---- images

    def _process(self, frame: BlobFrame) -> None:
        seen = seen_blobs(frame, self._rig, self._layout.chain.glove.hues)
        pose = frame.pose or self._rig.pose
        self._rest()
        expected, matched = self._look(self._state, seen, pose, self._previous(frame.t))
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
        """Markers as ``state`` expects them, and which were recognised near there, or near where
        the ``previous`` image left them."""
        expected = self._markers.expect(state, pose)
        return expected, self._markers.match(previous or expected, seen, pose)

    def _previous(self, t: float) -> Expected | None:
        """What correspondence is made from where the IMUs' prediction shall not be used."""
        return self._guide.at(t, self._params.prior.velocity) if self._guide else None

    def _start(self, frame: BlobFrame) -> None:
        """Look for the hand from nothing, at most every ``search_period``."""
        if frame.t - self._track.last_search < self._params.tracking.search_period:
            return
        self._track.last_search = frame.t
        seen = seen_blobs(frame, self._rig, self._layout.chain.glove.hues)
        pose = frame.pose or self._rig.pose
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
        """Move to a better place where the images show one; else all stays as it is."""
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
            self._guide = Previous(frame.t, self._markers.expect(self._state, pose))
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
        segment = self._layout.chain.marker_segment
        p_G = positions(self._head_at(t), segment, self._layout.marker_lever)
        return p_G, self._track.tip_sd[segment], self._layout.kept.copy()

    def calibration(self) -> Calibration:
        return calibration_of(self._layout, self._state)
