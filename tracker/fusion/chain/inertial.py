"""The chain filter for a glove without a camera: orientation and joints by the IMUs, no position.

Uses the same state and covariance as with images. It starts from gravity, without an image of the
hand's position. The assumption that a wearer stays near the same position bounds the double
integral of the root's accelerometer, and lets gravity correct tilt and gyro biases, as images do
otherwise. The heading is not observable: it drifts with the gyro biases about the vertical.

Where another system measures the pose of a tracker on the hand (`WristPose`), these poses are used
as images are otherwise: the hand has a position and a heading, coasts for a second without them,
and is lost after that.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tracker.base.notices import Notice, notice, warning
from tracker.fusion.chain.engine import ChainEngine, PoseAlignment
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pose_reset import doubt_drift, heading, turn
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.tracker import ChainTracker
from tracker.fusion.chain.wrist_pose import (
    PERIOD,
    PLACE_AFTER,
    SHORTEST,
    has_rotation,
    is_aligned,
    is_credible,
    place,
    unplace,
    wrist_rows,
)
from tracker.fusion.time.imu_buffer import Intervals
from tracker.fusion.time.timeline import LONGEST_LAG
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Estimate, FrameResult, ImuSample, Tracking, WristPose
from tracker.vision.rig import ideal_rig

LAG = 0.03  # s behind the newest packet: angular accelerations need samples on both sides
SILENCE = 1.0  # s without packets after which the orientation is unknown
MISALIGNED_FOR = 1.0  # s of poses that disagree with gravity, after which that is reported
ALWAYS = float("inf")  # disables velocity damping: a pseudo-measurement bounds the velocity instead


class InertialTracker(ChainTracker):
    """A `ChainTracker` without image corrections."""

    def begin(self) -> bool:
        """Starts from the last packets, with the known wearer profile; False where they are not
        sufficient."""
        started = self._starter.by_gravity(self._buffer, self.wearer.calibration.saved.known)
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
        was_placed = self.tracking != Tracking.LOST
        self._judge.judge(self.state.t, enough=False)
        if was_placed and self.tracking == Tracking.LOST:
            unplace(self.state, self._params.prior)
            self.confidence.saved.tip_sd = np.zeros(0)
        if self.filter.constrain(self.state.t) and self.tracking == Tracking.LOST:
            self.filter.stay()
        self.wearer.learn()
        self.confidence.drifted(self.state)
        if self.tracking != Tracking.LOST:
            self.confidence.aged(self.state)
        return True

    def start(self, frame: Any) -> FrameResult | None:
        """None: a pose does not start the hand."""
        return None

    def image(self, frame: Any) -> FrameResult | None:
        """Process the pose of a tracker of the state's own time."""
        pose: WristPose = frame
        since = pose.t - self._judge.saved.last_good
        if since < SHORTEST:
            return None
        if self.tracking == Tracking.LOST:
            self._place(pose)
        H, r, variance = wrist_rows(self.state, self._layout, pose)
        credible = self.tracking != Tracking.LOST and is_credible(self.state, H, r, variance)
        if pose.t - self._judge.measured(pose.t, credible) >= PLACE_AFTER:
            self._place(pose)
        if credible:
            self.filter.use(H, r, variance * max(1.0, PERIOD / since))
            if has_rotation(pose):
                self.confidence.held(pose.t)
        self.filter.constrain(pose.t)
        self.wearer.learn()
        self.confidence.aged(self.state)
        return None

    def _place(self, pose: WristPose) -> None:
        """Move the hand to the pose, if that agrees with gravity."""
        if is_aligned(pose, self.state.R_GB[0]):
            place(self.state, self._layout, self._params.prior, pose)
            self._judge.measured(pose.t, credible=True)


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

    ``segment_p`` of its estimates are relative to the root's IMU; keypoints have no position. While
    it is fed with poses of a tracker on the hand, positions are in G.
    """

    _tracker_type = InertialTracker
    _tracker: InertialTracker

    def __init__(self, hand: HandModel, glove: GloveModel, params: ChainParams) -> None:
        match = replace(params.match, max_frame_delay=LAG)
        # the chain requires a camera, which is not used here
        super().__init__(hand, glove, ideal_rig(), replace(params, match=match))
        self._pose_reset = InertialPoseAlignment(self._tracker, self._layout)
        self._results: list[FrameResult] = []
        self._misaligned_since, self._is_reported = np.inf, False

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

    def feed_wrist(self, pose: WristPose) -> Notice | None:
        """Process a tracker's pose; it is used once packets cover its time. One far from the newest
        packet is ignored."""
        newest = self.newest
        if newest is None or abs(pose.t - newest) > LONGEST_LAG or not np.isfinite(pose.p_GT).all():
            return None
        misaligned = self._is_misaligned(pose)
        self._timeline.feed_frame(pose)
        return warning("wrist_pose.misaligned", side=self._layout.hand.side) if misaligned else None

    def _is_misaligned(self, pose: WristPose) -> bool:
        """Whether to report that poses have been disagreeing with gravity for a while; once."""
        if self.tracking == Tracking.SEARCHING or is_aligned(pose, self._tracker.state.R_GB[0]):
            self._misaligned_since = np.inf
            return False
        self._misaligned_since = min(self._misaligned_since, pose.t)
        due = pose.t - self._misaligned_since > MISALIGNED_FOR and not self._is_reported
        self._is_reported = self._is_reported or due
        return due

    def predicted_markers(self, t: float) -> None:
        """Nothing: images are not used."""

    def expected(self, t: float) -> None:
        """Nothing: images are not used."""

    def take_results(self) -> list[FrameResult]:
        out, self._results = self._results, []
        return out

    def _estimate(self, state: ChainState, t: float, packet: ImuSample | None = None) -> Estimate:
        if self.tracking in (Tracking.TRACKING, Tracking.COASTING):
            return super()._estimate(state, t, packet)
        relative = state.copy_nominal()
        relative.p = np.zeros(3)
        return super()._estimate(relative, t, packet)
