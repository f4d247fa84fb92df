"""A glove that is unplugged while its hand remains in view."""

from __future__ import annotations

import numpy as np

from tracker.engine.pipeline import Pipeline
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, ImuSample, Tracking, Validity
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation


def test_images_alone_track_a_hand_but_measure_nothing(hand: HandModel, glove: GloveModel) -> None:
    """Tracking continues as long as possible; the posture between a few blobs is a guess."""
    sim = Simulation(hand, glove, RandomPostures(hand, 2, duration=4.5), 2, fps=20)
    pipeline, before, after, back = Pipeline(hand, glove, sim.rig), [], [], []
    for message in sim.feed():
        if isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
            shown = pipeline.predict(message.t)
            measured = int(np.sum(shown.keypoint_state == int(Validity.MEASURED)))
            if 1.5 < message.t < 2.0:
                before.append(measured)
            elif 2.7 < message.t < 3.5:
                after.append((measured, shown.tracking))
            elif message.t > 4.0:
                back.append(measured)
        elif isinstance(message, ImuSample) and not 2.0 < message.t < 3.5:
            pipeline.feed_imu(message)
    assert max(before) > 5
    assert max(back) > 5
    assert not any(measured for measured, _ in after)
    assert any(tracking == Tracking.TRACKING for _, tracking in after)
