"""The prior pose of a hand that was not seen before."""

import numpy as np
import pytest

from tracker.fusion.chain.layout import ChainLayout, V
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.prior import initial_covariance, reset_pose
from tracker.fusion.kalman import update
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel

PERIOD, WRONG = 0.1, 0.02  # s between two images, and m of error in the first


@pytest.fixture(scope="module")
def layout(hand: HandModel, glove: GloveModel) -> ChainLayout:
    return ChainLayout(hand, glove)


def test_a_hand_at_a_start_is_slower_than_one_that_returns(layout: ChainLayout) -> None:
    prior = ChainParams().prior
    shown = initial_covariance(layout, prior)
    back = shown.copy()
    reset_pose(back, layout, prior)
    v = np.arange(V, V + 3)
    assert np.all(shown[v, v] < back[v, v] / 4)
    assert np.all(shown[v, v] > 0.2**2)  # as fast as hands are shown to a camera


def test_a_correction_by_the_second_image_is_less_mistaken_for_velocity(
    layout: ChainLayout,
) -> None:
    """Two positions (sd as large as the error) that differ by 2 cm: with an unconstrained velocity
    the whole difference is taken for velocity, and in the next period the hand is 2 cm off in the
    other direction."""
    prior = ChainParams().prior
    speeds = []
    for free in (False, True):
        P = initial_covariance(layout, prior)[:6, :6].copy()
        if free:
            P[3:, 3:] = prior.velocity**2 * np.eye(3)
        H, R = np.eye(3, 6), WRONG**2 * np.eye(3)
        _, P = update(P, H, np.zeros(3), R)
        F = np.eye(6)
        F[:3, 3:] = PERIOD * np.eye(3)
        dx, _ = update(F @ P @ F.T, H, np.array([WRONG, 0.0, 0.0]), R)
        speeds.append(dx[3])
    assert speeds[0] < 0.8 * speeds[1]
    assert speeds[1] > 0.9 * WRONG / PERIOD
