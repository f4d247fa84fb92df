"""A glove without a camera: orientation and posture from its IMUs, no position."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.config import to_toml
from tracker.base.errors import ConfigError, FileError
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Estimate, ImuSample, Tracking, Validity
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, build
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

INERTIAL = Settings(engine="inertial")


@pytest.fixture(scope="module")
def sim(hand: HandModel, glove: GloveModel) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, 3, duration=12.0), 3, fps=30)


@pytest.fixture(scope="module")
def estimates(sim: Simulation) -> list[Estimate]:
    pipeline = Pipeline(sim.hand, sim.glove, None, INERTIAL)
    return [pipeline.feed_imu(sample) for sample in sim.imu_samples()]


@pytest.mark.long
def test_orientation_and_posture_match_the_true_hand(
    sim: Simulation, estimates: list[Estimate]
) -> None:
    """Within the IMU mounting error, 7.5° for this wearer, which no IMU can measure."""
    tilt, angles = [], []
    for e in estimates[100::10]:
        true = sim.truth(e.t)
        up, true_up = e.segment_R[0].T[:, 2], true.R_GB[0].T[:, 2]
        tilt.append(np.arccos(np.clip(up @ true_up, -1, 1)))
        measured = e.angle_state == Validity.MEASURED
        assert measured.sum() > 8
        angles.append(np.abs(e.angles - true.angles)[measured].mean())
    assert np.rad2deg(np.max(tilt)) < 12.0
    assert np.rad2deg(np.mean(angles)) < 6.0


def test_no_position_is_reported(estimates: list[Estimate]) -> None:
    begun = [e for e in estimates if e.tracking != Tracking.SEARCHING]
    assert begun[0].t - estimates[0].t < 0.5
    for e in begun:
        assert e.tracking == Tracking.LOST
        assert np.isnan(e.keypoints).all() and (e.keypoint_state == Validity.LOST).all()
        assert np.isfinite(e.segment_R).all() and np.linalg.norm(e.segment_p, axis=1).max() < 0.3


def test_segments_are_relative_to_the_imu_of_the_root(
    sim: Simulation, estimates: list[Estimate]
) -> None:
    root = sim.hand.index["dorsum"]
    reach = [
        float(np.linalg.norm(e.segment_p[root]))
        for e in estimates
        if e.tracking != Tracking.SEARCHING
    ]
    assert np.ptp(reach) < 1e-6


def test_after_an_interruption_it_starts_from_gravity_again(sim: Simulation) -> None:
    pipeline = Pipeline(sim.hand, sim.glove, None, INERTIAL)
    samples = list(sim.imu_samples())
    for sample in [*samples[:200], *samples[500:505]]:
        e = pipeline.feed_imu(sample)
    assert e.tracking == Tracking.SEARCHING
    for sample in samples[505:560]:
        e = pipeline.feed_imu(sample)
    up, true_up = e.segment_R[0].T[:, 2], sim.truth(e.t).R_GB[0].T[:, 2]
    assert e.tracking == Tracking.LOST and up @ true_up > np.cos(np.deg2rad(15))


def test_images_have_no_effect_and_empty_results(
    sim: Simulation, estimates: list[Estimate]
) -> None:
    pipeline = Pipeline(sim.hand, sim.glove, None, INERTIAL)
    frames, found, k = 0, [], 0
    for message in sim.feed():
        if isinstance(message, ImuSample):
            assert np.array_equal(
                pipeline.feed_imu(message).segment_R, estimates[k].segment_R, equal_nan=True
            )
            k += 1
        else:
            pipeline.feed_frame(message)
            frames += 1
        if k == 300:
            break
        found += pipeline.take_results()
    assert frames == len(found) > 50
    assert all((r.match_left == -1).all() for r in found)


def test_an_engine_that_needs_the_camera_reports_it(sim: Simulation) -> None:
    with raises(ConfigError, "engine.needs_camera"):
        Pipeline(sim.hand, sim.glove, None)


@pytest.fixture
def recorded(tmp_path: Path) -> Path:
    """A glove alone, recorded live."""
    path = tmp_path / "glove.mcap"
    sim, info = build(SimulateOptions(seed=5, duration=3.0, fps=30, images=False))
    info = replace(info, rig=None, engine="inertial", settings_text=to_toml(INERTIAL))
    pipeline = Pipeline(sim.hand, sim.glove, None, INERTIAL)
    with SessionRecorder(path, info) as recorder:
        for sample in sim.imu_samples():
            recorder.write(sample)
            recorder.write(pipeline.feed_imu(sample))
    return path


def test_a_session_without_a_camera_is_tracked_again_bit_for_bit(
    recorded: Path, tmp_path: Path
) -> None:
    track(recorded, tmp_path / "again.mcap")
    found = compare(recorded, tmp_path / "again.mcap")
    assert found["identical"] and found["compared"] > 200
    with SessionReader(tmp_path / "again.mcap") as reader:
        last = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)][-1]
    assert last.tracking == Tracking.LOST and np.isfinite(last.segment_R).all()
    with raises(FileError, "session.no_stereo"):
        track(recorded, tmp_path / "chain.mcap", TrackOptions(engine="chain"))
