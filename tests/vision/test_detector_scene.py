"""Detection and stereo matching on rendered images of a simulated hand, with ground truth."""

import numpy as np
import pytest

from tracker.simulation.backgrounds import BackgroundParams
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.render import RenderParams
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.colours import ColourProfile, HueRange
from tracker.vision.detector import Detector, detect_frame
from tracker.vision.stereo import all_pairs, match_stereo

CENTRES = {"red": 0, "yellow": 28, "green": 65, "blue": 110}
PROFILE = ColourProfile(
    "four", tuple(HueRange(n, ((h - 11) % 180, h + 11)) for n, h in CENTRES.items())
)
TIMES = (1.0, 3.5, 6.2, 9.1)


@pytest.fixture(scope="module", params=["plain", "painted"])
def simulation(request, hand, glove) -> Simulation:
    render = RenderParams(background=BackgroundParams(kind=request.param))
    motion = RandomPostures(hand, 3, duration=10.0)
    return Simulation(hand, glove, motion, 5, SimulationParams(render=render))


def truth(simulation: Simulation, t: float, right: bool) -> tuple[np.ndarray, np.ndarray]:
    """uv (n, 2) and ids (n,) of the markers that are blobs in one image."""
    seen = simulation.scene.markers_seen(simulation.scene.instant(t), right)
    ids = np.flatnonzero(seen.visible)
    return seen.uv[ids], ids


def test_visible_markers_are_found_where_they_are(simulation: Simulation) -> None:
    detector = Detector(PROFILE)
    number = np.array([PROFILE.hue_names.index(h) for h in simulation.glove.hues])
    errors, total = [], 0
    for t in TIMES:
        frame = detect_frame(detector, simulation.renderer.frame(t))
        for right, blobs in enumerate((frame.left, frame.right)):
            uv, ids = truth(simulation, t, bool(right))
            total += len(ids)
            assert blobs is not None
            for k, marker in enumerate(ids):
                same = blobs.hue == number[simulation.glove.marker_hue[marker]]
                d = np.hypot(*(blobs.uv[same] - uv[k]).T)
                if len(d) and d.min() < 4.0:
                    errors.append(d.min())
    assert len(errors) / total >= 0.97
    assert np.median(errors) < 0.5


def test_stereo_matches_are_the_same_marker(simulation: Simulation) -> None:
    """On true centroids of both images: markers seen by both cameras are paired correctly."""
    hue_of = simulation.glove.marker_hue
    right_pairs = pairs = possible = right_found = 0
    for t in TIMES:
        (left, i), (right, j) = (truth(simulation, t, side) for side in (False, True))
        args = (left, hue_of[i], right, hue_of[j], simulation.rig)
        got = match_stereo(*args)
        both = len(np.intersect1d(i, j))
        right_pairs += int(np.sum(i[got.left_index] == j[got.right_index]))
        pairs, possible = pairs + len(got), possible + both
        every = all_pairs(*args)
        right_found += int(np.sum(i[every.left_index] == j[every.right_index]))
    assert right_pairs / possible > 0.95
    assert right_pairs / pairs > 0.95
    assert right_found == possible
