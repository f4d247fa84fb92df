"""A recording that begins in the middle of tracking is tracked again bit for bit."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.config import to_toml
from tracker.base.errors import FileError
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.messages import BlobFrame, CameraPose, EngineState, Estimate, ImuSample
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, TruthsAhead, build, truth_message
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.description import SessionInfo
from tracker.session.engine_state import MEDIA_TYPE, NAME
from tracker.session.mcap.container import McapOutput
from tracker.session.reader import SessionReader
from tracker.session.recover import recover
from tracker.session.writer import SessionRecorder
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import StereoRig

BEGIN, CHANGE = 1.0, 1.8  # s


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Tracked from 0 s, recorded from 1.0 s, with another engine from 1.8 s on."""
    path = tmp_path_factory.mktemp("middle") / "in.mcap"
    sim, info = build(SimulateOptions(seed=5, duration=2.5, fps=30, images=False))
    info = replace(info, settings_text=to_toml(Settings()))
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig)
    messages = [m for m in sim.feed() if isinstance(m, ImuSample | BlobFrame)]
    with SessionRecorder(path, info) as recorder:
        began = changed = False
        for m in messages:
            if m.t_arrival >= BEGIN and not began:
                recorder.write(EngineState(m.t_arrival, "chain", pipeline.get_state()))
                began = True
            if m.t_arrival >= CHANGE and not changed:
                settings = replace(Settings(), engine="vist")
                pipeline = Pipeline(sim.hand, sim.glove, sim.rig, settings)
                recorder.write(EngineState(m.t_arrival, "vist", pipeline.get_state()))
                changed = True
            if began:
                recorder.write(m)
            if isinstance(m, BlobFrame):
                pipeline.feed_frame(m)
            else:
                estimate = pipeline.feed_imu(m)
                if began:
                    recorder.write(estimate)
    return path


@pytest.mark.long
def test_the_same_bits_from_the_first_packet_on(recorded: Path, tmp_path: Path) -> None:
    track(recorded, tmp_path / "a.mcap", TrackOptions(with_sensors=True))
    found = compare(recorded, tmp_path / "a.mcap")
    assert found["identical"] and found["compared"] > 140
    with SessionReader(recorded) as reader:
        first = next(m for m in reader.messages((Estimate,)) if isinstance(m, Estimate))
    assert np.isfinite(first.keypoints).all(), "tracked from its first instant"
    track(tmp_path / "a.mcap", tmp_path / "b.mcap")  # the copied part is again sufficient
    assert compare(recorded, tmp_path / "b.mcap")["identical"]


@pytest.mark.long
def test_a_recovered_recording_has_its_state(recorded: Path, tmp_path: Path) -> None:
    data = recorded.read_bytes()
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(data[: len(data) * 2 // 3])
    saved = recover(cut)
    track(saved.path, tmp_path / "a.mcap")
    found = compare(saved.path, tmp_path / "a.mcap")
    assert found["mean_mm"] == 0 and found["compared"] > 50


def test_with_other_settings_it_starts_without_the_state(recorded: Path, tmp_path: Path) -> None:
    report = track(recorded, tmp_path / "a.mcap", TrackOptions(engine="madgwick"))
    assert report.estimates > 140
    assert not compare(recorded, tmp_path / "a.mcap")["identical"]


def with_state(info: SessionInfo, path: Path, data: bytes) -> Path:
    out = McapOutput(path, sync=False)
    out.metadata("glovetrack", info.metadata())
    for name, text in info.attachments().items():
        out.attach(name, text, 0)
    out.attach_bytes(NAME, MEDIA_TYPE, data, 0)
    out.finish()
    return path


def test_a_damaged_state_is_reported(recorded: Path, tmp_path: Path) -> None:
    with SessionReader(recorded) as reader:
        assert NAME not in reader.attachments
        path = with_state(reader.info, tmp_path / "bad.mcap", b"GTES and nothing more")
    with SessionReader(path) as reader, raises(FileError, "session.state_damaged"):
        reader.engine_states()


def moved(info: SessionInfo, by: float) -> StereoRig:
    """The camera of a session ``by`` m further along G's x."""
    assert info.rig is not None
    pose = info.rig.pose
    return replace(info.rig, pose=CameraPose(pose.R_GC, pose.p_GC + [by, 0, 0]))


@pytest.mark.long
def test_a_camera_that_is_moved_while_recording(tmp_path: Path) -> None:
    """It is calibrated again halfway, 5 cm to the side: only the rig shows that."""
    sim, info = build(SimulateOptions(seed=3, duration=4.0, fps=30, images=False))
    lateral = Simulation(sim.hand, sim.glove, sim.motion, 3, fps=30, rig=moved(info, 0.05))
    changed, silent = tmp_path / "changed.mcap", tmp_path / "silent.mcap"
    feeds = list(sim.feed()), list(lateral.feed())
    for path in (changed, silent):
        truths = TruthsAhead(sim)
        with SessionRecorder(path, info) as recorder:
            for before, after in zip(*feeds, strict=False):
                if before.t_arrival < 2.0:
                    recorder.write(before)
                    continue
                if path == changed and recorder.info.rig is info.rig:
                    recorder.write_rig(lateral.rig, 2.0)
                recorder.write(after)
                if isinstance(after, ImuSample):
                    recorder.write_truth(truth_message(after.t, truths.at(after), info))
    with SessionReader(changed) as reader:
        ((t, rig),) = reader.rig_changes()
        assert t == pytest.approx(2.0) and np.array_equal(rig.pose.p_GC, lateral.rig.pose.p_GC)
    right = track(changed, tmp_path / "a.mcap", TrackOptions(with_sensors=True)).error_mm["mean"]
    wrong = track(silent, tmp_path / "b.mcap").error_mm["mean"]
    assert right < 6 and wrong > 20
    track(tmp_path / "a.mcap", tmp_path / "c.mcap")
    assert compare(tmp_path / "a.mcap", tmp_path / "c.mcap")["identical"]
    with raises(FileError, "track.smooth_calibration"):
        track(changed, tmp_path / "d.mcap", TrackOptions(smooth=True))


@pytest.fixture(scope="module")
def unsearched(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recorded by a computer that was too loaded to search one image."""
    path = tmp_path_factory.mktemp("unsearched") / "in.mcap"
    sim, info = build(SimulateOptions(seed=5, duration=1.5, fps=10, scene="plain"))
    info = replace(info, settings_text=to_toml(Settings()))
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig)
    with SessionRecorder(path, info) as recorder:
        recorder.write(EngineState(-1.0, "chain", pipeline.get_state()))
        for m in sim.feed(images=True):
            recorder.write(m)
            if isinstance(m, ImuSample):
                recorder.write(pipeline.feed_imu(m))
    return path


@pytest.mark.long
def test_images_that_were_not_searched_live_are_not_searched_again(
    unsearched: Path, tmp_path: Path
) -> None:
    report = track(unsearched, tmp_path / "again.mcap")
    assert report.frames == 0 and compare(unsearched, tmp_path / "again.mcap")["identical"]


def test_another_engine_searches_images_that_were_not_searched_live(
    unsearched: Path, tmp_path: Path
) -> None:
    assert track(unsearched, tmp_path / "other.mcap", TrackOptions(engine="vist")).frames > 10
