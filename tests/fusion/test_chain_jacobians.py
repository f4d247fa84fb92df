"""Every Jacobian of the chain filter against central differences with the same boxplus."""

from collections.abc import Callable

import numpy as np
import pytest

from tracker.fusion.chain.constraints import Constraints
from tracker.fusion.chain.kinematics import marker_jacobians, marker_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams, ConstraintParams
from tracker.fusion.chain.propagate import propagate, transition
from tracker.fusion.chain.state import ChainState, initial_state, inject
from tracker.fusion.chain.tilt import tilt_rows
from tracker.fusion.time.imu_buffer import Around, Intervals, Moment
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, ImuSample


@pytest.fixture(scope="module")
def layout(hand: HandModel, distal_glove: GloveModel) -> ChainLayout:
    return ChainLayout(hand, distal_glove)


def random_state(layout: ChainLayout, size: float = 0.2) -> ChainState:
    rng = np.random.default_rng(5)
    state = initial_state(layout)
    dx = size * rng.normal(size=layout.blocks.size)
    dx[layout.blocks.scale : layout.blocks.joint] *= 0.2
    dx[layout.blocks.joint :] *= 0.02
    inject(state, layout, dx)
    return state


def numeric(
    f: Callable[[ChainState], Array], state: ChainState, layout: ChainLayout, eps: float = 1e-6
) -> Array:
    columns = []
    for i in range(layout.blocks.size):
        dx = np.zeros(layout.blocks.size)
        dx[i] = eps
        plus, minus = state.copy(), state.copy()
        inject(plus, layout, dx)
        inject(minus, layout, -dx)
        columns.append((f(plus) - f(minus)) / (2 * eps))
    return np.moveaxis(np.array(columns), 0, -1)


def packets(n: int, rate: float) -> tuple[ImuSample, ImuSample, ImuSample]:
    """Three packets; ``rate`` rad/s is the rotation of the hand."""
    rng = np.random.default_rng(6)
    out = []
    for k in range(3):
        accel = rng.normal(size=(n, 3)) + [0, 0, 9.8]
        gyro = rate * (1 + 0.05 * k) * np.ones((n, 3))
        out.append(ImuSample(0.01 * k, 0.01 * k, 0.0, k, accel, gyro, np.ones(n, bool)))
    return out[0], out[1], out[2]


def test_markers(layout: ChainLayout) -> None:
    state = random_state(layout)
    J = marker_jacobians(state, layout, np.arange(len(layout.glove.markers)))
    expected = numeric(lambda s: marker_positions(s, layout), state, layout)
    assert np.allclose(J, expected, atol=1e-8)


def test_transition(layout: ChainLayout) -> None:
    """Phi to first order in dt: the error of a step of 1 ms is of the order dt²."""
    state, dt = random_state(layout), 1e-3
    _, sample, _ = packets(len(layout.glove.imus), 1.0)
    Phi = transition(state, layout, Moment.of(sample), dt)
    way = Intervals.single(sample, 0.0, dt)

    def moved(s: ChainState) -> ChainState:
        s = s.copy()
        propagate(s, layout, ChainParams(), way)
        return s

    base = moved(state)

    def error(s: ChainState) -> Array:
        s = moved(s)
        turn = so3.log(base.R_GB.swapaxes(1, 2) @ s.R_GB).ravel()
        return np.concatenate([s.p - base.p, s.v - base.v, turn])

    expected = numeric(error, state, layout)[:, : layout.blocks.scale]
    driven = (
        layout.blocks.theta + 3 * np.flatnonzero(layout.drive.source >= 0)[:, None] + np.arange(3)
    )
    sensed = np.setdiff1d(np.arange(len(Phi)), driven)
    assert np.allclose(Phi[sensed], expected[sensed], atol=3e-5)
    # the change of a synergy's flexion with orientation is neglected: of the order rate times dt
    assert np.allclose(Phi[driven], expected[driven], atol=4e-3)


def test_anatomy_near_a_natural_posture(layout: ChainLayout) -> None:
    """Axis rows are exact; flexion rows are valid for small twist, as enforced by the
    constraints."""
    state = random_state(layout, 0.02)
    constraints = Constraints(layout, ConstraintParams())
    H, _, _ = constraints.rows(state)
    expected = -numeric(lambda s: constraints.rows(s)[1], state, layout)
    n = len(constraints.axes)
    assert np.allclose(H[:n], expected[:n], atol=1e-7)
    assert np.allclose(H[n:], expected[n:], atol=0.1)


def test_relative_tilt(layout: ChainLayout) -> None:
    """Orientation and bias columns are exact; scale, offsets, gyro bias and the kinematic part of
    the mounting are neglected, so the hand is nearly still where the mounting is compared."""
    state = random_state(layout)
    state.bg[:] = 0
    for rate, columns in (
        (0.5, (layout.blocks.theta, layout.n_dynamic)),
        (1e-4, (layout.blocks.phi, layout.blocks.scale)),
    ):
        three = Around(*map(Moment.of, packets(len(layout.glove.imus), rate)))
        rows = tilt_rows(state, layout, ConstraintParams(), three)
        assert rows is not None
        expected = -numeric(
            lambda s, three=three: tilt_rows(s, layout, ConstraintParams(), three)[1],  # type: ignore[index,misc]
            state,
            layout,
        )
        part = slice(*columns)
        assert np.allclose(rows[0][:, part], expected[:, part], atol=5e-4)


def test_tilt_needs_the_dorsum(layout: ChainLayout) -> None:
    before, sample, after = packets(len(layout.glove.imus), 0.1)
    valid = np.ones(len(layout.glove.imus), bool)
    valid[layout.imu_of[0]] = False
    deaf = ImuSample(sample.t, sample.t, 0.0, 1, sample.accel.copy(), sample.gyro.copy(), valid)
    around = Around(*map(Moment.of, (before, deaf, after)))
    assert tilt_rows(initial_state(layout), layout, ConstraintParams(), around) is None
