"""The rings that show the uncertainty of each fingertip."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from app.engines.snapshot import Snapshot
from app.panels.hand.bodies import LIMIT, TipRings
from app.viewmodels.hand_scene import HandScene, HandSceneModel
from app.widgets.view3d.orbit import VIEW_ANGLE_DEG, Orbit
from app.widgets.view3d.raster.scene import RasterScene
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup

SIZE = 400
FOCAL = 0.5 * SIZE / np.tan(np.deg2rad(VIEW_ANGLE_DEG / 2))


@pytest.fixture(scope="module")
def hand() -> HandScene:
    setup = scripted_setup(ScriptedEngine())
    scene = HandSceneModel(setup).scene(
        Snapshot(setup, True, estimate=setup.engine.latest_estimate())
    )
    assert scene is not None
    return scene


def painted(hand: HandScene, sd: float, wanted: bool = True) -> tuple[np.ndarray, np.ndarray]:
    """Grey (H, W) of one fingertip's ring in the view's middle, and px from the middle of what
    differs from the background."""
    scene, orbit = RasterScene(), Orbit()
    orbit.target = hand.tips[0]
    scene.set_background("#FFFFFF")
    sds = np.full(len(hand.tips), np.nan)
    sds[0] = sd
    TipRings(scene, len(sds)).update(dataclasses.replace(hand, tip_sd=sds), wanted, orbit)
    pixels = scene.render(orbit, SIZE, SIZE).view(np.uint8).reshape(SIZE, SIZE, 4)
    grey = pixels[..., :3].mean(axis=2)
    v, u = np.nonzero(grey < 240)
    return grey, np.hypot(u + 0.5 - SIZE / 2, v + 0.5 - SIZE / 2)


@pytest.mark.parametrize("sd", [0.003, 0.005, 0.0074])
def test_a_ring_has_two_standard_deviations(hand: HandScene, sd: float) -> None:
    _, radii = painted(hand, sd)
    expected = FOCAL * 2 * sd / Orbit().distance
    assert np.median(radii) == pytest.approx(expected, abs=1.0)  # a pixel's width
    assert np.ptp(radii) < 4.0  # nothing but a thin line, so nothing is hidden


def test_a_larger_one_is_broken_and_no_larger_whatever_the_colours(hand: HandScene) -> None:
    whole, radii = painted(hand, 0.499 * LIMIT)
    broken, other = painted(hand, 0.04)
    assert np.median(other) == pytest.approx(np.median(radii), abs=1.0)
    assert 0.3 < (broken < 240).sum() / (whole < 240).sum() < 0.7


def test_none_where_nothing_is_known_or_none_is_wanted(hand: HandScene) -> None:
    assert not len(painted(hand, np.nan)[1])
    assert not len(painted(hand, 0.005, wanted=False)[1])
