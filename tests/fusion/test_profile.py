"""A learned wearer profile used in another run."""

import numpy as np
import pytest

from tests.fusion.test_chain_engine import errors, feed, simulation, times
from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.engine import ChainEngine
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel


@pytest.mark.long
def test_a_known_wearer_starts_more_accurately(hand: HandModel, glove: GloveModel) -> None:
    sim = simulation(hand, glove, 7, 12.0)
    messages = list(sim.feed())
    first = Pipeline(hand, glove, sim.rig)
    learned = errors(sim, estimates := feed(first, messages))
    again = Pipeline(hand, glove, sim.rig)
    assert isinstance(first.engine, ChainEngine) and isinstance(again.engine, ChainEngine)
    again.engine.apply_profile(first.engine.profile())
    known = errors(sim, feed(again, messages))
    early = (times(estimates) > 0.5) & (times(estimates) < 4)
    assert known[early].mean() < learned[early].mean()
    scale = again.calibration().scale
    assert np.allclose(scale, first.calibration().scale, atol=0.03)
