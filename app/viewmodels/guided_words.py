"""Texts of guided poses: instructions and corrections."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from app.viewmodels.guided import GuidedPhase, GuidedRun
from app.viewmodels.states import BLUISH_GREEN, ORANGE, SKY
from app.words import mark, tr
from tracker.hand.holding import NOTHING_ARRIVES, Holding, how_held
from tracker.hand.model import HandModel
from tracker.hand.poses import POSES
from tracker.messages import Estimate

SILENT = 1.0  # s without a new estimate after which the hand is unknown
POSE_WORDS = {
    "flat": mark("Hand flat on the table, fingers together"),
    "spread": mark("Flat on the table, fingers and thumb spread"),
    "fist": mark("A firm fist, the thumb over the fingers"),
    "thumb_up": mark("A fist with the thumb straight"),
    "pinch_index": mark("Thumb on the tip of the index finger"),
    "pinch_middle": mark("Thumb on the tip of the middle finger"),
    "pinch_ring": mark("Thumb on the tip of the ring finger"),
    "pinch_little": mark("Thumb on the tip of the little finger"),
}
POSE_NAMES = {
    "flat": mark("flat"),
    "spread": mark("spread"),
    "fist": mark("fist"),
    "thumb_up": mark("thumb straight"),
    "pinch_index": mark("index"),
    "pinch_middle": mark("middle"),
    "pinch_ring": mark("ring"),
    "pinch_little": mark("little"),
}
STRAIGHTEN = {
    "thumb": mark("Straighten the thumb"),
    "index": mark("Straighten the index finger"),
    "middle": mark("Straighten the middle finger"),
    "ring": mark("Straighten the ring finger"),
    "little": mark("Straighten the little finger"),
}
BEND = {
    "thumb": mark("Bend the thumb more"),
    "index": mark("Bend the index finger more"),
    "middle": mark("Bend the middle finger more"),
    "ring": mark("Bend the ring finger more"),
    "little": mark("Bend the little finger more"),
}
NOT_JUDGED = mark("Hold it: this finger has no sensor")


class LiveJudge:
    """Evaluates the newest estimate, unless it is outdated."""

    def __init__(
        self,
        newest: Callable[[], Estimate | None],
        hand: HandModel,
        clock: Callable[[], float],
    ) -> None:
        self._newest, self._hand, self._clock = newest, hand, clock
        self._seen, self._seen_at = -np.inf, -np.inf

    def __call__(self, pose: str) -> Holding:
        estimate, now = self._newest(), self._clock()
        if estimate is not None and estimate.t != self._seen:
            self._seen, self._seen_at = estimate.t, now
        if estimate is None or now - self._seen_at > SILENT:
            return Holding(False, NOTHING_ARRIVES)
        return how_held(POSES[pose], estimate, self._hand)


def amiss(holding: Holding) -> str:
    """How to correct the pose, in the user's language."""
    if holding.is_held:
        return ""
    if holding.joint == NOTHING_ARRIVES:
        return tr("No data from the glove")
    digit = holding.joint.split("_")[0]
    if not digit:
        return tr("Show the hand to the camera")
    if digit == holding.joint:
        return tr("Bring the tips together")
    return tr((STRAIGHTEN if holding.off > 0 else BEND)[digit])


def word(run: GuidedRun, t: float) -> str:
    """The large text at this instant."""
    if run.phase == GuidedPhase.HOLDING:
        if run.holding.is_held and run.holding.joint and not run.insisted:
            return tr(NOT_JUDGED)
        return tr("Hold it") if run.is_well else amiss(run.holding)
    if run.phase == GuidedPhase.REACHING:
        return amiss(run.holding) if run.may_begin(t) else tr("Next")
    return ""


def colour(run: GuidedRun) -> str:
    """Colour of ring and text."""
    if run.phase == GuidedPhase.HOLDING:
        return BLUISH_GREEN if run.is_well else ORANGE
    return ORANGE if run.late else SKY


def chips(run: GuidedRun) -> list[tuple[str, str]]:
    """(sign, name) of each pose: held, skipped, current, pending."""
    out = []
    for number, pose in enumerate(run.poses):
        if run.is_running and number == run.number:
            sign = "▶"
        elif pose in run.held:
            sign = "✓" if run.held[pose] else "–"
        else:
            sign = "○"
        out.append((sign, tr(POSE_NAMES[pose])))
    return out
