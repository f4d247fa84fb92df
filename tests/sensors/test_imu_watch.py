"""Per IMU: chip, self-test, temperature, saturation and stuck axes, from packets to the report."""

from __future__ import annotations

import numpy as np
import pytest

from tests.sensors.scripted_glove import N, Run, Scripted
from tracker.sensors.imu_watch import STUCK_PACKETS, ImuWatch, saturated, selftest_text
from tracker.sensors.protocol import Hello, ImuChip, Samples, Temperatures

CHIPS = (ImuChip(0x70, 0), ImuChip(0x74, 0), ImuChip(0x75, 3))


def test_both_ends_of_the_range_are_saturated_and_no_reading_is_not() -> None:
    raw = np.zeros((4, 6), np.int16)
    raw[1, 2], raw[2, 5], raw[3] = 32767, -32768, -32768
    assert saturated(raw).tolist() == [False, True, True, False]


class Impact(Scripted):
    """IMU 1's gyroscope is at the end of its range in packets 50 to 59."""

    def packet(self, t: float) -> Samples:
        number = self.seq
        samples = super().packet(t)
        if 50 <= number < 60:
            samples.raw[1, 4] = 32767
        return samples


def test_saturated_samples_are_counted_reported_once_and_not_trusted() -> None:
    run = Run(Impact(Hello(5, N)))
    run.go(1.5)
    bad = [k for k, s in enumerate(run.samples) if not s.valid[1]]
    assert bad == list(range(50, 60))
    assert np.isnan(run.samples[55].gyro[1]).all()
    assert all(s.valid[0] and s.valid[2] for s in run.samples)
    assert run.link.report().imus[1].saturated == 10
    assert run.link.figures.values()["imu_1_saturated"] == 10
    assert run.codes.count("glove.imu_saturated") == 1


def test_chips_and_self_tests_are_in_the_report() -> None:
    run = Run(Scripted(Hello(5, N, chips=CHIPS)))
    run.go(0.5)
    imus = run.link.report().imus
    assert [i.chip for i in imus] == [
        "MPU-6500 (0x70)",
        "unknown chip (0x74)",
        "unknown chip (0x75)",
    ]
    assert [i.is_known_chip for i in imus] == [True, False, False]
    assert [i.selftest for i in imus] == ["passed", "passed", "accelerometer and gyroscope failed"]
    found = {n.code: n.values["chip"] for n in run.notices if n.code.startswith("glove.chip")}
    assert found == {"glove.chip_unknown": "0x74", "glove.chip_refused": "0x75"}


def test_older_firmware_has_no_chips_and_no_temperatures() -> None:
    run = Run(Scripted(Hello(5, N, firmware=(1, 0, 0))))
    run.go(0.5)
    assert [(i.chip, i.selftest, i.temperature_cC) for i in run.link.report().imus] == [
        ("", "", None)
    ] * N
    assert not [name for name in run.link.figures.values() if name.startswith("imu_")]


def test_temperatures_reach_the_status() -> None:
    glove = Scripted(Hello(5, N, chips=CHIPS))
    run = Run(glove)
    run.go(0.2)
    glove.put(Temperatures((2510, None, 3120)))
    run.go(0.2)
    assert [i.temperature_cC for i in run.link.report().imus] == [2510, None, 3120]
    values = run.link.figures.values()
    assert values["imu_0_temperature_c"] == pytest.approx(25.1)
    assert "imu_1_temperature_c" not in values


def test_an_axis_that_never_changes_is_stuck() -> None:
    watch, rng = ImuWatch(2), np.random.default_rng(1)
    for _ in range(STUCK_PACKETS + 1):
        raw = rng.integers(-50, 50, (2, 6)).astype(np.int16)
        raw[0, 4] = 17
        watch.add(raw)
    assert watch.stuck(0) == ("gy",) and watch.stuck(1) == ()
    moved = raw.copy()
    moved[0, 4] = 18
    watch.add(moved)
    assert watch.stuck(0) == ()


def test_an_imu_without_any_change_is_absent_rather_than_stuck() -> None:
    watch = ImuWatch(1)
    for _ in range(STUCK_PACKETS + 2):
        watch.add(np.full((1, 6), -32768, np.int16))
    assert watch.stuck(0) == () and watch.saturated.tolist() == [0]


@pytest.mark.parametrize(("flags", "text"), [(0x80, "not run"), (1, "accelerometer failed")])
def test_flags_of_the_self_test(flags: int, text: str) -> None:
    assert selftest_text(flags) == text
