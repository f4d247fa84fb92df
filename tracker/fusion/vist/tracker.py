"""The paper's filter in operation: processing of packets, of images, and of missing images."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.params import ChainParams, MatchParams
from tracker.fusion.chain.pixels import SeenBlobs, seen_blobs
from tracker.fusion.chain.row_exposure import RowExposure
from tracker.fusion.chain.start.start import Starter
from tracker.fusion.output.output import Sensed
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals, Readings
from tracker.fusion.time.timeline import behind_variance
from tracker.fusion.vist.filter import VistFilter
from tracker.fusion.vist.layout import VistLayout
from tracker.fusion.vist.markers import Expected, MarkerModel, Matched, PreviousMarkers
from tracker.fusion.vist.params import VistParams
from tracker.fusion.vist.propagate import propagate
from tracker.fusion.vist.reports import ahead_variance, frame_result
from tracker.fusion.vist.rest import is_still
from tracker.fusion.vist.state import (
    VistState,
    as_chain,
    blank_state,
    from_chain,
    initial_covariance,
    reset_motion,
)
from tracker.messages import (
    RECENT,
    Array,
    BlobFrame,
    CameraPose,
    FrameResult,
    ImuSample,
    Search,
    Tracking,
)
from tracker.vision.rig import StereoRig
from tracker.vision.visibility import both_cameras

DOUBTFUL_SHARE = 0.35  # of the expected markers
MIN_RECOGNISED = 5  # stereo points required to locate a hand
RECOGNISED_SHARE = 0.6  # of the expected markers
LOST_SD = 0.05  # m: an unseen hand with a larger position sd is lost


@record("vist.tracking", shapes={"seen": "M", "felt": "I", "tip_sd": "t"})
@dataclass(eq=False)
class Track:
    """State besides the filter. seen (M,), felt (I,): last times (s) of each marker and IMU."""

    seen: Array
    felt: Array
    tip_sd: Array
    tracking: Tracking = Tracking.SEARCHING
    last_good: float = -np.inf
    last_search: float = -np.inf
    last_constraint: float = -np.inf
    doubtful_since: float = np.inf

    def is_coasting(self, t: float, params: MatchParams) -> bool:
        """Whether no recent image had enough markers."""
        return t - self.last_good > params.lost_after

    def judge(self, t: float, enough: bool, params: MatchParams) -> None:
        """Call after an image, or where none arrived."""
        if enough:
            self.last_good, self.tracking = t, Tracking.TRACKING
        elif t - self.last_good > params.coast_limit and self.tip_sd[0] > LOST_SD:
            self.tracking = Tracking.LOST
        elif self.is_coasting(t, params):
            self.tracking = Tracking.COASTING

    def should_search(self, t: float, matched: int, expected: float, params: MatchParams) -> bool:
        """Whether the hand is lost, or too few of the expected markers matched for too long."""
        doubtful = matched < max(params.min_markers, DOUBTFUL_SHARE * expected)
        self.doubtful_since = min(self.doubtful_since, t) if doubtful else np.inf
        long = t - self.doubtful_since >= params.lost_after or self.is_coasting(t, params)
        return long and t - self.last_search >= params.search_period / 10


def is_better(recognised: int, matched: int, expected: float) -> bool:
    """Whether a pose found by a search is preferred to the present one.

    It must explain clearly more points, more than chance would, and most of the expected markers.
    """
    return recognised >= max(MIN_RECOGNISED, 1.2 * matched, RECOGNISED_SHARE * expected)


class SeenFrame(NamedTuple):
    """An exposure: blobs of both sides in rectified pixels, where the camera was, and what moved
    while a rolling shutter exposed its rows."""

    blobs: tuple[SeenBlobs, ...]
    pose: CameraPose
    rows: RowExposure | None

    def unturned(self, rig: StereoRig) -> tuple[SeenBlobs, ...]:
        """The blobs without the camera's turn while the rows were exposed."""
        if self.rows is None:
            return self.blobs
        return tuple(
            side._replace(uv=self.rows.turned_back(side.uv, bool(c), rig, self.pose))
            for c, side in enumerate(self.blobs)
        )


@record("vist.tracker")
@dataclass(eq=False)
class VistTrackerSavedState:
    """The complete state of a tracker."""

    state: VistState
    track: Track
    previous: PreviousMarkers | None = None  # only where correspondence is based on it


class VistTracker:
    """Connects the parts of the vist engine; a `Filter` that a `Timeline` drives. The order of its
    steps is that of fig. 2B of Lee et al. 2021, doi:10.1126/scirobotics.abe1315.
    """

    def __init__(
        self, layout: VistLayout, rig: StereoRig, params: VistParams, buffer: ImuBuffer
    ) -> None:
        self._layout, self._rig, self._params, self._buffer = layout, rig, params, buffer
        self._filter = VistFilter(layout, params)
        self._markers = MarkerModel(layout, rig, params.noise, params.match)
        self._starter = Starter(layout.chain, rig, ChainParams())
        track = Track(
            seen=np.full(len(layout.used_markers), -np.inf),
            felt=np.full(len(layout.glove.imus), -np.inf),
            tip_sd=np.zeros(layout.n),
        )
        self.saved = VistTrackerSavedState(blank_state(layout), track)

    @property
    def state(self) -> VistState:
        return self.saved.state

    def restore(self, saved: VistTrackerSavedState) -> None:
        """Restore a `saved` state, which is not copied."""
        self.saved = saved

    @property
    def tracking(self) -> Tracking:
        return self._track.tracking

    @property
    def _track(self) -> Track:
        return self.saved.track

    # ---- packets

    def packet(self, sample: ImuSample) -> None:
        self._track.felt[sample.valid] = sample.t

    def step(self, way: Intervals, first: int) -> int:
        stop = float(way.stop[first])
        self._move(self.state, way.mean(first), stop - self.state.t, covariance=True)
        self.state.t = stop
        return first + 1

    def carry(self, state: VistState, t: float) -> None:
        way = self._buffer.intervals(state.t, t)
        for k in range(len(way.stop)):
            stop = float(way.stop[k])
            self._move(state, way.mean(k), stop - state.t, covariance=False)
            state.t = stop

    def _move(self, state: VistState, sample: Readings, dt: float, covariance: bool) -> None:
        coasting = self._track.is_coasting(self.state.t, self._params.tracking)
        noise = self._params.noise
        propagate(state, self._layout, noise, sample, dt, coasting=coasting, covariance=covariance)

    def no_image(self) -> bool:
        """Applies anatomy alone."""
        t = self.state.t
        self._track.judge(t, False, self._params.tracking)
        if t - self._track.last_constraint < self._params.constraint.period:
            return False
        self._filter.constrain(self.state)
        self._rest()
        self._track.last_constraint = t
        self._track.tip_sd = self._filter.tip_sd(self.state)
        return True

    def _rest(self) -> None:
        """Prevents drift of a hand that is unseen and at rest."""
        t, root = self.state.t, int(self._layout.imu_of[0])
        coasting = self._track.is_coasting(t, self._params.tracking)
        if coasting and is_still(list(self._buffer), t, root, self.state.bg[0]):
            self._filter.rest(self.state)

    # ---- images

    def image(self, frame: BlobFrame) -> FrameResult:
        seen = self._seen(frame)
        self._rest()
        expected, matched = self._look(self.state, seen, self._previous(frame.t))
        likely = float(both_cameras(expected.prior).sum())
        if self._track.should_search(frame.t, len(matched), likely, self._params.tracking):
            self._track.last_search = frame.t
            expected, matched = self._search_again(seen, expected, matched)
        enough = len(matched) >= self._params.tracking.min_markers
        if not enough and self._track.is_coasting(frame.t, self._params.tracking):
            matched = matched.none()  # in a wide gate, one or two points may be chance matches
        since = max(frame.t - self._track.last_constraint, 1e-3)
        often = max(1.0, self._params.constraint.period / since)
        self._filter.correct(self.state, expected, matched, often)
        self._track.judge(frame.t, enough, self._params.tracking)
        if enough:
            self.state.held_back = np.zeros((2, 3))
        return self._finish(frame, seen, expected, matched)

    def _seen(self, frame: BlobFrame) -> SeenFrame:
        blobs = seen_blobs(frame, self._rig, self._layout.chain.glove.hues)
        rows = RowExposure.of(frame, self._rig, self._buffer)
        return SeenFrame(blobs, frame.pose or self._rig.pose, rows)

    def _look(
        self, state: VistState, seen: SeenFrame, previous: Expected | None
    ) -> tuple[Expected, Matched]:
        """Markers as predicted by ``state``, and the matches near them, or near those of the
        ``previous`` image."""
        expected = self._markers.expect(state, seen.pose, seen.rows)
        return expected, self._markers.match(previous or expected, seen.blobs, seen.pose)

    def _previous(self, t: float) -> Expected | None:
        """The reference for correspondence where the IMUs' prediction must not be used."""
        previous = self.saved.previous
        return previous.at(t, self._params.prior.velocity) if previous is not None else None

    def start(self, frame: BlobFrame) -> FrameResult | None:
        """Search for the hand without a prior, at most once per ``search_period``."""
        since = frame.t - self._track.last_search
        if frame.search < Search.FULL or since < self._params.tracking.search_period:
            return None
        self._track.last_search = frame.t
        seen = self._seen(frame)
        blobs = seen.unturned(self._rig)
        found = self._starter.first(self._buffer, blobs, seen.pose, frame.t)
        if found is None:
            return None
        # the search takes gyro biases from a hand at rest, but tremor rotates a finger at 0.1
        # rad/s: over so short a time the mean is not a bias
        found.bg[:] = 0.0
        self.saved.state = from_chain(self._layout, found)
        self.state.P = initial_covariance(self._layout, self._params.prior)
        self._track.tracking, self._track.last_good = Tracking.TRACKING, frame.t
        for _ in range(2):  # the second pass matches and linearises at a better state
            expected, matched = self._look(self.state, seen, None)
            self._filter.correct(self.state, expected, matched)
        return self._finish(frame, seen, expected, matched)

    def _search_again(
        self, seen: SeenFrame, expected: Expected, matched: Matched
    ) -> tuple[Expected, Matched]:
        """Move to a better pose where the images show one; otherwise change nothing."""
        chain = as_chain(self._layout, self.state)
        blobs = seen.unturned(self._rig)
        found = self._starter.again(chain, blobs, seen.pose, len(matched))
        if found is None:
            return expected, matched
        chain.R_GB, chain.p, chain.v = found.R_GB, found.p, np.zeros(3)
        placed = from_chain(self._layout, chain)
        trial = self.state.copy()
        trial.p_GI, trial.R_GI, trial.v_GI = placed.p_GI, placed.R_GI, placed.v_GI
        reset_motion(trial.P, self._layout, self._params.prior)
        there, recognised = self._look(trial, seen, None)
        likely = float(both_cameras(there.prior).sum())
        if not is_better(len(recognised), len(matched), likely):
            return expected, matched
        self.saved.state = trial
        return there, recognised

    def _finish(
        self, frame: BlobFrame, seen: SeenFrame, expected: Expected, matched: Matched
    ) -> FrameResult:
        self._track.last_constraint = frame.t
        self._track.seen[matched.marker] = frame.t
        self._track.tip_sd = self._filter.tip_sd(self.state)
        if self._params.match.guide == "previous":
            there = self._markers.expect(self.state, seen.pose, seen.rows)
            self.saved.previous = PreviousMarkers(frame.t, there)
        tracking, pose = self._track.tracking, seen.pose
        result = frame_result(
            frame, self._layout, self._rig, pose, tracking, expected, matched, seen.blobs
        )
        if seen.rows is None:
            return result
        return replace(result, row_shift=self._markers.row_shift(self.state, pose, seen.rows))

    # ---- output

    def sensed(self, t: float) -> Sensed:
        """What was sensed recently, as of ``t``."""
        out = (t - self._track.felt[self._layout.imu_of] < RECENT).astype(np.int64)
        out[self._layout.chain.marker_segment[t - self._track.seen < RECENT]] = 1
        return Sensed(out, self._track.tracking)

    def sd_at(self, t: float, shown: VistState) -> Array:
        """(n,) m of the segments' ends of a state that is ``shown`` for ``t``; it grows with the
        time since the last image or constraint."""
        tip_sd, last = self._track.tip_sd, self._track.last_constraint
        tau = t - last if np.isfinite(last) else 0.0
        ahead = ahead_variance(self.state, self._layout, self._params.noise, max(tau, 0.0))
        back = shown.held_back[0] @ shown.held_back[0] / 3
        sd: Array = np.sqrt(tip_sd**2 + ahead + behind_variance(shown.t, t) + back)
        return sd
