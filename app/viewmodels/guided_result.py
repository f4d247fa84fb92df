"""What guided poses have taught, in plain words and figures: before and after."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from app.words import mark, tr
from tracker.fusion.chain.known import Remembered
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS
from tracker.messages import Array, Calibration

BENT_DEG = {"thumb": 45.0}
FINGER_BENT_DEG = 90.0
"""Flexion of the joint before the end joint at which that is told, as in a fist."""
CLEAR_DEG, CLEAR_MM = 2.0, 0.5  # changes worth a sentence
DIGITS = {
    "thumb": mark("thumb"),
    "index": mark("index finger"),
    "middle": mark("middle finger"),
    "ring": mark("ring finger"),
    "little": mark("little finger"),
}


class WearerNow(NamedTuple):
    """What an engine knows: gains (k, 2) ratio and offset (rad) of the hand's synergies, aside
    (S,) rad; calibration; ``remembered``, by which it can be taken back."""

    gains: Array
    aside: Array
    calibration: Calibration
    remembered: Remembered


class LearnedRow(NamedTuple):
    """One figure; ``change`` in its unit, ``is_clear`` where it is worth a word."""

    what: str
    before: str
    after: str
    change: str
    is_clear: bool


class Learned(NamedTuple):
    """``words``: sentences, none where nothing worth one has changed."""

    rows: list[LearnedRow]
    words: list[str]


def learned(hand: HandModel, before: WearerNow, after: WearerNow) -> Learned:
    """The end joints of all digits that follow another joint, the thumb's stand and the size."""
    rows: list[LearnedRow] = []
    words: list[str] = []
    for digit in DIGITS:
        link = _link(hand, digit)
        if link is None:
            continue
        name = tr(DIGITS[digit])
        bent = np.deg2rad(BENT_DEG.get(digit, FINGER_BENT_DEG))
        for form, source in (
            (tr("End joint of the {}, stretched"), 0.0),
            (tr("End joint of the {}, bent"), bent),
        ):
            old, new = (_bend_deg(now, link, source) for now in (before, after))
            rows.append(_row(form.format(name), old, new, "°", CLEAR_DEG))
        words += _bend_words(name, new - old)
    rows += _stand(hand, before, after)
    rows += _size(before.calibration, after.calibration)
    words += _size_words(before.calibration, after.calibration)
    return Learned(rows, words)


def _link(hand: HandModel, digit: str) -> int | None:
    """Row of the synergy that bends a digit's end joint."""
    chain = CHAINS[digit][-1]
    name = next((f"{j.name}_flexion" for j in hand.joints if j.child == chain), "")
    return next((k for k, s in enumerate(hand.synergies) if s.angle == name), None)


def _bend_deg(now: WearerNow, link: int, source: float) -> float:
    ratio, offset = now.gains[link]
    return float(np.rad2deg(ratio * source + offset))


def _bend_words(name: str, change_deg: float) -> list[str]:
    if abs(change_deg) < CLEAR_DEG:
        return []
    more = tr("The end joint of your {} bends {:.0f}° more than was thought.")
    less = tr("The end joint of your {} bends {:.0f}° less than was thought.")
    return [(more if change_deg > 0 else less).format(name, abs(change_deg))]


def _stand(hand: HandModel, before: WearerNow, after: WearerNow) -> list[LearnedRow]:
    """How far the thumb's end stands to the side."""
    row = hand.index.get(CHAINS["thumb"][-1], -1)
    if row < 0:
        return []
    old, new = (float(np.rad2deg(now.aside[row])) for now in (before, after))
    return [_row(tr("Tip of the thumb, to the side"), old, new, "°", CLEAR_DEG)]


def _size(before: Calibration, after: Calibration) -> list[LearnedRow]:
    old, new = before.hand_length * 1000, after.hand_length * 1000
    if not (np.isfinite(old) and np.isfinite(new)):
        return []
    return [_row(tr("Length of the hand"), old, new, " mm", CLEAR_MM)]


def _size_words(before: Calibration, after: Calibration) -> list[str]:
    change_mm = (after.hand_length - before.hand_length) * 1000
    if not np.isfinite(change_mm) or abs(change_mm) < CLEAR_MM:
        return []
    longer = tr("Your hand is {:.1f} mm longer than was thought.")
    shorter = tr("Your hand is {:.1f} mm shorter than was thought.")
    return [(longer if change_mm > 0 else shorter).format(abs(change_mm))]


def _row(what: str, old: float, new: float, unit: str, clear: float) -> LearnedRow:
    change = new - old
    figures = (f"{old:.1f}{unit}", f"{new:.1f}{unit}", f"{change:+.1f}{unit}")
    return LearnedRow(what, *figures, abs(change) >= clear)
