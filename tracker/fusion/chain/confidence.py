"""Which parts of a hand were sensed recently, and how certain the filter is of them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracker.base.records import record
from tracker.fusion.chain.distal import DistalSegments
from tracker.fusion.chain.driven_ends import EndDeviations
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.start.mono_start import (
    KNOWN_SIZE_SD,
    MonoParams,
    assumed_size_sd,
    fix_size,
    measured_sd,
    with_distance_uncertainty,
)
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.support import Evidence
from tracker.fusion.chain.tracking import DOUBT_AFTER
from tracker.fusion.output.output import Sensed, sensed_lately
from tracker.fusion.time.timeline import HAND_SPEED
from tracker.messages import RECENT, Array, CameraPose, ImuSample, IntArray, Tracking

MEASURED_SD = 0.016  # m, limit for the state MEASURED: three standard deviations are 5 cm
BIAS_LASTS = 2.0  # s for which a gyro bias error stays aligned with the vertical
SILENT = 0.5  # s without any IMU, after which the images alone do not count as a measurement
RETURN_AFTER = 0.15  # s of lost packets after which a segment's orientation is uncertain


@record(
    "chain.shown",
    shapes={
        "seen": "M",
        "felt": "I",
        "tip_sd": "0 | t",
        "doubted": "bool 0 | bool A",
        "poor_since": "0 | d",
        "p_GC": "0 | 3",
    },
)
@dataclass(eq=False)
class ConfidenceSavedState:
    """The part of a `HandConfidence` that changes."""

    seen: Array  # (M,) s when each marker was last seen
    felt: Array  # (n,) s when each IMU was last valid
    tip_sd: Array  # (A + d + k,) m, as of `EndDeviations`; or empty
    one_camera: bool = False  # started with one camera, and no marker was seen by both since
    doubted: NDArray[np.bool_] = field(default_factory=lambda: np.zeros(0, bool))
    """(A,) markers do not support the segment's pose; empty in older recordings"""
    poor_since: Array = field(default_factory=lambda: np.zeros(0))
    """(D,) s since when a digit's markers are not where expected; empty in older recordings"""
    most_sd: float = MEASURED_SD  # m, limit for the state MEASURED
    heading_drift: float = 0.0  # rad by which the heading may have drifted since the last image
    heading_at: float = np.inf  # s until when that was integrated
    p_GC: Array = field(default_factory=lambda: np.zeros(0))  # (3,) m of the one camera
    unsensed_until: float = -np.inf  # s until when no IMU measured the rotation of the hand


class HandConfidence:
    """For one hand with one glove. Packets and images must arrive in order of time."""

    def __init__(self, layout: ChainLayout, distal: DistalSegments) -> None:
        self._layout = layout
        self.ends = EndDeviations(layout, distal)
        self._rows = len(layout.active) + len(self.ends.driven) + len(self.ends.palm.keypoint)
        self._digit = digit_of(layout)
        markers, imus = len(layout.glove.markers), len(layout.glove.imus)
        self.saved = ConfidenceSavedState(
            seen=np.full(markers, -np.inf),
            felt=np.full(imus, -np.inf),
            tip_sd=np.zeros(0),
        )

    def restore(self, saved: ConfidenceSavedState, state: ChainState) -> None:
        """Restores the saved part, which is not copied; older versions saved less."""
        self.saved = saved
        if 0 < len(saved.tip_sd) < self._rows:
            self.saved.tip_sd = self.ends(state)

    # ---- what was sensed

    def returned(self, sample: ImuSample) -> IntArray:
        """(k,) IMUs that are valid in ``sample`` after a long interruption."""
        felt = self.saved.felt
        if sample.t - felt.min(initial=np.inf) <= RETURN_AFTER:
            return np.zeros(0, np.int64)
        away = np.asarray(sample.valid) & (sample.t - felt > RETURN_AFTER)
        return np.flatnonzero(away & np.isfinite(felt))

    def packet(self, sample: ImuSample) -> None:
        """Records which IMUs are valid."""
        self.saved.felt[sample.valid] = sample.t

    def image(self, t: float, match: IntArray) -> None:
        """Records which markers an image showed; match (2, M), -1 for none."""
        self.saved.seen[match.max(axis=0) >= 0] = t

    # ---- judgement of states

    def started(self) -> None:
        """After a start: only the search supports the pose."""
        self.saved.doubted = np.ones(len(self._layout.active), bool)
        self.saved.poor_since = np.full(int(self._digit.max(initial=-1)) + 1, -np.inf)

    def moved_unsensed(self, t: float) -> None:
        """The root's IMU is valid again at ``t``: the rotation meanwhile is unknown, and a tilt
        error is mistaken for acceleration until a later image supports the pose."""
        if not len(self.saved.doubted):
            self.started()
        self.saved.doubted = np.ones(len(self._layout.active), bool)
        self.saved.unsensed_until = t

    def supported(self, t: float, seen: Evidence, sure: bool) -> None:
        """Updates the support of the digits by ``seen``; ``sure``: the whole hand is supported."""
        now = self.saved
        if not len(now.doubted):
            self.started()
        now.poor_since[seen.supported] = np.inf
        now.poor_since[seen.unsupported] = np.minimum(now.poor_since[seen.unsupported], t)
        poor = t - now.poor_since >= DOUBT_AFTER
        sure = sure and t >= now.unsensed_until
        if sure and len(poor):
            now.doubted = (self._digit >= 0) & poor[self._digit]
        else:
            now.doubted = np.full(len(self._layout.active), not sure)

    # ---- what was sensed

    def sensed(self, t: float, tracking: Tracking) -> Sensed:
        """What was sensed recently, as of ``t``."""
        lay, now = self._layout, self.saved
        segments = sensed_lately(
            now.felt, lay.imu_segment, now.seen, lay.marker_segment, len(lay.active), t, RECENT
        )
        if len(now.doubted):
            segments[now.doubted] = 0
        if SILENT < t - now.felt.max(initial=-np.inf) < np.inf:
            segments[:] = 0  # without the glove, a few blobs constrain the posture too little
        return Sensed(segments, tracking)

    # ---- how sure

    @property
    def tip_sd(self) -> Array:
        """(A + d + k,) m, zeros before the first image."""
        return self.saved.tip_sd if len(self.saved.tip_sd) else np.zeros(self._rows)

    def unsure(self, state: ChainState, pose: CameraPose, known_size_sd: float) -> None:
        """Updates the standard deviations of the segments' ends; one camera measures the distance
        only through the hand's size, which is uncertain by the share ``known_size_sd``."""
        self.saved.tip_sd, self.saved.most_sd = self.ends(state), MEASURED_SD
        if self.saved.one_camera:
            self.saved.p_GC = pose.p_GC
            size_sd = self.size_sd(known_size_sd)
            ends = self.ends.positions(state)
            if size_sd > KNOWN_SIZE_SD:
                farthest = ends[np.linalg.norm(ends - pose.p_GC, axis=1).argmax()]
                self.saved.most_sd = min(measured_sd(farthest, pose, size_sd), MEASURED_SD)
            self.saved.tip_sd = with_distance_uncertainty(self.saved.tip_sd, ends, pose, size_sd)

    def worn(self, state: ChainState) -> None:
        """The hand size has changed: with one camera, the distance changes with it."""
        if self.saved.one_camera and len(self.saved.p_GC):
            fix_size(state, self._layout, self.saved.p_GC, MonoParams().distance_sd)

    def size_sd(self, known_size_sd: float) -> float:
        """Relative uncertainty of the size not in the state's covariance; 0 once both cameras saw
        it."""
        return assumed_size_sd(known_size_sd) if self.saved.one_camera else 0.0

    def held(self, t: float) -> None:
        """An image has corrected the heading."""
        self.saved.heading_drift, self.saved.heading_at = 0.0, t

    def drifted(self, state: ChainState) -> None:
        """Without heading measurements up to the state's time: integrates the uncertainty of the
        root gyro's bias about the vertical (docs/chain.md, eq. 58)."""
        now, j = self.saved, int(self._layout.imu_of[0])
        dt, now.heading_at = max(state.t - now.heading_at, 0.0), state.t
        if j < 0:
            return
        up = state.R_IB[j] @ state.R_GB[0][2]
        rows = slice(self._layout.blocks.bg + 3 * j, self._layout.blocks.bg + 3 * j + 3)
        bias = float(np.sqrt(max(up @ state.P[rows, rows] @ up, 0.0)))
        now.heading_drift = float(np.hypot(now.heading_drift, bias * np.sqrt(2 * BIAS_LASTS * dt)))

    def heading_sd(self, state: ChainState) -> float:
        """rad, of the rotation about the vertical."""
        up, rows = state.R_GB[0][2], slice(6, 9)  # eq. 3: the error is in the segment's own axes
        return float(np.sqrt(up @ state.P[rows, rows] @ up + self.saved.heading_drift**2))

    def aged(self, state: ChainState) -> None:
        """The filter has moved on without an image: update the standard deviations."""
        if not self.saved.one_camera:
            self.saved.tip_sd = self.ends(state)

    def doubt_variance(self, t: float) -> float:
        """m² per axis to add to the covariance while the whole hand is doubted: the covariance is
        valid only if the matches are correct (docs/chain.md, eq. 63)."""
        if not self.is_doubted:
            return 0.0
        since = t - self.saved.seen.max(initial=-np.inf)
        moved = HAND_SPEED * max(since, 0.0) if np.isfinite(since) else 0.0
        return MEASURED_SD**2 + float(moved) ** 2

    @property
    def is_doubted(self) -> bool:
        """Whether the markers support none of the segments."""
        return bool(len(self.saved.doubted) and self.saved.doubted.all())
