"""A simulated session is a stream of messages as from real devices."""

import numpy as np
import pytest

from tracker.base.clock import nanoseconds, seconds
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, ImuSample, StereoFrame
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation


@pytest.fixture(scope="module")
def simulation(hand: HandModel, glove: GloveModel) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, 1, duration=6), 1, fps=30.0)


def test_messages_are_in_order_of_arrival_at_their_rates(simulation: Simulation) -> None:
    messages = list(simulation.feed())
    arrivals = np.array([m.t_arrival for m in messages])
    assert np.all(np.diff(arrivals) >= 0)
    imu = [m for m in messages if isinstance(m, ImuSample)]
    frames = [m for m in messages if isinstance(m, BlobFrame)]
    assert len(imu) == pytest.approx(600, abs=2) and len(frames) == pytest.approx(180, abs=2)
    delays = np.array([f.t_arrival - f.t for f in frames])
    assert delays.min() >= 0.030 and delays.max() <= 0.050
    assert [f.index for f in frames] == list(range(len(frames)))


def test_times_are_integer_nanoseconds(simulation: Simulation) -> None:
    for message, _ in zip(simulation.feed(), range(200), strict=False):
        for t in (message.t, message.t_arrival):
            assert seconds(nanoseconds(t)) == t


def test_feed_is_reproducible(simulation: Simulation, hand: HandModel, glove: GloveModel) -> None:
    again = Simulation(hand, glove, RandomPostures(hand, 1, duration=6), 1, fps=30.0)
    for one, other, _ in zip(simulation.feed(), again.feed(), range(120), strict=False):
        assert one.t_arrival == other.t_arrival
        if isinstance(one, ImuSample) and isinstance(other, ImuSample):
            np.testing.assert_array_equal(one.accel, other.accel)
        elif isinstance(one, BlobFrame) and isinstance(other, BlobFrame):
            assert one.left is not None and other.left is not None
            np.testing.assert_array_equal(one.left.uv, other.left.uv)


def test_stereo_blobs_triangulate_to_true_markers(simulation: Simulation) -> None:
    """Rows agree in both images and the points are on the wearer's true markers."""
    t = 1.0
    now, rig = simulation.scene.instant(t), simulation.rig
    left, right = (simulation.scene.markers_seen(now, side) for side in (False, True))
    both = left.visible & right.visible
    p_C = rig.triangulate(left.uv[both], right.uv[both])
    segment = simulation.wearer.marker_segment[both]
    true = now.p_CB[segment] + np.einsum("nij,nj->ni", now.R_CB[segment], now.markers[both])
    gap = np.linalg.norm(p_C - true, axis=1)
    assert both.sum() >= 8
    assert (
        np.median(gap) < 2e-3 and gap.max() < 8e-3
    )  # the visible centroid of curved patches is off their centre


def test_truth_is_the_wearers_hand(simulation: Simulation, glove: GloveModel) -> None:
    truth = simulation.truth(2.0)
    names = glove.keypoint_names(simulation.hand)
    assert truth.keypoints.shape == (len(names), 3)
    np.testing.assert_allclose(truth.keypoints[names.index("wrist")], truth.p_GB[0])
    size = np.linalg.norm(truth.keypoints[names.index("middle_mcp")] - truth.p_GB[0])
    assert size != pytest.approx(0.082, abs=1e-4)  # not the reference hand
    assert size == pytest.approx(0.082, rel=0.15)


def test_images_are_stereo_frames(simulation: Simulation) -> None:
    frame = next(iter(simulation.frames(images=True)))
    assert isinstance(frame, StereoFrame)
    assert frame.left is not None and frame.left.shape == (720, 1280, 3)
    assert frame.right is not None and frame.right.dtype == np.uint8
