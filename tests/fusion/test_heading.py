"""The standard deviation of the heading is reported, and grows while no image corrects it."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.engine import ChainEngine
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import ImuSample
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation


def heading(R: np.ndarray) -> float:
    """rad about the vertical in a rotation (3, 3)."""
    return float(np.arctan2(R[1, 0] - R[0, 1], R[0, 0] + R[1, 1]))


@pytest.mark.long
def test_without_images_the_heading_error_matches_its_sd(
    hand: HandModel, glove: GloveModel
) -> None:
    sim = Simulation(hand, glove, RandomPostures(hand, 3, duration=12.0), 3)
    pipeline, off, sds = Pipeline(hand, glove, None, Settings(engine="inertial")), [], []
    engine = pipeline.engine
    assert isinstance(engine, ChainEngine) and np.isnan(engine.heading_sd)
    for sample in sim.imu_samples():
        e = pipeline.feed_imu(sample)
        if sample.seq % 50 == 0 and sample.t > 1.0:
            off.append(heading(e.segment_R[0] @ sim.truth(e.t).R_GB[0].T))
            sds.append(engine.heading_sd)
    drift = np.unwrap(off) - off[0]
    assert sds[-1] > sds[0]
    assert np.mean(np.abs(drift) < 3 * np.array(sds)) > 0.95
    assert np.abs(drift).max() > 0.2 * sds[-1]  # and not ten times too large


def test_an_image_corrects_it(hand: HandModel, glove: GloveModel) -> None:
    sim = Simulation(hand, glove, RandomPostures(hand, 3, duration=4.0), 3, fps=20)
    pipeline, sds = Pipeline(hand, glove, sim.rig), []
    engine = pipeline.engine
    assert isinstance(engine, ChainEngine)
    for message in sim.feed():
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
            sds.append(engine.heading_sd)
        elif message.t < 2.0:  # then the camera is removed
            pipeline.feed_frame(message)
    held, gone = sds[190], sds[-1]
    assert 1.1 * held < gone < np.deg2rad(10.0)
