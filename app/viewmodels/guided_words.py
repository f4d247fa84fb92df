"""Texts of guided poses: instructions and corrections."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from app.viewmodels.guided import GuidedPhase, GuidedRun
from app.viewmodels.states import BLUISH_GREEN, ORANGE, SKY
from app.words import local, mark, tr
from tracker.fusion.chain.known import WearerSnapshot
from tracker.hand.holding import NOTHING_ARRIVES, Holding, how_held
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS
from tracker.hand.poses import POSES
from tracker.messages import Array, Calibration, Estimate

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


# ---- the results of guided poses as sentences and figures, before and after
#
# Only parameters that the poses measure are listed: an end joint without measurements bends like
# its neighbours. A change is reported if it exceeds the remaining uncertainty.

BENT_DEG = {"thumb": 45.0}
FINGER_BENT_DEG = 90.0
"""Flexion of the neighbouring joint for which an end joint is reported, as in a fist."""
CLEAR_DEG, CLEAR_MM = 2.0, 0.5  # minimum changes that are reported
DIGITS = {
    "thumb": mark("thumb"),
    "index": mark("index finger"),
    "middle": mark("middle finger"),
    "ring": mark("ring finger"),
    "little": mark("little finger"),
}


class WearerNow(NamedTuple):
    """The estimates of an engine: gains (k, 2) ratio and offset (rad) of the hand's synergies,
    abduction (S,) rad; ``ends``, by the digits that poses measure, the covariance (3, 3) of ratio,
    offset and abduction; calibration; ``remembered``, a snapshot to restore it. ``frozen``: not
    updated; ``learning``: the last pose is still being evaluated."""

    gains: Array
    abduction: Array
    ends: Mapping[str, Array]
    calibration: Calibration
    remembered: WearerSnapshot
    frozen: bool = False
    learning: bool = False


class Figure(NamedTuple):
    """A value and its standard deviation in the same unit."""

    value: float
    sd: float


class LearnedRow(NamedTuple):
    """One value; ``change`` in its unit, ``is_clear`` if it is reported."""

    what: str
    before: str
    after: str
    change: str
    is_clear: bool


class LearnedWords(NamedTuple):
    """``words``: sentences; empty if no change is reported."""

    rows: list[LearnedRow]
    words: list[str]


def learned(hand: HandModel, before: WearerNow, after: WearerNow) -> LearnedWords:
    """End joints of all digits that follow another joint, thumb abduction, and the size."""
    rows: list[LearnedRow] = []
    words: list[str] = []
    for digit in DIGITS:
        link = _link(hand, digit)
        if link is None or digit not in after.ends or digit not in before.ends:
            continue
        name = tr(DIGITS[digit])
        bent = np.deg2rad(BENT_DEG.get(digit, FINGER_BENT_DEG))
        for form, source in (
            (tr("End joint of the {}, straight"), 0.0),
            (tr("End joint of the {}, bent"), bent),
        ):
            old, new = (_bend_deg(now, digit, link, source) for now in (before, after))
            rows.append(_row(form.format(name), old, new, "°", CLEAR_DEG))
        words += _bend_words(name, old, new)
    rows += _stand(hand, before, after)
    rows += _size(before.calibration, after.calibration)
    words += _size_words(before.calibration, after.calibration)
    return LearnedWords(rows, words)


def _link(hand: HandModel, digit: str) -> int | None:
    """Row of the synergy of a digit's end joint."""
    chain = CHAINS[digit][-1]
    name = next((f"{j.name}_flexion" for j in hand.joints if j.child == chain), "")
    return next((k for k, s in enumerate(hand.synergies) if s.angle == name), None)


def _bend_deg(now: WearerNow, digit: str, link: int, source: float) -> Figure:
    ratio, offset = now.gains[link]
    by = np.array([source, 1.0, 0.0])
    sd = np.sqrt(by @ now.ends[digit] @ by)
    return Figure(float(np.rad2deg(ratio * source + offset)), float(np.rad2deg(sd)))


def _is_clear(old: Figure, new: Figure, least: float) -> bool:
    return abs(new.value - old.value) >= np.nanmax([least, new.sd])


def _bend_words(name: str, old: Figure, new: Figure) -> list[str]:
    if not _is_clear(old, new, CLEAR_DEG):
        return []
    change_deg = new.value - old.value
    more = tr("The end joint of your {} bends {:.0f}° more than estimated before.")
    less = tr("The end joint of your {} bends {:.0f}° less than estimated before.")
    return [(more if change_deg > 0 else less).format(name, abs(change_deg))]


def _stand(hand: HandModel, before: WearerNow, after: WearerNow) -> list[LearnedRow]:
    """Thumb abduction."""
    row = hand.index.get(CHAINS["thumb"][-1], -1)
    if row < 0 or "thumb" not in after.ends or "thumb" not in before.ends:
        return []
    old, new = (
        Figure(*np.rad2deg([now.abduction[row], np.sqrt(now.ends["thumb"][2, 2])]).tolist())
        for now in (before, after)
    )
    return [_row(tr("Tip of the thumb, to the side"), old, new, "°", CLEAR_DEG)]


def _size(before: Calibration, after: Calibration) -> list[LearnedRow]:
    old, new = _length_mm(before), _length_mm(after)
    if not (np.isfinite(old.value) and np.isfinite(new.value)):
        return []
    return [_row(tr("Length of the hand"), old, new, " mm", CLEAR_MM)]


def _length_mm(known: Calibration) -> Figure:
    return Figure(known.hand_length * 1000, known.hand_length_sd * 1000)


def _size_words(before: Calibration, after: Calibration) -> list[str]:
    old, new = _length_mm(before), _length_mm(after)
    if not _is_clear(old, new, CLEAR_MM):
        return []
    change_mm = new.value - old.value
    longer = tr("Your hand is {:.1f} mm longer than estimated before.")
    shorter = tr("Your hand is {:.1f} mm shorter than estimated before.")
    return [(longer if change_mm > 0 else shorter).format(local(abs(change_mm)))]


def _row(what: str, old: Figure, new: Figure, unit: str, least: float) -> LearnedRow:
    before, after = (
        f"{local(f.value):.1f}{unit}" + (f" ± {local(f.sd):.1f}" if np.isfinite(f.sd) else "")
        for f in (old, new)
    )
    change = f"{local(new.value - old.value):+.1f}{unit}"
    return LearnedRow(what, before, after, change, _is_clear(old, new, least))
