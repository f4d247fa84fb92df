"""One look at the engine: what all panels of one tick share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from app.engines.engine import EngineSetup, ReferenceHand
from tracker.messages import (
    BlobFrame,
    Calibration,
    Estimate,
    FrameResult,
    ImuSample,
    Status,
    StereoFrame,
    Tracking,
)


@dataclass(frozen=True, eq=False)
class Snapshot:
    """The latest of every stream; None where there is nothing yet.

    ``estimate_at_frame`` is the estimate nearest to the exposure of ``frame``: images are some
    40 ms old when they arrive, so an overlay of the newest estimate would lead the hand.
    """

    setup: EngineSetup
    running: bool
    estimate: Estimate | None = None
    estimate_at_frame: Estimate | None = None
    frame: StereoFrame | None = None
    blobs: BlobFrame | None = None
    result: FrameResult | None = None
    calibration: Calibration | None = None
    status: Status | None = None
    imu: Sequence[ImuSample] = field(default_factory=tuple)

    def truth(self) -> ReferenceHand | None:
        """The simulated hand at the instant of the estimate; a millisecond's work, so on demand."""
        if self.setup.truth is None or self.estimate is None:
            return None
        return self.setup.truth(self.estimate.t)

    def reference(self) -> ReferenceHand | None:
        """The hand to compare with: a replay's second tracking, or a second engine, where one is
        set, else the truth."""
        player, reference_tracking = self.setup.player, self.setup.reference_tracking
        other = player.reference() if player is not None else None
        second = reference_tracking.reference_estimate() if reference_tracking is not None else None
        if second is not None:
            there = second.tracking != Tracking.LOST and bool(np.isfinite(second.segment_p).all())
            return (
                ReferenceHand(second.keypoints, second.segment_R, second.segment_p)
                if there
                else None
            )
        return other if other is not None else self.truth()


def nearest(estimates: Sequence[Estimate], t: float) -> Estimate | None:
    """The estimate whose instant is nearest to ``t``."""
    return min(estimates, key=lambda e: abs(e.t - t), default=None)
