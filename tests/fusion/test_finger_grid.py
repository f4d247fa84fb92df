"""The grid of a finger's postures, by laws of probability and against all cells at once."""

import numpy as np
import pytest

from tracker.fusion.chain.finger_grid import (
    CELL,
    CELLS,
    GRID,
    INDEPENDENT,
    KNUCKLES,
    MOVES,
    PERIOD,
    aged,
    fit,
    prior,
)
from tracker.messages import Array
from tracker.vision.cloth import INSIDE, OUTSIDE
from tracker.vision.finger_cloth import (
    BEND,
    FLEXION,
    JOINT_X,
    JOINT_Y,
    SAMPLES,
    UNKNOWN_DEPTH,
    Finger,
    FingerImages,
    covered,
    finger_evidence,
    finger_joints,
    finger_likelihoods,
)
from tracker.vision.rig import ideal_rig

AWAY, PITCH = 0.4, 3.0  # m from the camera, and px between two samples
NEIGHBOUR = np.array([0.0, 0.0, 0.3, 0.0, 0.5])
TRUE = np.array([0.001, 0.0, 0.62, 0.03, 0.95])


def drawn_finger(posture: Array | None) -> FingerImages:
    """A finger seen from the side by both cameras, in a posture; None: nothing is known of the
    images."""
    rig = ideal_rig()
    R = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
    length, radius = np.array([0.040, 0.025, 0.02]), np.array([0.008, 0.0075, 0.007])
    finger = Finger(np.array([0.02, 0.0, AWAY]), R, R, length, radius, 0.67)
    windows, maps = [], []
    for shift in (0.0, rig.baseline):
        u, v = rig.cx - rig.fx * shift / AWAY, rig.cy
        window = np.array([shift, u - SAMPLES / 2 * PITCH, v - SAMPLES / 2 * PITCH, PITCH])
        classes = np.zeros((SAMPLES, SAMPLES), np.uint8)
        if posture is not None:
            joints = finger_joints(posture[None], finger)[0]
            joints[3] += radius[2] / length[2] * (joints[2] - joints[3])  # a round end
            ends = np.stack([joints[:-1], joints[1:]], axis=1)
            inside = covered(ends, radius, rig.intrinsics, window) > 0.5
            classes = np.where(inside, INSIDE, OUTSIDE).astype(np.uint8)
        free, r = np.zeros(classes.shape), float(radius.mean()) * rig.fx / AWAY / PITCH
        maps.append(finger_evidence(classes, free, free, r, PITCH**2))
        windows.append(window)
    return FingerImages(finger, rig.intrinsics, np.array(windows), np.array(maps), *UNKNOWN_DEPTH)


def test_probabilities_sum_to_one_and_have_the_neighbours_mean() -> None:
    follows, alone = prior(NEIGHBOUR, 0.0), prior(NEIGHBOUR, 1.0)
    for p in (follows, alone, aged(follows, alone, 0.03)):
        assert p.sum() == pytest.approx(1.0, abs=1e-12) and p.min() >= 0.0
    both = prior(NEIGHBOUR, INDEPENDENT)
    assert np.allclose(both, (1 - INDEPENDENT) * follows + INDEPENDENT * alone, atol=1e-15)


def test_a_known_posture_spreads_like_the_motion_of_a_finger() -> None:
    cell = np.argmin(np.abs(GRID - (0.003, 0.0, 0.7, 0.0, 1.0)).sum(axis=1))
    known, flat = np.zeros(len(GRID)), np.full(len(GRID), 1 / len(GRID))
    known[cell] = 1.0
    assert np.array_equal(aged(known, flat, 0.0), known)
    dt = 0.3 * PERIOD
    p, stays = aged(known, flat, dt), 0.6**0.3
    # What remains at this knuckle has moved by a normal distribution; the rest is flat.
    here = p.reshape(KNUCKLES, CELLS)[cell // CELLS]
    mixed = here / here.sum() - (1 - stays) / CELLS
    off = GRID[:CELLS, FLEXION] - GRID[cell, FLEXION]
    sd = np.sqrt(mixed @ off**2 / mixed.sum())
    assert sd == pytest.approx(MOVES[0] * np.sqrt(0.3), abs=0.1 * CELL[FLEXION])
    # After ten minutes nothing is left of it.
    assert np.allclose(aged(known, flat, 600.0), flat, atol=1e-6)


def test_a_knuckle_does_not_bend_backwards_while_the_finger_is_bent() -> None:
    hooked = np.array([0.0, 0.0, 0.0, 0.0, np.deg2rad(100.0)])  # a hook fist, which is possible
    cells = GRID[:, FLEXION] < np.deg2rad(-15.0)
    bent, straight = cells & (GRID[:, BEND] > 1.8), cells & (GRID[:, BEND] < 0.5)
    p = prior(hooked, INDEPENDENT)
    assert p[bent].sum() < 1e-4 * p[straight].sum()
    assert p[np.abs(GRID - hooked)[:, (FLEXION, BEND)].max(axis=1) < 0.15].sum() > 0.02
    for _ in range(20):  # nor does it come to be by motion
        p = aged(p, prior(hooked, INDEPENDENT), 0.1)
    assert p[bent].sum() < 0.02 * p[GRID[:, BEND] > 1.8].sum()


def test_straight_fingers_are_seldom_bent_backwards() -> None:
    """Of people's knuckles, 1 % are bent backwards by more than 12.6 degrees (Leap, DFKI)."""
    straight = np.zeros(5)
    p = prior(straight, INDEPENDENT).reshape(KNUCKLES, CELLS).sum(axis=0)
    backwards = p[GRID[:CELLS, FLEXION] < np.deg2rad(-15.0)].sum()
    half = p[np.abs(GRID[:CELLS, FLEXION] - np.deg2rad(20.0)) < 0.05].sum()
    assert 0.0 < backwards < 0.8 * half  # equal without the limit: as far from straight


def test_the_posture_of_a_hidden_finger_is_one_of_a_finger() -> None:
    """What refutes the neighbour's posture displaces it to others, not beyond all of them."""
    images = drawn_finger(None)
    images.maps[:, 0] = -1.0  # nothing has the glove's colours
    found = fit(prior(NEIGHBOUR, INDEPENDENT), NEIGHBOUR, images, 1.0)
    low, high = GRID[:, FLEXION:].min(axis=0), GRID[:, FLEXION:].max(axis=0)
    assert (found.hidden[FLEXION:] >= low).all() and (found.hidden[FLEXION:] <= high).all()


def test_images_that_show_nothing_change_nothing() -> None:
    before = prior(NEIGHBOUR, INDEPENDENT)
    found = fit(before, NEIGHBOUR, drawn_finger(None), 1.0)
    assert np.allclose(found.posterior, before, atol=1e-15)
    assert np.allclose(found.hidden, NEIGHBOUR, atol=1e-12)
    assert found.evidence == 0.0 and abs(found.follows) < 1e-12


def test_the_fit_is_where_all_cells_together_have_it() -> None:
    """The search evaluates a third of what this does, and divides the best cells."""
    images, before = drawn_finger(TRUE), prior(NEIGHBOUR, INDEPENDENT)
    found = fit(before, NEIGHBOUR, images, 1.0)
    logs = np.log(before) + finger_likelihoods(GRID, images)
    p = np.exp(logs - logs.max())
    mean = p @ GRID / p.sum()
    # Abduction is along the line of sight, where the division of cells makes the difference.
    plane = [JOINT_X, JOINT_Y, FLEXION, BEND]
    assert np.all(np.abs(found.posterior @ GRID - mean)[plane] < 0.25 * CELL[plane])
    # The fit itself is finer than the grid: its tip is within a third of a finger's width.
    postures = np.array([found.weights @ found.postures, TRUE])
    shown, true = finger_joints(postures, images.finger)[:, 3]
    assert np.linalg.norm(shown - true) < 0.005
    assert found.weights.sum() == pytest.approx(1.0)
    assert found.evidence > 10.0
