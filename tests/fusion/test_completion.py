"""The compiled completion of a hand against HandModel's plain form."""

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.output.completion import Completion
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel


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
