"""How far away the cloth is, from a texture that both cameras see."""

import numpy as np

from tracker.messages import Array
from tracker.vision.cloth import INSIDE, OUTSIDE
from tracker.vision.cloth_depth import (
    FEWEST,
    GAIN,
    HALF,
    LEVELS,
    MOST,
    NEAREST_LEVEL,
    NOISE,
    depth_evidence,
    matches,
)
from tracker.vision.finger_cloth import (
    DEPTHS,
    SAMPLES,
    Finger,
    FingerImages,
    covered,
    finger_evidence,
    finger_joints,
    finger_likelihoods,
    surface_levels,
)
from tracker.vision.rig import ideal_rig

PALM, RAISED = 11, 6  # levels of the palm and of what is in front of it
AWAY, PITCH = 0.4, 3.2  # m from the camera, px between two samples


def seen_by_right(left: Array, level: Array) -> Array:
    """The right window of surfaces with the texture and the levels (n, n) of the left one; nearer
    ones are in front."""
    out = np.zeros_like(left)
    for k in range(LEVELS - 1, -1, -1):
        y, x = np.nonzero(level == k)
        to = x - (NEAREST_LEVEL - k)
        kept = (to >= 0) & (to < left.shape[1])
        out[y[kept], to[kept]] = left[y[kept], x[kept]]
    return out


def texture(seed: int) -> Array:
    return np.random.default_rng(seed).choice([-1, 1], (SAMPLES, SAMPLES)).astype(np.int32)


def test_a_texture_matches_at_the_distance_of_its_surface() -> None:
    left, level = texture(1), np.full((SAMPLES, SAMPLES), PALM)
    level[20:60, 30:50] = RAISED
    found = np.argmax(matches(left, seen_by_right(left, level)), axis=0)
    assert (found[12:28, 17:23] == RAISED).all()
    assert (found[33:45, 5:42] == PALM).all()


def test_matches_are_the_correlation_of_squares() -> None:
    rng = np.random.default_rng(3)
    left, right = (rng.choice([-1, 0, 1], (SAMPLES, SAMPLES)).astype(np.int32) for _ in range(2))
    right[:, :90] = np.where(rng.uniform(size=(SAMPLES, 90)) < 0.7, left[:, 6:], right[:, :90])
    found = matches(left, right)
    for k, y, x in [(2, 40, 50), (2, 10, 8), (NEAREST_LEVEL, 70, 30), (14, 20, 60)]:
        assert left[y, x] != 0
        shift, square = NEAREST_LEVEL - k, np.s_[y - HALF : y + HALF + 1]
        a = left[square, x - HALF : x + HALF + 1]
        b = right[square, x - HALF - shift : x + HALF + 1 - shift]
        count = np.count_nonzero(a * b)
        c = np.clip((a * b).sum() / (count + NOISE), 0.0, 0.95) * (count >= FEWEST)
        assert np.isclose(found[k, y // 2, x // 2], (1.0 - c**2) ** (-0.5 * GAIN), rtol=1e-5)


def test_the_surface_decides_which_fingers_are_possible() -> None:
    classes = np.full((SAMPLES, SAMPLES), INSIDE, np.uint8)
    classes[:, :20] = OUTSIDE
    left, level = texture(1), np.full((SAMPLES, SAMPLES), PALM)
    level[20:60, 30:50] = RAISED
    found = matches(left, seen_by_right(left, level))
    palm = np.full((DEPTHS, DEPTHS), 0.97)
    palm_level = palm * 0.0 + PALM
    inside = depth_evidence(found, classes, palm, palm_level)[:, 1:-1, 1:-1]
    # Where something is in front of the palm, a finger is there and not nearer; elsewhere none is.
    assert np.median(inside[RAISED, 13:27, 18:22]) > 2.0
    assert np.median(inside[RAISED - 4, 13:27, 18:22]) < -1.0
    assert np.median(inside[RAISED, 33:45, 13:42]) < -2.0
    # The palm explains its own surface, so a finger behind it is neither confirmed nor refuted.
    assert abs(np.median(inside[LEVELS - 1, 33:45, 13:42])) < 0.1
    assert not inside[:, :, :10].any() and np.abs(inside).max() <= MOST
    # Without texture all distances are alike.
    flat, some = np.ones((LEVELS, 12, 12), np.float32), np.s_[14:26, 14:26]
    small = classes[28:52, 28:52].copy(), palm[some].copy(), palm_level[some].copy()
    assert np.abs(depth_evidence(flat, *small)).max() < 1e-6


def test_the_nearest_surface_is_that_of_the_capsules() -> None:
    rig, window = ideal_rig(), np.array([0.0, 0.0, 0.0, PITCH])
    window[1:3] = rig.cx - SAMPLES / 2 * PITCH, rig.cy - SAMPLES / 2 * PITCH
    disparity = np.array([rig.fx * rig.baseline / PITCH, 40.0])
    ends = np.array(
        [[[-0.05, 0.0, 0.40], [0.05, 0.0, 0.40]], [[0.0, -0.05, 0.37], [0.0, 0.05, 0.37]]]
    )
    found = surface_levels(ends, np.array([0.01, 0.008]), rig.intrinsics, window, disparity)
    middle = DEPTHS // 2
    assert abs(found[middle, middle] - (40.0 - disparity[0] / (0.37 - 0.008))) < 0.02
    assert abs(found[middle, middle + 9] - (40.0 - disparity[0] / (0.40 - 0.01))) < 0.02
    assert np.isinf(found[5, 5])


def folded(towards: float) -> tuple[Finger, Array]:
    """A finger in front of the palm and the posture in which its tip is nearer to the camera."""
    R = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    length, radius = np.array([0.040, 0.025, 0.02]), np.array([0.008, 0.0075, 0.007])
    finger = Finger(np.array([0.0, 0.04, AWAY - 0.02]), R, R, length, radius, 0.67)
    return finger, np.array([0.0, 0.0, towards, 0.0, 0.2])


def test_a_finger_in_front_of_the_palm_is_found_without_an_outline() -> None:
    rig = ideal_rig()
    finger, true = folded(0.5)
    joints = finger_joints(true[None], finger)[0]
    assert joints[3, 2] < joints[0, 2] - 0.02  # nearer than its knuckle
    windows = np.array(
        [
            [
                b,
                rig.cx - rig.fx * b / AWAY - SAMPLES / 2 * PITCH,
                rig.cy - SAMPLES / 2 * PITCH,
                PITCH,
            ]
            for b in (0.0, rig.baseline)
        ]
    )
    disparity = np.array(
        [rig.fx * rig.baseline / PITCH, NEAREST_LEVEL + (windows[0, 1] - windows[1, 1]) / PITCH]
    )
    ends = np.stack([joints[:-1], joints[1:]], axis=1)
    drawn = surface_levels(ends, finger.radius, rig.intrinsics, windows[0], disparity)
    palm = np.full(drawn.shape, disparity[1] - disparity[0] / (AWAY + 0.02))
    surface = np.clip(np.round(np.minimum(drawn, palm)), 0, LEVELS - 1)
    surface = np.repeat(np.repeat(surface, 2, axis=0), 2, axis=1)
    classes, known = np.full(surface.shape, INSIDE, np.uint8), np.full(surface.shape, 0.97)
    left = texture(7)
    found = matches(left, seen_by_right(left, surface))
    depth = depth_evidence(found, classes, known[::2, ::2].copy(), palm)
    none, r = np.zeros(surface.shape), float(finger.radius.mean()) * rig.fx / AWAY / PITCH
    maps = np.array([finger_evidence(classes, known, none, r, PITCH**2)] * 2)
    images = FingerImages(finger, rig.intrinsics, windows, maps, depth, disparity)
    near = true + np.array([0, 0, 1, 1, 1]) * np.random.default_rng(2).normal(0, 0.5, (300, 5))
    values = finger_likelihoods(np.concatenate([true[None], near]), images)
    blind = finger_likelihoods(true[None], images._replace(depth=depth[:0]))
    tips = finger_joints(near, finger)[:, 3]
    off = np.linalg.norm(tips - joints[3], axis=1)
    assert values[0] > blind[0] + 10.0
    assert np.abs(blind[0]) < 1.0
    assert values[1:][off > 0.025].max() < values[0] - 1.5
    assert covered(ends, finger.radius, rig.intrinsics, windows[0]).max() > 0.9
