"""``glovetrack imu-axes`` and ``imu-drift`` on recordings with known errors."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.calibration.test_imu_axes import orientations, turned
from tracker import GRAVITY
from tracker.base.clock import ClockAnchor
from tracker.calibration.imu_drift import fit_drift, rests_of
from tracker.cli import main
from tracker.glove import library
from tracker.glove.files import parse_glove
from tracker.hand.model import HandModel
from tracker.messages import Array, ImuSample
from tracker.offline.imu_values import warmth_of
from tracker.session.description import describe
from tracker.session.writer import SessionRecorder
from tracker.simulation.imu_errors import DrawnImuErrors, ImuParams

RATE_HZ = 20.0
DEVICE = 11


def record(path: Path, accel: Array, gyro: Array, celsius: Array | None = None) -> Path:
    """A recording of accel and gyro (N, n, 3); celsius (N, n) once a second."""
    n = accel.shape[1]
    with SessionRecorder(path, describe(*library.texts(), ClockAnchor(10**18, 0))) as recorder:
        for k in range(len(accel)):
            warmth = celsius[k].copy() if celsius is not None and k % RATE_HZ == 0 else None
            t = k / RATE_HZ
            valid = np.ones(n, bool)
            recorder.write(ImuSample(t, t, t, k, accel[k].copy(), gyro[k].copy(), valid, warmth))
    return path


def errors() -> DrawnImuErrors:
    return DrawnImuErrors(7, DEVICE, ImuParams())


def warming(seed: int, start_c: float, seconds: float = 60.0) -> tuple[Array, Array, Array]:
    """accel, gyro and celsius of a glove at rest on a table that warms up by 6 °C."""
    rng, known = np.random.default_rng(seed), errors()
    n = round(seconds * RATE_HZ)
    celsius = start_c + 6 * np.linspace(0, 1, n)[:, None] + 0.3 * np.arange(7)
    warmer = (celsius - 25)[..., None]
    force = np.broadcast_to(np.array([0, 0, GRAVITY]), (n, 7, 3))
    session = rng.normal(0, np.deg2rad(0.05), (7, 3))
    gyro = known.measured_rate(0 * force, force) + warmer * known.gyro_slope + session
    accel = known.measured_force(force) + warmer * known.accel_slope
    gyro = gyro + rng.normal(0, np.deg2rad(0.07), gyro.shape)
    return accel + rng.normal(0, 0.02, gyro.shape), gyro, celsius


@pytest.fixture
def glove_file(tmp_path: Path) -> Path:
    path = tmp_path / "mine.toml"
    path.write_text(library.text("gloves", library.DEFAULT_GLOVE))
    return path


def test_slopes_are_learned_over_sessions(
    hand: HandModel, glove_file: Path, tmp_path: Path
) -> None:
    """Each session starts from the file of the one before; sd falls, and errors are within it."""
    known, sds = errors(), []
    for k in range(2):
        accel, gyro, celsius = warming(k, 24.0 + k, 20.0)
        session = record(tmp_path / f"{k}.mcap", accel, gyro, celsius)
        target = tmp_path / f"learned{k}.toml"
        words = [str(session), "--glove", str(glove_file), "--set", str(target)]
        assert main(["imu-drift", *words]) == 0
        glove_file = target
        drift = [imu.drift for imu in parse_glove(target.read_text(), hand).imus]
        slope, sd = (np.array([getattr(d, x) for d in drift]) for x in ("gyro", "gyro_sd"))
        assert np.abs(slope - known.gyro_slope).max() < 4 * sd.max()
        sds.append(sd.mean())
    assert sds[1] < 0.8 * sds[0] < 0.8 * 0.2 * np.deg2rad(0.08)


def test_without_rests_the_prior_stays() -> None:
    t = np.arange(500) / RATE_HZ
    moving = np.random.default_rng(0).normal(0, 1, (500, 3))
    rests = rests_of(t, np.full(500, 26.0), moving, moving)
    assert len(rests.rest) == 0 and fit_drift([rests]) is None


@pytest.mark.long
def test_axes_are_written_into_the_glove_file(
    hand: HandModel, glove_file: Path, tmp_path: Path
) -> None:
    known, rng = errors(), np.random.default_rng(5)
    R, rate = turned(orientations(12), RATE_HZ)
    force = np.swapaxes(R, 1, 2) @ np.array([0, 0, GRAVITY])
    force, rate = (np.broadcast_to(x[:, None], (len(R), 7, 3)) for x in (force, rate))
    gyro = known.measured_rate(rate, force) + rng.normal(0, np.deg2rad(0.07), force.shape)
    accel = known.measured_force(force) + rng.normal(0, 0.02, force.shape)
    session = record(tmp_path / "box.mcap", accel, gyro)
    out, target = tmp_path / "axes.json", tmp_path / "axes.toml"
    words = ["--glove", str(glove_file), "--set", str(target), "--json", str(out)]
    assert main(["imu-axes", str(session), *words]) == 0
    assert json.loads(out.read_text())["rests"] == 12
    for j, imu in enumerate(parse_glove(target.read_text(), hand).imus):
        left = imu.axes.accel @ known.accel_matrix[j]
        assert np.abs(left.T @ left - np.eye(3)).max() < 0.006
        assert np.abs(imu.axes.gyro @ known.gyro_matrix[j] - left).max() < 0.01


def test_a_simulated_session_has_temperatures(tmp_path: Path) -> None:
    session = tmp_path / "simulated.mcap"
    assert main(["simulate", "-o", str(session), "--duration", "2", "--lenses", "none"]) == 0
    _, warmth = warmth_of(session)
    assert warmth.celsius.shape == warmth.gyro.shape[:2] and len(np.unique(warmth.celsius)) >= 14
    assert 15.0 < warmth.celsius.min() < warmth.celsius.max() < 40.0


@pytest.mark.parametrize("command", ["imu-axes", "imu-drift"])
def test_a_recording_without_what_is_needed_is_an_error(
    tmp_path: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    moving = np.random.default_rng(0).normal(0, 1, (100, 7, 3))
    session = record(tmp_path / "moving.mcap", moving, moving)
    assert main([command, str(session)]) == 1
    assert {"imu-axes": "rests", "imu-drift": "temperatures"}[command] in capsys.readouterr().err
