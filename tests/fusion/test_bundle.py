"""Calibration over keyframes: against a dense solution, and on a simulated wearer."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.fusion.test_chain_engine import feed, simulation
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.bundle import solver
from tracker.fusion.chain.bundle.keyframes import Keyframe, Keyframes
from tracker.fusion.chain.bundle.solver import Bundle, BundleWork, KeyframeRows, adopt
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.params import BundleParams, ChainParams
from tracker.fusion.chain.profile import profile_of
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array
from tracker.simulation.scenario import Simulation
from tracker.simulation.wearer import Wearer

EARLY = BundleParams(first_after=3.0, least_keyframes=5, apart=0.2, sweeps=3)


def with_bundle(params: BundleParams) -> Settings:
    settings = Settings()
    return replace(settings, chain=replace(settings.chain, bundle=params))


@pytest.fixture(scope="module")
def sim(hand: HandModel, glove: GloveModel) -> Simulation:
    return simulation(hand, glove, 2, 11.0)


@pytest.fixture(scope="module")
def engine(sim: Simulation) -> ChainEngine:
    """A filter with stored postures and no solution yet."""
    waiting = replace(EARLY, first_after=1e6)
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig, with_bundle(waiting))
    feed(pipeline, sim.feed())
    assert isinstance(pipeline.engine, ChainEngine)
    return pipeline.engine


def work_of(engine: ChainEngine) -> BundleWork:
    return engine.get_state().tracker.wearer.work


def stored(engine: ChainEngine) -> list[Keyframe]:
    return work_of(engine).keyframes.stored


def state_of(engine: ChainEngine) -> ChainState:
    return engine.get_state().tracker.filter.state


def marker_error(state: ChainState, wearer: Wearer) -> float:
    """Mean distance (m) of markers from the wearer's true ones, in their segment's frame."""
    true = np.einsum("mki,mk->mi", wearer._tangents, wearer._marker_offset)
    return float(np.linalg.norm(state.marker - true, axis=1).mean())


@pytest.mark.long
def test_one_sweep_is_the_least_squares_solution(engine: ChainEngine, sim: Simulation) -> None:
    """Poses eliminated one by one, against all unknowns in one dense system."""
    lay, params = engine.layout, ChainParams(bundle=replace(EARLY, sweeps=1, least_keyframes=3))
    frames, state = stored(engine)[:3], state_of(engine)
    work = BundleWork(next_at=0.0, pause=1.0, keyframes=Keyframes(list(frames)))
    bundle = Bundle(lay, sim.rig, params)
    found = None
    while found is None:
        found = bundle.step(work, state)

    rows, n = KeyframeRows(lay, sim.rig, params), lay.n_dynamic
    moves = np.r_[0:3, lay.blocks.theta : n]
    d, c = len(moves), lay.blocks.size - n
    A, b = np.zeros((3 * d + c, 3 * d + c)), np.zeros(3 * d + c)
    A[3 * d :, 3 * d :] = bundle._information
    b[3 * d :] = -bundle._information @ solver.off_nominal(state, lay)
    for k, frame in enumerate(frames):
        H, r = rows(replace(state, p=frame.p, R_GB=frame.R_GB), frame)
        J = np.zeros((len(H), len(b)))
        J[:, k * d : (k + 1) * d], J[:, 3 * d :] = H[:, moves], H[:, n:]
        A += J.T @ J
        b += J.T @ r
        own = np.arange(k * d, (k + 1) * d)
        A[own, own] += np.r_[np.full(3, solver.POSITION_SD**-2), np.full(d - 3, 0.15**-2)]
    dense = np.linalg.solve(A, b)[3 * d :]
    scale = dense[lay.blocks.scale - n : lay.blocks.joint - n].reshape(-1, 2)
    assert np.allclose(found.scale, np.clip(state.scale + scale, 0.6, 1.5), atol=1e-9)
    marker = dense[lay.blocks.marker - n : lay.blocks.axis - n].reshape(-1, 3)
    assert np.allclose(found.marker, state.marker + marker, atol=1e-9)


def test_markers_are_placed_better_than_by_the_filter(engine: ChainEngine, sim: Simulation) -> None:
    state = state_of(engine)
    work = BundleWork(next_at=0.0, pause=1.0, keyframes=Keyframes(stored(engine)))
    bundle = Bundle(engine.layout, sim.rig, ChainParams(bundle=EARLY))
    found = None
    while found is None:
        found = bundle.step(work, state)
    better = state.copy()
    adopt(better, engine.layout, found)
    assert marker_error(better, sim.wearer) < 0.95 * marker_error(state, sim.wearer)


def test_imus_keep_their_orientation_when_the_calibration_is_replaced(engine: ChainEngine) -> None:
    state, lay = state_of(engine), engine.layout
    other = state.copy()
    other.R_IB = state.R_IB @ so3.exp(np.full((len(state.R_IB), 3), 0.05))
    adopt(state, lay, profile_of(other, lay))
    before = state_of(engine)

    def R_GI(s: ChainState) -> Array:
        return s.R_GB[lay.imu_segment] @ s.R_IB.swapaxes(1, 2)

    assert np.allclose(R_GI(state), R_GI(before), atol=1e-12)
    assert np.array_equal(state.bg, before.bg)
    assert np.linalg.eigvalsh(state.P).min() > -1e-12


def test_stored_postures_become_more_diverse(engine: ChainEngine) -> None:
    """At the limit, a new posture never reduces the smallest difference."""
    params, store = replace(EARLY, keyframes=5, apart=0.05), Keyframes()
    closest = 0.0
    for frame in stored(engine):
        store.offer(frame, params)
        assert len(store.stored) <= 5
        if len(store.stored) == 5:
            apart = [
                np.linalg.norm(a.relative - b.relative)
                for i, a in enumerate(store.stored)
                for b in store.stored[:i]
            ]
            assert min(apart) >= closest - 1e-12
            closest = min(apart)
    assert len(store.stored) == 5


@pytest.mark.long
def test_a_saved_state_resumes_in_the_middle_of_a_solution(sim: Simulation) -> None:
    messages = list(sim.feed())
    whole = Pipeline(sim.hand, sim.glove, sim.rig, with_bundle(EARLY))
    assert isinstance(whole.engine, ChainEngine)
    coming = iter(messages)
    while work_of(whole.engine).sweep != 2:
        feed(whole, [next(coming)])  # StopIteration: no solution was started
    state, rest = whole.get_state(), list(coming)
    other = Pipeline(sim.hand, sim.glove, sim.rig, with_bundle(EARLY))
    other.set_state(state)
    for a, b in zip(feed(whole, rest), feed(other, rest), strict=True):
        assert np.array_equal(a.keypoints, b.keypoints)
    assert work_of(whole.engine).calibration is None, "the solution was not finished"


def test_postures_of_another_hand_are_discarded(engine: ChainEngine, sim: Simulation) -> None:
    """Blobs of other images with each posture: the solution is discarded together with them."""
    frames = stored(engine)
    mixed = [replace(a, uv=b.uv) for a, b in zip(frames, frames[1:] + frames[:1], strict=True)]
    state, work = state_of(engine), BundleWork(0.0, 0.0, 1.0, Keyframes(mixed))
    bundle = Bundle(engine.layout, sim.rig, ChainParams(bundle=EARLY))
    found = [bundle.step(work, state) for _ in range(1 + EARLY.sweeps * len(mixed))]
    assert found == [None] * len(found)
    assert work.calibration is None
    assert work.keyframes.stored == []
