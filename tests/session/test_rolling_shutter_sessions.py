"""Sessions of a camera that exposes one row after the other."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.messages import BlobFrame, CameraPose, ImuSample
from tracker.offline.options import SimulateOptions, TrackOptions
from tracker.offline.simulate import build, simulate
from tracker.offline.track import track
from tracker.session import engine_state
from tracker.session.compare import compare
from tracker.session.mcap.container import McapOutput
from tracker.session.mcap.input import McapInput
from tracker.session.reader import SessionReader
from tracker.session.rigs import LineTimes
from tracker.session.verify import is_ok, verify
from tracker.session.writer import SessionRecorder
from tracker.vision.rig import StereoRig, ideal_rig

pytestmark = pytest.mark.long

OPTIONS = SimulateOptions(seed=6, duration=3.0, fps=30, images=False, readout=0.018)


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("rows") / "in.mcap"
    simulate(path, OPTIONS)
    return path


def test_the_line_time_is_read_back_to_the_last_bit(recorded: Path) -> None:
    _, info = build(OPTIONS)
    assert info.rig is not None and info.rig.line_time == pytest.approx(0.018 / 719, abs=1e-9)
    with SessionReader(recorded) as reader:
        assert reader.rig().line_time == info.rig.line_time
        assert not reader.rig_changes()
        records = {r.name: dict(r.metadata) for r in reader.source.metadata()}
    assert records["camera"] == {"line_time_ns": "25035"}
    assert is_ok(verify(recorded))


def test_a_session_without_it_is_of_a_global_shutter(tmp_path: Path) -> None:
    simulate(tmp_path / "old.mcap", replace(OPTIONS, readout=0.0, duration=1.0))
    with SessionReader(tmp_path / "old.mcap") as reader:
        assert reader.rig().line_time == 0.0
        assert "camera" not in {r.name for r in reader.source.metadata()}


def test_tracking_again_and_its_result_are_of_the_same_camera(
    recorded: Path, tmp_path: Path
) -> None:
    first, second = tmp_path / "a.mcap", tmp_path / "b.mcap"
    track(recorded, first, TrackOptions(with_sensors=True))
    track(first, second)
    assert compare(first, second)["identical"]
    with SessionReader(first) as reader, SessionReader(recorded) as source:
        assert reader.rig().line_time == source.rig().line_time > 0


def test_each_calibration_has_a_line_time_of_its_own(tmp_path: Path) -> None:
    sim, info = build(OPTIONS)
    assert info.rig is not None
    path, rigs = tmp_path / "changed.mcap", [info.rig]
    rigs += [
        replace(info.rig, line_time=t, pose=moved(info.rig, k)) for k, t in ((1, 0), (2, 1e-5))
    ]
    with SessionRecorder(path, info) as recorder:
        for m in sim.feed():
            if len(rigs) > 1 and m.t_arrival > 3 - len(rigs) + 0.5:
                recorder.write_rig(rigs.pop(1), m.t_arrival)
            recorder.write(m)
    with SessionReader(path) as reader:
        assert reader.rig().line_time == info.rig.line_time
        assert [rig.line_time for _, rig in reader.rig_changes()] == [0.0, 1e-5]


def moved(rig: StereoRig, k: int) -> CameraPose:
    return CameraPose(rig.pose.R_GC, rig.pose.p_GC + 0.01 * k)


def test_an_invalid_line_time_is_an_error_of_the_file(tmp_path: Path) -> None:
    path = tmp_path / "bad.mcap"
    output = McapOutput(path)
    output.metadata("camera", {"line_time_ns": "fast"})
    output.finish()
    source = McapInput(path)
    with closing(source), raises(FileError, "session.line_time"):
        LineTimes(source)


@pytest.mark.parametrize("engine", ["chain", "vist"])
@pytest.mark.parametrize("camera", ["stand", "head"])
def test_tracking_continues_bit_for_bit_from_a_recorded_state(engine: str, camera: str) -> None:
    """A state packed as recordings have it, taken over by another pipeline in mid-motion."""
    sim, info = build(replace(OPTIONS, camera=camera))
    first = Pipeline(sim.hand, sim.glove, info.rig, Settings(engine=engine))
    second: Pipeline | None = None
    compared = 0
    for k, m in enumerate(sim.feed()):
        if k == 250:
            data = engine_state.pack(engine, first.get_state())
            second = Pipeline(sim.hand, sim.glove, info.rig, Settings(engine=engine))
            name, state = engine_state.unpack(data)
            assert name == engine
            second.set_state(state)
        if isinstance(m, BlobFrame):
            first.feed_frame(m)
            if second is not None:
                second.feed_frame(m)
        elif isinstance(m, ImuSample):
            one = first.feed_imu(m)
            if second is not None:
                other = second.feed_imu(m)
                assert np.array_equal(one.keypoints, other.keypoints, equal_nan=True)
                assert np.array_equal(one.keypoint_sd, other.keypoint_sd, equal_nan=True)
                compared += 1
    assert compared > 50


def test_impossible_line_times_are_refused() -> None:
    for line_time in (-1e-6, 1e-3, float("nan")):
        with raises(ConfigError, "stereo.line_time"):
            replace(ideal_rig(), line_time=line_time)
    with pytest.raises(ConfigError):
        build(replace(OPTIONS, readout=0.2))
