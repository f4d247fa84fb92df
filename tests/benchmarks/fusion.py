"""The filters' arithmetic beside dense numpy: moving a covariance, and one update."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.benchmarks.peers_fusion import dense_covariance, dense_joseph
from tests.benchmarks.rows import BenchRow, interleaved, row
from tracker import GRAVITY
from tracker.fusion import kalman
from tracker.fusion.chain import propagate
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.state import initial_state
from tracker.fusion.time.imu_buffer import Intervals
from tracker.fusion.vist import propagate as vist_propagate
from tracker.fusion.vist.layout import VistLayout
from tracker.fusion.vist.params import VistParams
from tracker.fusion.vist.state import blank_state
from tracker.fusion.vist.state import initial_covariance as vist_covariance
from tracker.glove import library
from tracker.messages import Array, ImuSample

DT = 0.01
MARKERS, CONSTRAINTS, STATES = 15, 25, 147
INNER = 50


@dataclass(frozen=True, eq=False)
class Update:
    """One update: P (N, N), H (m, N), r (m,), R (m, m)."""

    P: Array
    H: Array
    r: Array
    R: Array


def fusion_rows(rounds: int, seed: int = 1, inner: int = INNER) -> list[BenchRow]:
    """Covariance propagation of both engines, and the update."""
    return [
        *_vist_rows(rounds, seed, inner),
        *_chain_rows(rounds, seed, inner),
        *update_rows(rounds, seed, inner),
    ]


def moving_hand(n: int, rng: np.random.Generator) -> ImuSample:
    """Readings of ``n`` IMUs of a hand in motion."""
    gyro = rng.normal(0, 1.0, (n, 3))
    accel = rng.normal(0, 1.0, (n, 3)) + [0.0, 0.0, GRAVITY]
    return ImuSample(0.0, 0.0, np.nan, -1, accel, gyro, np.ones(n, bool))


def _vist_rows(rounds: int, seed: int, inner: int) -> list[BenchRow]:
    """The paper's 147 states: the covariance alone, and all that a packet costs."""
    rng = np.random.default_rng(seed)
    hand, glove = library.load()
    layout, params = VistLayout(hand, glove), VistParams()
    state, sample = blank_state(layout), moving_hand(len(glove.imus), rng)
    state.P = vist_covariance(layout, params.prior)
    j = layout.imu_of
    w, f, valid = sample.gyro[j], sample.accel[j], sample.valid[j]
    F, P, q = (
        vist_propagate.transition(state, sample, layout, DT),
        state.P.copy(),
        np.zeros(len(state.P)),
    )
    whole = blank_state(layout)
    whole.P = state.P.copy()
    us = 1e6 * interleaved(
        [
            lambda: vist_propagate.move_covariance(state.P, state.R_GI, w, f, valid, DT),
            lambda: vist_propagate.propagate(whole, layout, params.noise, sample, DT),
            lambda: dense_covariance(F, P, q),
        ],
        rounds,
        inner,
    )
    name, peer = f"covariance propagation, vist, {layout.size} states", "dense F P Fᵀ + Q, F given"
    return [
        row(name, us[0], "µs", peer, us[2], "0.15"),
        row("the same with nominal state and noise", us[1], "µs", peer, us[2], "-"),
    ]


def _chain_rows(rounds: int, seed: int, inner: int) -> list[BenchRow]:
    """All that a packet costs the chain, beside the dense product at the chain's own size."""
    rng = np.random.default_rng(seed)
    hand, glove = library.load()
    layout, params = ChainLayout(hand, glove), ChainParams()
    state, sample = initial_state(layout), moving_hand(len(glove.imus), rng)
    state.P = initial_covariance(layout, params.prior)
    way = Intervals.single(sample, 0.0, DT)
    F, P, q = coupled_transition(layout), state.P.copy(), np.zeros(layout.blocks.size)
    us = 1e6 * interleaved(
        [
            lambda: propagate.propagate(state, layout, params, way),
            lambda: dense_covariance(F, P, q),
        ],
        rounds,
        inner,
    )
    name = f"propagation, chain, {layout.blocks.size} states, nominal state and noise included"
    return [row(name, us[0], "µs", "dense F P Fᵀ + Q, F given", us[1], "0.15")]


def coupled_transition(layout: ChainLayout) -> Array:
    """(N, N) filled where the chain's is: dynamic rows against all columns before the scales.

    The entries are drawn, as they do not change what a dense product costs.
    """
    F = np.eye(layout.blocks.size)
    rows, columns = layout.n_dynamic, layout.blocks.scale
    F[:rows, :columns] += np.random.default_rng(0).normal(0, 1e-3, (rows, columns))
    return F


def update_case(rng: np.random.Generator, states: int = STATES) -> Update:
    """Fifteen markers, three rows each, and twenty-five rows of anatomy: sparse like the real ones.

    A marker's rows touch four of seven segments, a constraint's two; P is a well-used one.
    """
    blocks = states // 21
    H = np.zeros((3 * MARKERS + CONSTRAINTS, states))
    for k in range(MARKERS):
        for b in rng.choice(blocks, 4, replace=False):
            H[3 * k : 3 * k + 3, 21 * b : 21 * b + 21] = rng.normal(0, 0.3, (3, 21))
    for k in range(3 * MARKERS, len(H)):
        for b in rng.choice(blocks, 2, replace=False):
            H[k, 21 * b : 21 * b + 9] = rng.normal(0, 0.5, 9)
    A = rng.normal(size=(states, states))
    P = 1e-4 * (A @ A.T / states + 0.1 * np.eye(states))
    variance = rng.uniform(1e-6, 1e-5, len(H))
    return Update(P, H, rng.normal(0, 3e-3, len(H)), np.diag(variance))


def update_rows(rounds: int, seed: int, inner: int = INNER) -> list[BenchRow]:
    """`kalman.update` beside Joseph's form, and how far apart the two results are."""
    u = update_case(np.random.default_rng(seed))
    us = 1e6 * interleaved(
        [
            lambda: kalman.update(u.P, u.H, u.r, u.R),
            lambda: dense_joseph(u.P, u.H, u.r, u.R),
        ],
        rounds,
        inner,
    )
    name = f"update, {MARKERS} markers and {CONSTRAINTS} constraint rows, {STATES} states"
    return [
        row(name, us[0], "µs", "dense Joseph form, numpy", us[1], "0.40"),
        row("update, difference from Joseph", difference(u), "of the largest", "-", None, "1e-10"),
    ]


def difference(u: Update) -> float:
    """Largest difference of dx and of P from Joseph's, each relative to its largest entry."""
    dx, P = kalman.update(u.P, u.H, u.r, u.R)
    dx_j, P_j = dense_joseph(u.P, u.H, u.r, u.R)
    return float(
        max(np.abs(dx - dx_j).max() / np.abs(dx_j).max(), np.abs(P - P_j).max() / np.abs(P_j).max())
    )
