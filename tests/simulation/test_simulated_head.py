"""A head-mounted camera: blobs follow its true pose, and the reported one has the given errors."""

from dataclasses import replace

import numpy as np
import pytest

from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.head import MOVING, Head, HeadParams
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.rig import default_pose


def test_a_static_camera_reports_nothing() -> None:
    head = Head(default_pose(), 1)
    np.testing.assert_array_equal(head.pose(5.0).p_GC, default_pose().p_GC)
    assert head.reported(5.0) is None and not head.moves


def test_reported_pose_has_the_given_errors() -> None:
    shifts, turns = [], []
    for seed in range(100):
        head = Head(default_pose(), seed, MOVING)
        true, reported_pose = head.pose(3.0), head.reported(3.0)
        assert reported_pose is not None
        shifts.append(reported_pose.p_GC - true.p_GC)
        turns.append(so3.log(true.R_GC.T @ reported_pose.R_GC))
    assert np.std(shifts) == pytest.approx(3e-3, rel=0.15)
    assert np.rad2deg(np.std(turns)) == pytest.approx(0.5, rel=0.15)


def test_blobs_fit_the_true_pose(hand: HandModel, glove: GloveModel) -> None:
    """With exact reports, blobs are on the markers; with the static pose they are far off."""
    perfect = replace(MOVING, error_mm=0.0, error_deg=0.0, sway_mm=30.0)
    simulation = Simulation(
        hand, glove, RandomPostures(hand, 1, duration=6), 1, SimulationParams(head=perfect)
    )
    frame = simulation.scene.blobs(1.0)
    assert frame.pose is not None and frame.left is not None
    truth, markers = simulation.truth(1.0), simulation.wearer.markers(1.0)
    segment = simulation.wearer.marker_segment
    p_G = truth.p_GB[segment] + np.einsum("nij,nj->ni", truth.R_GB[segment], markers)

    def gap(R_GC: np.ndarray, p_GC: np.ndarray) -> float:
        uv = simulation.rig.project((p_G - p_GC) @ R_GC)
        assert frame.left is not None
        distance = np.linalg.norm(frame.left.uv[:, None] - uv[None], axis=2)
        return float(np.median(distance.min(axis=1)))

    assert gap(frame.pose.R_GC, frame.pose.p_GC) < 1.0
    assert gap(default_pose().R_GC, default_pose().p_GC) > 5.0


def test_exact_reports_are_sent_for_a_moving_head() -> None:
    assert Head(default_pose(), 1, HeadParams(sway_mm=5.0)).reported(1.0) is not None
