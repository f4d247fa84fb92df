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
from tracker.fusion.chain.layout import ChainLayout, V
from tracker.fusion.chain.params import ChainParams, PriorParams
from tracker.fusion.chain.pose_reset import doubt_drift, heading, turn
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.tracker import ChainTracker
from tracker.fusion.time.imu_buffer import Intervals
from tracker.fusion.time.timeline import LONGEST_LAG
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, BlobFrame, Estimate, FrameResult, ImuSample, Tracking, WristPose
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


# ---- the pose of a tracker on the back of the hand as a measurement of the chain filter
#
# With l = p_BT - lever, where the state's position is that of the root's IMU at ``lever`` in B:
# p_GT = p + R_GB l and R_GT = R_GB R_BT (docs/chain.md, "Without a camera").

PERIOD = 0.03  # s between two poses that are independent: errors of a tracking system persist
SHORTEST = 0.008  # s between two poses that are used
MOST_TILT = np.deg2rad(30.0)  # between a pose and gravity, beyond which the tracker is misaligned
GATE = 60.0  # squared Mahalanobis distance of six values beyond which a pose is an outlier
PLACE_AFTER = 0.4  # s of outliers without a break, after which the hand is where they say


def has_rotation(pose: WristPose) -> bool:
    """Whether the tracking system measures rotations too."""
    return bool(np.isfinite(pose.q_GT).all())


def root_rotation(pose: WristPose) -> Array:
    """R_GB (3, 3) of the hand's root segment by a pose with a rotation."""
    out: Array = so3.matrix_from_quat(pose.q_GT) @ so3.matrix_from_quat(pose.q_BT).T
    return out


def tilt_between(R_GB: Array, other: Array) -> float:
    """rad between the directions of the vertical in B by two rotations (3, 3)."""
    return float(np.arccos(np.clip(R_GB[2] @ other[2], -1.0, 1.0)))


def is_aligned(pose: WristPose, R_GB: Array) -> bool:
    """Whether the pose agrees with gravity as R_GB (3, 3) of the root segment does."""
    return not has_rotation(pose) or tilt_between(root_rotation(pose), R_GB) <= MOST_TILT


def wrist_rows(
    state: ChainState, layout: ChainLayout, pose: WristPose
) -> tuple[Array, Array, Array]:
    """H (m, N), innovation r (m,) and variance (m,), of six values or of a position's three."""
    R, lever = state.R_GB[0], pose.p_BT - layout.root_lever
    rows = 6 if has_rotation(pose) else 3
    H, at = np.zeros((rows, layout.blocks.size)), layout.blocks.theta
    H[:3, :3] = np.eye(3)
    H[:3, at : at + 3] = -R @ so3.skew(lever)
    r = pose.p_GT - state.p - R @ lever
    if rows == 3:
        return H, r, np.full(3, pose.position_variance)
    H[3:, at : at + 3] = np.eye(3)
    r = np.concatenate([r, so3.log(R.T @ root_rotation(pose))])
    return H, r, np.repeat([pose.position_variance, pose.rotation_variance], 3)


def is_credible(state: ChainState, H: Array, r: Array, variance: Array) -> bool:
    """Whether the innovation is within what the state and the measurement allow."""
    S = H @ state.P @ H.T + np.diag(variance)
    return float(r @ np.linalg.solve(S, r)) <= GATE


def place(state: ChainState, layout: ChainLayout, prior: PriorParams, pose: WristPose) -> None:
    """Move and turn the whole hand to the pose: it is not known where it was."""
    if has_rotation(pose):
        turn(state, _heading_between(root_rotation(pose), state.R_GB[0]))
    state.p = pose.p_GT - state.R_GB[0] @ (pose.p_BT - layout.root_lever)
    state.v = np.zeros(3)
    _forget(state, max(pose.position_variance, prior.position**2), prior.velocity**2)


def unplace(state: ChainState, prior: PriorParams) -> None:
    """The hand's position is not known any more."""
    state.p, state.v = np.zeros(3), np.zeros(3)
    _forget(state, prior.position**2, prior.first_velocity**2)


def _forget(state: ChainState, position: float, velocity: float) -> None:
    """Position and velocity are independent of all else, with these variances of an axis."""
    rows = np.arange(V + 3)
    state.P[rows, :] = 0.0
    state.P[:, rows] = 0.0
    state.P[rows, rows] = np.repeat([position, velocity], 3)


def _heading_between(R: Array, other: Array) -> float:
    """rad about the vertical that turns ``other`` (3, 3) nearest to R."""
    D = R @ other.T
    return float(np.arctan2(D[1, 0] - D[0, 1], D[0, 0] + D[1, 1]))
