"""What of a hand was sensed lately, and how sure the filter is of it."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracker.base.records import record
from tracker.fusion.chain.distal import DistalSegments
from tracker.fusion.chain.driven_ends import EndsSureness
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.start.mono_start import (
    KNOWN_SIZE_SD,
    MonoParams,
    measured_sd,
    size_taken_for_granted,
    size_unsure_by,
    with_unsure_distance,
)
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.support import Evidence
from tracker.fusion.chain.tracking import DOUBT_AFTER
from tracker.fusion.output.output import Sensed, sensed_lately
from tracker.fusion.time.timeline import HAND_SPEED
from tracker.messages import SEEN_LATELY, Array, CameraPose, ImuSample, IntArray, Tracking

MEASURED_SD = 0.016  # m, beyond which nothing is called measured: three of them are 5 cm
BIAS_LASTS = 2.0  # s for which an error of the gyro's bias stays about the vertical
SILENT = 0.5  # s without any IMU after which images alone measure nothing
RETURN_AFTER = 0.15  # s of silence after which a segment is doubted


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
class ShownKept:
    """What changes of a `HandConfidence`."""

    seen: Array  # (M,) s when each marker was seen last
    felt: Array  # (n,) s when each IMU answered last
    tip_sd: Array  # (A + d,) m of each active segment's end, then of each that these drive; or none
    one_camera: bool = False  # started with one camera, and no marker was seen by both since
    doubted: NDArray[np.bool_] = field(default_factory=lambda: np.zeros(0, bool))
    """(A,) markers do not speak for where each segment is; none in what older versions kept"""
    poor_since: Array = field(default_factory=lambda: np.zeros(0))
    """(D,) s since when a digit's markers are not where they should be; as above"""
    most_sd: float = MEASURED_SD  # m, beyond which nothing is called measured
    heading_drift: float = 0.0  # rad by which the heading may be off since images held it
    heading_at: float = np.inf  # s until when that was added up
    p_GC: Array = field(default_factory=lambda: np.zeros(0))  # (3,) m of the one camera, lately
    unsensed_until: float = -np.inf  # s until when no IMU sensed how the hand turned


class HandConfidence:
    """For one hand with one glove. Packets and images go in, in order of time."""

    def __init__(self, layout: ChainLayout, distal: DistalSegments) -> None:
        self._layout = layout
        self.ends = EndsSureness(layout, distal)
        self._rows = len(layout.active) + len(self.ends.driven)
        self._digit = digit_of(layout)
        markers, imus = len(layout.glove.markers), len(layout.glove.imus)
        self.kept = ShownKept(
            seen=np.full(markers, -np.inf),
            felt=np.full(imus, -np.inf),
            tip_sd=np.zeros(0),
        )

    def restore(self, kept: ShownKept, state: ChainState) -> None:
        """Go on from what was kept of ``state``, which is taken over; older versions kept less."""
        self.kept = kept
        if 0 < len(kept.tip_sd) < self._rows:
            self.kept.tip_sd = self.ends(state)

    # ---- what was sensed

    def returned(self, sample: ImuSample) -> IntArray:
        """(k,) IMUs that answer in ``sample`` after they were silent for long."""
        felt = self.kept.felt
        if sample.t - felt.min(initial=np.inf) <= RETURN_AFTER:
            return np.zeros(0, np.int64)
        away = np.asarray(sample.valid) & (sample.t - felt > RETURN_AFTER)
        return np.flatnonzero(away & np.isfinite(felt))

    def packet(self, sample: ImuSample) -> None:
        """Which IMUs answered."""
        self.kept.felt[sample.valid] = sample.t

    def image(self, t: float, match: IntArray) -> None:
        """Which markers an image showed; match (2, M), -1 for none."""
        self.kept.seen[match.max(axis=0) >= 0] = t

    # ---- what is believed

    def started(self) -> None:
        """Nothing has spoken for the pose but the search that found it."""
        self.kept.doubted = np.ones(len(self._layout.active), bool)
        self.kept.poor_since = np.full(int(self._digit.max(initial=-1)) + 1, -np.inf)

    def moved_unsensed(self, t: float) -> None:
        """The root's IMU answers again at ``t``: no sensor knows how the hand turned meanwhile, and
        its tilt takes gravity for motion until an image since then supports the pose."""
        if not len(self.kept.doubted):
            self.started()
        self.kept.doubted = np.ones(len(self._layout.active), bool)
        self.kept.unsensed_until = t

    def supported(self, t: float, seen: Evidence, sure: bool) -> None:
        """An image supports the digits as ``seen`` tells; ``sure`` is the hand as a whole."""
        now = self.kept
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
        """What was sensed lately, as of ``t``."""
        lay, now = self._layout, self.kept
        segments = sensed_lately(
            now.felt, lay.imu_segment, now.seen, lay.marker_segment, len(lay.active), t, SEEN_LATELY
        )
        if len(now.doubted):
            segments[now.doubted] = 0
        if SILENT < t - now.felt.max(initial=-np.inf) < np.inf:
            segments[:] = 0  # a glove that was there is not: a few blobs bend a hand as they like
        return Sensed(segments, tracking)

    # ---- how sure

    @property
    def tip_sd(self) -> Array:
        """(A + d,) m, zeros before the first image."""
        return self.kept.tip_sd if len(self.kept.tip_sd) else np.zeros(self._rows)

    def unsure(self, state: ChainState, pose: CameraPose, known_size_sd: float) -> None:
        """Take how sure each segment's end is; one camera alone does not know the distance, but by
        the hand's size, of which a share was unknown beforehand."""
        self.kept.tip_sd, self.kept.most_sd = self.ends(state), MEASURED_SD
        if self.kept.one_camera:
            self.kept.p_GC = pose.p_GC
            size_sd = self.size_sd(known_size_sd)
            if size_sd > KNOWN_SIZE_SD:
                self.kept.most_sd = min(measured_sd(state.p, pose, size_sd), MEASURED_SD)
            self.kept.tip_sd = with_unsure_distance(self.kept.tip_sd, state.p, pose, size_sd)

    def worn(self, state: ChainState) -> None:
        """The size is another one now: one camera shows it at another distance."""
        if self.kept.one_camera and len(self.kept.p_GC):
            size_taken_for_granted(state, self._layout, self.kept.p_GC, MonoParams().distance_sd)

    def size_sd(self, known_size_sd: float) -> float:
        """Share by which the hand's size is unsure beyond its state; 0 once both cameras saw it."""
        return size_unsure_by(known_size_sd) if self.kept.one_camera else 0.0

    def held(self, t: float) -> None:
        """An image has shown how the hand is turned."""
        self.kept.heading_drift, self.kept.heading_at = 0.0, t

    def drifted(self, state: ChainState) -> None:
        """Nothing has shown the heading until the state's instant: what is not known of the root
        gyro's bias about the vertical adds up (docs/chain.md, eq. 58)."""
        now, j = self.kept, int(self._layout.imu_of[0])
        dt, now.heading_at = max(state.t - now.heading_at, 0.0), state.t
        if j < 0:
            return
        up = state.R_IB[j] @ state.R_GB[0][2]
        rows = slice(self._layout.blocks.bg + 3 * j, self._layout.blocks.bg + 3 * j + 3)
        bias = float(np.sqrt(max(up @ state.P[rows, rows] @ up, 0.0)))
        now.heading_drift = float(np.hypot(now.heading_drift, bias * np.sqrt(2 * BIAS_LASTS * dt)))

    def heading_sd(self, state: ChainState) -> float:
        """rad, of how the hand is turned about the vertical."""
        up, rows = state.R_GB[0][2], slice(6, 9)  # eq. 3: the error is in the segment's own axes
        return float(np.sqrt(up @ state.P[rows, rows] @ up + self.kept.heading_drift**2))

    def aged(self, state: ChainState) -> None:
        """The filter has moved on without an image: take how sure it is now."""
        if not self.kept.one_camera:
            self.kept.tip_sd = self.ends(state)

    def doubt_variance(self, t: float) -> float:
        """m² an axis that the covariance lacks while the whole hand is doubted: it holds only if
        the blobs were of the markers that they were taken for (docs/chain.md, eq. 63)."""
        if not self.is_doubted:
            return 0.0
        since = t - self.kept.seen.max(initial=-np.inf)
        moved = HAND_SPEED * max(since, 0.0) if np.isfinite(since) else 0.0
        return MEASURED_SD**2 + float(moved) ** 2

    @property
    def is_doubted(self) -> bool:
        """Whether no segment is known to be where its markers are."""
        return bool(len(self.kept.doubted) and self.kept.doubted.all())
