"""Allan deviation and fitted noise, on synthetic signals and data of a real chip."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest

from tracker.offline.imu_noise import NoiseModel, allan, fit, noise_of

RATE_HZ = 100.0
WHITE, WALK = 2e-4, 3e-5


def made(n: int, seed: int = 1) -> np.ndarray:
    """(n, 3) white noise and random walk of known densities."""
    rng = np.random.default_rng(seed)
    white = WHITE * np.sqrt(RATE_HZ) * rng.standard_normal((n, 3))
    walk = WALK / np.sqrt(RATE_HZ) * rng.standard_normal((n, 3)).cumsum(axis=0)
    return white + walk


def test_white_noise_decreases_with_the_square_root_of_time() -> None:
    rng = np.random.default_rng(2)
    curve = allan(WHITE * np.sqrt(RATE_HZ) * rng.standard_normal((60_000, 1)), RATE_HZ)
    short = curve.tau < 5
    expected = WHITE / np.sqrt(curve.tau[short])
    assert curve.deviation[short, 0] == pytest.approx(expected, rel=0.1)


def test_a_constant_has_no_deviation_and_a_ramp_a_known_one() -> None:
    t = np.arange(5000)[:, None] / RATE_HZ
    assert allan(np.ones((5000, 1)), RATE_HZ).deviation == pytest.approx(0, abs=1e-12)
    curve = allan(0.3 * t, RATE_HZ)
    assert curve.deviation[:, 0] == pytest.approx(0.3 * curve.tau / np.sqrt(2), rel=1e-6)


def test_the_densities_of_a_synthetic_signal_are_recovered() -> None:
    _, models = noise_of(made(120_000), RATE_HZ)
    for model in models:
        assert model.white == pytest.approx(WHITE, rel=0.05)
        assert model.walk == pytest.approx(WALK, rel=0.5)


def test_a_model_is_recovered_from_its_own_curve() -> None:
    tau = np.logspace(-2, 2, 40)
    model = NoiseModel(1e-4, 5e-5, 1e-6)
    found = fit(tau, model.deviation(tau), np.full(40, 100.0))
    assert found.white == pytest.approx(model.white, rel=1e-3)
    assert found.flicker == pytest.approx(model.flicker, rel=1e-3)
    assert found.walk == pytest.approx(model.walk, rel=1e-2)


def test_too_short_a_signal_is_rejected() -> None:
    with pytest.raises(ValueError, match="100"):
        allan(np.zeros((50, 3)), RATE_HZ)


def resting(data: Path) -> tuple[np.ndarray, np.ndarray, float]:
    """Gyroscope rad/s and accelerometer m/s² (N, 3) of an MPU-6050 at rest, and its rate."""
    folder = data / "mpu6050_temperature" / "unmoved-with-x-pointing-forward-10min"
    with h5py.File(folder / "mpu6050_gyroscope.mat") as file:
        gyro = np.array(file["gyroBuffer"])
    with h5py.File(folder / "mpu6050_accelerometer.mat") as file:
        accel = np.array(file["accelBuffer"])
    rate_hz = (gyro.shape[1] - 1) / (gyro[0, -1] - gyro[0, 0])
    return np.deg2rad(gyro[1:].T), 9.80665 * accel[1:].T, float(rate_hz)


def test_a_real_mpu_6050_at_rest_is_near_its_data_sheet(data_folder: Path) -> None:
    """Data sheet, typical: 0.005 °/s/√Hz and 400 µg/√Hz; 10 °/h is usual for its instability."""
    gyro, accel, rate_hz = resting(data_folder)
    assert rate_hz == pytest.approx(100, abs=1)
    _, gyro_models = noise_of(gyro, rate_hz)
    _, accel_models = noise_of(accel, rate_hz)
    for model in gyro_models:
        assert 0.002 < np.rad2deg(model.white) < 0.02
        assert np.rad2deg(model.flicker) * 3600 < 60
    for model in accel_models:
        assert 100e-6 < model.white / 9.80665 < 800e-6
