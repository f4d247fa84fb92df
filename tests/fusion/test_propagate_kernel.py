"""The compiled propagation of the chain against its formulas."""

import numpy as np
import pytest

from tracker import GRAVITY
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.propagate import (
    Coasting,
    SensedMotion,
    carry,
    move_nominal,
    propagate,
    transition,
)
from tracker.fusion.chain.state import ChainState, Dynamic, initial_state, inject
from tracker.fusion.engine import COAST_DAMPING
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals, Moment
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, ImuSample


@pytest.fixture(scope="module")
def layout(hand: HandModel, glove: GloveModel) -> ChainLayout:
    return ChainLayout(hand, glove)


def a_state(layout: ChainLayout) -> ChainState:
    state = initial_state(layout)
    inject(state, layout, 0.1 * np.random.default_rng(1).normal(size=layout.blocks.size))
    state.P = initial_covariance(layout, ChainParams().prior)
    return state


def packet(layout: ChainLayout, t: float, seed: int, silent: tuple[int, ...] = ()) -> ImuSample:
    rng, n = np.random.default_rng(seed), len(layout.glove.imus)
    valid = ~np.isin(np.arange(n), silent)
    accel = rng.normal(size=(n, 3)) + [0, 0, 9.8]
    return ImuSample(t, t, t, seed, accel, rng.normal(size=(n, 3)), valid)


def turn_noise(layout: ChainLayout, R_GB: Array, valid: Array, sd: tuple[float, ...]) -> Array:
    """L L^T with L as in the rule: own noise, and the parent's for a segment without an IMU."""
    n = len(layout.active)
    L = np.zeros((3 * n, 3 * n))
    for i in range(n):
        rows, a, j = slice(3 * i, 3 * i + 3), layout.parent[i], layout.imu_of[i]
        felt = j >= 0 and valid[j]
        L[rows, rows] = np.eye(3) * (sd[0] if felt else sd[1] if a >= 0 else sd[2])
        if not felt and a >= 0:
            L[rows] += R_GB[i].T @ R_GB[a] @ L[3 * a : 3 * a + 3]
    return L @ L.T


@pytest.mark.parametrize("silent", [(), (3,), (1, 2), (0,), tuple(range(7))])
def test_covariance_moves_as_the_dense_product(
    layout: ChainLayout, silent: tuple[int, ...]
) -> None:
    """Phi P Phi^T + Q, with any IMU invalid; marker variances above and below the slip limit."""
    rng, dt, n = np.random.default_rng(2), 0.01, layout.blocks.size
    state, sample = a_state(layout), packet(layout, 0.0, 3, silent)
    A = rng.normal(size=(n, n))
    markers = np.arange(layout.blocks.marker, layout.blocks.axis)
    A[markers] *= (
        ChainParams().noise.slip_most / np.sqrt(n) * rng.uniform(0.5, 1.5, (len(markers), 1))
    )
    state.P = A @ A.T
    F, R_GB, P = np.eye(n), state.R_GB, state.P.copy()
    F[: layout.n_dynamic, : layout.blocks.scale] = transition(state, layout, Moment.of(sample), dt)
    expected = F @ P @ F.T
    noise = ChainParams().noise
    expected[np.diag_indices(n)] += kernel_noise(layout, accel_noise(state, sample), dt)
    room = np.maximum(1 - P[markers, markers] / noise.slip_most**2, 0.0)
    assert 0 < np.mean(room == 0) < 1
    expected[markers, markers] += noise.slip**2 * dt * room
    block = slice(layout.blocks.theta, layout.n_dynamic)
    sd = noise.gyro, noise.free_rotation, noise.free_root_rotation
    expected[block, block] += turn_noise(layout, R_GB, sample.valid, sd) * dt
    propagate(state, layout, ChainParams(), Intervals.single(sample, 0.0, dt))
    assert np.abs(state.P - expected).max() < 1e-12 * np.abs(expected).max()
    np.testing.assert_allclose(state.P[markers, markers], expected[markers, markers], rtol=1e-12)
    assert np.array_equal(state.P, state.P.T)


def accel_noise(state: ChainState, sample: ImuSample) -> float:
    """m/s²·√s: grows with the acceleration of the hand, which the root's IMU measures."""
    noise = ChainParams().noise
    if not sample.valid[0]:
        return noise.free_accel
    a_G = state.R_GB[0] @ state.R_IB[0].T @ (sample.accel[0] - state.ba[0]) - [0, 0, GRAVITY]
    return float(np.hypot(noise.accel, noise.accel_gain * np.linalg.norm(a_G)))


def kernel_noise(layout: ChainLayout, accel: float, dt: float) -> Array:
    """(N,) variances as in the parameters, block by block; those of markers are 0 here."""
    noise, imus = ChainParams().noise, 3 * len(layout.glove.imus)
    blocks = [
        (3, accel**2 * dt**3 / 3),
        (3, accel**2 * dt),
        (3 * len(layout.active), 0.0),
        (imus, noise.gyro_bias**2 * dt),
        (imus, noise.mounting**2 * dt),
        (imus, noise.accel_bias**2 * dt),
        (2 * len(layout.active), noise.scale**2 * dt),
        (layout.blocks.marker - layout.blocks.joint, noise.offset**2 * dt),
        (layout.blocks.size - layout.blocks.marker, 0.0),
    ]
    return np.concatenate([np.full(count, value) for count, value in blocks])


def test_carrying_is_propagation_without_covariance(layout: ChainLayout) -> None:
    """Through eight packets, an interruption and a part of an interval."""
    buffer = ImuBuffer(len(layout.glove.imus), span=10.0)
    for k, t in enumerate([1.0, 1.01, 1.02, 1.03, 1.5, 1.51, 1.52, 1.53]):
        buffer.add(packet(layout, t, k, (k % 7,)))
    one, other = a_state(layout), a_state(layout)
    one.t = other.t = 1.004
    carry(one, layout, buffer, 1.525)
    propagate(other, layout, ChainParams(), buffer.intervals(1.004, 1.525))
    for name in ("p", "v", "R_GB"):
        assert np.allclose(getattr(one, name), getattr(other, name), atol=1e-12), name
    assert one.t == other.t == 1.525


def test_propagation_in_parts_equals_propagation_at_once(layout: ChainLayout) -> None:
    """Including covariance, bit for bit, and damped once no image has arrived for too long."""
    buffer = ImuBuffer(len(layout.glove.imus), span=10.0)
    for k in range(7):
        buffer.add(packet(layout, 1.0 + 0.01 * k, k, (k % 3,)))
    way = buffer.intervals(1.004, 1.055)
    whole, parts, free = a_state(layout), a_state(layout), a_state(layout)
    propagate(whole, layout, ChainParams(), way, Coasting(1.0, 0.025))
    for part in ((0, 2), (2, 3), (3, 6)):
        propagate(parts, layout, ChainParams(), way.part(*part), Coasting(1.0, 0.025))
    for name in ("p", "v", "R_GB", "P"):
        assert np.array_equal(getattr(whole, name), getattr(parts, name)), name
    propagate(free, layout, ChainParams(), way)
    gone = way.stop[-1] - way.start[3]  # the first three intervals start before 1.025
    assert parts.t == whole.t == 1.055
    assert np.abs(whole.v - free.v).max() > 0.5 * gone * np.abs(free.v).max()


def test_intervals_are_cut_at_packets_with_interpolated_means(layout: ChainLayout) -> None:
    buffer = ImuBuffer(len(layout.glove.imus), span=10.0)
    times = [0.0, 0.01, 0.02, 0.4]
    for k, t in enumerate(times):
        buffer.add(packet(layout, t, k))
    way = buffer.intervals(0.004, 0.5)
    assert np.allclose(way.start, [0.004, 0.01, 0.02, 0.4])
    assert np.allclose(way.stop, [0.01, 0.02, 0.4, 0.5])
    for k, (start, stop) in enumerate([(0.004, 0.01), (0.01, 0.02)]):
        middle = buffer.at((start + stop) / 2)
        assert middle is not None
        assert np.allclose(way.gyro[k], middle.gyro) and np.allclose(way.accel[k], middle.accel)
    assert not way.valid[2:].any()  # a gap too long to interpolate, and beyond the newest packet
    assert len(buffer.intervals(0.2, 0.2).stop) == 0


def test_a_full_table_moves_to_its_front(layout: ChainLayout) -> None:
    """Packets within the span are not lost when the buffer is full."""
    buffer = ImuBuffer(len(layout.glove.imus), span=0.05)
    for k in range(1500):
        buffer.add(packet(layout, 0.01 * k, k))
    way = buffer.intervals(0.01 * 1495, 0.01 * 1499)
    expected = [buffer.at(t) for t in (14.955, 14.965, 14.975, 14.985)]
    assert np.allclose(way.gyro, [e.gyro for e in expected if e is not None])


def test_a_root_without_imu_slows_down(layout: ChainLayout) -> None:
    """Its velocity decays; it does not fall."""
    v = np.array([1.0, 0.0, 0.0])
    hand, nothing = Dynamic(np.zeros(3), v, np.eye(3)[None]), np.zeros((1, 3))
    _, slower, _ = move_nominal(hand, SensedMotion(nothing, np.zeros(3), False), 0.5, False)
    assert np.allclose(slower, [np.exp(-COAST_DAMPING * 0.5), 0, 0])
