"""The prior against the view of a simulated camera of a hand in known poses."""

import numpy as np
import pytest

from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand, visibility


@pytest.fixture(scope="module")
def prior_and_truth(hand, glove) -> tuple[np.ndarray, np.ndarray]:
    """Prior and visibility of every marker in both images, 40 times."""
    simulation = Simulation(hand, glove, RandomPostures(hand, 2, duration=60.0), 2)
    wearer, scene = simulation.wearer, simulation.scene
    prior, seen = [], []
    for t in np.arange(0.5, 59.0, 1.5):
        now, truth = scene.instant(t), simulation.truth(t)
        segment = wearer.marker_segment
        R = truth.R_GB[segment]
        p_G = truth.p_GB[segment] + np.einsum("mij,mj->mi", R, now.markers)
        normal_G = np.einsum("mij,mj->mi", R, glove.marker_normal)
        prior.append(
            visibility(
                PosedHand(HandShape.of(hand), truth.R_GB, truth.p_GB),
                MarkerRows(p_G, normal_G, segment),
                simulation.rig,
                simulation.rig.pose,
            )
        )
        seen.append([scene.markers_seen(now, right).visible for right in (False, True)])
    return np.ravel(prior), np.ravel(seen)


def test_likely_markers_are_seen(prior_and_truth) -> None:
    prior, seen = prior_and_truth
    assert seen[prior > 0.95].mean() > 0.95


def test_unlikely_markers_are_not_seen(prior_and_truth) -> None:
    prior, seen = prior_and_truth
    assert seen[prior < 0.05].mean() < 0.01


def test_visible_markers_hardly_ever_have_a_prior_of_zero(prior_and_truth) -> None:
    prior, seen = prior_and_truth
    assert (prior[seen] < 0.01).mean() < 0.01
