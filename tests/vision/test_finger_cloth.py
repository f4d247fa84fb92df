"""The kernels that compare a finger's postures with the cloth in images."""

import numpy as np
import pytest

from tests.cloth_masks import cloth_of
from tracker.vision.cloth import cloth_map
from tracker.vision.finger_cloth import (
    EACH,
    Finger,
    cloth_window,
    covered,
    finger_evidence,
    finger_joints,
    finger_likelihoods,
)
from tracker.vision.rig import ideal_rig
from tracker.vision.tip_scan import INSIDE, OUTSIDE

SIDE, PITCH = 96, 3.0  # samples, and px between two
AWAY = 0.4  # m from the camera
TRUE = np.array([0.0, 0.0, 0.5, 0.1, 0.9])


def pointing_left() -> Finger:
    """A finger in the middle of the image, seen from the side."""
    R = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
    length, radius = np.array([0.040, 0.025, 0.02]), np.array([0.008, 0.0075, 0.007])
    return Finger(np.array([0.02, 0.0, AWAY]), R, R, length, radius, 0.67)


def test_a_window_is_the_map_between_its_nodes() -> None:
    mask = np.random.default_rng(1).random((40, 48)) < 0.5
    steps = np.arange(3.0) * EACH * 2
    nodes = np.stack(np.meshgrid(16.0 + steps, 8.0 + steps), axis=-1)
    found = cloth_window(cloth_map(cloth_of(mask)), nodes)
    # Samples are 2 px apart, as those of the map: the sample (0, 0) is the map's (4, 8).
    assert np.array_equal(found == INSIDE, mask[4 : 4 + 2 * EACH, 8 : 8 + 2 * EACH])
    assert np.array_equal(found == OUTSIDE, ~mask[4 : 4 + 2 * EACH, 8 : 8 + 2 * EACH])


def test_a_capsule_covers_what_is_within_its_radius() -> None:
    p = covered(np.array([[20.0, 30.0, 50.0, 30.0, 8.0]]), 64)
    assert p[30, 20:51].min() > 0.95
    assert p[38, 35] == pytest.approx(0.5, abs=0.01)  # on the outline
    assert p[30 + 13, 35] == 0.0 and p[30, 5] == 0.0


def test_the_true_posture_explains_the_cloth_best() -> None:
    rig, finger = ideal_rig(), pointing_left()
    windows, maps = [], []
    for shift in (0.0, rig.baseline):
        u = rig.cx - rig.fx * shift / AWAY
        window = np.array([shift, u - SIDE / 2 * PITCH, rig.cy - SIDE / 2 * PITCH, PITCH])
        joints = finger_joints(TRUE[None], finger)[0]
        joints[3] += finger.radius[2] / finger.length[2] * (joints[2] - joints[3])  # a round end
        uv = (rig.project(joints, shift > 0) - window[1:3]) / PITCH
        r = finger.radius * rig.fx / AWAY / PITCH
        drawn = covered(np.column_stack([uv[:-1], uv[1:], r]), SIDE) > 0.5
        classes = np.where(drawn, INSIDE, OUTSIDE).astype(np.uint8)
        free, radius = np.zeros(drawn.shape), float(r.mean())
        maps.append(finger_evidence(classes, free, radius, PITCH**2))
        windows.append(window)
    near = TRUE + np.array([0, 0, 1, 1, 1]) * np.random.default_rng(2).normal(0, 0.5, (300, 5))
    postures = np.concatenate([TRUE[None], near])
    values = finger_likelihoods(postures, finger, rig.intrinsics, np.array(windows), np.array(maps))
    tips = finger_joints(near, finger)[:, 3]
    off = np.linalg.norm(tips - finger_joints(TRUE[None], finger)[0, 3], axis=1)
    assert values[0] > 10.0  # of a finger in plain sight, to none
    assert values[1:][off > 0.02].max() < values[0] - 2.0
    # Something else that explains all of the cloth leaves nothing to the finger.
    hidden = finger_evidence(classes, np.full(classes.shape, 0.97), radius, PITCH**2)
    nothing = finger_likelihoods(
        TRUE[None], finger, rig.intrinsics, windows[1][None], np.array([hidden])
    )
    assert abs(nothing[0]) < 0.1 * values[0]
