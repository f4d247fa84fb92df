"""The default simulated cameras have the errors of real ones; options remove them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.cli import main
from tracker.glove import library
from tracker.offline.options import SimulateOptions
from tracker.offline.simulate import build, build_both
from tracker.simulation.camera_errors import FIELDS, IDEAL, WEBCAM, ZED, errors_named
from tracker.simulation.demo import DemoSpec, build_scene
from tracker.simulation.two_hands import TwoHandsSimulation
from tracker.vision.rig import StereoRig, ideal_rig

TEXTS = library.texts(library.DEFAULT_GLOVE)


def has_errors(true: StereoRig, rig: StereoRig, readout: float) -> bool:
    """Whether a camera distorts, exposes row by row and is not exactly its calibration."""
    off = abs(true.baseline / rig.baseline - 1)
    return bool(rig.left.D.any() and rig.readout == pytest.approx(readout, abs=1e-6) and off > 1e-3)


@pytest.mark.long
def test_simulated_sessions_demos_and_rigs_have_a_real_camera() -> None:
    simulated, _ = build(SimulateOptions(duration=2.0))
    demo = build_scene(DemoSpec(*TEXTS))
    both, _ = build_both(SimulateOptions(duration=2.0, hands="both"))
    webcam = DemoSpec(*TEXTS, one_camera=True)
    for sim in (simulated, demo, *both.hands.values()):
        assert not isinstance(sim, TwoHandsSimulation)
        assert has_errors(sim.scene.rig, sim.rig, ZED.readout)
        assert sim.params.stamp_jitter == ZED.stamp_jitter and sim.params.flicker == ZED.flicker
    left, right = both.hands.values()
    assert left.scene.rig.baseline == right.scene.rig.baseline, "one camera sees both hands"
    assert webcam.errors_of_camera == WEBCAM
    assert webcam.rig.left.D.any() and np.array_equal(webcam.rig.left.R, np.eye(3))


@pytest.mark.parametrize("name", FIELDS)
def test_each_error_is_switched_by_its_name(name: str) -> None:
    others = ",".join(n for n in FIELDS if n != name)
    without, alone = errors_named(others), errors_named(name)
    for field in FIELDS.values():
        is_own = field == FIELDS[name]
        assert getattr(without, field) == getattr(IDEAL if is_own else ZED, field)
        assert getattr(alone, field) == getattr(ZED if is_own else IDEAL, field)


def test_an_ideal_camera_is_the_one_of_the_papers() -> None:
    sim, _ = build(SimulateOptions(duration=2.0, camera_errors="none"))
    assert sim.scene.rig is sim.rig and sim.rig.line_time == 0.0
    assert np.array_equal(sim.rig.left.K, ideal_rig().left.K) and sim.rig.left.is_rectified
    assert sim.params.stamp_jitter == sim.params.flicker.depth == 0.0
    slow, _ = build(SimulateOptions(duration=2.0, camera_errors="none", readout=0.02))
    assert slow.rig.readout == pytest.approx(0.02, abs=1e-6)
    with raises(ConfigError, "option.choice"):
        errors_named("lenses,dust")


def test_the_rig_calibrates_its_distorting_lenses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its calibration file describes what the hand and the board are seen with, to 0.3 px."""
    from tracker.calibration.stereo.files import load_rig
    from tracker.offline import rig_command
    from tracker.simulation import rig_device
    from tracker.simulation.camera_device import NoSimulatedCamera

    monkeypatch.setattr(rig_device, "SimulatedCamera", lambda spec: NoSimulatedCamera())
    monkeypatch.setattr("sys.stdin", None)
    assert main(["rig", str(tmp_path), "--duration", "0.1"]) == 0
    spec = DemoSpec(*TEXTS)
    saved, rig = load_rig(tmp_path / rig_command.CALIBRATION), spec.rig
    for one, other in ((saved.left, rig.left), (saved.right, rig.right)):
        assert np.allclose(one.D, other.D) and np.allclose(one.K, other.K)
    assert saved.baseline == pytest.approx(rig.baseline)
    assert saved.line_time == rig.line_time
