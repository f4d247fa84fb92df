"""The block-sparse covariance against the dense product, and laws of a hand at rest."""

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.fusion.vist.filter import VistFilter
from tracker.fusion.vist.layout import VistLayout
from tracker.fusion.vist.params import VistNoise, VistParams, VistPrior
from tracker.fusion.vist.propagate import move_covariance, propagate, transition
from tracker.fusion.vist.state import blank_state, initial_covariance
from tracker.messages import ImuSample


@pytest.fixture(scope="module")
def layout(hand, glove):
    return VistLayout(hand, glove)


def sample(layout: VistLayout, accel: np.ndarray, gyro: np.ndarray, silent=()) -> ImuSample:
    valid = np.ones(layout.n, bool)
    valid[list(silent)] = False
    return ImuSample(0.0, 0.0, 0.0, 0, accel, gyro, valid)


@pytest.mark.parametrize("silent", [(), (2,), (0, 5)])
def test_sparse_covariance_equals_the_dense_product(layout, silent):
    rng = np.random.default_rng(0)
    state = blank_state(layout)
    root = rng.normal(0, 1, (layout.size, layout.size))
    P = root @ root.T
    s = sample(layout, rng.normal(0, 9, (layout.n, 3)), rng.normal(0, 4, (layout.n, 3)), silent)
    Phi = transition(state, s, layout, 0.01)
    expected = Phi @ P @ Phi.T
    j = layout.imu_of
    move_covariance(P, state.R_GI, s.gyro[j], s.accel[j], s.valid[j], 0.01)
    np.testing.assert_allclose(P, expected, rtol=1e-11, atol=1e-11)


def test_a_hand_at_rest_stays(layout):
    state = blank_state(layout)
    up_I = state.R_GI.swapaxes(1, 2)[:, :, 2] * GRAVITY
    accel = np.empty((layout.n, 3))
    accel[layout.imu_of] = up_I
    start = state.p_GI.copy()
    still = sample(layout, accel, np.zeros((layout.n, 3)))
    for _ in range(100):
        propagate(state, layout, VistNoise(), still, 0.01, covariance=False)
    np.testing.assert_allclose(state.p_GI, start, atol=1e-12)


def test_a_silent_finger_goes_with_the_hand(layout):
    """Turning and accelerating all at once, the silent segment keeps its place by its parent."""
    state = blank_state(layout)
    middle = layout.chain.names.index("middle_intermediate")
    parent = int(layout.chain.parent[middle])
    rng = np.random.default_rng(1)
    silent = sample(
        layout,
        rng.normal(0, 9, (layout.n, 3)),
        rng.normal(0, 2, (layout.n, 3)),
        [layout.imu_of[middle]],
    )
    before = state.R_GI[parent].T @ state.R_GI[middle]
    for _ in range(50):
        propagate(state, layout, VistNoise(), silent, 0.01, covariance=False)
    np.testing.assert_allclose(state.R_GI[parent].T @ state.R_GI[middle], before, atol=1e-12)
    np.testing.assert_allclose(state.v_GI[middle], state.v_GI[parent], atol=1e-12)


def test_covariance_stays_positive_over_a_long_time(layout):
    params = VistParams()
    update = VistFilter(layout, params)
    state = blank_state(layout)
    state.P = initial_covariance(layout, VistPrior())
    rng = np.random.default_rng(2)
    for k in range(1000):
        s = sample(
            layout,
            rng.normal(0, 2, (layout.n, 3)) + [0, 0, GRAVITY],
            rng.normal(0, 1, (layout.n, 3)),
        )
        propagate(state, layout, params.noise, s, 0.01)
        if k % 3 == 0:
            update.constrain(state)
    assert np.abs(state.P - state.P.T).max() < 1e-9 * np.abs(state.P).max()
    assert np.linalg.eigvalsh(state.P)[0] > 0
