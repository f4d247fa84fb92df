"""Colours that fit themselves to photographs of a desk, against the truth about them."""

from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks.desk import detection, folder, load, tracked
from tracker import library
from tracker.calibration.colours_image import learn_image
from tracker.offline.colours import check_session, fit_session
from tracker.vision.colours import (
    LEARNED_CELLS,
    ROOM,
    ColourProfile,
    LearnedColours,
    load_profile,
    parse_profile,
    profile_to_toml,
)

SCENES = folder()
needs_data = pytest.mark.skipif(SCENES is None, reason="needs the photographs of a desk")
FACTORY = parse_profile(library.text("colours", library.DEFAULT_COLOURS))


def test_what_was_learned_comes_back_from_its_file() -> None:
    classes = np.random.default_rng(0).integers(0, 5, LEARNED_CELLS).astype(np.uint8)
    profile = ColourProfile("x", FACTORY.hues, learned=LearnedColours.of(classes, 0.25))
    back = parse_profile(profile_to_toml(profile))
    assert back == profile
    assert back.learned is not None and (back.learned.classes() == classes).all()
    assert ROOM in classes


@needs_data
def test_colours_fitted_to_lamp_light_find_the_markers_and_little_else(tmp_path: Path) -> None:
    assert SCENES is not None
    out = tmp_path / "lamp.toml"
    fit = fit_session(SCENES / "lamp" / "in.mcap", out)
    assert fit.after.found > fit.before.found
    scene, profile = load(SCENES / "lamp"), load_profile(out)
    seen, factory = detection(scene, profile, 6), detection(scene, FACTORY, 6)
    assert seen.recall >= 0.94 > factory.recall
    assert seen.false_far <= 40 * seen.images
    assert seen.false_near <= 3 * seen.images
    assert check_session(SCENES / "lamp" / "in.mcap", str(out)).tracked > 35
    assert tracked(scene, profile).error_mm <= 6.0


@needs_data
@pytest.mark.parametrize("name", ["window", "led"])
def test_one_image_is_enough_to_learn_from(name: str) -> None:
    assert SCENES is not None
    scene = load(SCENES / name)
    image = scene.frames[0].left
    assert image is not None and scene.info.rig is not None
    profile, _ = learn_image(image, FACTORY, 0.012, scene.info.rig.fx)
    assert detection(scene, profile, 6).recall >= 0.85
    assert tracked(scene, profile).longest_wrong <= 0.1
