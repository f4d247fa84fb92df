"""Fingers with an unexpected spread are rotated to their markers."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.fusion.chain.kinematics import marker_positions
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.start.search import StereoPoints
from tracker.fusion.chain.start.start import BETTER, spread
from tracker.fusion.chain.state import ChainState, initial_state
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel

INDEX, MIDDLE = 1, 2


@pytest.fixture
def layout(hand: HandModel, glove: GloveModel) -> ChainLayout:
    return ChainLayout(hand, glove)


def lateral(layout: ChainLayout, degrees: dict[int, float]) -> ChainState:
    """A flat hand whose digits are rotated about the palm's normal, G's z, by ``degrees``."""
    state = initial_state(layout)
    for digit, angle in degrees.items():
        rows = np.flatnonzero(digit_of(layout) == digit)
        state.R_GB[rows] = so3.rz(np.deg2rad(angle)) @ state.R_GB[rows]
    return state


def seen(state: ChainState, layout: ChainLayout) -> StereoPoints:
    """A point at each marker, from above."""
    p_G = marker_positions(state, layout)
    return StereoPoints(p_G, layout.glove.marker_hue, np.array([0.05, 0.0, 0.5]))


def test_fingers_are_rotated_to_their_markers(layout: ChainLayout) -> None:
    """12° to the side, the middle finger's end is 2 cm away; steps of 5° leave 2.5° at most."""
    true, flat = lateral(layout, {INDEX: -12.0, MIDDLE: 12.0}), lateral(layout, {})
    R = spread(flat, layout, seen(true, layout))
    turned = np.flatnonzero(np.isin(digit_of(layout), (INDEX, MIDDLE)))
    others = np.setdiff1d(np.arange(len(R)), turned)
    np.testing.assert_array_equal(R[others], flat.R_GB[others])
    off = so3.log(R[turned].swapaxes(1, 2) @ true.R_GB[turned])
    assert np.rad2deg(np.linalg.norm(off, axis=1)).max() < 2.6


def test_correct_fingers_are_unchanged(layout: ChainLayout) -> None:
    flat = lateral(layout, {})
    np.testing.assert_array_equal(spread(flat, layout, seen(flat, layout)), flat.R_GB)


def test_one_stray_point_has_no_effect(layout: ChainLayout) -> None:
    """An object of a marker's colour where a rotated finger would have it counts at most half a
    marker, once the others are correct."""
    flat = lateral(layout, {})
    points = seen(flat, layout)
    stray = marker_positions(lateral(layout, {INDEX: 15.0}), layout)
    row = np.flatnonzero(digit_of(layout)[layout.marker_segment] == INDEX)[0]
    more = StereoPoints(
        np.vstack([points.p_G, stray[row]]),
        np.append(points.hue, points.hue[row]),
        points.p_GC,
    )
    assert BETTER > 0
    np.testing.assert_array_equal(spread(flat, layout, more), flat.R_GB)
