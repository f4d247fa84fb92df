"""Rows of a held pose: Jacobians against finite differences, zero residuals of an exact pose."""

from collections.abc import Callable

import numpy as np
import pytest

from tracker.fusion.chain.distal import DistalSegments, Synergies
from tracker.fusion.chain.guided.learning import PoseRows
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import GuidedParams, SynergyParams
from tracker.fusion.chain.state import ChainState, initial_state, inject
from tracker.fusion.output.completion import Completion
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS
from tracker.hand.poses import POSES
from tracker.messages import Array

STEP = 1e-5


@pytest.fixture(params=["glove", "distal_glove"])
def layout(request, hand: HandModel) -> ChainLayout:
    glove: GloveModel = request.getfixturevalue(request.param)
    return ChainLayout(hand, glove)


@pytest.fixture
def distal(layout: ChainLayout) -> DistalSegments:
    return DistalSegments(layout, SynergyParams())


def somehow(layout: ChainLayout) -> ChainState:
    """A bent hand of a random wearer."""
    rng = np.random.default_rng(4)
    state = initial_state(layout)
    dx = 0.2 * rng.normal(size=layout.blocks.size)
    dx[layout.blocks.scale : layout.blocks.joint] *= 0.2
    dx[layout.blocks.joint :] *= 0.02
    inject(state, layout, dx)
    return state


def numeric(
    f: Callable[[ChainState, Synergies], Array],
    state: ChainState,
    own: Synergies,
    layout: ChainLayout,
) -> tuple[Array, Array]:
    """Derivatives of ``f`` by the state's errors and by the synergies', central differences."""
    by_state, by_own = [], []
    for i in range(layout.blocks.size):
        sides = []
        for sign in (1, -1):
            moved, dx = state.copy(), np.zeros(layout.blocks.size)
            dx[i] = sign * STEP
            inject(moved, layout, dx)
            sides.append(f(moved, own))
        by_state.append((sides[0] - sides[1]) / (2 * STEP))
    for i in range(own.value.size):
        dx = np.zeros(own.value.size)
        dx[i] = STEP
        by_own.append((f(state, own.moved(dx, own.P)) - f(state, own.moved(-dx, own.P))) / 2 / STEP)
    shape = np.shape(f(state, own))
    return np.moveaxis(np.array(by_state), 0, -1), np.array(by_own).reshape(-1, *shape).T


def changed(distal: DistalSegments) -> Synergies:
    own = distal.prior()
    return own.moved(0.1 * np.random.default_rng(2).normal(size=own.value.size), own.P)


def test_a_point_of_a_fingertip_has_the_jacobian_of_finite_differences(layout, distal):
    state, own, x = somehow(layout), changed(distal), np.array([0.015, 0.002, -0.006])
    for digit in ("thumb", "index", "middle"):
        rows = distal.point(state, own, digit, x)
        H, H_own = numeric(lambda s, o, d=digit: distal.point(s, o, d, x).p, state, own, layout)
        # a distal segment is scaled with the digit, which is neglected: a few percent of its own
        # length
        scale = slice(layout.blocks.scale, layout.blocks.joint)
        np.testing.assert_allclose(np.delete(rows.H, scale, 1), np.delete(H, scale, 1), atol=2e-5)
        np.testing.assert_allclose(rows.H_own, H_own, atol=2e-5)


@pytest.mark.long
def test_a_flexion_has_the_jacobian_of_finite_differences(layout, distal):
    state, own = somehow(layout), changed(distal)
    for joint in ("thumb_mcp", "thumb_ip", "index_mcp", "index_pip", "index_dip"):
        row = distal.flexion(state, own, joint)
        assert row is not None
        H, H_own = numeric(
            lambda s, o, j=joint: np.array(distal.flexion(s, o, j).value), state, own, layout
        )
        np.testing.assert_allclose(row.H, H, atol=1e-4)
        np.testing.assert_allclose(row.H_own, H_own, atol=1e-4)


def test_a_fingertip_is_where_the_shown_hand_has_it(hand, layout, distal):
    state, own = somehow(layout), changed(distal)
    complete = Completion(layout)
    complete.wear(distal.gains(own), distal.lateral(own))
    from tracker.fusion.chain.kinematics import segment_positions

    R, p, scale, *_ = complete(state.R_GB, segment_positions(state, layout), state.scale3())
    for digit in ("thumb", "index", "middle"):
        row = hand.index[CHAINS[digit][-1]]
        tip = np.array([hand.segments[row].length, 0.0, 0.0])
        there = p[row] + R[row] @ (scale[row] * tip)
        np.testing.assert_allclose(distal.point(state, own, digit, tip).p, there, atol=1e-12)


def test_a_finger_without_sensors_contributes_no_rows(layout, distal):
    rows = PoseRows(layout, distal, GuidedParams())
    assert rows(somehow(layout), distal.prior(), POSES["pinch_ring"]) == []
    assert distal.flexion(somehow(layout), distal.prior(), "ring_pip") is None


def test_a_flat_hand_lies_on_the_table(layout, distal):
    rows = PoseRows(layout, distal, GuidedParams())
    flexions, plane = rows(initial_state(layout), distal.of_hand_file(), POSES["flat"])
    np.testing.assert_allclose(flexions.r, 0.0, atol=1e-12)
    # fingertips are thinner than the palm: neither of them touches in the file's hand
    assert np.abs(plane.r).max() < 5e-3


def test_straight_fingers_say_nothing_about_joints_that_follow_others(hand, glove):
    """Held straight, people's end joints are straight, however they bend in free motion."""
    layout = ChainLayout(hand, glove)
    distal = DistalSegments(layout, SynergyParams())
    flexions, _ = PoseRows(layout, distal, GuidedParams())(
        initial_state(layout), distal.prior(), POSES["flat"]
    )
    assert len(flexions.r) == 4 and not flexions.H_own.any()  # MCP and PIP of two fingers


def test_a_contact_is_independent_of_the_hands_pose(layout, distal):
    """The gap between two pads does not depend on where the whole hand is, nor on how it is
    turned."""
    rows = PoseRows(layout, distal, GuidedParams())
    (contact,) = rows(somehow(layout), changed(distal), POSES["pinch_index"])
    everywhere = np.zeros(layout.blocks.size)
    everywhere[:3] = 1.0
    np.testing.assert_allclose(contact.H @ everywhere, 0.0, atol=1e-12)
    state = somehow(layout)
    turn_G = np.array([0.3, -0.5, 0.8])
    for a in range(len(layout.active)):
        first = layout.blocks.theta + 3 * a
        everywhere[first : first + 3] = state.R_GB[a].T @ turn_G
    everywhere[:3] = 0.0
    np.testing.assert_allclose(contact.H @ everywhere, 0.0, atol=1e-6)
