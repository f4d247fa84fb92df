"""Lenses, calibrations, time stamps and lamps of simulated devices as real ones are."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.flicker import Exposure, FlickerParams, brightened, row_gains
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.rig_errors import BOARD, RigErrorParams, true_camera, with_lenses
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.rig import StereoRig, ideal_rig

IN_VIEW = np.array([[0.0, 0.0, 0.4], [0.12, 0.06, 0.35], [-0.1, -0.08, 0.5]])


def rectified(true: StereoRig, calibrated: StereoRig) -> list[np.ndarray]:
    """(n, 2) px of `IN_VIEW` in the left and the right image, by the calibration."""
    cameras = ((true.left, calibrated.left), (true.right, calibrated.right))
    return [
        c.rectify(t.unrectify(true.project(IN_VIEW, bool(k)))) for k, (t, c) in enumerate(cameras)
    ]


def test_lenses_distort_by_tens_of_pixels_and_their_calibration_takes_it_back() -> None:
    rig = with_lenses(ideal_rig(), 3)
    corner = np.array([[60.0, 40.0]])
    assert np.linalg.norm(rig.left.unrectify(corner) - corner) > 30.0
    for found, right in zip(rectified(rig, rig), (False, True), strict=True):
        assert found == pytest.approx(rig.project(IN_VIEW, right), abs=1e-3)


@pytest.mark.parametrize("seed", range(3))
def test_a_board_calibration_errs_by_its_pixels_and_its_baseline(seed: int) -> None:
    rig = with_lenses(ideal_rig(), seed)
    true = true_camera(rig, seed, BOARD)
    assert abs(true.baseline / rig.baseline - 1.0) == pytest.approx(BOARD.baseline)
    uv = np.random.default_rng(seed).uniform(0.0, [1279.0, 719.0], (500, 2))
    for a, b in ((true.left, rig.left), (true.right, rig.right)):
        off = a.unrectify(b.rectify(uv)) - uv
        rms = float(np.sqrt(np.mean(np.sum(off**2, axis=1))))
        assert rms == pytest.approx(BOARD.pixel_px, rel=0.15)
    left, right = rectified(true, rig)
    z = rig.triangulate(left, right)[:, 2]
    assert 0.0 < np.abs(z - IN_VIEW[:, 2]).max() < 0.005
    assert true_camera(rig, seed, RigErrorParams()) is rig


def test_a_pitched_and_rolled_camera_shifts_rows() -> None:
    rig = ideal_rig()
    errors = RigErrorParams(pitch_px=3.0, roll_deg=0.5)
    left, right = rectified(true_camera(rig, 0, errors), rig)
    x = (right[:, 0] - rig.cx) / rig.fx
    expected = 3.0 - rig.fy * np.deg2rad(0.5) * x
    assert (right - left)[:, 1] == pytest.approx(expected, abs=0.35)


def test_stamps_jitter_and_stay_in_order(hand: HandModel, glove: GloveModel) -> None:
    def frames(jitter: float) -> np.ndarray:
        params = SimulationParams(stamp_jitter=jitter)
        motion = RandomPostures(hand, 2, duration=3.0)
        sim = Simulation(hand, glove, motion, 2, params, fps=60)
        return np.array([f.t for f in sim.frames()])

    exact, jittered = frames(0.0), frames(0.004)
    assert np.ptp(np.diff(exact)) < 1e-8
    assert np.all(np.diff(jittered) > 0.0)
    assert 0.003 < np.std(jittered - exact) < 0.005


def test_lamps_flicker_in_bands_of_a_rolling_shutter() -> None:
    lamps, global_shutter = FlickerParams(depth=0.5), Exposure(0.004, 0.0)
    rolling = Exposure(0.004, 0.018)
    times = np.arange(0.0, 1.0, 1 / 60)
    mean = np.array([row_gains(720, t, global_shutter, lamps)[0] for t in times])
    assert 0.1 < np.ptp(mean) < 0.5
    assert np.ptp(row_gains(720, 0.0, global_shutter, lamps)) == 0.0
    bands = row_gains(720, 0.0, rolling, lamps)
    changes = np.count_nonzero(np.diff(np.sign(bands - bands.mean())))
    assert changes in (3, 4), "1.8 periods of 10 ms in 18 ms"
    # an exposure of one period averages over it
    assert np.ptp(row_gains(720, 0.0, Exposure(0.01, 0.018), lamps)) < 1e-6
    grey = np.full((720, 4, 3), 100, np.uint8)
    lit = np.empty_like(grey)
    brightened(grey, bands.astype(np.float32), lit)
    assert np.array_equal(lit[:, 0, 0], np.floor(100 * bands.astype(np.float32) + 0.5))
