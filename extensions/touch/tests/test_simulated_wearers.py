"""Simulated wearers touch the requested crosses, and the study compares equal conditions."""

from __future__ import annotations

import numpy as np
import pytest

from extensions.touch.protocol import FINGERS, touches
from extensions.touch.sheet import BY_NAME
from extensions.touch.simulated.command import summary, table
from extensions.touch.simulated.trial import FingerFigures, SimulatedTrial, WearerFigures, figures
from tracker.messages import Calibration


def test_the_pulp_rests_on_the_cross_that_was_asked_for() -> None:
    """The middle of the round end is a radius above the cross, minus the compression of the pulp;
    aim, pulp and tremor move it by some 0.8 mm per axis (SD)."""
    trial = SimulatedTrial(5, lead=1.0)
    wearer = trial.sim.wearer
    for cued in trial.motion.cued:
        segment = trial.hand.index[f"{cued.cue.finger}_distal"]
        radius = trial.hand.segments[segment].radius * wearer.scale[segment, 2]
        length = trial.hand.segments[segment].length * wearer.scale[segment, 0]
        truth = trial.sim.truth(cued.end - 0.4)
        centre = truth.p_GB[segment] + truth.R_GB[segment][:, 0] * (length - radius)
        off = centre - trial.sheet.target(BY_NAME[cued.cue.target].p_S) - [0, 0, radius]
        assert np.linalg.norm(off[:2]) < 0.003 and -0.003 < off[2] < 0.0015, cued.cue


def test_the_movement_has_no_jumps() -> None:
    """Faster than 3 m/s no wearer moves; a jump between two samples would be."""
    trial = SimulatedTrial(6, lead=1.0)
    t = np.arange(0.0, trial.motion.duration, 0.01)
    p_GB = trial.motion.poses(t).p_GB
    assert np.abs(np.diff(p_GB, axis=0)).max() / 0.01 < 3.0


@pytest.mark.long
def test_the_engine_s_error_is_found_on_a_short_test() -> None:
    """Four touches of the index finger, tracked by the default engine: the bias found is within
    1 mm per axis of the true one (pulp 0.4 mm, aim 0.6 / √4 mm, ruler 0.3 mm: SD 0.6 mm)."""
    cues = [c for c in touches() if c.finger == "index"][:4]
    trial = SimulatedTrial(1, cues=cues, lead=3.0)
    estimates, calibration = trial.track()
    assert isinstance(calibration, Calibration)
    found = figures(trial, estimates, calibration)
    [finger] = found.fingers
    assert finger.touches == 4 and found.missed == 0
    off = np.subtract(finger.bias_found, finger.bias_true)
    assert np.abs(off).max() < 1.5 and np.linalg.norm(finger.bias_true) > 2.0


def row(seed: int, fault: str, off: float, sd: float, codes=(), with_ruler=()) -> WearerFigures:
    bias = (1.0, -2.0, 3.0)
    found = tuple(b + off for b in bias)
    fingers = tuple(FingerFigures(seed, fault, f, 8, found, bias, sd, 2.0) for f in FINGERS)
    return WearerFigures(seed, fault, fingers, 0, codes, with_ruler, 1.0, (0.7, 0.95, 1.0))


def test_the_study_judges_bias_spread_and_claims() -> None:
    rows = [
        row(1, "none", 0.3, 2.1),
        row(2, "print", -0.1, 2.2, ("touch.print_scale",), ("touch.print_scale",)),
        row(3, "camera", 0.1, 2.0, ("touch.print_scale",), ("touch.camera_scale",)),
    ]
    found = summary(rows)
    assert found["ok"] and found["bias_off_mm"] == pytest.approx([0.1] * 3)
    assert found["sd_ratio"] == pytest.approx(np.sqrt((2.1**2 + 2.2**2 + 2.0**2) / 3) / 2.0)
    assert found["print_said"] == found["print_said_with_ruler"] == [1, 1]
    assert found["camera_said_with_ruler"] == [1, 1] and found["said_wrongly"] == [0, 1]
    assert len(table(rows, found)) == 1 + 9 + 3
    assert not summary([row(1, "none", 0.6, 2.0)])["ok"]
    assert not summary([row(1, "none", 0.0, 2.4)])["ok"]
    wrongly = summary([row(4, "none", 0.0, 2.0, ("touch.print_scale",))])
    assert wrongly["said_wrongly"] == [1, 1]
