"""The compiled completion of a hand against HandModel's plain form."""

from dataclasses import replace

import numpy as np
import pytest

from tests.fusion.test_late_data import feed
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.output.completion import Completion
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Tracking
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation


def test_equals_the_plain_form(hand: HandModel, glove: GloveModel) -> None:
    layout = ChainLayout(hand, glove)
    low, high = hand.angle_limits.T
    angles = low + np.random.default_rng(2).random(len(low)) * (high - low)
    R, p = hand.forward(angles, np.eye(3), np.zeros(3))
    known = np.zeros(len(angles), bool)
    known[[c for i in layout.active for c in hand.axis_columns[i] if c >= 0]] = True
    expected, inferred = hand.apply_synergies(np.where(known, angles, 0.0), known)
    R_expected, p_expected = hand.forward(expected, np.eye(3), np.zeros(3))
    ones = np.ones((len(layout.active), 3))
    R_all, p_all, _, out, have = Completion(layout)(R[layout.active], p[layout.active], ones)
    assert np.allclose(out, expected, atol=1e-9)
    assert np.array_equal(have, known | inferred)
    assert np.allclose(R_all, R_expected, atol=1e-9) and np.allclose(p_all, p_expected, atol=1e-9)


@pytest.mark.long
@pytest.mark.parametrize("engine", ["chain", "vist"])
def test_fingers_without_sensors_and_synergies_follow_their_neighbours(
    hand: HandModel, glove: GloveModel, engine: str
) -> None:
    """A hand file that couples no fingers; the people's ring and little fingers are as usual."""
    alone = replace(hand, synergies=())
    motion = RandomPostures(hand, 8, duration=4.0)
    sim = Simulation(hand, glove, motion, 8, fps=30)
    pipeline = Pipeline(alone, glove, sim.rig, Settings(engine=engine))
    shown = [
        e for e in feed(pipeline, sim.feed()) if e.t > 2.0 and e.tracking != Tracking.SEARCHING
    ]
    true = np.array([x.keypoints for x in sim.truths(np.array([e.t for e in shown]))])
    error = np.linalg.norm(np.array([e.keypoints for e in shown]) - true, axis=2)
    sd = np.array([e.keypoint_sd for e in shown])
    names = glove.keypoint_names(hand)
    tips = [names.index(k) for k in ("ring_tip", "little_tip")]
    assert error[:, tips].mean() < 0.04  # drawn straight, they would be up to 0.11 m off
    assert np.mean(error[:, tips] <= 3 * sd[:, tips]) > 0.9
    mcp, pip = (hand.angle_index[f"ring_{j}_flexion"] for j in ("mcp", "pip"))
    middle = [hand.angle_index[f"middle_{j}_flexion"] for j in ("mcp", "pip")]
    for e in shown[::50]:
        np.testing.assert_allclose(e.angles[[mcp, pip]], e.angles[middle], atol=1e-9)
