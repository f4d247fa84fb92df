"""Guided poses: the requested pose, how far it has been held, and the notices about it.

The engine is notified that a pose begins when it is first held well, and that it ends after `HELD`
s; if the wearer loses the pose, it starts again. A wearer can accept a pose that is not detected,
or skip one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import Enum

from app.engines.engine import LivePart
from tracker.hand.holding import NOTHING_ARRIVES, Holding
from tracker.hand.poses import BETWEEN, HELD, POSES

SLACK = 0.4  # s for which a pose may be held badly before it counts as released
POSE_TIMEOUT = 12.0  # s after which a pose that a visible hand does not hold is skipped
LONGEST_STEP = (
    0.25  # maximum s between two evaluations that count as held, for example if the window stalls
)
UNSEEN = ("", NOTHING_ARRIVES)
"""Replaces the joint if there is no hand to evaluate."""
Judge = Callable[[str], Holding]
"""Returns how the pose of that name is held at this instant."""


class GuidedPhase(Enum):
    WAITING = "waiting"  # not started
    REACHING = "reaching"
    HOLDING = "holding"
    DONE = "done"


class GuidedRun:
    """Call ``tick`` with a clock's time in s; ``share`` 0..1 is the filled part of the ring.

    ``held`` are the outcomes so far by pose: True held, False skipped.
    """

    def __init__(self, live: LivePart, judge: Judge, poses: Sequence[str] = tuple(POSES)) -> None:
        self._hand, self._wearer, self._judge = live.hand, live.wearer, judge
        self.poses = tuple(poses)
        self.phase = GuidedPhase.WAITING
        self.number = 0
        self.share = 0.0
        self.holding = Holding(True)
        self.held: dict[str, bool] = {}
        self.insisted = False  # the wearer accepted the pose
        self.late = False  # there was enough time for the pose, but it is not held
        self._requested_at = self._well = self._last = self._missed = 0.0

    @property
    def pose(self) -> str:
        """The requested pose; the last one at the end."""
        return self.poses[min(self.number, len(self.poses) - 1)]

    @property
    def is_running(self) -> bool:
        return self.phase in (GuidedPhase.REACHING, GuidedPhase.HOLDING)

    def may_begin(self, t: float) -> bool:
        """Whether there was enough time to take the pose."""
        return t - self._requested_at >= BETWEEN

    @property
    def is_well(self) -> bool:
        """Whether the pose is held according to the evaluation, or accepted by a visible wearer."""
        return self.holding.is_held or (self.insisted and not self._is_unseen)

    @property
    def _is_unseen(self) -> bool:
        """Whether there is no hand to evaluate."""
        return not self.holding.is_held and self.holding.joint in UNSEEN

    # --- requests of the wearer

    def start(self, t: float) -> None:
        """Start from the first pose."""
        self.held = {}
        self._ask(0, t)

    def insist(self, t: float) -> None:
        """Accept the pose whatever the evaluation; the engine checks its measurements itself."""
        if self.phase == GuidedPhase.REACHING and not self._is_unseen:
            self.insisted = True
            self._begin(t)

    def skip(self, t: float) -> None:
        """Skip this pose."""
        if self.is_running:
            if self.phase == GuidedPhase.REACHING:
                self._hand.hold(self.pose)  # the recording contains which pose was skipped
            self._end(False, t)

    def repeat(self, t: float) -> None:
        """Repeat this pose, or the previous one if this one has not begun; at the end, the last
        one."""
        if self.phase == GuidedPhase.WAITING:
            return
        if self.phase == GuidedPhase.HOLDING:
            self._hand.let_go(self.pose, False)
            self._ask(self.number, t)
        else:
            self._ask(max(self.number - 1, 0), t)

    def cancel(self) -> None:
        """Stop; poses held so far are used."""
        if self.phase == GuidedPhase.HOLDING:
            self._hand.let_go(self.pose, False)
        if self.is_running:
            self._show("")
        self.phase = GuidedPhase.DONE

    # --- progress

    def tick(self, t: float) -> None:
        """Evaluate the pose."""
        step, self._last = min(t - self._last, LONGEST_STEP), t
        if not self.is_running:
            return
        self.holding = self._judge(self.pose)
        self.late = self.phase == GuidedPhase.REACHING and self.may_begin(t)
        if self.phase == GuidedPhase.REACHING:
            if self.late and self.holding.is_held:
                self._begin(t)
            elif self.late and not self._is_unseen:  # wait for a hand that is not visible
                self._missed += step
                if self._missed > POSE_TIMEOUT:
                    self.skip(t)
            return
        if self.is_well:
            self._well = t
            self.share += step / HELD
        elif t - self._well > SLACK:
            self._lost(t)
        if self.share >= 1.0:
            self._end(True, t)

    def _show(self, pose: str) -> None:
        """Instruct a simulated wearer; a real one reads the screen."""
        if self._wearer is not None:
            self._wearer.show(pose)

    def _ask(self, number: int, t: float) -> None:
        self.number, self.phase, self.share = number, GuidedPhase.REACHING, 0.0
        self._requested_at, self._last, self.insisted, self.late = t, t, False, False
        self._missed = 0.0
        self._show(self.pose)

    def _begin(self, t: float) -> None:
        self.phase, self.share, self._well, self._last = GuidedPhase.HOLDING, 0.0, t, t
        self._hand.hold(self.pose)

    def _lost(self, t: float) -> None:
        """Restart a pose that was released too early, without a pause."""
        self._hand.let_go(self.pose, False)
        self.phase, self.share, self._requested_at = GuidedPhase.REACHING, 0.0, t - BETWEEN

    def _end(self, held: bool, t: float) -> None:
        self._hand.let_go(self.pose, held)
        self.held[self.pose] = held
        if self.number + 1 < len(self.poses):
            self._ask(self.number + 1, t)
        else:
            self.number += 1
            self.phase = GuidedPhase.DONE
            self._show("")
