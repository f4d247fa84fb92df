"""The line time in calibration files, of ZED modes, and as estimated from a recording."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from tests.notices import raises
from tests.sensors.test_stereo_files import ZED
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.calibration.stereo.files import MissingFacts, load_rig, rig_text
from tracker.cli import main
from tracker.engine.pipeline import Pipeline
from tracker.glove import library
from tracker.offline.line_time import LineTimeEstimator
from tracker.offline.options import SimulateOptions
from tracker.offline.simulate import build
from tracker.sensors.rig_files import zed_line_time
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder
from tracker.simulation.motion import Swinging
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import ideal_rig, with_readout

pytestmark = pytest.mark.long


@pytest.mark.parametrize("cameras", [1, 2])
def test_a_calibration_file_keeps_the_line_time(tmp_path: Path, cameras: int) -> None:
    rig = with_readout(ideal_rig(), 0.018)
    rig = rig if cameras == 2 else with_one_camera(rig)
    path = tmp_path / "camera.yml"
    path.write_text(rig_text(rig))
    assert load_rig(path).line_time == rig.line_time
    path.write_text(rig_text(rig, line_time=0.0))
    assert "line_time" not in path.read_text() and load_rig(path).line_time == 0.0
    path.write_text(rig_text(rig).replace("line_time: ", "line_time: 99"))
    with raises(ConfigError, "stereo.line_time", "stereo.file_refused"):
        load_rig(path)


def test_a_zed_has_the_line_time_of_its_mode(tmp_path: Path) -> None:
    path = tmp_path / "SN12.conf"
    path.write_text(ZED)
    assert load_rig(path, MissingFacts(fps=30.0)).line_time == 25.6e-6
    assert load_rig(path, MissingFacts(fps=60.0)).line_time == 15.7e-6
    assert load_rig(path, MissingFacts(fps=15.0)).line_time == 0.0
    assert zed_line_time(376, 60.0) == 0.0
    path.write_text(ZED + "[LEFT_CAM_SVGA]\nfx = 350\n")
    assert load_rig(path).line_time == 0.0


@pytest.fixture(scope="module")
def swung(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A hand swung at 1 m/s, recorded by a camera that reads 720 rows in 18 ms, whose calibration
    takes it for a global shutter."""
    rig, (hand, glove) = with_readout(ideal_rig(), 0.018), library.load()
    own = RandomPostures(hand, 3, 3.0, 6.0, camera=rig.pose)
    sim = Simulation(hand, glove, Swinging(own, 1.0, rig.pose), 3, fps=30.0, rig=rig)
    path = tmp_path_factory.mktemp("line_time") / "swung.mcap"
    _, info = build(SimulateOptions(seed=3, images=False))
    with SessionRecorder(path, replace(info, rig=ideal_rig())) as recorder:
        for message in sim.messages():
            recorder.write(message)
    return path


@pytest.mark.timeout(400)
def test_the_line_time_is_estimated_from_a_swung_hand(swung: Path, tmp_path: Path) -> None:
    out, calibration = tmp_path / "found.json", tmp_path / "camera.yml"
    assert main(["line-time", str(swung), "--json", str(out), "--set", str(calibration)]) == 0
    found = json.loads(out.read_text())
    assert found["line_time_us"] == pytest.approx(25.035, abs=1.5)
    assert found["residual_px"] < 0.9 * found["residual_global_px"]
    for option, path in (("--json", out), ("--set", calibration)):
        before = path.read_bytes()
        assert main(["line-time", str(swung), option, str(path)]) != 0
        assert path.read_bytes() == before, "an existing file is not replaced"
    assert load_rig(calibration).line_time == pytest.approx(1e-6 * found["line_time_us"], abs=1e-9)


def test_a_recording_in_which_little_is_seen_is_too_short(swung: Path) -> None:
    with SessionReader(swung) as reader:
        info, rig, messages = reader.info, reader.rig(), list(reader.messages(end=2.2))
    make = LineTimeEstimator(lambda r: Pipeline(info.hand, info.glove, r), rig, messages)  # type: ignore[arg-type]
    with raises(GlovetrackError, "line_time.too_short"):
        make.estimate()
