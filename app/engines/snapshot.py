"""The latest data of the engine, shared by all panels in one refresh of the window."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from app.engines.engine import EngineSetup
from app.engines.protocols import ReferenceHand, TrackedHand
from tracker.live.history import SearchedImage
from tracker.messages import (
    BlobFrame,
    Calibration,
    Estimate,
    FrameResult,
    ImuSample,
    Shed,
    Status,
    StereoFrame,
    Tracking,
)
from tracker.sensors.camera import UnfitImages

AT_FRAME = 0.1  # s between an image and an estimate that is shown over it
FEW_MISSED = 0.05  # share of unsearched images that does not yet count as overload
STOPPED_AFTER = 0.7  # s without data; with a panel's period it is shown within about 1 s
STATUS_PERIOD = 0.1  # s
RECENT_ESTIMATES = 60
"""1 s at the window's rate, more than the delay of any image."""


@dataclass(frozen=True, eq=False)
class Snapshot:
    """The latest data of every stream; None where there are none yet.

    ``imu``, ``estimates`` and ``images`` are those of the last seconds, oldest first.
    ``estimate_at_frame`` is the estimate nearest to the exposure of ``frame``: images are about
    40 ms old when they arrive, so an overlay of the newest estimate would lead the hand. The other
    hand has the same ``frame`` and ``blobs``; its ``result`` may be None.
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
    estimates: Sequence[Estimate] = field(default_factory=tuple)
    images: Sequence[SearchedImage] = field(default_factory=tuple)
    others: tuple[Snapshot, ...] = ()  # of the other hands, each with its own setup

    @property
    def hands(self) -> tuple[Snapshot, ...]:
        """The snapshots of all hands, the left one first."""
        return tuple(sorted((self, *self.others), key=lambda view: view.setup.side))

    @property
    def shed(self) -> Shed:
        """The load level of a live engine: what it leaves out because the computer is too slow."""
        if self.setup.player is not None or self.status is None:
            return Shed.NOTHING
        return Shed(int(self.status.values.get("load_shed", 0.0)))

    @property
    def is_overloaded(self) -> bool:
        """Whether a live engine skips images, or more, because of overload."""
        if self.setup.player is not None or self.status is None:
            return False
        missed = self.status.values.get("images_missed", 0.0)
        return self.shed > Shed.NOTHING or missed > FEW_MISSED

    def _has_stopped(self, last_arrival: float) -> bool:
        """Whether a live stream has sent nothing for `STOPPED_AFTER`; never for a replay."""
        if self.setup.player is not None or self.status is None:
            return False
        return self.status.t - last_arrival > STOPPED_AFTER

    @property
    def packets_arrive(self) -> bool:
        """Whether the glove sends now."""
        return len(self.imu) > 0 and not self._has_stopped(self.imu[-1].t_arrival)

    @property
    def images_arrive(self) -> bool:
        """Whether the camera sends images now."""
        return self.frame is not None and not self._has_stopped(self.frame.t_arrival)

    @property
    def unfit(self) -> UnfitImages | None:
        """The latest images that do not match the camera's calibration."""
        device = self.setup.camera.device
        return device.unfit if device is not None else None

    def truth(self) -> ReferenceHand | None:
        """The simulated hand at the instant of the estimate; it takes 1 ms, so only on demand."""
        if self.setup.truth is None or self.estimate is None:
            return None
        return self.setup.truth.at(self.estimate.t)

    def reference(self) -> ReferenceHand | None:
        """The hand to compare with: a replay's second tracking or a second engine, if one is set,
        else the truth. While one that is set has no hand, the truth is not shown instead."""
        player, compared = self.setup.player, self.setup.comparable
        other = player.reference(self.setup.side) if player is not None else None
        second = compared.reference_estimate() if compared is not None else None
        if second is not None:
            there = second.tracking != Tracking.LOST and bool(np.isfinite(second.segment_p).all())
            return (
                ReferenceHand(second.keypoints, second.segment_R, second.segment_p)
                if there
                else None
            )
        is_compared = player is not None and player.is_compared
        return other if other is not None or is_compared else self.truth()


def nearest(estimates: Sequence[Estimate], t: float) -> Estimate | None:
    """The estimate nearest to ``t`` (s); None if none is within `AT_FRAME` of it."""
    found = min(estimates, key=lambda e: abs(e.t - t), default=None)
    return found if found is not None and abs(found.t - t) <= AT_FRAME else None


class HandSnapshots:
    """Takes snapshots of one hand; ``recent`` are the last estimates, oldest first."""

    def __init__(self) -> None:
        self.recent: deque[Estimate] = deque(maxlen=RECENT_ESTIMATES)
        self._status: Status | None = None
        self._status_due = 0.0

    def take(self, setup: EngineSetup, running: bool, t: float | None = None) -> Snapshot:
        """A snapshot of the hand; ``t`` (s): with the image of that exposure."""
        hand, estimate = setup.tracked, self._estimate(setup.tracked)
        triple = hand.latest_frame() if t is None else hand.latest_frame(t)
        frame, blobs, result = triple if triple is not None else (None, None, None)
        at = frame.t if frame is not None else t
        return Snapshot(
            setup=setup,
            running=running,
            estimate=estimate,
            estimate_at_frame=nearest(self.recent, at) if at is not None else estimate,
            frame=frame,
            blobs=blobs,
            result=result,
            calibration=hand.calibration(),
            status=self._status_of(hand),
            imu=hand.recent_imu(),
            estimates=hand.recent_estimates(),
            images=hand.recent_images(),
        )

    def _estimate(self, hand: TrackedHand) -> Estimate | None:
        estimate = hand.latest_estimate()
        if estimate is not None and (not self.recent or self.recent[-1].t != estimate.t):
            self.recent.append(estimate)
        return estimate

    def _status_of(self, hand: TrackedHand) -> Status:
        """Updated every `STATUS_PERIOD`: its medians are slower than all the rest."""
        now = time.monotonic()
        if self._status is None or now >= self._status_due:
            self._status, self._status_due = hand.status(), now + STATUS_PERIOD
        return self._status


class EngineSnapshots:
    """The `HandSnapshots` of all hands of an engine."""

    def __init__(self) -> None:
        self._hands: dict[str, HandSnapshots] = {}

    def of(self, side: str) -> HandSnapshots:
        """The `HandSnapshots` of one side."""
        return self._hands.setdefault(side, HandSnapshots())

    def take(self, setup: EngineSetup, running: bool) -> Snapshot:
        """A snapshot of the hand that is shown, and of the other one with the same image."""
        view = self.of(setup.side).take(setup, running)
        if not setup.others:
            return view
        at = view.frame.t if view.frame is not None else None
        others = [self.of(other.side).take(other, running, at) for other in setup.others]
        if view.frame is not None:
            others = [replace(other, frame=view.frame, blobs=view.blobs) for other in others]
        return replace(view, others=tuple(others))
