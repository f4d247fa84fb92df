"""Markers seen row by row, against points that really move while the rows are exposed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.filter import MovedStates
from tracker.fusion.chain.kinematics import marker_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams, NoiseParams
from tracker.fusion.chain.pixels import PixelModel
from tracker.fusion.chain.row_exposure import RowExposure
from tracker.fusion.chain.state import ChainState, initial_state, inject
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, CameraPose, ImuSample
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import StereoRig, ideal_rig, with_readout

READOUT = 0.018  # s
V = np.array([0.9, -1.2, 0.4])  # m/s of the hand
W = np.array([1.5, -2.0, 3.0])  # rad/s of the root, in its B
V_CAMERA, W_CAMERA = np.array([0.1, 0.2, -0.1]), np.array([0.5, -1.0, 3.3])  # in G


def rig_of(lens: str) -> StereoRig:
    """With an ideal lens, or one that bends lines by some thirty pixels."""
    rig = with_readout(ideal_rig(), READOUT)
    if lens == "ideal":
        return rig
    D = np.array([-0.17, 0.03, 1e-3, -5e-4, 0.0])
    return replace(rig, left=replace(rig.left, D=D), right=replace(rig.right, D=D))


@pytest.fixture(scope="module")
def layout(hand: HandModel, glove: GloveModel) -> ChainLayout:
    return ChainLayout(hand, glove)


def still(layout: ChainLayout) -> ChainState:
    """A bent hand off the image's middle, moving with `V`."""
    rng, rig = np.random.default_rng(4), ideal_rig()
    state = initial_state(layout)
    state.p = rig.pose.p_GC + rig.pose.R_GC @ np.array([-0.1, 0.08, 0.35])
    inject(state, layout, 0.03 * rng.normal(size=layout.blocks.size))
    state.v = V.copy()
    root = 1e-3 * rng.normal(size=(layout.blocks.size, layout.blocks.size))
    state.P = root @ root.T
    return state


def stiff(layout: ChainLayout, state: ChainState) -> RowExposure:
    """All segments turn as the root does; each IMU reads that in its own axes."""
    w_G = state.R_GB[0] @ W
    gyro = np.empty((len(layout.imu_segment), 3))
    for j, segment in enumerate(layout.imu_segment):
        gyro[j] = state.R_IB[j] @ state.R_GB[segment].T @ w_G + state.bg[j]
    return RowExposure(gyro, np.ones(len(gyro), np.bool_), V_CAMERA, W_CAMERA)


def seen_at(state: ChainState, layout: ChainLayout, rig: StereoRig, delay: float) -> Array:
    """(2, M, 2) rectified px of the hand ``delay`` s later, moved without any first order."""
    turn = so3.exp(state.R_GB[0] @ W * delay)
    p_G = (marker_positions(state, layout) - state.p) @ turn.T + state.p + V * delay
    pose = CameraPose(so3.exp(W_CAMERA * delay) @ rig.pose.R_GC, rig.pose.p_GC + V_CAMERA * delay)
    p_C = (p_G - pose.p_GC) @ pose.R_GC
    return np.stack([rig.project(p_C), rig.project(p_C, right=True)])


def sheared(state: ChainState, layout: ChainLayout, rig: StereoRig) -> tuple[Array, Array]:
    """Where each marker is (2, M, 2) when the row that it is then on is exposed, and when (2, M) s:
    found among instants 20 µs apart, by the raw row alone."""
    instants = np.arange(-0.011, 0.011, 2e-5)
    uv = np.stack([seen_at(state, layout, rig, d) for d in instants])
    out, when = np.empty(uv.shape[1:]), np.empty(uv.shape[1:3])
    for c, camera in enumerate((rig.left, rig.right)):
        for m in range(uv.shape[2]):
            row = camera.unrectify(uv[:, c, m])[:, 1]
            own = READOUT * (row / (camera.height - 1) - 0.5)
            k = int(np.argmin(np.abs(instants - own)))
            out[c, m], when[c, m] = uv[k, c, m], instants[k]
    return out, when


@pytest.mark.parametrize("lens", ["ideal", "bent"])
def test_markers_are_predicted_when_their_own_rows_are_exposed(
    layout: ChainLayout, lens: str
) -> None:
    rig, state = rig_of(lens), still(layout)
    model, rows = PixelModel(layout, rig, NoiseParams()), stiff(layout, state)
    true, _ = sheared(state, layout, rig)
    at_once = model.predict(state, rig.pose)
    e = model.predict(state, rig.pose, exposure=rows)
    shown = np.isfinite(true).all(axis=2) & (true[..., 1] > 20) & (true[..., 1] < 700)
    shown &= (true[..., 0] > 20) & (true[..., 0] < 1260)
    assert shown.sum() > 40
    off = np.linalg.norm(e.uv - true, axis=2)[shown]
    assert np.linalg.norm(at_once.uv - true, axis=2)[shown].max() > 10.0
    # what is left is of second order, (w² r / 2 + w v) d² = 0.6 mm at 9 ms, and the grid's 20 µs
    assert off.max() < 1.2 and np.median(off) < 0.2


def test_rows_depend_on_the_velocity_as_the_pixels_do(layout: ChainLayout) -> None:
    """H against difference quotients; H P and S against the plain products."""
    rig, state = rig_of("ideal"), still(layout)
    noise, rows = NoiseParams(), stiff(layout, state)
    model = PixelModel(layout, rig, noise)
    e = model.predict(state, rig.pose, exposure=rows)
    _, when = sheared(state, layout, rig)
    delay = when[:, e.rows].mean(axis=0)
    assert np.abs(delay).max() > 0.004
    # a row is 25 µs, and the second order that predictions lack less than two rows
    assert np.abs(e.H[:, :, 3:6] - delay[:, None, None] * np.eye(3)).max() < 6e-5
    step = 1e-4
    for axis in range(3):
        faster = state.copy()
        faster.v[axis] += step
        moved = model.predict(faster, rig.pose, exposure=rows).uv[:, e.rows]
        by_v = (moved - e.uv[:, e.rows]) / step
        by_H = np.einsum("ckij,kj->cki", e.A[:, e.rows], e.H[:, :, 3 + axis])
        # the marker's own delay changes with the velocity, by a tenth
        assert np.abs(by_v - by_H).max() < 0.2 * np.abs(by_H).max()
    HP = np.einsum("kij,jl->kil", e.H, state.P)
    assert np.abs(e.HP - HP).max() < 1e-12 * np.abs(HP).max()
    cov = HP @ e.H.swapaxes(1, 2) + np.eye(3) * noise.marker**2
    assert np.abs(e.cov - cov).max() < 1e-12 * np.abs(cov).max()
    A = e.A[:, e.rows]
    S = A @ cov @ A.swapaxes(-1, -2) + np.eye(2) * noise.pixel_px**2
    assert np.abs(e.S - S).max() < 1e-12 * np.abs(S).max()


def test_blobs_moved_back_are_those_of_a_global_shutter(layout: ChainLayout) -> None:
    rig, state = rig_of("bent"), still(layout)
    model, rows = PixelModel(layout, rig, NoiseParams()), stiff(layout, state)
    shift = model.row_shift(state, rig.pose, rows)
    assert shift is not None
    moved = model.predict(state, rig.pose, exposure=rows).uv
    assert np.allclose(moved - shift, model.predict(state, rig.pose).uv, atol=1e-9, equal_nan=True)
    assert model.row_shift(state, rig.pose, None) is None


def test_a_turning_camera_is_turned_back_without_knowing_how_far_points_are() -> None:
    rig = rig_of("ideal")
    rows = RowExposure(np.zeros((1, 3)), np.zeros(1, np.bool_), np.zeros(3), W_CAMERA)
    rng = np.random.default_rng(1)
    depth = rng.uniform(0.2, 5.0, 50)
    uv = np.column_stack([rng.uniform(100, 1180, 50), rng.uniform(60, 660, 50)])
    p_G = rig.triangulate(uv, uv - [[rig.fx * rig.baseline / 1.0, 0]]) * depth[:, None]
    p_G = p_G @ rig.pose.R_GC.T
    seen = np.empty_like(uv)
    for k, p in enumerate(p_G):
        delay = 0.0
        for _ in range(20):  # until the point is on the row that is exposed then
            R_GC = so3.exp(W_CAMERA * delay) @ rig.pose.R_GC
            seen[k] = rig.project(p @ R_GC)
            delay = READOUT * (seen[k, 1] / 719 - 0.5)
    back = rows.turned_back(seen, False, rig, rig.pose)
    assert np.linalg.norm(seen - uv, axis=1).max() > 10
    assert np.linalg.norm(back - uv, axis=1).max() < 0.6


def test_delays_count_from_the_middle_row_of_the_image_as_recorded() -> None:
    rig = rig_of("bent")
    raw = np.array([[[100.0, 0.0], [640.0, 359.5], [1200.0, 719.0]]] * 2)
    uv = np.stack([camera.rectify(r) for camera, r in zip((rig.left, rig.right), raw, strict=True)])
    # OpenCV inverts a lens at this edge to a fifth of a row
    assert np.allclose(rig.row_delays(uv), [[-0.009, 0.0, 0.009]] * 2, atol=5e-6)
    assert not ideal_rig().row_delays(uv).any()
    lost = rig.row_delays(np.full((2, 1, 2), np.nan))
    assert not lost.any()


@pytest.mark.long
def test_a_hand_found_twice_keeps_a_proper_covariance(
    hand: HandModel, glove: GloveModel, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two searches in succession determine the hand's velocity, on which the rows depend: the
    update has to use the covariance of the state with this velocity."""
    found: list[Array] = []
    moving = MovedStates.moving

    def noted(self: MovedStates, moved: ChainState, v: Array) -> None:
        found.append(v)
        moving(self, moved, v)

    monkeypatch.setattr(MovedStates, "moving", noted)
    postures = RandomPostures(hand, 3, duration=2.6)
    sim = Simulation(hand, glove, postures, 3, fps=30, rig=with_readout(ideal_rig(), READOUT))
    engine = ChainEngine(hand, glove, sim.rig, ChainParams())
    for message in sim.feed():
        if isinstance(message, ImuSample):
            engine.feed_imu(message)
            continue
        if message.t > 1.2 and not found:
            turn = 9 * message.t  # moved away before each image until it is found twice
            engine._tracker.state.p += 0.3 * np.array([np.cos(turn), np.sin(turn), 0.0])
        engine.feed_frame(message)
        assert np.linalg.eigvalsh(engine._tracker.state.P)[0] > 0
    assert found
