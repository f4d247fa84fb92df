"""Automatic colour fits on photographs of a desk, compared with ground truth."""

from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks.desk import detection, folder, load, tracked
from tests.notices import raises
from tracker.base.errors import GlovetrackError
from tracker.calibration.colours_image import learn_image
from tracker.glove import library
from tracker.messages import ImuSample, StereoFrame
from tracker.offline.colours import check_session, fit_session
from tracker.offline.colours_fit import (
    Sensed,
    WatchedGlove,
    check_messages,
    check_with_names,
    exchanged_hues,
    fit_messages,
)
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import (
    LEARNED_CELLS,
    ROOM,
    ColourProfile,
    LearnedColours,
    load_profile,
    parse_profile,
    profile_to_toml,
)
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import ideal_rig

pytestmark = pytest.mark.long

SCENES = folder()
needs_data = pytest.mark.skipif(SCENES is None, reason="needs the photographs of a desk")
FACTORY = parse_profile(library.text("colours", library.DEFAULT_COLOURS))


def test_learned_colours_are_read_back_from_their_file() -> None:
    classes = np.random.default_rng(0).integers(0, 5, LEARNED_CELLS).astype(np.uint8)
    profile = ColourProfile("x", FACTORY.hues, learned=LearnedColours.of(classes, 0.25))
    back = parse_profile(profile_to_toml(profile))
    assert back == profile
    assert back.learned is not None and (back.learned.classes() == classes).all()
    assert ROOM in classes


@needs_data
def test_colours_fitted_to_lamp_light_find_the_markers_and_few_false_blobs(tmp_path: Path) -> None:
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


LAMP = np.array([0.75, 1.0, 1.15])  # of blue, green and red


@lru_cache(maxsize=1)
def simulated() -> tuple[WatchedGlove, tuple[ImuSample | StereoFrame, ...]]:
    """A simulated hand for a second."""
    hand, glove = library.load()
    sim = Simulation(hand, glove, RandomPostures(hand, 2, duration=0.9), 2, fps=8)
    feed = [m for m in sim.feed(images=True) if isinstance(m, ImuSample | StereoFrame)]
    return WatchedGlove(hand, glove, sim.rig), tuple(feed)


@lru_cache(maxsize=1)
def under_a_lamp() -> tuple[WatchedGlove, tuple[ImuSample | StereoFrame, ...]]:
    """The same in light for which the factory colours are unsuitable."""
    worn, feed = simulated()
    messages: list[ImuSample | StereoFrame] = []
    for m in feed:
        if isinstance(m, StereoFrame):
            assert m.left is not None and m.right is not None
            lit = [np.clip(x * LAMP, 0, 255).astype(np.uint8) for x in (m.left, m.right)]
            messages.append(replace(m, left=lit[0], right=lit[1]))
        elif isinstance(m, ImuSample):
            messages.append(m)
    return worn, tuple(messages)


def seen_by(cameras: str) -> tuple[WatchedGlove, list[Sensed]]:
    """The same with the left camera alone, or next to a monochrome one."""
    worn, messages = under_a_lamp()
    out: list[Sensed] = []
    for m in messages:
        if isinstance(m, StereoFrame):
            assert m.right is not None
            grey = np.repeat(m.right[..., 1:2], 3, axis=2)
            m = replace(m, right=None if cameras == "one" else grey)
        out.append(m)
    return (worn._replace(rig=with_one_camera(ideal_rig())) if cameras == "one" else worn), out


@pytest.mark.parametrize("cameras", ["one", "infrared"])
def test_one_camera_is_sufficient_for_a_fit(cameras: str) -> None:
    """Markers seen by it count like those seen by two cameras: some missed by the factory colours
    are found."""
    worn, messages = seen_by(cameras)
    fit = fit_messages(messages, worn, FACTORY)
    assert fit.after.sure > 15
    assert fit.after.sure > fit.before.sure + 0.5
    assert fit.after.tracked == fit.after.images >= 6


def test_nothing_is_learned_from_a_glove_of_the_other_hand() -> None:
    """A left glove with right files: the colours are not the cause, and none are learned from a
    hand found among mirrored patches by mistake."""
    hand, glove = library.load("vist-small-left", "reference-left")
    sim = Simulation(hand, glove, RandomPostures(hand, 2, duration=0.9), 2, fps=10)
    messages: list[Sensed] = [
        m for m in sim.feed(images=True) if isinstance(m, ImuSample | StereoFrame)
    ]
    with raises(GlovetrackError, "glove.other_hand"):
        fit_messages(messages, WatchedGlove(*library.load(), sim.rig), FACTORY)


RENAMED = {"red": "yellow", "yellow": "green", "green": "blue", "blue": "red"}


def with_names(names: dict[str, str]) -> ColourProfile:
    """The factory colours with other names, in another order."""
    hues = [replace(h, name=names.get(h.name, h.name)) for h in reversed(FACTORY.hues)]
    return replace(FACTORY, hues=tuple(hues))


def test_exchanged_hues_are_corrected_in_any_order_of_names() -> None:
    worn, messages = simulated()
    wrong = with_names({"red": "blue", "blue": "red"})
    fit = fit_messages(messages, worn, wrong)
    assert set(fit.exchanged) == {"red", "blue"}
    assert fit.after.sure > 15 > fit.before.sure
    assert fit.profile.hue_names == wrong.hue_names


def test_all_hues_exchanged_are_named() -> None:
    assert set(RENAMED) == set(FACTORY.hue_names)
    worn, messages = simulated()
    check = check_with_names(messages, worn, with_names(RENAMED))
    assert not check.ok
    assert set(check.exchanged) == set(RENAMED)
    assert check.lines()[-1].startswith("The names of these hues are exchanged")


def test_colours_in_order_are_not_called_exchanged() -> None:
    worn, messages = simulated()
    assert exchanged_hues(messages, worn, FACTORY) == ()
    assert check_with_names(messages, worn, FACTORY).exchanged == ()


def test_no_more_markers_are_found_than_expected() -> None:
    worn, messages = simulated()
    for hue in check_messages(messages, worn, FACTORY).hues:
        assert 0 < hue.found <= hue.expected
