"""A glove of the other hand than in its files is detected; our left files mirror the right ones."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.engine.side_watch import SideWatch
from tracker.glove import library
from tracker.glove.mirror import mirrored_glove, mirrored_hand
from tracker.messages import BlobFrame, ImuSample, Tracking
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

RIGHT = ("vist-small", "reference-right")
LEFT = ("vist-small-left", "reference-left")


def test_the_files_of_both_sides_are_mirror_images() -> None:
    (hand, glove), (left_hand, left_glove) = library.load(*RIGHT), library.load(*LEFT)
    other, other_glove = mirrored_hand(hand), mirrored_glove(glove)
    assert other.side == left_hand.side and other_glove.side == left_glove.side
    for mine, theirs in zip(other.segments, left_hand.segments, strict=True):
        np.testing.assert_allclose(mine.origin, theirs.origin, atol=1e-9)
        np.testing.assert_allclose(mine.R_rest, theirs.R_rest, atol=1e-6)
    np.testing.assert_allclose(other.angle_limits, left_hand.angle_limits, atol=1e-6)
    assert other.synergies == left_hand.synergies
    np.testing.assert_allclose(other_glove.marker_position, left_glove.marker_position, atol=1e-9)
    np.testing.assert_allclose(other_glove.marker_normal, left_glove.marker_normal, atol=1e-9)
    for a, b in zip(other_glove.imus, left_glove.imus, strict=True):
        np.testing.assert_allclose(a.R_BI, b.R_BI, atol=1e-9)


@pytest.mark.long
@pytest.mark.parametrize(
    ("worn", "not_found", "expected"),
    [
        (LEFT, Tracking.SEARCHING, ["left"]),
        (LEFT, Tracking.LOST, ["left"]),  # found by mistake before
        (RIGHT, Tracking.SEARCHING, []),
    ],
)
def test_a_left_glove_with_right_files_is_reported_once(worn, not_found, expected) -> None:
    hand, glove = library.load(*worn)
    sim = Simulation(hand, glove, RandomPostures(hand, 0, duration=4.0), 0, fps=20)
    own_hand, own_glove = library.load(*RIGHT)
    pipeline = Pipeline(own_hand, own_glove, sim.rig)
    watch, reported = SideWatch(pipeline, delay=0.3), []
    for message in sim.feed():
        if isinstance(message, ImuSample):
            tracking = pipeline.feed_imu(message).tracking
            watch.packet(message, not_found if tracking == Tracking.SEARCHING else tracking)
        elif isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
            watch.frame(message)
        reported += watch.notices.drain()
    assert [n.code for n in reported] == ["glove.other_hand"] * len(expected)
    assert [n.values["other"] for n in reported] == list(expected)
    assert watch.is_other == bool(expected)
