"""Misplaced digits are moved to their markers; chance matches are distinguished from support."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest

from tracker.fusion.chain.digits import RADIUS, DigitSearch, SeenPoints
from tracker.fusion.chain.kinematics import marker_positions
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.state import ChainState, initial_state
from tracker.fusion.chain.support import Evidence
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array

BENT = {"index_mcp_flexion": 0.5, "index_mcp_abduction": 0.1, "thumb_cmc_abduction": 0.3}
INDEX = 1


class Posed(NamedTuple):
    """A hand in a posture, its digits, and points at all of its markers, viewed from above."""

    state: ChainState
    digits: DigitSearch
    points: SeenPoints


def posed(hand: HandModel, layout: ChainLayout) -> Posed:
    angles = np.zeros(len(hand.joint_names))
    for name, angle in BENT.items():
        angles[hand.angle_index[name]] = angle
    state = initial_state(layout)
    R, _ = hand.forward(angles, np.eye(3), np.zeros(3))
    state.R_GB = R[layout.active]
    p_G = marker_positions(state, layout)
    hue = layout.glove.marker_hue
    points = SeenPoints(p_G, hue, np.ones(len(hue), bool), np.array([0.05, 0.0, 0.5]))
    return Posed(state, DigitSearch(layout), points)


def turned(posed: Posed, layout: ChainLayout, digit: int, angle: float) -> ChainState:
    """The same hand with a digit rotated about G's z by ``angle`` rad."""
    out = posed.state.copy()
    rows = np.flatnonzero(digit_of(layout) == digit)
    out.R_GB[rows] = so3.rz(angle) @ out.R_GB[rows]
    return out


@pytest.fixture
def layout(hand: HandModel, glove: GloveModel) -> ChainLayout:
    return ChainLayout(hand, glove)


def test_a_correct_digit_is_unchanged(hand: HandModel, layout: ChainLayout) -> None:
    right = posed(hand, layout)
    for digit in range(right.digits.count):
        assert right.digits.other(right.state, digit, right.points) is None


def test_a_misplaced_finger_is_moved_to_its_markers(hand: HandModel, layout: ChainLayout) -> None:
    """Off by 20°, which moves its end by 3 cm; the grid's steps leave a third of that."""
    right = posed(hand, layout)
    wrong = turned(right, layout, INDEX, np.deg2rad(20.0))
    R = right.digits.other(wrong, INDEX, right.points)
    assert R is not None
    rows = np.flatnonzero(digit_of(layout) == INDEX)
    others = np.setdiff1d(np.arange(len(R)), rows)
    np.testing.assert_array_equal(R[others], wrong.R_GB[others])

    def off(R_GB: Array) -> float:
        between = so3.log(R_GB[rows].swapaxes(1, 2) @ right.state.R_GB[rows])
        return float(np.linalg.norm(between, axis=1).max())

    assert off(R) < 0.5 * off(wrong.R_GB)


def test_support_counts_markers_and_fades_with_distance(
    hand: HandModel, layout: ChainLayout
) -> None:
    right = posed(hand, layout)
    there = right.digits.support(right.state, INDEX, right.points)
    lateral = right.points.p_G + [0.0, 0.0, 0.5 * RADIUS]
    half = replace(right.points, p_G=lateral)
    assert there > 2.5
    seen = right.digits.support(right.state, INDEX, half)
    assert seen == pytest.approx(0.75 * there, rel=0.02)  # 1 - (1/2)²; the way to the camera same
    nothing = right.points.within(lateral[0] + 1.0, 0.1)
    assert right.digits.support(right.state, INDEX, nothing) == 0.0


def test_without_additional_points_nothing_is_tried(hand: HandModel, layout: ChainLayout) -> None:
    right = posed(hand, layout)
    wrong = turned(right, layout, INDEX, np.deg2rad(20.0))
    far = replace(right.points, p_G=right.points.p_G + 1.0)
    assert right.digits.other(wrong, INDEX, far) is None


def test_points_that_are_all_matched_are_not_searched(hand: HandModel, layout: ChainLayout) -> None:
    """A digit moves to unmatched points, of which a single one triggers the search."""
    right = posed(hand, layout)
    wrong = turned(right, layout, INDEX, np.deg2rad(20.0))
    known = replace(right.points, fresh=np.zeros(len(right.points.hue), bool))
    assert right.digits.other(wrong, INDEX, known) is None
    known.fresh[np.flatnonzero(digit_of(layout)[layout.marker_segment] == INDEX)[0]] = True
    assert right.digits.other(wrong, INDEX, known) is not None


def evidence(matched: int, chance: float = 0.0, crowd: float = 0.0) -> Evidence:
    return Evidence(matched, 20.0, chance, crowd, np.array([4.0, 1.0, 0.0]), np.array([4.0] * 3))


def test_matches_must_exceed_chance_among_many_blobs() -> None:
    """Among few blobs any match counts; among many only those beyond chance: 3 sd more."""
    assert evidence(3).is_credible
    assert not evidence(9, chance=4.0, crowd=3.0).is_credible  # 4 + 3 * 2 > 9
    assert evidence(11, chance=4.0, crowd=3.0).is_credible
    assert not evidence(7, chance=0.1, crowd=3.0).is_credible  # too small a share
    assert evidence(9).is_start and not evidence(9, crowd=3.0).is_start


def test_digits_are_evaluated_by_their_own_markers() -> None:
    seen = evidence(10)
    assert seen.supported.tolist() == [0]
    assert seen.unsupported.tolist() == [1, 2]
