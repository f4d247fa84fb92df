"""The chain filter for a glove without a camera: orientation and joints by the IMUs, no position.

Uses the same state and covariance as with images. It starts from gravity, without an image of the
hand's position. The assumption that a wearer stays near the same position bounds the double
integral of the root's accelerometer, and lets gravity correct tilt and gyro biases, as images do
otherwise. The heading is not observable: it drifts with the gyro biases about the vertical.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.base.notices import Notice, notice, warning
from tracker.fusion.chain.engine import ChainEngine, PoseAlignment
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pose_reset import doubt_drift, heading, turn
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.tracker import ChainTracker
from tracker.fusion.time.imu_buffer import Intervals
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Estimate, FrameResult, ImuSample, Tracking
from tracker.vision.rig import ideal_rig

LAG = 0.03  # s behind the newest packet: angular accelerations need samples on both sides
SILENCE = 1.0  # s without packets after which the orientation is unknown
ALWAYS = float("inf")  # disables velocity damping: a pseudo-measurement bounds the velocity instead


class InertialTracker(ChainTracker):
    """A `ChainTracker` without image corrections."""

    def begin(self) -> bool:
        """Starts from the last packets, with the known wearer profile; False where they are not
        sufficient."""
        started = self._starter.by_gravity(self._buffer, self.wearer.calibration.kept.known)
        if started is None:
            return False
        self.filter.adopt(started)
        self.wearer.calibration.begin(started)
        self._judge.started_anywhere()
        self.confidence.held(started.t)  # the initial heading defines zero
        return True

    def forget(self) -> None:
        """Restart the search for the hand."""
        self._judge.forget()

    def step(self, way: Intervals, first: int) -> int:
        return self.filter.step(way, first, ALWAYS, held=self.wearer.calibration.is_frozen)

    def carry(self, state: ChainState, t: float) -> None:
        self.filter.carry(state, t, coasting=False)

    def no_image(self) -> bool:
        """Applies anatomy and the position prior; the output follows."""
        if self.filter.constrain(self.state.t):
            self.filter.stay()
        self.wearer.learn()
        self.confidence.drifted(self.state)
        return True


class InertialPoseAlignment(PoseAlignment):
    """Also aligns the heading, and allows for the drift of segments about the vertical."""

    def refusal(self) -> Notice | None:
        if heading(self._tracker.state.R_GB[0]) is None:
            return warning("pose_reset.steep", side=self._side)
        return super().refusal()

    def _straighten(self) -> None:
        frozen = self._tracker.wearer.calibration.is_frozen
        doubt_drift(self._tracker.state, self._layout, frozen)
        super()._straighten()

    def _align_heading(self, joints_deg: float) -> Notice:
        """Sets the heading to zero: the fingers point straight ahead."""
        state = self._tracker.state
        angle = heading(state.R_GB[0]) or 0.0
        turn(state, -angle)
        self._tracker.confidence.held(state.t)
        corrected = {"joints_deg": joints_deg, "heading_deg": abs(float(np.rad2deg(angle)))}
        return notice("pose_reset.done_heading", side=self._side, **corrected)


class InertialEngine(ChainEngine):
    """An `Engine` without images: the hand is LOST, with posture and orientation from the IMUs.

    ``segment_p`` of its estimates are relative to the root's IMU; keypoints have no position.
    """

    _tracker_type = InertialTracker
    _tracker: InertialTracker

    def __init__(self, hand: HandModel, glove: GloveModel, params: ChainParams) -> None:
        match = replace(params.match, max_frame_delay=LAG)
        # the chain requires a camera, which is not used here
        super().__init__(hand, glove, ideal_rig(), replace(params, match=match))
        self._pose_reset = InertialPoseAlignment(self._tracker, self._layout)
        self._results: list[FrameResult] = []

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Process a packet; returns the hand at the packet's time."""
        newest = self.newest
        if newest is not None and sample.t - newest > SILENCE:
            self._tracker.forget()
        state = self._timeline.feed_imu(sample)
        if self.tracking == Tracking.SEARCHING and self._tracker.begin():
            self._timeline.rebuild_head()
            state = self._timeline.head_at(sample.t)
        return self._estimate(state, sample.t, self._timeline.packet_at(sample.t))

    def feed_frame(self, frame: BlobFrame) -> None:
        """Ignores images."""
        markers = len(self._layout.glove.markers)
        self._results.append(FrameResult.nothing(frame.t, self.tracking, markers))

    def take_results(self) -> list[FrameResult]:
        out, self._results = self._results, []
        return out

    def _estimate(self, state: ChainState, t: float, packet: ImuSample | None = None) -> Estimate:
        relative = state.copy_nominal()
        relative.p = np.zeros(3)
        return super()._estimate(relative, t, packet)
