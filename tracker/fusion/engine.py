"""The interface of an engine to the pipeline: mandatory and optional methods."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, NamedTuple, Protocol

from tracker.base.notices import Notice, warning
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    Estimate,
    FrameResult,
    ImuSample,
    IntArray,
    WristPose,
)

COAST_DAMPING = 2.0  # 1/s: decay rate of a velocity that no marker confirms


class ExpectedHand(NamedTuple):
    """The hand predicted for an image's time from earlier data: the estimate, and its markers' p_G
    (m, 3) m, their sd (m,) m and ids (m,)."""

    estimate: Estimate
    p_G: Array
    sd: Array
    ids: IntArray


class Engine(Protocol):
    """A synchronous tracker: the same messages in the same order give the same states.

    Engines derive from this class, which has defaults for optional methods. What must be known
    before an engine is created is in `tracker.engine.kinds.Capabilities`; an engine that learns the
    wearer is also a `tracker.fusion.wearer_learning.LearnsWearer`.
    """

    @abstractmethod
    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Process a packet; returns the hand at the packet's time."""

    @abstractmethod
    def feed_frame(self, frame: BlobFrame) -> None:
        """Queue an image; it is processed once IMU data cover its exposure."""

    @abstractmethod
    def take_results(self) -> list[FrameResult]:
        """The results of the images since the last call, oldest first."""

    @abstractmethod
    def predict(self, t: float) -> Estimate:
        """The hand at any time close to the present. Changes nothing."""

    @abstractmethod
    def calibration(self) -> Calibration:
        """Estimated parameters with their uncertainty."""

    @abstractmethod
    def get_state(self) -> Any:
        """The complete state, independent of the engine."""

    @abstractmethod
    def set_state(self, state: Any) -> None:
        """Continue from a `get_state`."""

    # ---- optional methods

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        """Predicted markers in G (n, 3), their sd (n,) m and ids (n,); None while searching, and
        for an engine that does not use images for tracking."""
        return None

    def expected(self, t: float) -> ExpectedHand | None:
        """The predicted hand in an image of ``t`` not processed yet; None while its position is
        unknown, and for an engine that does not use images for tracking."""
        return None

    def feed_wrist(self, pose: WristPose) -> Notice | None:
        """Take the pose of a tracker on the hand. Reports a pose that cannot be used, once; what an
        engine that takes its position from images reports is that it ignores them."""
        return warning("wrist_pose.not_used")

    def set_vibration(self, gyro: float, accel: float) -> None:
        """From now on the IMUs have this noise in addition, rad/s/√Hz and m/s²/√Hz, since motors
        run; an engine without a model of noise ignores it."""
        return

    def drain_notices(self) -> list[Notice]:
        """Notices since the last call; for an engine without any, none."""
        return []

    def reset_pose(self) -> Notice | None:
        """Align the joints with a flat hand that the wearer holds now. Returns a notice of the
        result; None for an engine without this function."""
        return None

    @property
    def heading_drift_sd(self) -> float:
        """sd (rad) of the rotation about the vertical while no image measures it; NaN for an engine
        that does not estimate it, and while it is measured or unknown."""
        return float("nan")
