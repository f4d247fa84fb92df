"""One camera: the hand is found and tracked, with an uncertain distance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.start.mono_start import (
    COVERING,
    UNKNOWN_COVERING,
    best_position,
    measured_sd,
    with_distance_uncertainty,
)
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, BlobFrame, Estimate, ImuSample, Tracking, Validity
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import ideal_rig

TIPS = ("thumb_tip", "index_tip", "middle_tip", "dorsum")


def pattern(rng: np.random.Generator, n: int) -> tuple[Array, np.ndarray]:
    """Markers of a hand's size and hues."""
    return rng.uniform(-0.07, 0.07, (n, 3)), rng.integers(0, 4, n)


@pytest.mark.parametrize("depth", [0.25, 0.4, 0.6])
def test_a_known_pattern_is_placed(depth: float) -> None:
    rng = np.random.default_rng(4)
    markers, hue = pattern(rng, 14)
    place = np.array([0.05, -0.03, depth])
    p = markers[:11] + place  # three are occluded
    seen = p[:, :2] / p[:, 2:] + rng.normal(0, 0.3 / 640, (11, 2))
    seen = np.concatenate([seen, rng.uniform(-0.5, 0.5, (4, 2))])  # four belong to no marker
    hues = np.concatenate([hue[:11], [0, 1, 2, 3]])
    depths = np.geomspace(0.2, 0.75, 8)
    found, score, support = best_position(seen, hues, markers, hue, np.ones(14), depths, 0.012)
    assert found == pytest.approx(place, abs=0.02 * depth)
    assert support >= 11 and score > 9


def run(
    sim: Simulation, blind: str, until: float = np.inf
) -> tuple[Pipeline, list[Estimate], list[float]]:
    """All estimates, and their mean errors (m); a side is blind until a given time."""
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig)
    rows = [pipeline.keypoint_names.index(k) for k in TIPS]
    shown, errors = [], []
    for message in sim.feed():
        if isinstance(message, ImuSample):
            e = pipeline.feed_imu(message)
            if message.seq % 10 == 0:
                shown.append(e)
                true = sim.truth(e.t).keypoints[rows]
                errors.append(float(np.linalg.norm(e.keypoints[rows] - true, axis=1).mean()))
        else:
            assert isinstance(message, BlobFrame)
            pipeline.feed_frame(replace(message, **{blind: None}) if message.t < until else message)
    return pipeline, shown, errors


def simulation(hand: HandModel, glove: GloveModel, seed: int, duration: float) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, seed, duration=duration), seed, fps=20)


@pytest.mark.long
@pytest.mark.parametrize("blind", ["right", "left"])
def test_one_camera_tracks_and_reports_its_uncertainty(hand, glove, blind: str) -> None:
    sim = simulation(hand, glove, 4, 6.0)
    pipeline, shown, errors = run(sim, blind)
    late = shown[10:]
    assert all(e.tracking == Tracking.TRACKING for e in late)
    error = np.array(errors[10:])
    assert error.mean() < 0.030
    sds = np.array([sd_of_sensed_digits(glove, hand, e) for e in late])
    assert np.all(sds > 0.010)  # 6.5 % of the distance, over three axes
    assert np.mean(error < 3 * np.sqrt(3) * sds) > 0.95
    found = pipeline.calibration()
    assert found.hand_length_sd == pytest.approx(0.065 * found.hand_length, rel=0.01)
    assert abs(found.hand_length - sim.wearer.hand_length) < 3 * found.hand_length_sd
    assert np.nanmin(found.scale_sd) >= 0.065  # not the value that the filter fixes


def sd_of_sensed_digits(glove, hand, estimate) -> float:
    """m, mean over keypoints; ring and little finger are inferred in any case."""
    names = glove.keypoint_names(hand)
    rows = [k for k, name in enumerate(names) if not name.startswith(("ring", "little"))]
    return float(np.nanmean(estimate.keypoint_sd[rows]))


@pytest.mark.long
def test_the_second_camera_removes_the_uncertainty(hand, glove) -> None:
    pipeline, shown, errors = run(simulation(hand, glove, 4, 8.0), "right", until=3.0)
    assert sd_of_sensed_digits(glove, hand, shown[25]) > 0.008
    assert sd_of_sensed_digits(glove, hand, shown[-1]) < 0.006
    assert pipeline.calibration().hand_length_sd < 0.02 * hand.length
    assert np.mean(errors[-15:]) < 0.010
    assert pipeline.calibration().hand_length_sd > 0.0005


def test_a_scene_without_a_hand_starts_nothing(hand, glove) -> None:
    sim = simulation(hand, glove, 4, 2.0)
    pipeline, rng = Pipeline(hand, glove, sim.rig), np.random.default_rng(3)
    for message in sim.feed():
        if isinstance(message, ImuSample):
            assert pipeline.feed_imu(message).tracking == Tracking.SEARCHING
        else:
            assert isinstance(message, BlobFrame) and message.left is not None
            anywhere = rng.uniform([0, 0], [1280, 720], message.left.uv.shape)
            strangers = replace(message.left, uv=anywhere)
            pipeline.feed_frame(replace(message, left=strangers, right=None))


def measured_after(
    hand: HandModel, glove: GloveModel, seed: int, start: float, fps: float = 10.0
) -> list[float]:
    """For a hand first seen at ``start`` (s): the largest error (m) of any point called measured,
    for each packet within 1.5 s."""
    sim = Simulation(hand, glove, RandomPostures(hand, seed, duration=9.0), seed, fps=fps)
    pipeline, worst = Pipeline(hand, glove, sim.rig), []
    for message in sim.feed():
        if not start - 0.35 <= message.t <= start + 1.5:
            continue
        if isinstance(message, BlobFrame):
            if message.t >= start:
                pipeline.feed_frame(replace(message, right=None))
            continue
        assert isinstance(message, ImuSample)
        e = pipeline.feed_imu(message)
        sure = e.keypoint_state == int(Validity.MEASURED)
        if sure.any():
            off = np.linalg.norm(e.keypoints - sim.truth(e.t).keypoints, axis=1)
            worst.append(float(off[sure].max()))
    return worst


def test_a_start_in_few_images_is_not_measured_before_it_is_correct(hand, glove) -> None:
    """At ten images per second markers matched their neighbours' blobs: 8 cm wrong, with a small
    sd."""
    assert max(measured_after(hand, glove, 2, 3.1), default=0.0) < 0.05


def test_a_hand_with_few_matches_is_not_measured_while_most_blobs_are_unmatched(
    hand, glove
) -> None:
    """A start with the wrong heading matches 5 of 15 blobs by chance in each image, and is 11 cm
    wrong."""
    assert max(measured_after(hand, glove, 12, 5.2), default=0.0) < 0.05


@pytest.mark.long
def test_a_small_hand_mistaken_for_a_distant_one_is_not_measured_beyond_5_cm(hand, glove) -> None:
    """A hand 8 % shorter than the file's, 42 cm away, plus the error of a start: it was called
    measured and 6 cm wrong for 0.9 s; another, 10 % shorter, for 1.7 s. At a smaller distance the
    error is smaller.
    """
    assert max(measured_after(hand, glove, 9, 2.8), default=0.0) < 0.05
    assert max(measured_after(hand, glove, 57, 3.1, fps=30.0), default=0.0) < 0.05


def test_a_point_is_measured_only_if_people_of_any_size_leave_it_within_5_cm() -> None:
    """Of people's hands, 97 % are within 2.2 standard deviations of a size measured by motion; an
    unmeasured one has 3 of 6.5 %."""
    pose = ideal_rig().pose
    ahead = pose.R_GC @ np.array([0.0, 0.0, 1.0])
    unknown = UNKNOWN_COVERING
    for sds, size_sd, distance, covering in (
        (3, 0.065, 0.2, unknown), (3, 0.065, 0.25, unknown), (2.2, 0.04, 0.34, COVERING)
    ):  # fmt: skip
        p = pose.p_GC + distance * ahead
        limit = measured_sd(p, pose, size_sd)
        of_pose = np.sqrt(limit**2 - (covering * size_sd * distance) ** 2 / 3)
        assert sds * size_sd * distance + 4 * of_pose == pytest.approx(0.05, abs=1e-9)
    assert measured_sd(pose.p_GC + 0.36 * ahead, pose, 0.065) == 0.0
    assert measured_sd(pose.p_GC + 0.36 * ahead, pose, 0.015) > 0.015 * 0.36 / np.sqrt(3)


def test_each_point_of_a_hand_of_unknown_size_may_be_off_along_its_own_ray() -> None:
    """The 99th percentile of people (ANSUR II: 189 mm ± 6.1 %; breadth ± 5.4 % given length, which
    counts half) is 19 % larger than the file's hand of 183 mm: all points of such a hand are at
    1.19 times their estimated distance, and within three standard deviations."""
    mean, half = 189 / 183, np.hypot(0.061 * 189 / 183, 0.054 / 2)
    largest = mean + 2.326 * half
    assert largest == pytest.approx(1.19, abs=0.005)
    pose = ideal_rig().pose
    p = (
        pose.p_GC
        + np.array([[0.0, 0.0, 0.25], [0.05, 0.0, 0.33], [-0.02, 0.1, 0.42]]) @ pose.R_GC.T
    )
    off = np.linalg.norm((largest - 1.0) * (p - pose.p_GC), axis=1)
    sd = with_distance_uncertainty(np.full(3, 0.003), p, pose, 0.065)
    assert np.all(off <= 3 * sd) and np.all(off > 2.4 * sd)
    assert off.max() > 3 * sd.min()  # the nearest point's would not cover the farthest one
