"""The protocol itself: motion, errors, metrics, crossing, goals, and the command's JSON."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from extensions.evaluation.inertial import broad as inertial_broad
from extensions.evaluation.inertial import goals as inertial_goals
from extensions.evaluation.inertial.broad import BroadTrial, score
from extensions.evaluation.inertial.errors import MPU9250, draw
from extensions.evaluation.inertial.experiment import ErrorRow, Plan, crossover, run
from extensions.evaluation.inertial.motion import (
    CONDITIONS,
    DURATIONS,
    EXTENDED,
    HORIZONTAL,
    MOVING,
    STATIC,
    grasp,
)
from extensions.evaluation.inertial.peers import available, peer_angles
from tests.fixtures import DATA
from tests.notices import raises
from tracker import GRAVITY
from tracker.base.errors import FileError
from tracker.cli import build_parser
from tracker.inertial.finger import Finger, phalanx_angles

FINGER = Finger()
BROAD = DATA / "broad_imu"


def test_the_motion_passes_the_papers_poses_at_the_papers_times() -> None:
    motion = grasp(FINGER, 3.0, 1000.0)
    at = np.rad2deg(motion.theta[[0, 200, 1200, 3200]])
    expected = phalanx_angles(np.array([[0, 0, 0], [0, 0, 0], [-28, 0, 0], [90, 85, 85]], float))
    np.testing.assert_allclose(at, expected, atol=1e-9)
    np.testing.assert_allclose(np.rad2deg(EXTENDED[0]), -28)
    assert len(DURATIONS) == 32
    assert DURATIONS[0] == pytest.approx(0.1)
    assert DURATIONS[-1] == pytest.approx(1000.0)


@pytest.mark.parametrize("condition", CONDITIONS, ids=lambda c: c.name)
def test_rates_and_accelerations_are_derivatives_of_the_angles(condition) -> None:  # type: ignore[no-untyped-def]
    rate = 20000.0
    motion = grasp(FINGER, 1.2, rate, condition)
    smooth = np.abs(motion.t - STATIC) > 1e-3
    smooth &= np.abs(motion.t - STATIC - 0.4) > 1e-3
    for level, derivative in ((motion.theta, motion.omega), (motion.omega, motion.alpha)):
        numeric = np.gradient(level, 1 / rate, axis=0)
        np.testing.assert_allclose(numeric[smooth][1:-1], derivative[smooth][1:-1], atol=2e-3)


def test_gravity_leaves_a_horizontal_plane_and_swaying_shows_at_the_root() -> None:
    assert np.abs(grasp(FINGER, 1.0, 100.0, HORIZONTAL).ideal.root).max() < 1e-12
    assert grasp(FINGER, 1.0, 100.0, HORIZONTAL).normal_gravity == pytest.approx(GRAVITY)
    moving = grasp(FINGER, 2.0, 2000.0, MOVING)
    place = MOVING.sway * np.sin(2 * np.pi * np.maximum(moving.t - STATIC, 0)) ** 3
    numeric = np.gradient(np.gradient(place, moving.t), moving.t)
    np.testing.assert_allclose(moving.ideal.root.real[5:-5], numeric[5:-5], atol=0.05)


def test_errors_are_the_data_sheets() -> None:
    n, rate = 20000, 100.0
    white = draw(n, "white", rate, (1,))
    assert white.accel.std() == pytest.approx(300e-6 * GRAVITY * np.sqrt(50), rel=0.02)
    assert np.rad2deg(white.gyro.std()) == pytest.approx(0.01 * np.sqrt(50), rel=0.02)
    offset = draw(3, "offset", rate, (1,))
    np.testing.assert_allclose(np.abs(np.rad2deg(offset.gyro)), 5.0)
    np.testing.assert_allclose(np.abs(offset.accel) / GRAVITY, 0.060)
    assert np.ptp(offset.accel, axis=0).max() == 0.0
    np.testing.assert_array_equal(
        draw(3, "both", rate, (2,)).gyro, draw(3, "both", rate, (2,)).gyro
    )
    assert MPU9250.accel_sd(400.0) == pytest.approx(2 * MPU9250.accel_sd(100.0))


def _row(t_m: float, name: str, rms: float) -> ErrorRow:
    return ErrorRow("vertical", "both", 100.0, t_m, name, rms, rms, rms, 1)


def test_the_crossing_of_known_power_laws_is_found() -> None:
    rows = []
    for t in np.logspace(-1, 2, 13):
        rows += [_row(t, "gravity", 4.0), _row(t, "integration", 3.0 * t)]
    assert crossover(rows, "both", 100.0) == pytest.approx(4 / 3, rel=1e-6)
    never = [r for r in rows if r.t_m < 1]
    assert crossover(never, "both", 100.0) is None


@pytest.fixture(scope="module")
def measured() -> list[ErrorRow]:
    short = tuple(t for t in DURATIONS[::2] if t < 12)
    return run(Plan((100.0,), 6, 1, short, ("both", "white"), with_peers=False), FINGER)


def test_the_papers_crossing_and_our_goals_are_reached(measured: list[ErrorRow]) -> None:
    found = inertial_goals.goals(measured, [], {})
    assert [g.what for g in found if not g.reached] == []
    assert len(found) >= 6


def test_figures_of_the_paper_order_of_magnitude(measured: list[ErrorRow]) -> None:
    """Closed forms: 5 °/s over t has RMS 5 t / √3; noise of 300 µg/√Hz over 50 Hz is 0.1215°."""
    vertical = [r for r in measured if r.condition == "vertical"]
    by = {(r.series, r.estimator, r.t_m): r.rms_deg for r in vertical}
    slowest = max(r.t_m for r in measured)
    drift = 5.0 * (slowest + STATIC) / np.sqrt(3)
    assert by["both", "integration", slowest] == pytest.approx(drift, rel=0.02)
    noise = np.rad2deg(300e-6 * np.sqrt(50))
    assert by["white", "gravity", slowest] == pytest.approx(noise, rel=0.1)


@pytest.mark.parametrize("peer", available())
def test_peers_find_a_slow_motion(peer: str) -> None:
    motion = grasp(FINGER, 8.0, 100.0)
    ideal = draw(len(motion.t), "none", 100.0, (0,))
    theta = peer_angles(peer, motion, ideal, 0.01)
    assert np.rad2deg(np.abs(theta - motion.theta[:, :2]).max()) < 3.0


def test_scores_split_a_known_error_into_heading_and_inclination() -> None:
    rng = np.random.default_rng(0)
    truth = Rotation.random(50, random_state=rng)
    tilt = Rotation.from_rotvec(np.deg2rad([3.0, 0, 0]))
    heading = Rotation.from_rotvec(np.deg2rad([0, 0, 4.0]))
    free = Rotation.from_rotvec([0, 0, 2.0])
    n = len(truth)
    late = Rotation.concatenate([Rotation.identity()] + [heading * tilt] * (n - 1))
    estimate = free * late * truth
    scored = np.ones(n, bool)
    trial = BroadTrial("t", 0.01, np.zeros((n, 3)), np.zeros((n, 3)), truth.as_quat(), scored)
    row = score(trial, "x", estimate.as_quat())
    share = np.sqrt((n - 1) / n)
    assert row.inclination_deg == pytest.approx(3.0 * share, rel=1e-6)
    assert row.heading_deg == pytest.approx(4.0 * share, rel=1e-6)
    angle = np.rad2deg((heading * tilt).magnitude())
    assert row.total_deg == pytest.approx(angle * share, rel=1e-6)


def test_a_file_that_is_not_a_recording_is_refused(tmp_path: Path) -> None:
    (tmp_path / "x.mat").write_bytes(b"nothing")
    with raises(FileError, "evaluation.not_broad"):
        inertial_broad.read_trial(tmp_path / "x.mat")
    with raises(FileError, "evaluation.no_broad"):
        inertial_broad.trial_paths(tmp_path / "nowhere")


@pytest.mark.data
@pytest.mark.skipif(not BROAD.is_dir(), reason="the BROAD recordings are not here")
def test_inclination_on_an_undisturbed_recording_is_as_good_as_vqfs() -> None:
    pytest.importorskip("vqf")
    paths = [p for p in inertial_broad.trial_paths(BROAD) if "16_undisturbed" in p.name]
    every = inertial_broad.filters()
    rows = inertial_broad.evaluate(paths, {n: every[n] for n in ("segments", "vqf")})
    by = {r.estimator: r.inclination_deg for r in rows}
    assert by["segments"] < 1.1 * by["vqf"]
    assert by["segments"] < 1.0


@pytest.mark.long
def test_the_command_writes_the_files_of_the_contract(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, saved = tmp_path / "figures", tmp_path / "r.json"
    words = [
        "evaluate",
        "inertial",
        "--quick",
        "--seeds",
        "1",
        "--json",
        str(saved),
        "--out",
        str(out),
    ]
    args = build_parser(words).parse_args(words)
    assert args.command.start(args) == 0
    data = json.loads(saved.read_text())
    assert {"series", "rate_hz", "t_m", "estimator", "rms_deg"} <= data["rows"][0].keys()
    names = {r["estimator"] for r in data["rows"]}
    assert {"gravity", "integration", "switching", "switching_offset", "madgwick"} <= names
    assert {"madgwick_adaptive", "learned"} <= names
    assert 1.0 < data["crossover_s"]["both"] < 1.6
    assert data["crossover_s"]["white"] is None
    assert data["cost_us"].keys() >= {"gravity", "learned", "segments_7"}
    assert data["broad"] == []
    assert all(p.read_bytes().startswith(b"\x89PNG") for p in out.glob("*.png"))
    assert len(list(out.glob("*.png"))) == 3
    assert "Integration and gravity cross" in capsys.readouterr().out


def test_a_missing_folder_of_recordings_is_reported_first(tmp_path: Path) -> None:
    words = ["evaluate", "inertial", "--broad", str(tmp_path / "none")]
    args = build_parser(words).parse_args(words)
    with raises(FileError, "evaluation.no_broad"):
        args.command.start(args)
