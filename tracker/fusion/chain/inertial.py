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
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pose_reset import doubt_drift, heading, turn
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.tape import Tape
from tracker.fusion.chain.tracker import ChainTracker
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Estimate, FrameResult, ImuSample, Tracking
from tracker.vision.rig import StereoRig, ideal_rig

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


class InertialEngine(ChainEngine):
    """An `Engine` that uses no image: its hand is LOST, articulated and turned as the IMUs say.

    ``segment_p`` of its estimates are relative to the root's IMU; keypoints have no position.
    """

    def __init__(self, hand: HandModel, glove: GloveModel, params: ChainParams) -> None:
        match = replace(params.match, max_frame_delay=LAG)
        # the camera that the chain asks for is never looked through
        super().__init__(hand, glove, ideal_rig(), replace(params, match=match))
        self._results: list[FrameResult] = []

    def _make_tracker(
        self, rig: StereoRig, params: ChainParams, buffer: ImuBuffer, tape: Tape | None
    ) -> ChainTracker:
        self._inertial = InertialTracker(self._layout, rig, params, buffer, tape)
        return self._inertial

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Take a packet; the hand at the packet's instant."""
        newest = self.newest
        if newest is not None and sample.t - newest > SILENCE:
            self._inertial.forget()
        state = self._timeline.feed_imu(sample)
        if self.tracking == Tracking.SEARCHING and self._inertial.begin():
            self._timeline.rebuild_head()
            state = self._timeline.head_at(sample.t)
        return self._of_packet(state, sample.t)

    def feed_frame(self, frame: BlobFrame) -> None:
        """Nothing is made of an image."""
        markers = len(self._layout.glove.markers)
        self._results.append(FrameResult.nothing(frame.t, self.tracking, markers))

    def take_results(self) -> list[FrameResult]:
        out, self._results = self._results, []
        return out

    def _refuse_reset(self, state: ChainState) -> Notice | None:
        if heading(state.R_GB[0]) is None:
            return warning("pose_reset.steep", side=self._layout.hand.side)
        return super()._refuse_reset(state)

    def _straighten(self) -> None:
        frozen = self.wearer.calibration.is_frozen
        doubt_drift(self._inertial.state, self._layout, frozen)
        super()._straighten()

    def _reset_heading(self, joints_deg: float) -> Notice:
        """Straight ahead is where the fingers point now."""
        state = self._inertial.state
        angle = heading(state.R_GB[0]) or 0.0
        turn(state, -angle)
        self._inertial.confidence.held(state.t)
        corrected = {"joints_deg": joints_deg, "heading_deg": abs(float(np.rad2deg(angle)))}
        return notice("pose_reset.done_heading", side=self._layout.hand.side, **corrected)

    def _estimate(self, state: ChainState, t: float) -> Estimate:
        relative = state.copy_nominal()
        relative.p = np.zeros(3)
        return super()._estimate(relative, t)
