"""Metrics compared with manually computed numbers."""

import numpy as np
import pytest

from extensions.evaluation.vist.metrics import (
    Trial,
    by_seen,
    confidence_interval,
    nees_per_dof,
    pck,
    pck_curve,
    summarise,
)


def trial(error_mm, sd_mm=10.0, seen=None, participant=0, matches=0, wrong=0) -> Trial:
    error = np.array(error_mm, float) / 1000
    n = len(error)
    return Trial(
        participant=participant,
        hand_length=0.18,
        t=np.arange(n) / 100,
        error=error,
        sd=np.full(error.shape, sd_mm / 1000),
        joints=np.full((n, 9), 0.002),
        seen=np.array(seen if seen is not None else [10] * n),
        matches=matches,
        wrong_matches=wrong,
        core_s=0.5,
        duration=10.0,
    )


def test_pck_judges_the_worst_of_the_four():
    t = trial([[1, 2, 3, 19], [1, 2, 3, 21], [36, 1, 1, 1], [1, 1, 1, 1]])
    assert pck([t], 20) == pytest.approx(50)
    assert pck([t], 35) == pytest.approx(75)


def test_a_lost_instant_is_outside_every_bound_and_outside_the_mean():
    t = trial([[2, 2, 2, 2], [np.nan] * 4])
    s = summarise([t])
    assert s.pck35 == pytest.approx(50)
    assert s.lost == pytest.approx(0.5)
    assert s.mean_mm == pytest.approx(2)


def test_the_curve_never_falls():
    rng = np.random.default_rng(0)
    curve = pck_curve([trial(rng.gamma(2, 6, (500, 4)))])
    assert np.all(np.diff(curve) >= 0)
    assert curve[0] == 0


def test_within_and_between_participants():
    """Two people, errors 4 ± 1 and 8 ± 3 mm: within (1 + 3) / 2, between 4 / sqrt 2."""
    a = trial([[3, 5, 3, 5], [5, 3, 5, 3]])
    b = trial([[5, 11, 5, 11], [11, 5, 11, 5]], participant=1)
    s = summarise([a, b])
    assert s.mean_mm == pytest.approx(6)
    assert s.within_sd_mm == pytest.approx(2)
    assert s.between_sd_mm == pytest.approx(4 / np.sqrt(2))
    assert s.sd_mm == pytest.approx(np.sqrt((1 + 9) / 2 + 4))


def test_confidence_interval_is_students():
    """Means 1, 2, 3: 2 ± 4.302653 / sqrt 3, the t of two degrees of freedom."""
    low, high = confidence_interval(np.array([1.0, 2.0, 3.0]))
    assert (high - low) / 2 == pytest.approx(4.302653 / np.sqrt(3), rel=1e-6)
    assert (high + low) / 2 == pytest.approx(2)
    assert np.isnan(confidence_interval(np.array([1.0]))).all()


def test_nees_of_errors_drawn_from_the_stated_sd_is_one():
    rng = np.random.default_rng(1)
    distance = np.linalg.norm(rng.normal(0, 5, (20000, 4, 3)), axis=2)
    assert nees_per_dof([trial(distance, sd_mm=5.0)]) == pytest.approx(1.0, abs=0.02)
    assert nees_per_dof([trial(distance, sd_mm=2.5)]) == pytest.approx(4.0, abs=0.08)


def test_error_over_matched_markers():
    b = by_seen([trial([[1] * 4, [3] * 4, [8] * 4, [np.nan] * 4], seen=[2, 2, 0, 0])])
    np.testing.assert_allclose(b.share, [0.5, 0, 0.5])
    np.testing.assert_allclose(b.mean_mm, [8, np.nan, 2])


def test_wrong_matches_and_cost_are_shares_of_all():
    s = summarise([trial([[1] * 4], matches=30, wrong=1), trial([[1] * 4], matches=70, wrong=4)])
    assert s.wrong_match_rate == pytest.approx(0.05)
    assert s.core_s_per_s == pytest.approx(0.05)


def test_no_participants_are_rejected():
    with pytest.raises(ValueError, match="trials"):
        summarise([])


def test_tips_and_joints_are_distinguished():
    summary = summarise([trial([[9.0, 6.0, 3.0, 1.0]] * 5)])
    assert summary.tips_mm == pytest.approx(6.0)
    assert summary.joints_mm == pytest.approx(2.0)


def test_within_three_sd_counts_an_error_along_one_axis():
    """sd 10 mm of a coordinate: 51 mm along one axis is within three of its own, 53 is not."""
    t = trial([[51, 51, 51, 53]])
    assert summarise([t]).within_3sd == pytest.approx(0.75)
