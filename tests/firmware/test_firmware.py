"""The glove's firmware, run on a simulated chip with simulated IMUs, against its protocol."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.firmware.glove_oracle import (
    ASK_HELLO,
    ERROR,
    HAPTIC,
    HELLO,
    IMUS,
    NO_READING,
    PULSE,
    RATE,
    SAMPLE_BYTES,
    SAMPLES,
    START,
    STATUS,
    STOP,
    TEMPERATURES,
    encode,
    samples,
    simulated_glove,
)

pytestmark = pytest.mark.long

GRAVITY = 9.80665
ACCEL_LSB = 16 * GRAVITY / 32768  # of the ranges in HELLO
GYRO_LSB = np.radians(2000) / 32768
INNER_PERIOD_S = 0.001  # sampling period of an MPU-9250
RAMP_S = 20.0


def ramps() -> NDArray[np.float64]:
    """(7, 6) m/s² and rad/s after RAMP_S of a linear rise from 0: all values differ."""
    share = (1 + np.arange(IMUS * 6).reshape(IMUS, 6)) / (IMUS * 6 + 1)
    sign = np.where(np.arange(IMUS * 6).reshape(IMUS, 6) % 2, -1, 1)
    return sign * share * np.array([15 * GRAVITY] * 3 + [np.radians(1900)] * 3)


@pytest.fixture
def ramp_file(tmp_path: Path) -> Path:
    path = tmp_path / "ramp.txt"
    np.savetxt(path, [[0.0] * 43, [RAMP_S, *ramps().ravel()]])
    return path


def test_sends_hello_each_second_and_nothing_else_until_start(build: Path) -> None:
    with simulated_glove(build) as glove:
        first = glove.wait_for(HELLO, 4)[0]
        report = glove.stop()
    assert {f.kind for f in glove.frames} == {HELLO}
    assert first.numbers == (1, 1, 3, 0, 7, IMUS, 2000, 16, 100, 3)
    # Start-up and self-test take half a second, then one a second; a loaded computer stops late.
    assert 3 < report["simulated_s"] < 7


def test_samples_contain_each_imus_readings_at_their_time(build: Path, ramp_file: Path) -> None:
    with simulated_glove(build, motion=ramp_file) as glove:
        glove.start()
        seq, t_us, raw = samples(glove.wait_for(SAMPLES, 200))
    assert np.array_equal(seq, np.arange(200))
    assert np.all(np.diff(t_us) == 10_000)
    lsb = np.array([ACCEL_LSB] * 3 + [GYRO_LSB] * 3)
    felt = raw * lsb
    # Converted to times, the ramps show when each IMU was read: after the time in t_us by at most
    # one round over all IMUs, and the chip's newest sample is at most 1 ms old.
    late = felt / ramps() * RAMP_S - 1e-6 * t_us[:, None, None]
    rounding = lsb / np.abs(ramps()) * RAMP_S
    assert np.all(late < 0.001 + rounding)
    assert np.all(late > -INNER_PERIOD_S - rounding)


@pytest.mark.parametrize(("baud", "rate_hz"), [(250_000, 100), (250_000, 200), (115_200, 100)])
def test_the_line_and_the_chip_keep_up(
    build_firmware: Callable[[int], Path],
    record_property: Callable[[str, object], None],
    baud: int,
    rate_hz: int,
) -> None:
    with simulated_glove(build_firmware(baud)) as glove:
        glove.wait_for(HELLO)
        glove.send(RATE, "H", rate_hz)
        glove.send(START)
        glove.wait_for(SAMPLES)
        start = len(glove.raw)
        seq, t_us, _ = samples(glove.wait_for(SAMPLES, 2 * rate_hz))
        report = glove.stop()
    bytes_per_s = (len(glove.raw) - start) / 2
    record_property("bytes_per_s", bytes_per_s)
    record_property("awake", report["awake"])
    assert np.all(np.diff(seq) == 1), "samples were dropped"
    assert np.all(np.diff(t_us) == 1_000_000 // rate_hz)
    assert SAMPLE_BYTES * rate_hz <= bytes_per_s * 1.02 < 0.95 * baud / 10
    assert glove.of(STATUS)[-1].numbers[3] == 0
    assert report["round_us"] < 1000
    assert report["awake"] < 0.7


def test_115200_baud_rejects_200_hz(build_firmware: Callable[[int], Path]) -> None:
    with simulated_glove(build_firmware(115_200)) as glove:
        glove.start()
        glove.send(RATE, "H", 200)
        assert "250000 baud" in glove.wait_for(ERROR)[0].text
        _, t_us, _ = samples(glove.wait_for(SAMPLES, 20))
    assert np.all(np.diff(t_us) == 10_000)


def test_a_new_rate_applies_at_once_and_is_reported(build: Path) -> None:
    with simulated_glove(build) as glove:
        glove.start()
        glove.wait_for(SAMPLES, 5)
        glove.send(RATE, "H", 50)
        glove.send(RATE, "H", 37)
        glove.wait_for(ERROR)
        glove.send(ASK_HELLO)
        hello = glove.wait_for(HELLO)[0]
        glove.wait_for(SAMPLES, 20)
    _, t_us, _ = samples(glove.of(SAMPLES))
    steps = np.diff(t_us)
    slow = int(np.argmax(steps != 10_000))
    assert hello.numbers[8] == 50
    assert 10_000 < steps[slow] <= 30_000  # part of the old period, then a whole new one
    assert np.all(steps[slow + 1 :] == 20_000)
    assert [f.text for f in glove.of(ERROR)] == ["rate must be 50, 100 or 200 Hz"]


def test_status_each_second_contains_battery_temperature_and_imus(build: Path) -> None:
    with simulated_glove(build, "0:battery 3700") as glove:
        glove.start()
        glove.wait_for(SAMPLES, 310)
    status = [f.numbers for f in glove.of(STATUS)]
    assert 4 <= len(status) <= 5  # one at once, then one a second
    battery_mV, temperature_cC, imu_ok, dropped = status[-1]
    assert abs(battery_mV - 3700) <= 8  # two steps of the converter
    assert abs(temperature_cC - 3100) <= 2
    assert (imu_ok, dropped) == (0b1111111, 0)


def test_stop_ends_the_samples(build: Path) -> None:
    with simulated_glove(build) as glove:
        glove.start()
        glove.wait_for(SAMPLES, 10)
        glove.send(STOP)
        glove.wait_for(HELLO, 2)
        after = [f.kind for f in glove.frames]
    assert set(after[-1 - after[::-1].index(SAMPLES) + 1 :]) == {HELLO}


def test_damaged_commands_are_ignored(build: Path) -> None:
    good = encode(START)
    wrong_crc = good[:2] + bytes([good[2] ^ 1]) + good[3:]
    too_long = encode(START, b"\1")
    with simulated_glove(build) as glove:
        glove.wait_for(HELLO)
        for damaged in (wrong_crc, too_long, b"\xff" * 300 + b"\0", good[1:], b"\0\0\5\1\0"):
            glove.port.write(damaged)
        glove.wait_for(HELLO, 2)
        assert not glove.of(SAMPLES)
        glove.port.write(b"\x82\x03garbage\0" + good)
        glove.wait_for(SAMPLES)


def test_a_missing_imu_is_reported_and_never_reads_as_rest(build: Path) -> None:
    with simulated_glove(build, "0:unplug 3") as glove:
        glove.start()
        absent = glove.wait_for(SAMPLES, 50)
        glove.tell("plug 3")
        glove.read_until(lambda: glove.of(STATUS)[-1].numbers[2] == 0b1111111)
        back = glove.wait_for(SAMPLES, 20)[-10:]
    assert glove.of(ERROR)[0].text == "no answer from IMU 3"
    assert glove.of(STATUS)[0].numbers[2] == 0b1110111
    assert np.all(samples(absent)[2][:, 3] == NO_READING)
    assert np.all(samples(back)[2][:, 3] == [0, 0, 2048, 0, 0, 0])  # at rest, 1 g of ±16 g
    assert np.all(samples(glove.of(SAMPLES))[2][:, [0, 1, 2, 4, 5, 6], 2] == 2048)


def test_no_sample_of_an_imu_that_lost_its_settings_is_sent(build: Path) -> None:
    with simulated_glove(build) as glove:
        glove.start()
        glove.wait_for(SAMPLES, 20)
        glove.tell("brownout 1")
        glove.wait_for(ERROR)
        glove.wait_for(SAMPLES, 130)  # it is restarted within the second
        glove.tell("unplug 5")
        glove.wait_for(ERROR)
        glove.wait_for(SAMPLES, 50)
    _, _, raw = samples(glove.of(SAMPLES))
    gap = raw[:, 1, 2] == NO_READING
    assert 1 <= gap.sum() <= 110
    assert np.all(raw[~gap, 1, 2] == 2048)
    assert not gap[-1]
    assert np.all(raw[-40:, 5] == NO_READING)
    assert [f.text for f in glove.of(ERROR)] == ["no answer from IMU 1", "no answer from IMU 5"]


def test_status_reports_an_imu_before_any_packet_does(build: Path) -> None:
    with simulated_glove(build, "0:unplug 2") as glove:
        glove.start()
        glove.wait_for(SAMPLES, 20)
        glove.tell("unplug 4")
        glove.wait_for(SAMPLES, 30)
        glove.tell("plug 2")
        glove.wait_for(SAMPLES, 150)
    believed = None
    seen = set()
    for frame in glove.frames:
        if frame.kind == STATUS:
            believed = [bool(frame.numbers[2] >> j & 1) for j in range(IMUS)]
        elif frame.kind == SAMPLES:
            answering = np.any(samples([frame])[2][0] != NO_READING, axis=1)
            assert np.array_equal(answering, believed)
            seen.add(tuple(answering))
    assert len(seen) == 3


def test_the_self_test_finds_weak_sensors_and_only_those(build: Path) -> None:
    # IMU 0 has no factory codes, so that its absolute limits are tried as well.
    weak = ("0:weak-gyro 2", "0:weak-accel 4", "0:weak-gyro 4", "0:weak-accel 0")
    with simulated_glove(build, *weak) as glove:
        texts = [f.text for f in glove.wait_for(ERROR, 2)]
        glove.wait_for(HELLO)
    assert texts == [
        "accelerometer self-test failed on IMU 0 4",
        "gyroscope self-test failed on IMU 2 4",
    ]
    assert len(glove.of(ERROR)) == 2


def chip(imu: int, who_am_i: int) -> str:
    return f"0:chip {256 * imu + who_am_i}"


def test_related_chips_and_clones_that_pass_are_used(build: Path) -> None:
    """MPU-6500 (0x70), MPU-9255 (0x73), and two ids that no data sheet has."""
    ids = (0x71, 0x70, 0x73, 0x74, 0x75, 0x71, 0x71)
    with simulated_glove(build, *(chip(j, who) for j, who in enumerate(ids))) as glove:
        first = glove.wait_for(HELLO)[0]
        glove.send(START)
        _, _, raw = samples(glove.wait_for(SAMPLES, 20))
    assert first.chips == [(who, 0) for who in ids]
    assert glove.of(STATUS)[0].numbers[2] == 0b1111111
    assert not glove.of(ERROR)
    assert np.all(raw == [0, 0, 2048, 0, 0, 0])


def test_a_clone_that_fails_its_self_test_is_not_used_and_a_known_chip_is(build: Path) -> None:
    events = (chip(3, 0x74), "0:weak-gyro 3", "0:weak-accel 5", "0:unplug 6")
    with simulated_glove(build, *events) as glove:
        first = glove.wait_for(HELLO)[0]
        glove.read_until(lambda: len(glove.of(ERROR)) == 4)
        texts = [f.text for f in glove.of(ERROR)]
        glove.send(START)
        _, _, raw = samples(glove.wait_for(SAMPLES, 130))  # longer than a second
    assert first.chips[3:] == [(0x74, 2), (0x71, 0), (0x71, 1), (0, 0x80)]
    assert texts == [
        "no answer from IMU 6",
        "unknown chip, not used: IMU 3",
        "accelerometer self-test failed on IMU 5",
        "gyroscope self-test failed on IMU 3",
    ]
    assert glove.of(STATUS)[0].numbers[2] == 0b0110111
    assert np.all(raw[:, [3, 6]] == NO_READING)
    assert np.all(raw[:, 5, 2] == 2048)


def test_an_untested_clone_is_not_used_when_it_is_plugged_in_later(build: Path) -> None:
    with simulated_glove(build, "0:unplug 2", chip(2, 0x75)) as glove:
        glove.start()
        glove.wait_for(SAMPLES, 20)
        glove.tell("plug 2")
        _, _, raw = samples(glove.wait_for(SAMPLES, 230))
    assert np.all(raw[-20:, 2] == NO_READING)


def test_every_imu_has_its_own_temperature(build: Path) -> None:
    with simulated_glove(build, "0:warm 265", "0:unplug 6") as glove:
        glove.start()
        warmth = [f.numbers for f in glove.wait_for(TEMPERATURES, 2)]
    expected = [3100, 3100 + 900, 3100, 3100, 3100, 3100, NO_READING]  # 265 = 256 + 9 °C
    assert warmth[-1] == pytest.approx(expected, abs=2)


def test_motors_run_for_their_time_on_their_own_pins(build: Path) -> None:
    with simulated_glove(build) as glove:
        glove.start()
        glove.send(HAPTIC, "BBH", 0, 200, 150)
        glove.send(HAPTIC, "BBH", 1, 255, 60)
        glove.send(HAPTIC, "BBH", 2, 1, 5000)
        glove.send(HAPTIC, "BBH", 3, 99, 400)  # there is no such motor
        glove.wait_for(SAMPLES, 25)
        glove.send(HAPTIC, "BBH", 2, 0, 100)
        glove.wait_for(SAMPLES, 60)
        glove.stop()
    lines = [line.split()[1:] for line in glove.printed.splitlines() if line.startswith("haptic")]
    changes: dict[int, list[tuple[int, float]]] = {}
    for channel, amplitude, t in lines:
        changes.setdefault(int(channel), []).append((int(amplitude), float(t)))
    lasted = {c: rows[1][1] - rows[0][1] for c, rows in changes.items()}
    assert {c: [a for a, _ in rows] for c, rows in changes.items()} == {
        0: [200, 0],
        1: [255, 0],
        2: [1, 0],
    }
    assert lasted[0] == pytest.approx(0.150, abs=0.002)
    assert lasted[1] == pytest.approx(0.060, abs=0.002)
    assert lasted[2] < 4.9  # stopped before its time


def test_a_reset_while_streaming_shows_as_a_hello(build: Path) -> None:
    # In real time, or simulated seconds would pass before a loaded host answers the HELLO.
    with simulated_glove(build, fast=False) as glove:
        glove.start()
        glove.wait_for(SAMPLES, 200)
        glove.may_cut_off = True
        glove.tell("reset")
        glove.wait_for(HELLO)
        before = len(glove.of(SAMPLES))
        glove.send(START)
        glove.wait_for(SAMPLES, 10)
    seq, t_us, _ = samples(glove.of(SAMPLES))
    assert glove.cut_off <= 1
    assert seq[before] == 0
    assert t_us[before] < t_us[before - 1]


def test_in_real_time_the_packets_have_their_rate(build: Path) -> None:
    with simulated_glove(build, fast=False) as glove:
        glove.start()
        seq, _, _ = samples(glove.wait_for(SAMPLES, 100))
        report = glove.stop()
    assert np.array_equal(seq, np.arange(100))
    assert report["bytes_lost"] == 0


def test_pulses_have_accurate_times(build: Path) -> None:
    """On the clock of the samples, at any phase, although the chip is busy with the IMUs."""
    times = [1.0 + 0.0373 * k for k in range(30)]
    events = [f"{t:.4f}:pulse 50" for t in times]
    with simulated_glove(build, *events) as glove:
        glove.start()
        pulses = [f.numbers for f in glove.wait_for(PULSE, len(times))]
        _, t_us, _ = samples(glove.wait_for(SAMPLES, 5))
        glove.stop()
    assert [number for number, _ in pulses] == list(range(1, len(times) + 1))
    at = [float(line.split()[1]) for line in glove.printed.splitlines() if line[:5] == "pulse"]
    gone = np.diff([t for _, t in pulses])
    assert gone == pytest.approx(1e6 * np.diff(at), abs=15.0)
    assert 0 < t_us[-1] - pulses[-1][1] < 2_000_000


def test_pulses_before_the_start_are_not_reported(build: Path) -> None:
    with simulated_glove(build, "0.8:pulse 50", "2.5:pulse 50") as glove:
        glove.read_until(lambda: "pulse" in glove.printed or len(glove.of(HELLO)) > 2)
        glove.send(START)
        (pulse,) = glove.wait_for(PULSE)
        glove.wait_for(SAMPLES, 20)
        glove.stop()
    assert pulse.numbers[0] == 2 and len(glove.of(PULSE)) == 1
