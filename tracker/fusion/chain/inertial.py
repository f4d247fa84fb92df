"""The chain filter for a glove without a camera: orientation and joints by the IMUs, no position.

The same state and covariance as with images. It starts from gravity, with no image to say where
the hand is. That a wearer stays about where he is keeps the double integral of the root's
accelerometer bounded, and makes gravity correct tilt and gyro biases, as images do otherwise. The
heading is not observable: it drifts with the gyro biases about the vertical.
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

LAG = 0.03  # s behind the newest packet: angular accelerations need readings on both sides
SILENCE = 1.0  # s without packets after which the hand may have turned anyhow
ALWAYS = float("inf")  # the velocity is never damped: it is kept small by a measurement instead


class InertialTracker(ChainTracker):
    """A `ChainTracker` that no image corrects."""

    def begin(self) -> bool:
        """Start from the last packets, with what is known of the wearer; False where they do not
        suffice."""
        started = self._starter.by_gravity(self._buffer, self.wearer.calibration.kept.known)
        if started is None:
            return False
        self.filter.adopt(started)
        self.wearer.calibration.begin(started)
        self._judge.started_anywhere()
        self.confidence.held(started.t)  # its heading is zero by what it is counted from
        return True

    def forget(self) -> None:
        """Look for the hand from nothing again."""
        self._judge.forget()

    def step(self, way: Intervals, first: int) -> int:
        return self.filter.step(way, first, ALWAYS, held=self.wearer.calibration.is_frozen)

    def carry(self, state: ChainState, t: float) -> None:
        self.filter.carry(state, t, coasting=False)

    def no_image(self) -> bool:
        """Held together by anatomy, and about where it was; what is shown follows."""
        if self.filter.constrain(self.state.t):
            self.filter.stay()
        self.wearer.learn()
        self.confidence.drifted(self.state)
        return True


class InertialPoseAlignment(PoseAlignment):
    """Aligns the heading too, and allows for what segments have drifted about the vertical."""

    def refusal(self) -> Notice | None:
        if heading(self._tracker.state.R_GB[0]) is None:
            return warning("pose_reset.steep", side=self._side)
        return super().refusal()

    def _straighten(self) -> None:
        frozen = self._tracker.wearer.calibration.is_frozen
        doubt_drift(self._tracker.state, self._layout, frozen)
        super()._straighten()

    def _align_heading(self, joints_deg: float) -> Notice:
        """The fingers point straight ahead now."""
        state = self._tracker.state
        angle = heading(state.R_GB[0]) or 0.0
        turn(state, -angle)
        self._tracker.confidence.held(state.t)
        corrected = {"joints_deg": joints_deg, "heading_deg": abs(float(np.rad2deg(angle)))}
        return notice("pose_reset.done_heading", side=self._side, **corrected)


class InertialEngine(ChainEngine):
    """An `Engine` that uses no image: its hand is LOST, articulated and turned as the IMUs say.

    ``segment_p`` of its estimates are relative to the root's IMU; keypoints have no position.
    """

    _tracker_type = InertialTracker
    _tracker: InertialTracker

    def __init__(self, hand: HandModel, glove: GloveModel, params: ChainParams) -> None:
        match = replace(params.match, max_frame_delay=LAG)
        # the camera that the chain asks for is never looked through
        super().__init__(hand, glove, ideal_rig(), replace(params, match=match))
        self._pose_reset = InertialPoseAlignment(self._tracker, self._layout)
        self._results: list[FrameResult] = []

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Take a packet; the hand at the packet's instant."""
        newest = self.newest
        if newest is not None and sample.t - newest > SILENCE:
            self._tracker.forget()
        state = self._timeline.feed_imu(sample)
        if self.tracking == Tracking.SEARCHING and self._tracker.begin():
            self._timeline.rebuild_head()
            state = self._timeline.head_at(sample.t)
        return self._estimate(state, sample.t, self._timeline.packet_at(sample.t))

    def feed_frame(self, frame: BlobFrame) -> None:
        """Nothing is made of an image."""
        markers = len(self._layout.glove.markers)
        self._results.append(FrameResult.nothing(frame.t, self.tracking, markers))

    def take_results(self) -> list[FrameResult]:
        out, self._results = self._results, []
        return out

    def _estimate(self, state: ChainState, t: float, packet: ImuSample | None = None) -> Estimate:
        relative = state.copy_nominal()
        relative.p = np.zeros(3)
        return super()._estimate(relative, t, packet)
