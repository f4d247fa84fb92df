"""A second engine next to the first one gets the same input and gives the result it gives alone."""

import time

import numpy as np
import pytest

from tests.live.test_runner import live, profile, sim
from tracker.base.errors import ConfigError
from tracker.engine.hands import Hands, Sided
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.engine import ChainEngine
from tracker.live.reference import ReferenceEngine
from tracker.messages import BlobFrame, ImuSample

__all__ = ["profile", "sim"]  # fixtures


def wait_until(condition, limit: float = 60.0) -> bool:
    deadline = time.monotonic() + limit
    while time.monotonic() < deadline:
        if condition():
            return True
        time.sleep(0.01)
    return False


def test_a_reference_equals_the_engine_alone(sim):
    messages = [m for m in sim.feed() if isinstance(m, ImuSample | BlobFrame)]
    settings = Settings(engine="switching")
    alone = Pipeline(sim.hand, sim.glove, sim.rig, settings)
    reference = ReferenceEngine(
        Hands({"right": lambda: Pipeline(sim.hand, sim.glove, sim.rig, settings)})
    )
    last = None
    for message in messages:
        if isinstance(message, ImuSample):
            reference.put(Sided(message, "right"))
            last = alone.feed_imu(message)
        else:
            reference.put(message)
            alone.feed_frame(message)
    assert wait_until(lambda: getattr(reference.estimate("right"), "t", None) == last.t)
    np.testing.assert_array_equal(reference.estimate("right").keypoints, last.keypoints)
    assert reference.engine == "switching"
    reference.close()
    reference.close()


def test_a_live_tracker_starts_changes_and_stops_its_reference(sim, profile):
    tracker, _ = live(sim, profile, None)
    with pytest.raises(ConfigError):
        tracker.set_reference("none such")
    tracker.set_reference("vist")
    tracker.start()
    assert wait_until(lambda: tracker.hand("right").reference_estimate() is not None)
    assert tracker.settings.engine == "chain"
    tracker.set_reference(None)
    assert tracker.hand("right").reference_estimate() is None
    tracker.set_reference("madgwick")
    tracker.stop()
    assert tracker.hand("right").reference_estimate() is None


def test_a_command_runs_in_the_engines_thread_and_its_errors_are_reported(sim, profile):
    tracker, _ = live(sim, profile, None)
    seen = []

    def refuse(engine) -> None:
        seen.append(engine)
        raise ConfigError("That cannot be done.")

    tracker.hand("right").command(refuse)
    tracker.start()
    assert wait_until(lambda: any("That cannot be done." in e.text for e in tracker.drain_events()))
    assert isinstance(seen[0], ChainEngine)
    tracker.stop()
