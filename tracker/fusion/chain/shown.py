"""What a chain filter shows: the whole hand, what of it was sensed lately, and how sure it is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.fusion.chain.kinematics import marker_positions, segment_positions, tip_sd
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.start.mono_start import KNOWN_SIZE_SD, SIZE_SD, with_unsure_distance
from tracker.fusion.chain.state import ChainState
from tracker.fusion.output.output import HandOutput, Sensed, sensed_lately
from tracker.messages import SEEN_LATELY, Array, CameraPose, Estimate, ImuSample, IntArray, Tracking
from tracker.records import record

RETURN_AFTER = 0.15  # s of silence after which a segment is doubted


@record("chain.shown")
@dataclass(eq=False)
class ShownKept:
    """All of it that changes."""

    seen: Array  # (M,) s when each marker was seen last
    felt: Array  # (n,) s when each IMU answered last
    tip_sd: Array  # (A,) m of each active segment's end
    one_camera: bool = False  # started with one camera, and no marker was seen by both since


class ShownHand:
    """Makes estimates for one hand with one glove."""

    def __init__(self, layout: ChainLayout) -> None:
        self._layout = layout
        self._output = HandOutput(layout)
        markers, imus = len(layout.glove.markers), len(layout.glove.imus)
        self.kept = ShownKept(
            seen=np.full(markers, -np.inf),
            felt=np.full(imus, -np.inf),
            tip_sd=np.zeros(len(layout.active)),
        )

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

    def sensed(self, t: float, tracking: Tracking) -> Sensed:
        """What was sensed lately, as of ``t``."""
        lay, now = self._layout, self.kept
        segments = sensed_lately(
            now.felt, lay.imu_segment, now.seen, lay.marker_segment, len(lay.active), t, SEEN_LATELY
        )
        return Sensed(segments, tracking)

    # ---- how sure

    def unsure(self, state: ChainState, pose: CameraPose, size_is_known: bool) -> None:
        """Take how sure each segment's end is; one camera alone does not know the distance."""
        self.kept.tip_sd = tip_sd(state, self._layout)
        if self.kept.one_camera:
            size_sd = KNOWN_SIZE_SD if size_is_known else SIZE_SD
            self.kept.tip_sd = with_unsure_distance(self.kept.tip_sd, state.p, pose, size_sd)

    # ---- messages

    def estimate(self, state: ChainState, t: float, tracking: Tracking) -> Estimate:
        """The hand of a nominal state at ``t``."""
        return self.estimate_of(state, t, self.sensed(t, tracking), self.kept.tip_sd)

    def estimate_of(self, state: ChainState, t: float, sensed: Sensed, sd: Array) -> Estimate:
        """The hand of a nominal state whose segments' ends are as sure as sd (A,) m."""
        p_GB = segment_positions(state, self._layout)
        return self._output.estimate(t, state.R_GB, p_GB, state.scale3(), sensed, sd)

    def markers(self, state: ChainState) -> tuple[Array, Array, IntArray]:
        """Markers of a nominal state in G (M, 3), their SD (M,) m and ids (M,)."""
        p_G = marker_positions(state, self._layout)
        return p_G, self.kept.tip_sd[self._layout.marker_segment], np.arange(len(p_G))
