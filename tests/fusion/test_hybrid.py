"""The hybrids of the 2020 paper on the real glove: finger markers are not used."""

import numpy as np
import pytest

from tests.fusion.test_chain_engine import errors, feed, times
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Validity
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation


@pytest.fixture(scope="module")
def sim(hand: HandModel, glove: GloveModel) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, 1, duration=6.0), 1, fps=30)


@pytest.mark.long
@pytest.mark.parametrize("engine", ["switching", "madgwick"])
def test_follows_the_fingers_by_their_imus_alone(sim: Simulation, engine: str) -> None:
    """Mounting and bias are not estimated here, so a few centimetres at the tips are expected."""
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig, Settings(engine=engine))
    estimates = feed(pipeline, sim.feed())
    error = errors(sim, estimates)[times(estimates) > 2]
    assert error[:, 3].mean() < 0.005, "the dorsum has its markers"
    assert error[:, 1:3].mean() < 0.030
    results = pipeline.take_results()
    finger = [m.id for m in sim.glove.markers if m.segment != "dorsum"]
    assert results and all(np.all(r.match_left[finger] == -1) for r in results)
    state = dict(zip(sim.hand.joint_names, estimates[-1].angle_state, strict=True))
    assert state["middle_pip_flexion"] == Validity.MEASURED


@pytest.mark.long
def test_resumes_identically_from_a_saved_state(sim: Simulation) -> None:
    messages = list(sim.feed())
    first = Pipeline(sim.hand, sim.glove, sim.rig, Settings(engine="switching"))
    feed(first, messages[:300])
    second = Pipeline(sim.hand, sim.glove, sim.rig, Settings(engine="switching"))
    second.set_state(first.get_state())
    a, b = feed(first, messages[300:500]), feed(second, messages[300:500])
    assert all(np.array_equal(x.keypoints, y.keypoints) for x, y in zip(a, b, strict=True))


def test_an_unknown_engine_is_rejected(sim: Simulation) -> None:
    with raises(ConfigError, "part.unknown"):
        Pipeline(sim.hand, sim.glove, sim.rig, Settings(engine="magic"))
