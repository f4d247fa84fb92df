"""What the pipeline asks of an engine: what each must do, and what only some can do."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, NamedTuple, Protocol

from tracker.base.notices import Notice
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    Estimate,
    FrameResult,
    ImuSample,
    IntArray,
)

COAST_DAMPING = 2.0  # 1/s: how fast a velocity that no marker confirms dies away


class ExpectedHand(NamedTuple):
    """A hand at an image's instant as what was before it tells: the estimate, and its markers'
    p_G (m, 3) m, their sd (m,) m and ids (m,)."""

    estimate: Estimate
    p_G: Array
    sd: Array
    ids: IntArray


class Engine(Protocol):
    """A synchronous tracker: the same messages in the same order give the same states.

    An engine derives from this class. What only some can do is given a default here. What must be
    known before an engine is made is in `tracker.engine.kinds.Capabilities`; an engine that learns
    the wearer is also a `tracker.fusion.worn.LearnsWearer`.
    """

    @abstractmethod
    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Take a packet; the hand at the packet's instant."""

    @abstractmethod
    def feed_frame(self, frame: BlobFrame) -> None:
        """Take what was seen; processed once IMU data cover its exposure."""

    @abstractmethod
    def take_results(self) -> list[FrameResult]:
        """What was made of images since the last call, oldest first."""

    @abstractmethod
    def predict(self, t: float) -> Estimate:
        """The hand at any instant near now. Moves nothing."""

    @abstractmethod
    def calibration(self) -> Calibration:
        """Estimated parameters with their uncertainty."""

    @abstractmethod
    def get_state(self) -> Any:
        """Everything that changes, independent of the engine."""

    @abstractmethod
    def set_state(self, state: Any) -> None:
        """Go on from `get_state`."""

    # ---- what only some engines can do

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        """Markers expected in G (n, 3), their sd (n,) m and ids (n,); None while searching, and
        for an engine that does not follow images."""
        return None

    def expected(self, t: float) -> ExpectedHand | None:
        """The hand in an image of ``t`` that was not used yet; None while its place is unknown,
        and for an engine that does not follow images."""
        return None

    def reset_pose(self) -> Notice | None:
        """Align joints with a flat hand that the wearer holds now. Reports what was done; None for
        an engine that cannot do it."""
        return None

    @property
    def heading_drift_sd(self) -> float:
        """sd (rad) of the turn about the vertical while no image measures it; NaN for an engine
        that does not estimate it, and while it is measured or nothing is known."""
        return float("nan")
