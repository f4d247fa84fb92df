"""Predicted markers and their update, compiled, against the plain formulas."""

from __future__ import annotations

import numpy as np
import pytest

from tests.vision.gated_assignment import assign_gated
from tracker.fusion.chain.kinematics import marker_jacobians, marker_positions
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.params import NoiseParams
from tracker.fusion.chain.pixel_rows import point_rows, stack_rows
from tracker.fusion.chain.pixels import (
    DISPUTED,
    USUAL_LN_DET,
    PixelModel,
    SeenBlobs,
    Tally,
    median_ln_det,
    worn,
)
from tracker.fusion.chain.prediction import MIN_PRIOR, Prediction
from tracker.fusion.chain.state import ChainState, initial_state, inject
from tracker.fusion.kalman import update
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, IntArray
from tracker.vision.correspondence import GateParams
from tracker.vision.rig import ideal_rig

RIG, NOISE = ideal_rig(), NoiseParams()
Case = tuple[ChainLayout, ChainState, Prediction]


@pytest.fixture(scope="module")
def case(hand: HandModel, glove: GloveModel) -> Case:
    """A bent hand of another size in front of the camera, with a fully correlated covariance."""
    layout, rng = ChainLayout(hand, glove), np.random.default_rng(21)
    state = initial_state(layout)
    state.p = RIG.pose.p_GC + 0.35 * RIG.pose.R_GC[:, 2]
    inject(state, layout, 0.02 * rng.normal(size=layout.blocks.size))
    root = 1e-3 * rng.normal(size=(layout.blocks.size, layout.blocks.size))
    state.P = root @ root.T
    return layout, state, PixelModel(layout, RIG, NOISE).predict(state, RIG.pose)


def test_expected_markers_are_the_plain_products(case: Case) -> None:
    """Their positions, Jacobians, H P, and covariance in G and in pixels."""
    layout, state, e = case
    p_C = (marker_positions(state, layout) - RIG.pose.p_GC) @ RIG.pose.R_GC
    for c in range(2):
        assert np.allclose(e.uv[c], RIG.project(p_C, bool(c)), atol=1e-9)
    assert len(e.rows) > 10
    assert np.array_equal(e.rows, np.flatnonzero(e.prior.max(axis=0) > MIN_PRIOR))
    H = marker_jacobians(state, layout, e.rows)
    assert np.allclose(e.H, H, atol=1e-14)
    HP = np.einsum("kij,jl->kil", H, state.P)
    assert np.abs(e.HP - HP).max() < 1e-12 * np.abs(HP).max()
    cov = HP @ H.swapaxes(1, 2) + np.eye(3) * NOISE.marker**2
    assert np.abs(e.cov - cov).max() < 1e-12 * np.abs(cov).max()
    A = e.A[:, e.rows]
    S = A @ cov @ A.swapaxes(-1, -2) + np.eye(2) * NOISE.pixel_px**2
    assert np.abs(e.S - S).max() < 1e-12 * np.abs(S).max()


def blobs(case: Case, seed: int) -> tuple[SeenBlobs, ...]:
    """Most predicted markers displaced by some pixels, shuffled, plus unrelated blobs."""
    layout, _, e = case
    rng, out = np.random.default_rng(seed), []
    for c in range(2):
        rows = rng.permutation(e.rows)[: len(e.rows) - 4]
        extra = rng.uniform(0, 700, (5, 2)), rng.integers(0, 4, 5)
        uv = np.concatenate([e.uv[c, rows] + rng.normal(0, 2.0, (len(rows), 2)), extra[0]])
        hue = np.concatenate([layout.glove.marker_hue[rows], extra[1]])
        out.append(SeenBlobs(uv, hue, np.arange(len(uv))))
    return tuple(out)


def test_matches_are_those_of_the_assignment(case: Case) -> None:
    """Image by image, with a cost of no match that grows with the covariance; except for blobs that
    would fit another digit's marker equally well."""
    layout, _, e = case
    seen = blobs(case, 1)
    match = PixelModel(layout, RIG, NOISE).match(e, seen)
    of_digit = digit_of(layout)[layout.marker_segment]
    for c in range(2):
        alone = GateParams().dummy_cost + max(0.0, median_ln_det(e.S[c]) - USUAL_LN_DET)
        found = assign_gated(
            seen[c].uv, seen[c].hue, e.uv[c, e.rows], e.S[c], layout.glove.marker_hue[e.rows],
            e.prior[c, e.rows], GateParams(dummy_cost=alone),
        )  # fmt: skip
        for i, blob in enumerate(found):
            if match[c, e.rows[i]] == blob:
                continue
            own, *rivals = distances(e, c, seen[c].uv[blob], i, found, of_digit[e.rows], layout)
            assert match[c, e.rows[i]] == -1 and min(rivals) < own + DISPUTED
        assert (found >= 0).sum() > 5 and np.all(np.delete(match[c], e.rows) == -1)


def distances(
    e: Prediction, c: int, uv: Array, i: int, found: IntArray, digit: IntArray, layout: ChainLayout
) -> list[float]:
    """Distances of a blob from its assigned marker, and from unmatched markers of other digits."""
    hue = layout.glove.marker_hue[e.rows]
    free = (found < 0) & (hue == hue[i]) & (digit != digit[i]) & (e.prior[c, e.rows] >= 0.01)
    out = []
    for k in (i, *np.flatnonzero(free)):
        apart, S = uv - e.uv[c, e.rows[k]], e.S[c, k]
        out.append(float(apart @ np.linalg.solve(S, apart) + np.log(np.linalg.det(S))))
    return out


def test_a_blob_between_two_fingers_is_not_assigned(case: Case) -> None:
    """Two markers of a hue on neighbouring fingers, and one blob midway between them; closer to
    either of them it is assigned to that one."""
    layout, _, e = case
    of_digit, hue = digit_of(layout)[layout.marker_segment], layout.glove.marker_hue
    pairs = [
        (a, b)
        for a in e.rows
        for b in e.rows
        if hue[a] == hue[b] and 0 <= of_digit[a] < of_digit[b] and e.prior[0, [a, b]].min() > 0.5
    ]
    a, b = min(pairs, key=lambda p: float(np.linalg.norm(e.uv[0, p[0]] - e.uv[0, p[1]])))
    wide = e._replace(S=np.full_like(e.S, 0.0) + 60.0 * np.eye(2))
    none = SeenBlobs(np.zeros((0, 2)), np.zeros(0, np.int64), np.zeros(0, np.int64))
    for share, whose in ((0.5, -1), (0.0, a), (1.0, b)):
        uv = (1.0 - share) * e.uv[0, a] + share * e.uv[0, b]
        blob = SeenBlobs(uv[None], hue[[a]], np.zeros(1, np.int64))
        match = PixelModel(layout, RIG, NOISE).match(wide, (blob, none))
        assert np.flatnonzero(match[0] >= 0).tolist() == ([] if whose < 0 else [whose]), share


def some_matched(case: Case) -> IntArray:
    """Markers of both cameras, of either one, of none."""
    rows = case[2].rows
    match = np.full((2, case[2].uv.shape[1]), -1)
    match[:, rows[: len(rows) - 2]] = np.arange(len(rows) - 2)
    match[0, rows[:3]] = match[1, rows[2:5]] = -1
    return match


def test_three_rows_of_a_marker_are_equivalent_to_its_four_pixels(case: Case) -> None:
    """The same correction and covariance as with all pixels, including an outlier."""
    _, state, e = case
    match, rng = some_matched(case), np.random.default_rng(5)
    n = int(match.max()) + 1
    uv = e.uv[:, e.rows[:n]] + rng.normal(0, 2.0, (2, n, 2))
    uv[1, 7] += 200.0
    H, HP, r, R = point_rows(e, match, *uv, NOISE.pixel)
    residual = np.full((2, len(e.rows), 2), np.nan)
    for c in range(2):
        hit = match[c, e.rows] >= 0
        residual[c, hit] = (uv[c] - e.uv[c, e.rows[:n]])[hit[:n]]
    whole = stack_rows(e.H, e.HP, np.ascontiguousarray(e.A[:, e.rows]), residual, NOISE.pixel)
    both = np.all(match >= 0, axis=0).sum()
    assert len(r) == len(whole[2]) - both and both > 5
    assert np.allclose(HP, H @ state.P, atol=1e-12)
    dx, P = update(state.P, H, r, R)
    dx_whole, P_whole = update(state.P, whole[0], *whole[2:])
    assert np.abs(dx - dx_whole).max() < 1e-8 * np.abs(dx_whole).max()
    assert np.abs(P - P_whole).max() < 1e-8 * np.abs(P_whole).max()


def test_no_matches_give_no_rows(case: Case) -> None:
    _, _, e = case
    none, nothing = np.full((2, e.uv.shape[1]), -1), np.zeros((0, 2))
    got = point_rows(e, none, nothing, nothing, NOISE.pixel)
    assert [len(a) for a in got] == [0, 0, 0, 0]


def test_a_tally_counts_markers(case: Case) -> None:
    _, _, e = case
    match = some_matched(case)
    tally = Tally.of(e, match)
    assert tally.matched == np.any(match >= 0, axis=0).sum()
    assert tally.expected == pytest.approx(e.prior.max(axis=0).sum())


def test_only_blobs_of_the_gloves_hues_are_used() -> None:
    """Those of another hue, without a hue, or without a position are ignored."""
    rng = np.random.default_rng(6)
    uv, hue = rng.normal(size=(12, 2)), rng.integers(0, 4, 12)
    uv[3, 1], uv[5, 0], hue[7], hue[8] = np.nan, np.inf, 4, -1
    number = np.array([2, -1, 0, 1])
    keep = [i for i in range(12) if i not in (3, 5, 7, 8) and number[hue[i]] >= 0]
    got = worn(uv, hue, number)
    assert got[2].tolist() == keep and len(keep) > 3
    assert np.array_equal(got[0], uv[keep]) and np.array_equal(got[1], number[hue[keep]])
