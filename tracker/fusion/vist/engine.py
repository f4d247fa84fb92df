"""The vist engine: Lee et al. 2021 on packets and images, with automatic initialization.

Delay compensation: `tracker.fusion.time.timeline`.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass

from tracker.base.records import record
from tracker.fusion.ablations.variants import check_variant
from tracker.fusion.chain.shown import mark_inferred
from tracker.fusion.engine import Engine, ExpectedHand
from tracker.fusion.output.completion import ActiveSegments
from tracker.fusion.output.motion import moving
from tracker.fusion.output.output import HandOutput
from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.fusion.time.timeline import Timeline, TimelineSavedState
from tracker.fusion.vist.layout import VistLayout
from tracker.fusion.vist.params import VistParams
from tracker.fusion.vist.points import positions
from tracker.fusion.vist.reports import calibration_of, rates_of
from tracker.fusion.vist.state import VistState
from tracker.fusion.vist.tracker import VistTracker, VistTrackerSavedState
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    Estimate,
    FrameResult,
    ImuSample,
    IntArray,
    Tracking,
)
from tracker.vision.rig import StereoRig


@record("vist", sized=True)
@dataclass(eq=False)
class VistSavedState:
    """The complete state of a vist engine."""

    timeline: TimelineSavedState[VistState]
    tracker: VistTrackerSavedState


class VistEngine(Engine):
    """The paper's filter for one hand; an `Engine`.

    Y. Lee et al.: Visual-inertial hand motion tracking with robustness against occlusion,
    interference, and contact. Science Robotics 6 (58), eabe1315, 2021.
    doi:10.1126/scirobotics.abe1315

    Raises ConfigError for a glove with a segment without IMU within a chain, and for invalid
    settings.
    """

    def __init__(
        self, hand: HandModel, glove: GloveModel, rig: StereoRig, params: VistParams
    ) -> None:
        check_variant(params.match.guide, params.coupling)
        self._layout = VistLayout(hand, glove)
        buffer, timing = ImuBuffer(len(glove.imus)), params.tracking
        self._buffer = buffer
        self._tracker = VistTracker(self._layout, rig, params, buffer)
        self._timeline = Timeline(self._tracker, buffer, timing.lost_after, timing.max_frame_delay)
        self._output = HandOutput(self._layout.chain)

    # ---- messages

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Process a packet; returns the hand at the packet's time."""
        state = self._timeline.feed_imu(sample)
        estimate, newest = self._estimate(state, sample.t), self._buffer.newest
        if estimate.tracking == Tracking.SEARCHING or newest is None or newest.t != sample.t:
            return estimate
        active = ActiveSegments(state.R_GB, state.p_GB(self._layout), state.scale)
        rates = rates_of(self._layout, state, self._tracker.state, newest)
        return moving(self._output, estimate, active, rates)

    def feed_frame(self, frame: BlobFrame) -> None:
        """Queue an image; it is processed once IMU data cover its exposure."""
        self._timeline.feed_frame(frame)

    def take_results(self) -> list[FrameResult]:
        """The results of the images since the last call, oldest first."""
        return self._timeline.take_results()

    def predict(self, t: float) -> Estimate:
        """The hand at any time close to the present. Changes nothing."""
        return self._estimate(self._timeline.head_at(t), t)

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        """Markers expected in G (n, 3), their sd (n,) m and ids (n,); None while searching."""
        if self._tracker.tracking in (Tracking.SEARCHING, Tracking.LOST):
            return None
        return self._markers(self._timeline.head_at(t))

    def _markers(self, state: VistState) -> tuple[Array, Array, IntArray]:
        segment = self._layout.chain.marker_segment
        p_G = positions(state, segment, self._layout.marker_lever)
        return p_G, self._tracker.saved.track.tip_sd[segment], self._layout.used_markers.copy()

    def expected(self, t: float) -> ExpectedHand | None:
        """The predicted hand in an image of ``t`` not processed yet; None while its position is
        unknown."""
        if self._tracker.tracking in (Tracking.SEARCHING, Tracking.LOST):
            return None
        past = self._timeline.past_at(t)
        return ExpectedHand(self._estimate(past, t), *self._markers(past))

    def _estimate(self, state: VistState, t: float) -> Estimate:
        p_GB, sensed = state.p_GB(self._layout), self._tracker.sensed(t)
        sd = self._tracker.sd_at(t, state)
        return mark_inferred(self._output.estimate(t, state.R_GB, p_GB, state.scale, sensed, sd))

    def calibration(self) -> Calibration:
        """Estimated parameters with their uncertainty."""
        return calibration_of(self._layout, self._tracker.state)

    # ---- saving

    def get_state(self) -> VistSavedState:
        """A copy of the complete state."""
        return copy.deepcopy(VistSavedState(self._timeline.saved, self._tracker.saved))

    def set_state(self, state: VistSavedState) -> None:
        """Continue from a `get_state`."""
        saved = copy.deepcopy(state)
        self._tracker.saved = saved.tracker
        self._timeline.restore(saved.timeline)
