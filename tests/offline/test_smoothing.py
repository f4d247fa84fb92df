"""Fixed-interval smoothing: its equations, and its benefit for a simulated wearer."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.notices import shows
from tracker.cli import main
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.messages import Array, BlobFrame, Estimate, ImuSample, IntArray
from tracker.offline import smooth
from tracker.offline.simulate import SimulateOptions, build
from tracker.offline.smooth import Forgotten, Smoother, SmootherStep, Update
from tracker.session.description import SessionInfo
from tracker.session.reader import SessionReader
from tracker.simulation.scenario import Simulation

Messages = list[ImuSample | BlobFrame]


def test_smoothing_equals_the_least_squares_solution() -> None:
    """A random linear system: three steps and four measurements, solved jointly and by λ."""
    rng = np.random.default_rng(3)
    n, D, m = 5, 3, 2
    P0 = np.diag(rng.uniform(0.5, 2, n))
    A = np.eye(n)  # the first D rows are dynamic
    A[:D] += rng.normal(0, 0.3, (D, n))
    Q = np.diag(rng.uniform(0.1, 0.3, n))
    R = 0.2 * np.eye(m)
    measured = [(rng.normal(size=(m, n)), rng.normal(size=m)) for _ in range(4)]

    # 1. Jointly: x = (x0, w1, w2, w3), z_k = H_k x_k + noise.
    to_x = [np.hstack([np.eye(n), np.zeros((n, 3 * n))])]
    for k in range(3):
        noise = np.zeros((n, 4 * n))
        noise[:, (k + 1) * n : (k + 2) * n] = np.eye(n)
        to_x.append(A @ to_x[-1] + noise)
    prior = np.kron(np.diag([0, 1, 1, 1]), Q)
    prior[:n, :n] = P0
    H_all = np.vstack([H @ T for (H, _), T in zip(measured, to_x, strict=True)])
    z_all = np.concatenate([z for _, z in measured])
    S = H_all @ prior @ H_all.T + np.kron(np.eye(4), R)
    every = prior @ H_all.T @ np.linalg.solve(S, z_all)
    wanted = [T @ every for T in to_x]

    # 2. A filter that records a tape, and the backward pass.
    x, P, tape, states = np.zeros(n), P0, [], []
    for k, (H, z) in enumerate(measured):
        if k:
            x, P = A @ x, A @ P @ A.T + Q
            tape.append(SmootherStep(A[:D]))
        tape.append(Update(H, H @ P, H @ P @ H.T + R, z - H @ x))
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
        x, P = x + K @ (z - H @ x), P - K @ H @ P
        states.append((x, P))
    adjoint = np.zeros(n)
    for k in reversed(range(4)):
        x, P = states[k]
        assert np.allclose(x + P @ adjoint, wanted[k], atol=1e-12)
        adjoint = tape.pop().back(adjoint)
        if tape:
            adjoint = tape.pop().back(adjoint)


def test_reset_states_are_independent_of_the_past() -> None:
    assert np.array_equal(Forgotten(2).back(np.arange(1.0, 5)), [0, 0, 3, 4])


@pytest.fixture(scope="module")
def simulated() -> tuple[Simulation, SessionInfo, Messages]:
    sim, info = build(SimulateOptions(seed=2, duration=8.0, fps=30, images=False))
    return sim, info, [m for m in sim.feed() if isinstance(m, ImuSample | BlobFrame)]


def smoothed(info: SessionInfo, messages: Messages) -> list[Estimate]:
    smoother = Smoother(info, Settings())
    for m in messages:
        smoother.feed(m)
    found = list(smoother.results(lambda share: None))
    assert [m.t_arrival for m, _ in found] == [m.t_arrival for m in messages]
    assert all((e is not None) == isinstance(m, ImuSample) for m, e in found)
    return [e for _, e in found if e is not None]


@pytest.mark.long
def test_the_block_size_has_no_effect(
    simulated: tuple[Simulation, SessionInfo, Messages], monkeypatch: pytest.MonkeyPatch
) -> None:
    _, info, messages = simulated
    short = [m for m in messages if m.t_arrival < 1.8]
    whole = smoothed(info, short)
    monkeypatch.setattr(smooth, "BLOCK_S", 0.4)
    pieces = smoothed(info, short)
    assert [e.t for e in whole] == [e.t for e in pieces]
    for a, b in zip(whole, pieces, strict=True):
        assert np.array_equal(a.keypoints, b.keypoints, equal_nan=True)


def live(info: SessionInfo, messages: Messages) -> list[Estimate]:
    assert info.rig is not None
    pipeline, out = Pipeline(info.hand, info.glove, info.rig), []
    for m in messages:
        if isinstance(m, ImuSample):
            out.append(pipeline.feed_imu(m))
        else:
            pipeline.feed_frame(m)
    return out


@pytest.mark.long
def test_it_is_more_accurate_than_live_and_continuous(
    simulated: tuple[Simulation, SessionInfo, Messages],
) -> None:
    sim, info, messages = simulated
    blind = (5.0, 5.8)  # s without images
    messages = [m for m in messages if isinstance(m, ImuSample) or not blind[0] < m.t < blind[1]]
    before, after = live(info, messages), smoothed(info, messages)
    t = np.array([e.t for e in before])
    truth = np.array([x.keypoints for x in sim.truths(t)])
    seen = [
        info.keypoint_names.index(k) for k in ("dorsum", "index_pip", "middle_pip", "index_dip")
    ]

    def error(found: list[Estimate], rows: slice | IntArray = slice(None)) -> float:
        off = np.array([e.keypoints for e in found])[:, seen] - truth[:, seen]
        return float(np.nanmean(np.linalg.norm(off, axis=2)[rows]))

    def steps(found: list[Estimate]) -> float:
        angles: Array = np.array([e.angles for e in found])
        return float(np.nanpercentile(np.abs(np.diff(angles, axis=0, n=2)), 99.9))

    assert error(after) < 0.95 * error(before)
    rows = np.flatnonzero((t > blind[0]) & (t < blind[1]))
    assert error(after, rows) < 0.7 * error(before, rows)
    assert steps(after) < 0.5 * steps(before)


@pytest.mark.long
def test_only_chain_can_be_smoothed(
    tmp_path: Path, record_short: Callable[[Path], Path], capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = record_short(tmp_path / "in.mcap"), tmp_path / "out.mcap"
    assert main(["track", str(source), "-o", str(out), "--smooth", "--engine", "vist"]) == 1
    assert shows(capsys.readouterr().err, "track.smooth_engine", engine="vist")
    assert not out.exists()
    assert main(["track", str(source), "-o", str(out), "--smooth", "--with-sensors"]) == 0
    with SessionReader(source) as first, SessionReader(out) as second:
        assert second.metadata["smoothed"] == "true"
        packets = [m.t for m in first.messages((ImuSample,))]  # type: ignore[union-attr]
        assert [m.t for m in second.messages((ImuSample,))] == packets  # type: ignore[union-attr]
        assert [e.t for e in second.messages((Estimate,))] == packets  # type: ignore[union-attr]


@pytest.fixture
def record_short() -> Callable[[Path], Path]:
    from tracker.offline.simulate import simulate

    def write(path: Path) -> Path:
        simulate(path, replace(SimulateOptions(), seed=4, duration=1.0, fps=30, images=False))
        return path

    return write
