"""The chain engine: one root position, one orientation per segment, joints that hold exactly.

How it treats time is in `lagged`; what it takes from images in `pixels`, from the accelerometers
in `tilt`, from anatomy in `constraints`.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracker.fusion.ablations.variants import check_variant
from tracker.fusion.chain.bundle.solver import Bundle, BundleWork
from tracker.fusion.chain.calibration import control
from tracker.fusion.chain.calibration.chain_calibration import AROUND, CalibratedChain
from tracker.fusion.chain.constraints import Constraints
from tracker.fusion.chain.kinematics import marker_positions, segment_positions, tip_sd
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.loose import LooseRows
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pixels import PixelModel, Prediction, SeenBlobs, Tally, seen_blobs
from tracker.fusion.chain.previous import Previous
from tracker.fusion.chain.prior import initial_covariance, reset_pose
from tracker.fusion.chain.profile import WearerProfile, profile_of, wear
from tracker.fusion.chain.propagate import carry, propagate
from tracker.fusion.chain.reports import frame_result
from tracker.fusion.chain.start.mono_start import (
    KNOWN_SIZE_SD,
    SIZE_SD,
    release_size,
    with_unsure_distance,
)
from tracker.fusion.chain.start.start import Starter
from tracker.fusion.chain.state import ChainState, initial_state, inject
from tracker.fusion.chain.tilt import tilt_rows
from tracker.fusion.kalman import correct
from tracker.fusion.output.output import HandOutput, Sensed
from tracker.fusion.output.output_kernel import sensed_lately
from tracker.fusion.sparse import joined, products
from tracker.fusion.time.imu_buffer import Intervals
from tracker.fusion.time.lagged import LaggedEngine
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    Array,
    BlobFrame,
    CameraPose,
    Estimate,
    ImuSample,
    IntArray,
    Tracking,
)
from tracker.vision.rig import StereoRig

MANY_MARKERS = 6  # in an image that shows the hand
SEEN_LATELY = 0.5  # s
IN_VAIN = 0.3  # s of images with markers in which a lost hand is not found as it was last
KEEP_CALIBRATION = 5.0  # s after which a hand that is still lost is looked for without it
RETURN_AFTER = 0.15  # s of silence after which a segment is doubted


@dataclass(eq=False)
class _Track:
    """What changes beside the filter itself."""

    tracking: Tracking = Tracking.SEARCHING
    last_good: float = -np.inf  # last image with enough matches
    one_camera: bool = False  # started with one lens, and no marker was seen by both since
    last_search: float = -np.inf
    last_start: float = -np.inf  # last search from nothing
    in_vain_since: float = np.inf  # lost, although images show markers
    last_tilt: float = -np.inf
    last_constraint: float = -np.inf
    doubtful_since: float = np.inf
    seen: Array = field(default_factory=lambda: np.zeros(0))  # (M,) when each marker was seen last
    felt: Array = field(default_factory=lambda: np.zeros(0))  # (n,) when each IMU answered last
    tip_sd: Array = field(default_factory=lambda: np.zeros(0))  # (A,)


class ChainEngine(CalibratedChain):
    """Visual-inertial filter on a chain of segments. One instance per hand."""

    _KEPT = (*LaggedEngine._KEPT, "_track", "_held", "_known", "_guide", "_work")

    def __init__(
        self, hand: HandModel, glove: GloveModel, rig: StereoRig, params: ChainParams
    ) -> None:
        check_variant(params.guide, params.coupling)
        self._params, self._rig = params, rig
        self._still = control.without_walks(params)
        self._held = None
        self._guide: Previous | None = None  # only where correspondence is made from it
        self._layout = layout = ChainLayout(hand, glove)
        state = initial_state(layout)
        state.P = initial_covariance(layout, params.prior)
        super().__init__(
            len(glove.imus), state, params.match.lost_after, params.match.max_frame_delay
        )
        self._pixels = PixelModel(layout, rig, params.noise)
        self._loose = LooseRows(layout, rig, params.noise)
        self._constraints = Constraints(layout, params.constraint)
        self._starter = Starter(layout, rig, params)
        self._bundle, self._work = Bundle(layout, rig, params), BundleWork()
        self._output = HandOutput(layout)
        self._track = _Track(
            seen=np.full(len(glove.markers), -np.inf),
            felt=np.full(len(glove.imus), -np.inf),
            tip_sd=np.zeros(len(layout.active)),
        )

    @property
    def tracking(self) -> Tracking:
        return self._track.tracking

    # ---- time

    def _heard(self, sample: ImuSample) -> None:
        self._welcome(sample)
        self._track.felt[sample.valid] = sample.t

    def _welcome(self, sample: ImuSample) -> None:
        """A segment whose IMU was away may stand anywhere: doubt it, its own weight aside."""
        if sample.t - self._track.felt.min(initial=np.inf) <= RETURN_AFTER:
            return
        away = np.asarray(sample.valid) & (sample.t - self._track.felt > RETURN_AFTER)
        for j in np.flatnonzero(away & np.isfinite(self._track.felt)):
            rows = self._layout.theta + 3 * self._layout.imu_segment[j] + np.arange(3)
            self._state.P[rows, rows] += self._params.prior.returned**2

    def _step(self, way: Intervals, first: int) -> int:
        params = self._params if self._held is None else self._still
        end = self._step_end(way, first)
        coasting = self._track.last_good, params.match.lost_after
        propagate(self._state, self._layout, params, way, slice(first, end), coasting)
        return end

    def _step_end(self, way: Intervals, first: int) -> int:
        """After the first interval at whose end relative tilt is due, or the last one."""
        end = first + 1
        while end < len(way.stop) and not self._tilt_is_due(float(way.stop[end - 1])):
            end += 1
        return end

    def _tilt_is_due(self, t: float) -> bool:
        return t - self._track.last_tilt >= self._params.constraint.period

    def _carry(self, state: ChainState, t: float) -> None:
        carry(state, self._layout, self._buffer, t, self._is_coasting())

    def _stepped(self) -> None:
        self._tilt()

    def _without_image(self, t: float) -> None:
        """Held together by anatomy."""
        self._judge(t, enough=False)
        if t - self._track.last_constraint >= self._params.constraint.period:
            self._constrain(t)

    def _is_coasting(self) -> bool:
        return self._state.t - self._track.last_good > self._params.match.lost_after

    # ---- measurements

    def _tilt(self) -> None:
        """Relative tilt from the accelerometers, at most every ``period``."""
        t = self._state.t
        if not self._tilt_is_due(t):
            return
        before, now, after = (self._buffer.at(t + d) for d in AROUND)
        if before is None or now is None or after is None or not before.t < now.t < after.t:
            return
        rows = tilt_rows(self._state, self._layout, self._params.constraint, before, now, after)
        if rows is not None:
            self._track.last_tilt = t
            self._update(*rows)

    def _constrain(self, t: float) -> None:
        self._track.last_constraint = t
        self._update(*self._constraints.rows(self._state))

    def _update(self, H: Array, r: Array, variance: Array) -> None:
        HP, HPH = products(H, self._state.P)
        self._learn(H, HP, HPH, r, np.diag(variance))

    def _learn(self, H: Array, HP: Array, HPH: Array, r: Array, R: Array) -> None:
        """One update with H (m, N), H P, H P Hᵀ, innovation r (m,) and its noise R (m, m)."""
        dx = correct(self._state.P, HP, HPH, r, R)
        inject(self._state, self._layout, dx)

    def _process(self, frame: BlobFrame) -> None:
        if frame.t - self._track.in_vain_since > IN_VAIN and self._begin_anew(frame):
            return
        seen = seen_blobs(frame, self._rig, self._layout.glove.hues)
        pose = frame.pose or self._rig.pose
        prediction = self._predict(self._state, pose)
        match = self._pixels.match(self._compared(prediction, frame.t), seen)
        tally = Tally.of(prediction, match)
        if self._should_search(frame.t, tally):
            self._track.last_search = frame.t
            prediction, match = self._search_again(seen, pose, prediction, match)
            tally = Tally.of(prediction, match)
        self._correct(prediction, seen, match, pose)
        self._judge(frame.t, self._enough(tally))
        self._finish(frame, seen, prediction, match)
        looked = self.tracking == Tracking.LOST and max(len(s.uv) for s in seen) >= MANY_MARKERS
        since = min(self._track.in_vain_since, frame.t)
        self._track.in_vain_since = since if looked else np.inf
        if self._params.bundle.enabled and self._held is None and self._known is None:
            self._calibrate(seen, match, pose)

    def _search_again(
        self,
        seen: tuple[SeenBlobs, ...],
        pose: CameraPose,
        prediction: Prediction,
        match: IntArray,
    ) -> tuple[Prediction, IntArray]:
        """Move to a better place where the images show one; else all stays as it is."""
        count = Tally.of(prediction, match).matched
        found = self._starter.again(self._state, seen, pose, count)
        if found is None:
            return prediction, match
        before = self._state
        self._state = before.copy()
        self._state.R_GB, self._state.p, self._state.v = found.R_GB, found.p, np.zeros(3)
        reset_pose(self._state.P, self._layout, self._params.prior)
        there = self._predict(self._state, pose)
        matched = self._pixels.match(there, seen)
        if Tally.of(there, matched).matched <= 1.2 * count:
            self._state = before
            return prediction, match
        return there, matched

    def _begin_anew(self, frame: BlobFrame) -> bool:
        """Look for the lost hand as at the start: by now it may be turned and bent in any way.

        What is known of the wearer is kept, unless it is so long that it may be what is wrong.
        """
        lately = frame.t - self._track.last_good < KEEP_CALIBRATION
        self._start(frame, profile_of(self._state, self._layout) if lately else None)
        return self.tracking == Tracking.TRACKING

    def _adopt(self, state: ChainState) -> None:
        """Go on from a state that has nothing to do with the one before."""
        self._state = state

    def _start(self, frame: BlobFrame, known: WearerProfile | None = None) -> None:
        if frame.t - self._track.last_start < self._params.match.search_period:
            return
        self._track.last_start = frame.t
        seen = seen_blobs(frame, self._rig, self._layout.glove.hues)
        pose = frame.pose or self._rig.pose
        started = self._starter.first(self._buffer, seen, pose, frame.t, known)
        if started is None:
            return
        self._adopt(started)
        self._track.in_vain_since = np.inf
        if self._held is not None:
            wear(self._state, self._layout, self._held)
            control.hold_calibration(self._state, self._layout)
        self._track.tracking = Tracking.TRACKING
        self._track.last_good = frame.t
        self._track.one_camera = any(len(s.uv) == 0 for s in seen)
        for _ in range(2):  # the second pass matches and linearises at a better place
            prediction = self._predict(self._state, pose)
            match = self._pixels.match(prediction, seen)
            self._correct(prediction, seen, match, pose)
        self._finish(frame, seen, prediction, match)

    def _predict(self, state: ChainState, pose: CameraPose) -> Prediction:
        return self._pixels.predict(state, pose)

    def _compared(self, prediction: Prediction, t: float) -> Prediction:
        """What blobs are compared with: usually the prediction."""
        return self._guide.at(t, self._params.prior.velocity) if self._guide else prediction

    def _correct(
        self,
        prediction: Prediction,
        seen: tuple[SeenBlobs, ...],
        match: IntArray,
        pose: CameraPose,
    ) -> None:
        """One stacked update: what was seen and anatomy, linearised at the same place."""
        H, r, variance = self._constraints.rows(self._state)
        variance = variance * self._how_often()
        rows = self._seen_rows(prediction, seen, match, pose)
        self._learn(*joined(*rows, H, r, variance, self._state.P))
        self._track.last_constraint = self._state.t

    def _seen_rows(
        self,
        prediction: Prediction,
        seen: tuple[SeenBlobs, ...],
        match: IntArray,
        pose: CameraPose,
    ) -> tuple[Array, Array, Array, Array]:
        if self._params.coupling == "loose":
            return self._loose(self._state, prediction, seen, match, pose)
        return self._pixels.rows(prediction, seen, match)

    def _how_often(self) -> float:
        """Factor on anatomy's variance: at twice the usual rate each use says half as much."""
        since = max(self._state.t - self._track.last_constraint, 1e-3)
        return max(1.0, self._params.constraint.period / since)

    # ---- state of tracking

    def _enough(self, tally: Tally) -> bool:
        """Markers to go by: some, or most of the few that can be seen of a hand edge-on."""
        p = self._params.match
        return tally.matched >= min(p.min_markers, max(p.least_markers, 0.6 * tally.expected))

    def _should_search(self, t: float, tally: Tally) -> bool:
        """Lost, or too few of the expected markers are there for too long."""
        p = self._params.match
        doubtful = tally.matched < max(p.min_markers, 0.35 * tally.expected)
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
        self._track.seen[match.max(axis=0) >= 0] = frame.t
        self._track.tip_sd = self._tip_sd(frame, match)
        if self._params.guide == "previous":
            pose = frame.pose or self._rig.pose
            self._guide = Previous(frame.t, self._predict(self._state, pose))
        self._results.append(
            frame_result(frame, self._rig, self._track.tracking, prediction, seen, match)
        )

    def _tip_sd(self, frame: BlobFrame, match: IntArray) -> Array:
        """(A,) m: of each active segment's end. One lens alone does not know the distance."""
        sd = tip_sd(self._state, self._layout)
        if self._track.one_camera and np.all(match >= 0, axis=0).any():
            self._track.one_camera = False
            release_size(self._state.P, self._layout, self._params.prior)
        if not self._track.one_camera:
            return sd
        size_sd = SIZE_SD if self._starter.profile is None else KNOWN_SIZE_SD
        pose = frame.pose or self._rig.pose
        return with_unsure_distance(sd, self._state.p, pose, size_sd)

    # ---- messages out

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
        lay, track = self._layout, self._track
        return sensed_lately(
            track.felt, lay.imu_segment, track.seen, lay.marker_segment, len(lay.active),
            t, SEEN_LATELY,
        )  # fmt: skip

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        if self._track.tracking in (Tracking.SEARCHING, Tracking.LOST):
            return None
        p_G = marker_positions(self._head_at(t), self._layout)
        sd = self._track.tip_sd[self._layout.marker_segment]
        return p_G, sd, np.arange(len(p_G))
