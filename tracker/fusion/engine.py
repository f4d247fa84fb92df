"""What the pipeline asks of an engine; every filter offers just this."""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

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
    """A synchronous tracker: the same messages in the same order give the same states."""

    def feed_imu(self, sample: ImuSample) -> Estimate:
        """Take a packet; the hand at the packet's instant."""

    def feed_frame(self, frame: BlobFrame) -> None:
        """Take what was seen; processed once IMU data cover its exposure."""

    def take_results(self) -> list[FrameResult]:
        """What was made of images since the last call, oldest first."""

    def predict(self, t: float) -> Estimate:
        """The hand at any instant near now. Moves nothing."""

    def predicted_markers(self, t: float) -> tuple[Array, Array, IntArray] | None:
        """Markers expected in G (n, 3), their sd (n,) m and ids (n,); None while searching."""

    def expected(self, t: float) -> ExpectedHand | None:
        """The hand in an image of ``t`` that was not used yet; None while its place is unknown."""

    def calibration(self) -> Calibration:
        """Estimated parameters with their uncertainty."""

    def get_state(self) -> Any:
        """Everything that changes, independent of the engine."""

    def set_state(self, state: Any) -> None:
        """Go on from `get_state`."""
