"""Led through held poses: which pose is asked for, how far it is held, and what is told of it.

A pose is told to begin when it is first held well and to end when it was held for `HELD` s, so
that what the engine learns from was held; a wearer who loses it begins again. One whom the
judgement does not believe may insist, one who cannot may skip.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import Enum

from app.engines.engine import LivePart
from tracker.hand.holding import NOTHING_ARRIVES, Holding
from tracker.hand.poses import BETWEEN, HELD, POSES

SLACK = 0.4  # s for which a pose may look badly held before it counts as let go
PATIENCE = 12.0  # s of a hand that is seen and does not hold the pose, which is left out then
LONGEST_STEP = 0.25  # s between two looks that count as held; a stalled window proves nothing
UNSEEN = ("", NOTHING_ARRIVES)
"""In place of a joint where there is no hand to be judged."""
Judge = Callable[[str], Holding]
"""How the pose of that name is held at this instant."""


class GuidedPhase(Enum):
    WAITING = "waiting"  # not begun
    REACHING = "reaching"
    HOLDING = "holding"
    DONE = "done"


class GuidedRun:
    """``tick`` it with a clock's time in s; ``share`` 0..1 says how full the ring is.

    ``held`` are the outcomes so far by pose: True held, False left out.
    """

    def __init__(self, live: LivePart, judge: Judge, poses: Sequence[str] = tuple(POSES)) -> None:
        self._hand, self._wearer, self._judge = live.hand, live.wearer, judge
        self.poses = tuple(poses)
        self.phase = GuidedPhase.WAITING
        self.number = 0
        self.share = 0.0
        self.holding = Holding(True)
        self.held: dict[str, bool] = {}
        self.insisted = False  # the wearer says that it is held
        self.late = False  # the pose could be held by now, and is not
        self._asked = self._well = self._last = self._missed = 0.0

    @property
    def pose(self) -> str:
        """The one asked for; the last one when all are done."""
        return self.poses[min(self.number, len(self.poses) - 1)]

    @property
    def is_running(self) -> bool:
        return self.phase in (GuidedPhase.REACHING, GuidedPhase.HOLDING)

    def may_begin(self, t: float) -> bool:
        """Whether the wearer has had the time to come to the pose."""
        return t - self._asked >= BETWEEN

    @property
    def is_well(self) -> bool:
        """Whether the pose is held by all that is known, or by the word of a wearer who is seen."""
        return self.holding.is_held or (self.insisted and not self._is_unseen)

    @property
    def _is_unseen(self) -> bool:
        """There is no hand to be judged, nor one to be learned from."""
        return not self.holding.is_held and self.holding.joint in UNSEEN

    # --- what the wearer asks

    def start(self, t: float) -> None:
        """From the first pose on."""
        self.held = {}
        self._ask(0, t)

    def insist(self, t: float) -> None:
        """It is held, whatever it looks like: the engine judges for itself what it believes."""
        if self.phase == GuidedPhase.REACHING and not self._is_unseen:
            self.insisted = True
            self._begin(t)

    def skip(self, t: float) -> None:
        """Leave this pose out."""
        if self.is_running:
            if self.phase == GuidedPhase.REACHING:
                self._hand.hold(self.pose)  # a recording tells what was skipped
            self._end(False, t)

    def repeat(self, t: float) -> None:
        """This pose again, or the one before where this one has not begun; the last when done."""
        if self.phase == GuidedPhase.WAITING:
            return
        if self.phase == GuidedPhase.HOLDING:
            self._hand.let_go(self.pose, False)
            self._ask(self.number, t)
        else:
            self._ask(max(self.number - 1, 0), t)

    def cancel(self) -> None:
        """Nothing more is asked for; what was held counts."""
        if self.phase == GuidedPhase.HOLDING:
            self._hand.let_go(self.pose, False)
        if self.is_running:
            self._show("")
        self.phase = GuidedPhase.DONE

    # --- as time goes on

    def tick(self, t: float) -> None:
        """Look how the pose is held."""
        step, self._last = min(t - self._last, LONGEST_STEP), t
        if not self.is_running:
            return
        self.holding = self._judge(self.pose)
        self.late = self.phase == GuidedPhase.REACHING and self.may_begin(t)
        if self.phase == GuidedPhase.REACHING:
            if self.late and self.holding.is_held:
                self._begin(t)
            elif self.late and not self._is_unseen:  # who is not seen is waited for
                self._missed += step
                if self._missed > PATIENCE:
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
        """To a simulated wearer, who takes the pose; a real one reads the screen."""
        if self._wearer is not None:
            self._wearer.show(pose)

    def _ask(self, number: int, t: float) -> None:
        self.number, self.phase, self.share = number, GuidedPhase.REACHING, 0.0
        self._asked, self._last, self.insisted, self.late = t, t, False, False
        self._missed = 0.0
        self._show(self.pose)

    def _begin(self, t: float) -> None:
        self.phase, self.share, self._well, self._last = GuidedPhase.HOLDING, 0.0, t, t
        self._hand.hold(self.pose)

    def _lost(self, t: float) -> None:
        """Let go too early: the same pose from its beginning, without a pause."""
        self._hand.let_go(self.pose, False)
        self.phase, self.share, self._asked = GuidedPhase.REACHING, 0.0, t - BETWEEN

    def _end(self, held: bool, t: float) -> None:
        self._hand.let_go(self.pose, held)
        self.held[self.pose] = held
        if self.number + 1 < len(self.poses):
            self._ask(self.number + 1, t)
        else:
            self.number += 1
            self.phase = GuidedPhase.DONE
            self._show("")
