"""The kernels that compare a finger's postures with the cloth in images."""

import numpy as np
import pytest

from tests.cloth_masks import cloth_of
from tracker.vision.cloth import INSIDE, NOTHING, OUTSIDE, cloth_map
from tracker.vision.finger_cloth import (
    SAMPLES,
    UNKNOWN_DEPTH,
    Finger,
    FingerImages,
    beyond_end,
    cloth_window,
    covered,
    finger_evidence,
    finger_joints,
    finger_likelihoods,
    separates,
)
from tracker.vision.rig import ideal_rig

PITCH = 3.0  # px between two samples
AWAY = 0.4  # m from the camera
TRUE = np.array([0.0, 0.0, 0.5, 0.1, 0.9])


def pointing_left() -> Finger:
    """A finger in the middle of the image, seen from the side."""
    R = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
    length, radius = np.array([0.040, 0.025, 0.02]), np.array([0.008, 0.0075, 0.007])
    return Finger(np.array([0.02, 0.0, AWAY]), R, R, length, radius, 0.67)


def test_a_window_is_the_map_from_its_first_sample_on() -> None:
    mask = np.random.default_rng(1).random((120, 128)) < 0.5
    # Samples are 2 px apart, as those of the map: the sample (0, 0) is the map's (4, 8).
    window = np.array([0.0, 16.0, 8.0, 2.0])
    found, _ = cloth_window(cloth_map(cloth_of(mask)), window, ideal_rig().left.optics, False)
    assert np.array_equal(found == INSIDE, mask[4 : 4 + SAMPLES, 8 : 8 + SAMPLES])
    assert np.array_equal(found == OUTSIDE, ~mask[4 : 4 + SAMPLES, 8 : 8 + SAMPLES])


def test_a_capsule_covers_what_is_within_its_radius() -> None:
    rig = ideal_rig()
    at = np.array([[20.0, 30.0], [50.0, 30.0]]) * PITCH  # px: samples 20 and 50 of row 30
    ends = np.column_stack([(at - (rig.cx, rig.cy)) * AWAY / (rig.fx, rig.fy), (AWAY, AWAY)])
    radius = np.array([8.0 * PITCH * AWAY / rig.fx])
    p = covered(ends[None], radius, rig.intrinsics, np.array([0.0, 0.0, 0.0, PITCH]))
    assert p[30, 20:51].min() > 0.95
    assert p[38, 35] == pytest.approx(0.5, abs=0.01)  # on the outline
    assert p[30 + 13, 35] == 0.0 and p[30, 5] == 0.0


def test_cloth_separates_where_it_is_on_the_hand_only() -> None:
    known = np.zeros((SAMPLES, SAMPLES))
    known[20:50, 20:50] = 0.97
    worn = np.where(known > 0.5, INSIDE, OUTSIDE).astype(np.uint8)
    assert separates(worn, known)
    assert not separates(np.full_like(worn, INSIDE), known)
    assert not separates(np.full_like(worn, OUTSIDE), known)
    assert not separates(np.full_like(worn, NOTHING), known)


def test_the_true_posture_explains_the_cloth_best() -> None:
    rig, finger = ideal_rig(), pointing_left()
    windows, maps = [], []
    for shift in (0.0, rig.baseline):
        u = rig.cx - rig.fx * shift / AWAY
        window = np.array([shift, u - SAMPLES / 2 * PITCH, rig.cy - SAMPLES / 2 * PITCH, PITCH])
        joints = finger_joints(TRUE[None], finger)[0]
        joints[3] += finger.radius[2] / finger.length[2] * (joints[2] - joints[3])  # a round end
        ends = np.stack([joints[:-1], joints[1:]], axis=1)
        drawn = covered(ends, finger.radius, rig.intrinsics, window) > 0.5
        classes = np.where(drawn, INSIDE, OUTSIDE).astype(np.uint8)
        free, radius = np.zeros(drawn.shape), float(finger.radius.mean()) * rig.fx / AWAY / PITCH
        maps.append(finger_evidence(classes, free, free, radius, PITCH**2))
        windows.append(window)
    near = TRUE + np.array([0, 0, 1, 1, 1]) * np.random.default_rng(2).normal(0, 0.5, (300, 5))
    postures = np.concatenate([TRUE[None], near])
    images = FingerImages(finger, rig.intrinsics, np.array(windows), np.array(maps), *UNKNOWN_DEPTH)
    values = finger_likelihoods(postures, images)
    tips = finger_joints(near, finger)[:, 3]
    off = np.linalg.norm(tips - finger_joints(TRUE[None], finger)[0, 3], axis=1)
    assert values[0] > 10.0  # of a finger in plain sight, to none
    assert values[1:][off > 0.02].max() < values[0] - 2.0
    # The rim alone: what is left without the inside.
    rims = finger_likelihoods(TRUE[None], images._replace(inside=0.0))
    assert 0.0 < rims[0] < values[0]
    # Nothing continues beyond its end, unlike that of a shorter finger.
    assert beyond_end(TRUE, images) > 0.4
    shorter = finger._replace(length=finger.length * (1.0, 1.0, 0.2))
    assert beyond_end(TRUE, images._replace(finger=shorter)) < -0.25
    # Something else that explains all of the cloth leaves nothing to the finger.
    hidden = finger_evidence(classes, np.full(classes.shape, 0.97), free, radius, PITCH**2)
    one = images._replace(windows=windows[1][None], maps=np.array([hidden]))
    assert abs(finger_likelihoods(TRUE[None], one)[0]) < 0.1 * values[0]
