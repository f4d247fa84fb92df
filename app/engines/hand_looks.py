"""What the host keeps of one hand between two looks at it."""

from __future__ import annotations

import time
from collections import deque
from dataclasses import replace

from app.engines.engine import EngineSetup
from app.engines.protocols import TrackedHand
from app.engines.snapshot import Snapshot, nearest
from tracker.messages import Estimate, Status

STATUS_PERIOD = 0.1  # s
RECENT_ESTIMATES = 60
"""One second at the window's rate: more than any image is late."""


class HandLooks:
    """``recent`` are the last estimates, oldest first."""

    def __init__(self) -> None:
        self.recent: deque[Estimate] = deque(maxlen=RECENT_ESTIMATES)
        self._status: Status | None = None
        self._status_due = 0.0

    def look(self, setup: EngineSetup, running: bool, t: float | None = None) -> Snapshot:
        """The latest of the hand; ``t`` (s): with the image of that exposure."""
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
        """A few times a second: its medians and percentiles cost more than the rest of a look."""
        now = time.monotonic()
        if self._status is None or now >= self._status_due:
            self._status, self._status_due = hand.status(), now + STATUS_PERIOD
        return self._status


class Looks:
    """Those of all hands of an engine."""

    def __init__(self) -> None:
        self._hands: dict[str, HandLooks] = {}

    def of(self, side: str) -> HandLooks:
        """Of the hand of that side."""
        return self._hands.setdefault(side, HandLooks())

    def look(self, setup: EngineSetup, running: bool) -> Snapshot:
        """The latest of the hand that is shown, and of the other one in the same image."""
        view = self.of(setup.side).look(setup, running)
        if not setup.others:
            return view
        at = view.frame.t if view.frame is not None else None
        others = [self.of(other.side).look(other, running, at) for other in setup.others]
        if view.frame is not None:
            others = [replace(other, frame=view.frame, blobs=view.blobs) for other in others]
        return replace(view, others=tuple(others))
