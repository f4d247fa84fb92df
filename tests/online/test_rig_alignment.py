"""A right camera that has turned since its calibration: measured from markers, and corrected."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings, recorded_settings_from
from tracker.messages import Array, BlobFrame, Blobs, FrameResult, ImuSample, Tracking
from tracker.online.rig_alignment import AlignmentParams, RigAlignment
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.rig_errors import RigErrorParams, true_camera, with_lenses
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import StereoRig, ideal_rig

MARKERS = 16
TURNED = RigErrorParams(pitch_px=2.5, roll_deg=-0.6)


def markers(t: float) -> Array:
    """(n, 3) m in C: a hand that moves about the view."""
    rest = np.random.default_rng(4).uniform([-0.08, -0.05, 0.33], [0.08, 0.05, 0.42], (MARKERS, 3))
    return rest + [0.06 * np.sin(1.3 * t), 0.04 * np.sin(1.7 * t), 0.05 * np.sin(0.7 * t)]


def frames(rig: StereoRig, errors: RigErrorParams, seconds: float, start: float = 0.0) -> list:
    """Blobs of the markers at 30 images per second, with noise of 0.4 px."""
    true, rng, out = true_camera(rig, 1, errors), np.random.default_rng(5), list[BlobFrame]()
    for k in range(int(30 * seconds)):
        t = start + k / 30
        sides = []
        for right, camera in ((False, true.left), (True, true.right)):
            uv = camera.unrectify(true.project(markers(t), right))
            uv = uv + rng.normal(0, 0.4, uv.shape)
            none = np.zeros(MARKERS, np.int64)
            sides.append(Blobs(uv, np.full((MARKERS, 2), 12.0), none, np.ones(MARKERS)))
        out.append(BlobFrame(t, t, ("red",), *sides))
    return out


def fed(alignment: RigAlignment, images: list[BlobFrame]) -> RigAlignment:
    every = np.arange(MARKERS)
    for frame in images:
        alignment.remember(frame)
        nothing = FrameResult.nothing(frame.t, Tracking.TRACKING, MARKERS)
        alignment.learn(replace(nothing, match_left=every, match_right=every))
    return alignment


def rows_apart(rig: StereoRig, frame: BlobFrame) -> float:
    """px, RMS of the rows of the same markers in both rectified images."""
    assert frame.left is not None and frame.right is not None
    apart = rig.right.rectify(frame.right.uv)[:, 1] - rig.left.rectify(frame.left.uv)[:, 1]
    return float(np.sqrt(np.mean(apart**2)))


def test_a_turned_camera_is_measured_reported_once_and_corrected() -> None:
    rig = with_lenses(ideal_rig(), 2)
    alignment = fed(RigAlignment(rig), frames(rig, TURNED, 6.0))
    pitch, _, roll = alignment.rotation
    assert rig.fy * pitch == pytest.approx(2.5, abs=0.25)
    assert np.rad2deg(roll) == pytest.approx(-0.6, abs=0.12)
    after = frames(rig, TURNED, 1.0, 6.0)
    corrected = alignment.aligned(after[0])
    assert rows_apart(rig, after[0]) > 2.0
    assert rows_apart(rig, corrected) < 0.8, "0.57 px are noise"
    fed(alignment, after)
    assert [n.code for n in alignment.notices.drain()] == ["camera.calibrate_again"]


@pytest.mark.long
def test_a_large_shift_is_reported_by_one_notice_until_it_is_gone(hand, glove) -> None:
    """The row watch and the alignment both measure it."""
    motion = RandomPostures(hand, 7, duration=5.0)
    params = SimulationParams(rig_errors=RigErrorParams(pitch_px=5.0))
    sim = Simulation(hand, glove, motion, 7, params, fps=30)
    pipeline = Pipeline(hand, glove, sim.rig)
    for message in sim.feed():
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
        else:
            pipeline.feed_frame(message)
    codes = [n.code for n in pipeline.drain_notices()]
    assert len({"camera.lens_moved", "camera.calibrate_again"} & set(codes)) == len(codes) == 1
    alignment, rig = pipeline.alignment, sim.rig
    alignment.reported = 5.0
    fed(alignment, frames(rig, RigErrorParams(), 4.0, 20.0))
    assert alignment.reported == 0.0, "the next shift is a new one"


def test_the_rest_of_a_board_calibration_is_not_reported() -> None:
    """An exact calibration does not change images by a single bit."""
    rig = ideal_rig()
    for errors in (RigErrorParams(), RigErrorParams(pixel_px=0.3, baseline=0.003)):
        alignment = fed(RigAlignment(rig), frames(rig, errors, 4.0))
        assert alignment.notices.drain() == []
        offset, sd = alignment.offset_px
        assert offset < 0.5 and sd < 0.4
    exact = fed(RigAlignment(rig), frames(rig, RigErrorParams(), 4.0))
    image = frames(rig, RigErrorParams(), 0.1)[0]
    assert exact.aligned(image) is image


def test_a_knocked_lens_is_followed_within_two_seconds() -> None:
    rig = ideal_rig()
    alignment = fed(RigAlignment(rig), frames(rig, RigErrorParams(), 6.0))
    fed(alignment, frames(rig, RigErrorParams(pitch_px=-5.0), 2.0, 6.0))
    assert rig.fy * alignment.rotation[0] == pytest.approx(-5.0, abs=0.5)


def test_before_a_hand_is_found_rows_of_blobs_are_brought_together() -> None:
    rig = ideal_rig()
    alignment, image = RigAlignment(rig), frames(rig, RigErrorParams(pitch_px=4.0), 0.1)[0]
    for _ in range(9):
        alignment.start_from(-4.0)
    assert alignment.aligned(image) is image
    alignment.start_from(-4.0)
    assert rows_apart(rig, alignment.aligned(image)) < 0.8


def test_results_are_those_of_the_image_as_it_arrived() -> None:
    rig = with_lenses(ideal_rig(), 2)
    alignment = fed(RigAlignment(rig), frames(rig, TURNED, 4.0))
    image = frames(rig, TURNED, 0.1, 4.0)[0]
    moved = alignment.aligned(image)
    assert moved.right is not None and image.right is not None
    nothing = FrameResult.nothing(0.0, Tracking.TRACKING, MARKERS)
    back = alignment.restored(replace(nothing, predicted_right=moved.right.uv))
    assert back.predicted_right == pytest.approx(image.right.uv, abs=1e-3)


def test_a_saved_state_resumes_identically() -> None:
    rig, images = ideal_rig(), frames(ideal_rig(), TURNED, 3.0)
    whole, first = fed(RigAlignment(rig), images), fed(RigAlignment(rig), images[:50])
    second = RigAlignment(rig)
    second.set_state(first.get_state())
    fed(second, images[50:])
    assert np.array_equal(second.rotation, whole.rotation)
    assert np.array_equal(second.applied, whole.applied)
    assert second.reported == whole.reported > 0.0
    assert second.notices.drain() == [], "it was reported before"


def test_one_camera_or_the_setting_leaves_images_alone() -> None:
    rig, images = ideal_rig(), frames(ideal_rig(), TURNED, 3.0)
    off = fed(RigAlignment(rig, AlignmentParams(apply=False)), images)
    assert off.aligned(images[0]) is images[0] and off.notices.drain() == []
    single = RigAlignment(with_one_camera(rig))
    fed(single, [replace(frame, right=None) for frame in images[:30]])
    assert not single.rotation.any()


def test_recordings_made_before_are_tracked_as_they_were() -> None:
    def on_problem(path: str, why: str) -> None:
        raise AssertionError(path)

    older = recorded_settings_from({"engine": "chain", "timing": {"sure": 0.002}}, on_problem)
    assert not older.alignment.apply and not older.timing.jitter and older.timing.sure == 0.002
    assert not older.chain.cloth.fingers
    known = {
        "alignment": {"apply": True},
        "timing": {"jitter": True},
        "chain": {"cloth": {"fingers": True}},
    }
    assert recorded_settings_from(known, on_problem) == Settings()
