"""The camera's time offset, from simulated motion with a known one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Blobs, FrameResult, ImuSample, Tracking
from tracker.online.frame_timing import FrameTiming, TimingParams
from tracker.online.time_offset import (
    FLAT,
    Offset,
    TimeOffset,
    _GyroRotation,
    _point,
    _RootView,
    rigid,
)
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

Seen = tuple[BlobFrame, FrameResult]


def simulation(hand: HandModel, glove: GloveModel, seed: int, duration: float) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, seed, duration=duration), seed, fps=30)


def images(sim: Simulation) -> list[Seen]:
    """Markers as blobs with 0.3 px of noise, and their ids."""
    rng, n = np.random.default_rng(1), len(sim.glove.markers)
    out = []
    for index, t, arrival in sim.exposures():
        now, sides, matches = sim.scene.instant(t), [], []
        for right in (False, True):
            seen = sim.scene.markers_seen(now, right)
            uv = seen.uv + rng.normal(0, 0.3, (n, 2))
            sides.append(Blobs(uv, np.full((n, 2), 15.0), sim.glove.marker_hue, np.ones(n)))
            matches.append(np.where(seen.visible, np.arange(n), -1))
        frame = BlobFrame(t, arrival, sim.glove.hues, *sides, index=index)
        nothing = FrameResult.nothing(t, Tracking.TRACKING, n)
        out.append((frame, replace(nothing, match_left=matches[0], match_right=matches[1])))
    return out


@pytest.fixture(scope="module")
def recording(hand: HandModel, glove: GloveModel) -> tuple[Simulation, list[ImuSample], list[Seen]]:
    sim = simulation(hand, glove, 3, 20.0)
    return sim, list(sim.imu_samples()), images(sim)


def measured(recording, late: float, keep: int | None = None) -> TimeOffset:
    """Feeds all in order; after ``keep`` messages continues in another object."""
    sim, packets, seen = recording
    offset = TimeOffset(sim.hand, sim.glove, sim.rig)
    messages = sorted([*packets, *seen], key=lambda m: m[0].t if isinstance(m, tuple) else m.t)
    for k, message in enumerate(messages):
        if k == keep:
            state = offset.get_state()
            offset = TimeOffset(sim.hand, sim.glove, sim.rig)
            offset.set_state(state)
        if isinstance(message, tuple):
            frame, result = message
            offset.feed_image(replace(frame, t=frame.t + late), result)
        else:
            offset.feed_imu(message)
    return offset


@pytest.mark.parametrize("late", [-0.020, -0.005, 0.0, 0.020])
def test_known_offsets_are_found_to_3_ms(recording, late: float) -> None:
    found = measured(recording, late).estimate
    assert found.value == pytest.approx(late, abs=0.003)
    assert abs(found.value - late) < 3 * found.sd < 0.008


@pytest.mark.parametrize("late", [-0.015, 0.030])
@pytest.mark.parametrize("blind", ["left", "right"])
def test_one_camera_measures_it_too(recording, late: float, blind: str) -> None:
    sim, packets, seen = recording
    alone = [(replace(frame, **{blind: None}), result) for frame, result in seen]
    found = measured((sim, packets, alone), late).estimate
    assert found.value == pytest.approx(late, abs=0.007)
    assert abs(found.value - late) < 3 * found.sd < 0.015


def test_a_saved_state_resumes_identically(recording) -> None:
    whole, parts = measured(recording, 0.01), measured(recording, 0.01, keep=1111)
    assert whole.estimate == parts.estimate


def test_a_still_hand_gives_no_result(recording) -> None:
    sim, packets, seen = recording
    offset = TimeOffset(sim.hand, sim.glove, sim.rig)
    assert offset.estimate.sd == np.inf
    rng = np.random.default_rng(2)
    frame, result = seen[0]
    for k in range(1000):
        still = replace(packets[k], gyro=rng.normal(0, 0.002, packets[k].gyro.shape))
        offset.feed_imu(still)
        if k % 3 == 0:
            t = still.t + 0.001
            uv = frame.left.uv + rng.normal(0, 0.3, frame.left.uv.shape)
            noisy = replace(frame, t=t, left=replace(frame.left, uv=uv))
            offset.feed_image(noisy, result)
    assert not offset.estimate.sd < 0.02


class Known(TimeOffset):
    """An offset set by the test."""

    value = Offset()

    @property
    def estimate(self) -> Offset:
        return self.value


def test_significant_offsets_are_compensated_step_by_step(recording) -> None:
    sim, _, seen = recording
    offset = Known(sim.hand, sim.glove, sim.rig)
    timing = FrameTiming(offset, TimingParams())
    frame, result = seen[0]
    for value in (
        Offset(),
        Offset(0.004, 0.001),
        Offset(0.007, 0.0025),
        Offset(0.02, 0.005),
    ):
        offset.value = value
        assert timing.corrected(frame) is frame
    offset.value = Offset(0.02, 0.001)
    for k in range(1, 30):
        given = replace(frame, t=frame.t + k / 30)
        sent = timing.corrected(given)
        assert given.t - sent.t == pytest.approx(min(0.001 * k, 0.02))
        assert timing.restored(replace(result, t=sent.t)).t == given.t
    offset.value = Offset(0.001, 0.001)
    for _ in range(30):
        timing.corrected(given)
    assert timing.applied == 0.001
    off = FrameTiming(offset, TimingParams(apply=False))
    assert off.corrected(frame) is frame


@pytest.mark.long
def test_the_pipeline_corrects_its_camera(hand: HandModel, glove: GloveModel) -> None:
    sim = simulation(hand, glove, 1, 12.0)
    pipeline = Pipeline(hand, glove, sim.rig, Settings())
    stamps: list[float] = []
    for message in sim.feed():
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
        else:
            assert isinstance(message, BlobFrame)
            late = replace(message, t=message.t + 0.020)
            stamps.append(late.t)
            pipeline.feed_frame(late)
        assert all(r.t in stamps for r in pipeline.take_results())
    offset = pipeline.timing.offset
    assert abs(offset.value - 0.020) < min(3 * offset.sd, 0.006)
    assert pipeline.timing.applied == pytest.approx(offset.value, abs=0.001)


def test_a_point_of_the_line_equals_the_plain_one() -> None:
    """Two views with five common markers, as in the formulas."""
    rng = np.random.default_rng(4)
    nominal, R_GB = rng.normal(0, 0.03, (9, 3)), so3.exp(rng.normal(size=3))
    gyro = so3.exp(rng.normal(0, 0.2, (2, 3)))
    rate = rng.normal(size=(2, 3))
    first, second = np.array([0, 2, 3, 5, 7, 8]), np.array([1, 2, 3, 5, 6, 7, 8])
    p_0 = nominal[first] @ R_GB.T + rng.normal(0, 1e-4, (6, 3))
    p_1 = nominal[second] @ so3.exp(rng.normal(0, 0.2, 3)).T + rng.normal(0, 1e-4, (7, 3))
    views = _RootView(0.0, first, p_0, R_GB), _RootView(0.3, second, p_1, np.eye(3))
    rotations = _GyroRotation(0.0, gyro[0], rate[0]), _GyroRotation(0.3, gyro[1], rate[1])
    fits, a, e = _point(nominal, *views, *rotations, 5, 0.004)
    both, i, j = np.intersect1d(first, second, return_indices=True)
    R_made, _ = rigid(p_1[j], p_0[i])
    D, b = gyro[0].T @ gyro[1], nominal[both] - nominal[both].mean(axis=0)
    information = ((b**2).sum() + FLAT) * np.eye(3) - b.T @ b
    whiten = np.linalg.cholesky(information).T
    assert fits
    assert np.allclose(a, whiten @ (D.T @ rate[0] - rate[1]), atol=1e-12)
    assert np.allclose(e, whiten @ so3.log(D.T @ R_GB.T @ R_made @ R_GB), atol=1e-12)
    assert not _point(nominal, *views, *rotations, 6, 0.004)[0]  # too few in common
    assert not _point(nominal, *views, *rotations, 5, 1e-6)[0]  # they do not fit
