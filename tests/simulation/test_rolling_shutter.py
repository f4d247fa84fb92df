"""Simulated images whose rows are exposed one after the other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from extensions.evaluation.vist.scenes import Distractors
from tests.fixtures import RESOURCES
from tracker.glove import library
from tracker.simulation.motion import Swinging
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.render import RenderParams
from tracker.simulation.row_sampling import bands_of
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.scene import BlobParams
from tracker.vision.colours import load_profile
from tracker.vision.detector import Detector
from tracker.vision.rig import StereoRig, ideal_rig, with_readout

READOUT = 0.018  # s
CLEAN = BlobParams(noise_px=0.0, dropout=0.0, size_noise=0.0)


def simulated(rig: StereoRig, seed: int = 2) -> Simulation:
    """A hand that is swung at up to 2 m/s, among balls of the markers' colours."""
    hand, glove = library.load()
    motion = Swinging(RandomPostures(hand, seed, duration=4.0), 2.0, rig.pose)
    params = SimulationParams(blobs=CLEAN, render=RenderParams(noise=0.0, exposures=1))
    extras = [Distractors(seed, 6, moving=0.05)]
    return Simulation(hand, glove, motion, seed, params, rig=rig, extras=extras)


def test_each_blob_is_where_its_marker_is_when_its_row_is_exposed() -> None:
    rig = with_readout(ideal_rig(), READOUT)
    D = np.array([-0.17, 0.03, 1e-3, -5e-4, 0.0])
    rig = replace(rig, left=replace(rig.left, D=D), right=replace(rig.right, D=D))
    sim, farthest = simulated(rig), 0.0
    off: list[float] = []
    for t in np.arange(0.5, 3.6, 0.3):
        frame = sim.scene.blobs(t)
        at_once = sim.scene.markers_seen(sim.scene.instant(t), False)
        assert frame.left is not None
        for uv in frame.left.uv:
            # what is on this row is what a global shutter shows at the row's own instant
            when = t + READOUT * (uv[1] / 719 - 0.5)
            now = sim.scene.markers_seen(sim.scene.instant(when), False)
            apart = np.linalg.norm(now.uv - uv, axis=1)
            k = int(np.nanargmin(apart))
            if apart[k] > 3.0:
                continue  # a ball
            off.append(float(apart[k]))
            farthest = max(farthest, float(np.linalg.norm(at_once.uv[k] - uv)))
    assert len(off) > 60 and farthest > 10.0
    # the visible part of a marker at the edge of another finger changes within an image
    assert max(off) < 1.0 and np.mean(np.array(off) < 0.15) > 0.97


def test_a_global_shutter_is_the_limit_of_a_fast_readout() -> None:
    slow, fast = simulated(ideal_rig()), simulated(with_readout(ideal_rig(), 1e-5))
    for t in (0.5, 1.7):
        one, other = slow.scene.blobs(t), fast.scene.blobs(t)
        assert one.left is not None and other.left is not None
        assert np.array_equal(one.left.hue, other.left.hue)
        assert np.allclose(one.left.uv, other.left.uv, atol=0.05)


def test_images_show_blobs_where_their_rows_are_exposed() -> None:
    """What the detector finds in a sheared image against the blobs computed marker by marker."""
    sim = simulated(with_readout(ideal_rig(), READOUT))
    profile = load_profile(RESOURCES / "colours" / "fabric-default.toml")
    detector = Detector(profile, fx=sim.rig.fx)
    off, at_once, t = [], [], 1.3
    image, _ = sim.renderer.images(t)
    seen, still = sim.scene.blobs(t).left, sim.scene.markers_seen(sim.scene.instant(t), False)
    found, _ = detector.detect(image)
    assert seen is not None and len(found) > 20
    for uv in seen.uv:
        off.append(np.linalg.norm(found.uv - uv, axis=1).min())
    for uv in still.uv[still.visible]:
        at_once.append(np.linalg.norm(found.uv - uv, axis=1).min())
    assert np.median(off) < 0.8 < 3.0 < np.median(at_once)


@pytest.mark.parametrize("speed", [0.0, 50.0, 1000.0, 1e6])
def test_bands_cover_all_rows_once(speed: float) -> None:
    rig = with_readout(ideal_rig(), READOUT)
    bands = bands_of(rig, rig.left, speed)
    rows = [v for band in bands for v in range(band.first, band.end)]
    assert rows == list(range(720))
    for band in bands:
        middle = (band.first + band.end - 1) / 2
        assert band.delay == pytest.approx(READOUT * (middle / 719 - 0.5), abs=2e-7)
    assert len(bands) == min(max(int(np.ceil(speed * READOUT * 720 / 719 / 0.7)), 1), 45)
