"""Two free-running cameras: the delay of the right one is measured and compensated."""

from __future__ import annotations

from dataclasses import replace
from functools import reduce

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Blobs, FrameResult, ImuSample, Tracking
from tracker.online import pair_offset
from tracker.online.pair_offset import PairOffset
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import ideal_rig

MARKERS = 10


def frames(late: float, seconds: float, skip_at: float = np.inf) -> list[BlobFrame]:
    """Markers that sway in front of two cameras; from ``skip_at`` on the right one is 33 ms
    late."""
    rig, rng = ideal_rig(), np.random.default_rng(4)
    rest = rng.uniform([-0.05, -0.05, 0.38], [0.05, 0.05, 0.42], (MARKERS, 3))
    hue, out = np.zeros(MARKERS, np.int64), []

    def seen(t: float, right: bool) -> Blobs:
        sway = 0.05 * np.array([np.sin(5 * t), np.sin(6.5 * t), 0.3 * np.sin(3 * t)])
        uv = rig.project(rest + sway, right) + rng.normal(0, 0.3, (MARKERS, 2))
        return Blobs(uv, np.full((MARKERS, 2), 12.0), hue, np.ones(MARKERS))

    for k in range(int(30 * seconds)):
        t = k / 30
        more = 1 / 30 if t > skip_at else 0.0
        left, right = seen(t, False), seen(t + late + more, True)
        out.append(BlobFrame(t, t, ("red",), left, right))
    return out


def matched(frame: BlobFrame) -> FrameResult:
    every = np.arange(MARKERS)
    nothing = FrameResult.nothing(frame.t, Tracking.TRACKING, MARKERS)
    return replace(nothing, match_left=every, match_right=every)


def fed(pair: PairOffset, images: list[BlobFrame]) -> PairOffset:
    for frame in images:
        pair.remember(frame)
        pair.learn(matched(frame))
    return pair


@pytest.mark.parametrize("late", [-0.012, 0.0, 0.015])
def test_a_known_offset_is_found_to_a_millisecond(late: float) -> None:
    pair = fed(PairOffset(ideal_rig()), frames(late, 6.0))
    assert pair.estimate.value == pytest.approx(late, abs=0.001)
    assert pair.estimate.sd < 0.001
    assert pair.applied == (pair.estimate.value if late else 0.0)  # synchronised: unchanged


def test_a_camera_that_skips_an_image_is_detected_within_four_seconds() -> None:
    pair = fed(PairOffset(ideal_rig()), frames(0.005, 14.0, skip_at=10.0))
    assert pair.estimate.value == pytest.approx(0.005 + 1 / 30, abs=0.002)


def test_markers_are_moved_back_to_their_positions() -> None:
    rig, pair = ideal_rig(), PairOffset(ideal_rig())
    p_C = np.array([[0.0, 0.0, 0.4], [0.05, 0.02, 0.42]])
    pose = rig.pose
    then = p_C @ pose.R_GC.T + pose.p_GC
    late = then + np.array([0.012, -0.006, 0.004])  # 15 ms at 1 m/s
    uv = rig.project((late - pose.p_GC) @ pose.R_GC, right=True)
    far = np.array([[1200.0, 700.0]])
    blobs = Blobs(np.vstack([uv, far]), np.full((3, 2), 9.0), np.zeros(3, np.int64), np.ones(3))
    frame = BlobFrame(0.0, 0.0, ("red",), blobs, blobs)
    moved = pair.moved_back(frame, then, late)
    assert moved.right is not None and moved.left is blobs
    assert moved.right.uv[:2] == pytest.approx(rig.project(p_C, right=True), abs=1e-6)
    assert np.array_equal(moved.right.uv[2:], far)


def test_a_saved_state_resumes_identically() -> None:
    images = frames(0.01, 5.0)
    whole, first = fed(PairOffset(ideal_rig()), images), fed(PairOffset(ideal_rig()), images[:70])
    second = PairOffset(ideal_rig())
    second.set_state(first.get_state())
    assert fed(second, images[70:]).estimate == whole.estimate


def test_one_camera_has_no_offset() -> None:
    pair = PairOffset(with_one_camera(ideal_rig()))
    fed(pair, [replace(frame, right=None) for frame in frames(0.01, 3.0)])
    assert pair.applied == 0.0 and pair.estimate.sd == np.inf


def mean_error(sim: Simulation, in_step: bool) -> tuple[Pipeline, float]:
    """m, of all keypoints in the second half; whether the offset may be compensated."""
    pipeline, errors = Pipeline(sim.hand, sim.glove, sim.rig), []
    for message in sim.feed():
        if isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
            if not in_step:
                pipeline.pair_offset = PairOffset(sim.rig)
        elif isinstance(message, ImuSample):
            e = pipeline.feed_imu(message)
            if message.t > sim.duration / 2 and message.seq % 5 == 0:
                off = e.keypoints - sim.truth(e.t).keypoints
                errors.append(np.linalg.norm(off, axis=1).mean())
    return pipeline, float(np.mean(errors))


@pytest.mark.long
def test_two_free_running_cameras_track_nearly_as_well_as_synchronised_ones(
    hand: HandModel, glove: GloveModel
) -> None:
    motion = RandomPostures(hand, 4, 1.5, duration=10.0)
    free = Simulation(hand, glove, motion, 4, SimulationParams(right_late=0.016), fps=30)
    together = Simulation(hand, glove, motion, 4, fps=30)
    pipeline, error = mean_error(free, in_step=True)
    assert pipeline.pair_offset.estimate.value == pytest.approx(0.016, abs=0.003)
    assert error < 1.25 * mean_error(together, in_step=True)[1]


@pytest.mark.parametrize("seed", range(20))
def test_markers_of_three_images_are_the_common_ones(seed: int) -> None:
    rng = np.random.default_rng(seed)
    images = [np.flatnonzero(rng.random(12) < rng.random()) for _ in range(3)]
    common = reduce(np.intersect1d, images)
    rows = pair_offset._in_all(*images)
    assert len(rows) == len(common)
    for image, row in zip(images, rows.T, strict=True):
        assert image[row].tolist() == common.tolist()
