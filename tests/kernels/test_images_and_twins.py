"""Kernels for images, against their twins on images small enough for Python."""

import numpy as np
import pytest

from resources import folder
from tests.vision.hue_classes import all_classes
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import parse_profile
from tracker.vision.components import Scan, fill, run_buffer
from tracker.vision.detector import Detector
from tracker.vision.hue_table import hue_table
from tracker.vision.rig import ideal_rig

SIZE = 160, 120


@pytest.fixture(scope="module")
def profile():
    return parse_profile((folder("colours") / "fabric-default.toml").read_text("utf-8"))


@pytest.fixture
def frame(compare_large, hand, glove):
    """Images of the simulated hand with a rig of few pixels."""
    rig = ideal_rig(*SIZE, hfov_deg=60.0, vfov_deg=46.0)
    simulation = Simulation(hand, glove, RandomPostures(hand, 4, duration=2.0), 4, rig=rig)
    index, t, arrival = next(iter(simulation.exposures()))
    return simulation.renderer.frame(t, arrival, index)


def test_images_are_drawn_as_by_python(frame):
    for image in (frame.left, frame.right):
        assert image.shape == (SIZE[1], SIZE[0], 3)
        assert image.std() > 5.0  # there is a hand


def test_blobs_are_found_as_by_python(profile, frame):
    detector = Detector(profile, fx=140.0)
    image = frame.left.copy()
    found, rejected = detector.detect(image)
    image.flags.writeable = False
    again, _ = detector.detect(image)
    assert len(found.uv) + len(rejected.uv) > 0
    assert np.array_equal(found.uv, again.uv)


@pytest.mark.usefixtures("compare_large")
def test_a_region_is_filled_as_by_python(profile):
    table, image = hue_table(profile), np.full((30, 40, 3), 110, np.uint8)
    image[8:20, 10:31] = (40, 40, 215)
    visited, runs = np.zeros((30, 40), np.uint8), run_buffer(40)
    hue = int(all_classes(table)[40, 40, 215])
    n, whole = fill(Scan(image, table, visited, 1, runs, 40), 8, 10, hue)
    assert (n, whole) == (12, True)
