"""Every derivative of the paper's filter against central differences of the function itself."""

import numpy as np
import pytest

from tracker.fusion.vist.filter import Anatomy
from tracker.fusion.vist.layout import VistLayout
from tracker.fusion.vist.params import VistConstraint, VistNoise
from tracker.fusion.vist.points import in_joint_rows, jacobians, positions
from tracker.fusion.vist.propagate import propagate, transition
from tracker.fusion.vist.state import VistState, inject
from tracker.geometry import so3
from tracker.messages import ImuSample

STEP = 1e-6


@pytest.fixture(scope="module")
def layout(hand, glove):
    return VistLayout(hand, glove)


def random_state(layout: VistLayout, seed: int) -> VistState:
    rng = np.random.default_rng(seed)
    n = layout.n
    return VistState(
        t=0.0,
        p_GI=rng.normal(0, 0.1, (n, 3)),
        v_GI=rng.normal(0, 0.5, (n, 3)),
        R_GI=so3.exp(rng.normal(0, 1.0, (n, 3))),
        bg=rng.normal(0, 0.02, (n, 3)),
        ba=rng.normal(0, 0.2, (n, 3)),
        scale=rng.uniform(0.8, 1.2, (n, 3)),
        R_IB=so3.exp(rng.normal(0, 0.5, (n, 3))),
        P=np.eye(layout.size),
    )


def moved(state: VistState, dx: np.ndarray) -> VistState:
    out = state.copy_nominal()
    inject(out, dx)
    return out


def differences(f, state: VistState, size: int) -> np.ndarray:
    columns = []
    for k in range(size):
        dx = np.zeros(size)
        dx[k] = STEP
        columns.append((f(moved(state, dx)) - f(moved(state, -dx))) / (2 * STEP))
    return np.stack(columns, axis=-1)


@pytest.mark.parametrize("seed", [0, 1])
def test_marker_jacobian(layout, seed):
    state, segment = random_state(layout, seed), layout.chain.marker_segment
    H = in_joint_rows(jacobians(state, segment, layout.marker_lever), segment, layout.size)
    f = lambda s: positions(s, segment, layout.marker_lever)  # noqa: E731
    np.testing.assert_allclose(H, differences(f, state, layout.size), atol=1e-7)


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize("kind", ["position_rows", "rotation_rows"])
def test_constraint_jacobians(layout, seed, kind):
    state, anatomy = random_state(layout, seed), Anatomy(layout, VistConstraint())
    H, _ = getattr(anatomy, kind)(state)
    f = lambda s: -getattr(anatomy, kind)(s)[1]  # noqa: E731
    np.testing.assert_allclose(H, differences(f, state, layout.size), atol=1e-6)


def test_the_paper_has_six_positional_and_seven_rotational_constraints(layout):
    anatomy = Anatomy(layout, VistConstraint())
    assert len(anatomy.children) == 6
    assert len(anatomy.axes) == 7


def packet(layout: VistLayout, seed: int) -> ImuSample:
    rng = np.random.default_rng(seed)
    n = layout.n
    return ImuSample(
        0.0, 0.0, 0.0, 0, rng.normal(0, 5, (n, 3)), rng.normal(0, 3, (n, 3)), np.ones(n, bool)
    )


def test_transition_is_the_derivative_of_the_nominal_motion(layout):
    """Error after = Phi error before; the model drops terms of order dt times itself."""
    dt = 1e-3
    state, sample = random_state(layout, 3), packet(layout, 4)
    Phi = transition(state, sample, layout, dt)

    def after(s: VistState) -> VistState:
        out = s.copy_nominal()
        propagate(out, layout, VistNoise(), sample, dt, covariance=False)
        return out

    rng = np.random.default_rng(5)
    base = after(state)
    for _ in range(5):
        dx = rng.normal(0, 1e-5, layout.size)
        there = after(moved(state, dx))
        error = np.concatenate(
            [
                there.p_GI - base.p_GI,
                there.v_GI - base.v_GI,
                so3.log(base.R_GI.swapaxes(1, 2) @ there.R_GI),
            ],
            axis=1,
        )
        predicted = (Phi @ dx).reshape(layout.n, 21)[:, :9]
        np.testing.assert_allclose(error, predicted, atol=5e-10)
