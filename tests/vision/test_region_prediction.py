"""Predicted regions of an image, and how little has to be searched."""

from dataclasses import replace

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, BlobFrame, Blobs, ImuSample, StereoFrame, Tracking
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import ColourProfile, HueRange
from tracker.vision.detector import Detector, detect_frame
from tracker.vision.region_prediction import LONGEST, MARGIN_PX, RegionPrediction, SearchPlan
from tracker.vision.rig import ideal_rig
from tracker.vision.shape_tests import windows_around

RIG = ideal_rig()
AHEAD = RIG.pose.p_GC + 0.4 * RIG.pose.R_GC[:, 2]  # 0.4 m in front of the left camera


def predicted(t: float = 1.0, v: float = 0.0) -> RegionPrediction:
    """Two markers, one red in front of the camera, one blue 5 cm to its right, moving right at v
    m/s."""
    right = RIG.pose.R_GC[:, 0]
    p = np.stack([AHEAD, AHEAD + 0.05 * right])
    speed = np.tile(v * right, (2, 1))
    return RegionPrediction(
        t, p, speed, np.full(2, 0.001), np.full(2, 0.012), np.array([1, 0]), ("blue", "red")
    )


def test_positions_and_hues_match_the_images() -> None:
    left, right = predicted().hints(RIG, 1.0, RIG.pose, ("red", "green", "blue"))
    assert left.uv[0] == pytest.approx([RIG.cx, RIG.cy])
    assert left.uv[1] == pytest.approx([RIG.cx + RIG.fx * 0.05 / 0.4, RIG.cy])
    assert right.uv[0, 0] == pytest.approx(RIG.cx - RIG.fx * RIG.baseline / 0.4)
    assert left.hue.tolist() == [0, 2]
    assert left.radius_px == pytest.approx(np.full(2, RIG.fx * 0.015 / 0.4 + MARGIN_PX))


def test_a_moving_hand_is_extrapolated_with_a_larger_sd() -> None:
    now, later = (predicted(v=1.0).hints(RIG, t, RIG.pose, ("red",))[0] for t in (1.0, 1.03))
    assert later.uv[0, 0] - now.uv[0, 0] == pytest.approx(RIG.fx * 0.03 / 0.4)
    assert np.all(later.radius_px > now.radius_px)
    assert later.hue.tolist() == [0, -1]


def test_velocity_is_computed_from_the_previous_prediction() -> None:
    first = predicted(1.0)
    second = replace(predicted(1.02), p_G=first.p_G + [0.01, 0, 0])
    assert second.after(first).v_G == pytest.approx(np.tile([0.5, 0, 0], (2, 1)))
    assert np.all(replace(second, t=1.0 + 2 * LONGEST).after(first).v_G == 0)
    assert np.all(second.after(None).v_G == 0)


def test_every_sixth_image_is_searched_completely() -> None:
    plan = SearchPlan(every=6)
    whole = [
        plan.hints(predicted(0.01 * k), RIG, 0.01 * k, None, ("red",)) is None for k in range(18)
    ]
    assert [k for k in range(18) if whole[k]] == [5, 11, 17]


def test_images_are_searched_completely_without_a_valid_prediction() -> None:
    plan = SearchPlan()
    assert plan.hints(None, RIG, 1.0, None, ("red",)) is None
    assert plan.hints(predicted(1.0), RIG, 1.2, None, ("red",)) is None  # too old
    behind = replace(predicted(), p_G=RIG.pose.p_GC - RIG.pose.R_GC[:, [2]].T)
    assert plan.hints(behind, RIG, 1.0, None, ("red",)) is None


def test_overlapping_windows_are_merged() -> None:
    uv = np.array([[100.0, 100.0], [110.0, 100.0], [105.0, 108.0]])
    assert windows_around(uv, np.full(3, 20.0), 640, 480, 2).tolist() == [[80, 130, 80, 128, 2]]
    apart = np.array([[100.0, 100.0], [500.0, 400.0], [np.nan, 0.0], [-90.0, 5.0]])
    assert len(windows_around(apart, np.full(4, 20.0), 640, 480, 2)) == 2


@pytest.fixture(scope="module")
def sim(hand: HandModel, glove: GloveModel) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, 4, duration=2.2), 4)


def profile(sim: Simulation) -> ColourProfile:
    """The simulation's hues in another order than the glove's."""
    ranges = {"red": (175, 5), "yellow": (23, 37), "green": (53, 75), "blue": (100, 118)}
    assert set(ranges) == set(sim.glove.hues)
    return ColourProfile("turned", tuple(HueRange(n, ranges[n]) for n in sorted(ranges)))


def found(blobs: Blobs, markers: Array) -> set[tuple[float, float]]:
    """Positions of the blobs that are on a marker (m, 2)."""
    d = np.hypot(*np.moveaxis(blobs.uv[:, None] - markers, 2, 0))
    return {(round(u, 6), round(v, 6)) for u, v in blobs.uv[d.min(axis=1) < 4].tolist()}


def test_regions_find_the_same_as_complete_images(sim: Simulation) -> None:
    """A tracked hand: with the engine's prediction, the same markers as in a complete search."""
    pipeline, seen = Pipeline(sim.hand, sim.glove, sim.rig), None
    detector = Detector(profile(sim), fx=sim.rig.fx)
    names, compared = detector.profile.hue_names, 0
    for message in sim.feed():
        if isinstance(message, ImuSample):
            estimate = pipeline.feed_imu(message)
        elif isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
            if pipeline.take_results() and estimate.tracking == Tracking.TRACKING:
                seen = pipeline.ahead.markers(estimate.t, seen)
        if seen is None or not isinstance(message, BlobFrame) or compared >= 12:
            continue
        t = seen.t - 0.01 + 0.002 * compared
        frame = StereoFrame(t, t, *sim.renderer.pair(t))
        hints = seen.hints(sim.rig, t, sim.rig.pose, names)
        near, whole = detect_frame(detector, frame, hints), detect_frame(detector, frame)
        for side, a, b in ((False, near.left, whole.left), (True, near.right, whole.right)):
            assert a is not None and b is not None
            shown = sim.scene.markers_seen(sim.scene.instant(t), side)
            markers = found(b, shown.uv[shown.visible])
            assert len(markers) >= 5
            assert markers <= found(a, shown.uv[shown.visible])
        compared += 1
    assert compared == 12
