"""The buffer of recent packets."""

import numpy as np
import pytest

from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.messages import ImuSample
from tracker.online.imu_health import STUCK_AFTER, ImuHealth


def packet(t: float, value: float = 0.0, n: int = 2, valid: bool = True) -> ImuSample:
    return ImuSample(
        t, t, t, 0, np.full((n, 3), value), np.full((n, 3), 2 * value), np.full(n, valid)
    )


def test_interpolates_between_packets_and_their_validity() -> None:
    buffer = ImuBuffer(2)
    buffer.add(packet(1.0, 0.0))
    buffer.add(packet(1.1, 10.0, valid=False))
    middle = buffer.at(1.025)
    assert middle is not None and middle.accel[0, 0] == pytest.approx(2.5)
    assert not middle.valid.any()


def test_rejects_an_old_packet_and_drops_expired_ones() -> None:
    buffer = ImuBuffer(2, span=0.5)
    assert all(buffer.add(packet(0.1 * k)) for k in range(20))
    assert not buffer.add(packet(1.0))
    assert len(buffer) == 6 and [s.t for s in buffer][-2:] == pytest.approx([1.8, 1.9])


def test_health_finds_stuck_and_non_finite_sensors() -> None:
    health, rng = ImuHealth(3), np.random.default_rng(0)
    for k in range(STUCK_AFTER + 2):
        accel, gyro = rng.normal(size=(3, 3)), rng.normal(size=(3, 3))
        accel[0], gyro[0] = 1.0, 1.0
        gyro[1, 2] = np.nan
        out = health.check(ImuSample(k, k, k, k, accel, gyro, np.ones(3, bool)))
    assert out.valid.tolist() == [False, False, True]
    assert np.all(np.isfinite(out.gyro))
