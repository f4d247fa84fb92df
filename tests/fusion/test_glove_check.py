"""A glove that does not match its file is recognised; usual gloves are not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import multivariate_normal

from tracker.base.notices import Notice
from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.calibration.glove_check import (
    SHIFT,
    gain,
    neighbours,
    shift_gains,
    spans,
)
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, ImuSample
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.wearer import WearerParams

USUAL = WearerParams()
TWICE = replace(
    USUAL,
    common_size=2 * USUAL.common_size,
    length=2 * USUAL.length,
    breadth=2 * USUAL.breadth,
    girth=2 * USUAL.girth,
    joint_offset=2 * USUAL.joint_offset,
    axis_deg=2 * USUAL.axis_deg,
    thumb_axis_deg=2 * USUAL.thumb_axis_deg,
    marker_place=2 * USUAL.marker_place,
    slip=2 * USUAL.slip,
    mounting_deg=2 * USUAL.mounting_deg,
)
"""People, markers, mountings and cloth that differ from the files by twice the usual spread."""


def reports(
    hand: HandModel, glove: GloveModel, seed: int, wearer: WearerParams, until: float
) -> list[tuple[float, Notice]]:
    """Time (s) and notice of all reports about the glove until a time (s)."""
    motion = RandomPostures(hand, seed, duration=20.0)
    sim = Simulation(hand, glove, motion, seed, SimulationParams(wearer=wearer), fps=30)
    pipeline, found = Pipeline(hand, glove, sim.rig), list[tuple[float, Notice]]()
    for message in sim.feed():
        if message.t > until:
            break
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
            found += [(message.t, n) for n in pipeline.drain_notices()]
        elif isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
        pipeline.take_results()
    return [(t, n) for t, n in found if n.code in ("glove.markers_off", "glove.imu_off")]


def test_an_unusual_glove_is_reported_once_within_20_s(hand: HandModel, glove: GloveModel) -> None:
    found = reports(hand, glove, 822, TWICE, 13.0)
    assert [n.code for _, n in found] == ["glove.markers_off"]
    t, report = found[0]
    assert t < 20.0
    assert 2.0 < float(str(report.values["offset_mm"])) < 6.0
    assert "22–23" in str(report), "of the markers that are 3 mm off"


@pytest.mark.long
def test_an_imu_that_is_mounted_differently_is_reported(hand: HandModel, glove: GloveModel) -> None:
    """In this wearer that of the middle finger's intermediate segment is turned by 30°."""
    found = reports(hand, glove, 823, TWICE, 13.0)
    report = next(n for _, n in found if n.code == "glove.imu_off")
    assert report.values["imu"] == "middle intermediate"
    assert float(str(report.values["angle_deg"])) == pytest.approx(30.0, abs=10.0)


@pytest.mark.long
def test_a_usual_glove_is_not_reported(hand: HandModel, glove: GloveModel) -> None:
    assert reports(hand, glove, 724, USUAL, 19.0) == []


def test_gain_is_the_ratio_of_marginal_likelihoods() -> None:
    """Against the densities of simulated data under both priors."""
    rng = np.random.default_rng(1)
    H, noise = rng.normal(0, 1, (9, 5)), 0.3
    prior = np.diag(rng.uniform(0.5, 2.0, 5))
    rows, C = np.array([1, 3, 4]), rng.normal(0, 1, (3, 2))
    wider = prior.copy()
    wider[np.ix_(rows, rows)] += C @ C.T
    y = rng.normal(0, 1, 9)
    N, b = H.T @ H / noise**2, H.T @ y / noise**2
    A = np.linalg.inv(N + np.linalg.inv(prior))
    found = gain(N - N @ A @ N, b - N @ (A @ b), rows, C)
    usual, unusual = (
        multivariate_normal(np.zeros(9), H @ P @ H.T + noise**2 * np.eye(9)).logpdf(y)
        for P in (prior, wider)
    )
    assert found == pytest.approx(unusual - usual, abs=1e-9)


def test_gains_of_groups_are_those_of_each_group() -> None:
    rng = np.random.default_rng(2)
    segment = np.array([0, 0, 0, 3, 3])
    groups = neighbours(segment)
    assert len(groups) == 6 + 3
    markers = rng.permutation(15).reshape(5, 3)
    A = rng.normal(0, 1e2, (15, 15))
    F, s = A @ A.T, rng.normal(0, 1e3, 15)
    found = shift_gains(F, s, markers, groups)
    for group, value in zip(groups, found, strict=True):
        rows = markers[np.flatnonzero(group)]
        C = SHIFT * np.tile(np.eye(3), (len(rows), 1))
        assert value == pytest.approx(gain(F, s, rows.ravel(), C), rel=1e-9)


def test_successive_markers_are_named_as_a_range() -> None:
    assert spans((0, 2, 3, 4, 7)) == ("0", "2–4", "7")
