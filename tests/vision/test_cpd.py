"""EM kernels against plain numpy twins, and matching with known ground truth."""

import numpy as np
import pytest

from tests.benchmarks.matching import hand_points, ours, right
from tracker.messages import CameraPose
from tracker.vision.correspondence import TranslationParams, match_translation
from tracker.vision.cpd import (
    ExpectedMarkers,
    HuedPixels,
    HuedPoints,
    ParallaxMixture,
    TranslationMixture,
    parallax_em,
    translation_em,
)
from tracker.vision.rig import ideal_rig
from tracker.vision.stereo import all_pairs, match_stereo

RIG = ideal_rig(pose=CameraPose(np.eye(3), np.zeros(3)))
FOCAL = RIG.fx * RIG.baseline


def numpy_parallax(left, left_hue, right, right_hue, zeta, sd_u, sd_v, outlier, iterations):
    du = left[:, None, 0] - right[None, :, 0]
    dv = (left[:, None, 1] - right[None, :, 1]) / sd_v
    same = (left_hue[:, None] == right_hue[None]) & (np.abs(dv) <= 4)
    s = sd_u[1]
    for _ in range(iterations):
        g = np.where(same, np.exp(-0.5 * (((du - zeta) / s) ** 2 + dv**2)), 0)
        P = g / (g.sum(axis=1, keepdims=True) + outlier / (1 - outlier) * 2 / 9)
        zeta = (P * du).sum() / P.sum()
        s = float(np.clip(np.sqrt((P * (du - zeta) ** 2).sum() / P.sum()), *sd_u))
    return zeta, s


def numpy_translation(points, hue, cov, markers, marker_hue, prior, w, volume, sd, iterations):
    eta = np.zeros(3)
    schedule = np.append(np.geomspace(*sd, iterations), sd[1])
    for step, s in enumerate(schedule):
        C = cov + s * s * np.eye(3)
        W = np.linalg.inv(C)
        d = points[:, None] - markers[None] - eta
        d2 = np.einsum("nmi,nij,nmj->nm", d, W, d)
        density = np.exp(-0.5 * d2) / np.sqrt((2 * np.pi) ** 3 * np.linalg.det(C))[:, None]
        g = (1 - w) * prior * density * (hue[:, None] == marker_hue[None])
        P = g / (g.sum(axis=1, keepdims=True) + w / volume)
        if step < iterations:
            A = np.einsum("nm,nij->ij", P, W)
            b = np.einsum("nm,nij,nmj->i", P, W, points[:, None] - markers[None])
            eta = np.linalg.solve(A, b)
    return eta, P


def stereo_scene(rng, n=14, noise_px=0.3, lost=0.0):
    p, hue = hand_points(rng, n)
    left = RIG.project(p) + rng.normal(0, noise_px, (n, 2))
    right = RIG.project(p, right=True) + rng.normal(0, noise_px, (n, 2))
    i = np.flatnonzero(rng.random(n) >= lost)
    j = rng.permutation(np.flatnonzero(rng.random(n) >= lost))
    return p, hue, left, right, i, j


@pytest.mark.parametrize("seed", range(4))
def test_parallax_kernel_equals_numpy(seed: int) -> None:
    rng = np.random.default_rng(seed)
    _, hue, left, right, i, j = stereo_scene(rng, lost=0.2)
    args = (left[i], hue[i], right[j], hue[j], FOCAL / 0.4, (6.0, 30.0), 1.0, 0.1, 12)
    found = parallax_em(
        HuedPixels(left[i], hue[i]), HuedPixels(right[j], hue[j]), FOCAL / 0.4,
        ParallaxMixture(6.0, 30.0, 1.0, 0.1, 12),
    )  # fmt: skip
    assert found == pytest.approx(numpy_parallax(*args), abs=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_translation_kernel_equals_numpy(seed: int) -> None:
    rng = np.random.default_rng(seed)
    markers, marker_hue = hand_points(rng, 37)
    seen = rng.choice(37, 13, replace=False)
    points = markers[seen] + 0.01 + rng.normal(0, 0.002, (13, 3))
    A = rng.normal(0, 0.001, (13, 3, 3))
    cov = A @ A.swapaxes(1, 2) + np.eye(3) * 1e-6
    prior = rng.uniform(0, 0.2, 37)
    args = (points, marker_hue[seen], cov, markers, marker_hue, prior, 0.1, 1e-3, (0.012, 0.004), 9)
    eta, P = translation_em(
        HuedPoints(points, marker_hue[seen], cov),
        ExpectedMarkers(markers, marker_hue, prior),
        TranslationMixture(0.1, 1e-3, 0.012, 0.004, 9),
    )
    expected_eta, expected_P = numpy_translation(*args)
    assert eta == pytest.approx(expected_eta, abs=1e-10)
    assert pytest.approx(expected_P, abs=1e-9) == P


@pytest.mark.parametrize("z_hint", [None, 0.40])
def test_stereo_matches_are_right_and_nearly_all_found(z_hint: float | None) -> None:
    rng = np.random.default_rng(11)
    wrong = found = possible = 0
    for _ in range(200):
        p, hue, left, right, i, j = stereo_scene(rng, lost=0.15)
        got = match_stereo(left[i], hue[i], right[j], hue[j], RIG, z_hint=z_hint)
        same = i[got.left_index] == j[got.right_index]
        wrong += int(np.sum(~same))
        found += int(np.sum(same))
        possible += len(np.intersect1d(i, j))
        error = np.linalg.norm(got.p_C[same] - p[i[got.left_index]][same], axis=1)
        assert np.all(error < 0.02)
    assert found / possible > 0.985
    assert wrong / found < 0.01


def test_stereo_matching_works_with_other_colours_in_the_background() -> None:
    """A second cloud at 0.7 m: the parallax must converge to the hand, which has more blobs."""
    rng = np.random.default_rng(12)
    found = possible = 0
    for _ in range(50):
        _, hue, left, right, i, j = stereo_scene(rng)
        far = rng.uniform([-0.3, -0.2, 0.68], [0.3, 0.2, 0.72], (6, 3))
        far_hue = rng.integers(0, 4, 6)
        left_uv = np.concatenate([left[i], RIG.project(far)])
        right_uv = np.concatenate([right[j], RIG.project(far, right=True)])
        hues = np.concatenate([hue[i], far_hue]), np.concatenate([hue[j], far_hue])
        got = match_stereo(left_uv, hues[0], right_uv, hues[1], RIG)
        hand = got.left_index < len(i)
        partner = np.concatenate([j, 100 + np.arange(6)])[got.right_index[hand]]
        found += int(np.sum(partner == i[got.left_index[hand]]))
        possible += len(i)
    assert found / possible > 0.95


def test_each_blob_is_used_once() -> None:
    rng = np.random.default_rng(13)
    for _ in range(30):
        _, _, left, right, i, j = stereo_scene(rng)
        zero = np.zeros(len(i), np.int64)
        got = match_stereo(left[i], zero, right[j], zero, RIG)
        assert len(np.unique(got.left_index)) == len(np.unique(got.right_index)) == len(got)


def test_all_pairs_contains_every_true_pair_and_nothing_impossible() -> None:
    rng = np.random.default_rng(14)
    _, hue, left, right, i, j = stereo_scene(rng, n=40)
    got = all_pairs(left[i], hue[i], right[j], hue[j], RIG)
    pairs = set(zip(i[got.left_index], j[got.right_index], strict=True))
    assert pairs >= {(k, k) for k in np.intersect1d(i, j)}
    assert np.all(hue[i[got.left_index]] == hue[j[got.right_index]])
    assert np.all((got.p_C[:, 2] > 0.18) & (got.p_C[:, 2] < 0.70))


@pytest.mark.parametrize(("n", "m"), [(0, 0), (0, 4), (4, 0)])
def test_nothing_to_match(n: int, m: int) -> None:
    args = np.zeros((n, 2)), np.zeros(n, np.int64), np.zeros((m, 2)), np.zeros(m, np.int64)
    assert len(match_stereo(*args, RIG)) == 0
    assert len(all_pairs(*args, RIG)) == 0
    points = np.zeros((n, 3)), np.zeros(n, np.int64), np.zeros((m, 3)), np.zeros(m, np.int64)
    got = match_translation(*points, np.ones(m), np.eye(3) * 1e-6)
    assert got.marker.tolist() == [-1] * n


def test_translation_finds_markers_after_a_shift_of_20_mm_and_3_degrees() -> None:
    clean, recall = right(ours)
    assert clean >= 0.97
    assert recall >= 0.95


def test_shift_is_recovered_with_outliers() -> None:
    rng = np.random.default_rng(16)
    markers, hue = hand_points(rng, 20)
    strays = rng.uniform([-0.1, -0.1, 0.3], [0.1, 0.1, 0.4], (6, 3))
    shift = np.array([0.009, -0.008, 0.009])  # 15 mm
    points = np.concatenate([markers + shift, strays])
    hues = np.concatenate([hue, rng.integers(0, 4, 6)])
    got = match_translation(points, hues, markers, hue, np.ones(20), np.eye(3) * 1e-6)
    assert got.eta == pytest.approx(shift, abs=0.002)
    assert got.marker[:20].tolist() == list(range(20))


def test_of_two_points_on_one_marker_the_nearer_is_used() -> None:
    markers = np.array([[0.0, 0, 0.3]])
    points = np.array([[0.004, 0, 0.3], [0.001, 0, 0.3]])
    zero = np.zeros(2, np.int64)
    got = match_translation(points, zero, markers, zero[:1], np.ones(1), np.eye(3) * 1e-6)
    assert sorted(got.marker.tolist()) == [-1, 0]


def test_invisible_marker_gets_no_point() -> None:
    markers = np.array([[0.0, 0, 0.3], [0.01, 0, 0.3]])
    zero = np.zeros(2, np.int64)
    prior = np.array([0.0, 1.0])
    params = TranslationParams(sd_first=0.004)
    got = match_translation(markers[:1], zero[:1], markers, zero, prior, np.eye(3) * 1e-6, params)
    assert got.marker.tolist() != [0]


def test_translation_is_no_worse_than_pycpd() -> None:
    """The reference of the benchmark on the same frames, with noise, outliers and a shift of 21
    mm."""
    pycpd = pytest.importorskip("pycpd")
    rng = np.random.default_rng(17)
    right_ones = theirs = 0
    for _ in range(8):
        truth, hue = hand_points(rng, 37)
        seen = rng.choice(37, 13, replace=False)
        predicted = truth + [0.012, -0.012, 0.012]
        strays = rng.uniform([-0.1, -0.1, 0.3], [0.1, 0.1, 0.4], (3, 3))
        points = np.concatenate([truth[seen] + rng.normal(0, 0.001, (13, 3)), strays])
        hues = np.concatenate([hue[seen], rng.integers(0, 4, 3)])
        got = match_translation(points, hues, predicted, hue, np.ones(37), np.eye(3) * 1e-6)
        right_ones += int(np.sum(got.marker[:13] == seen))
        registration = pycpd.RigidRegistration(X=points, Y=predicted, w=0.3)
        registration.register()
        theirs += int(np.sum(np.argmax(registration.P, axis=0)[:13] == seen))
    assert right_ones >= 0.95 * 8 * 13
    assert right_ones >= theirs
