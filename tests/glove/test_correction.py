"""Packets corrected by the measured axes and drift of a glove file, live and from a recording."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.clock import ClockAnchor
from tracker.base.errors import FileError
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove import library
from tracker.glove.correction import ImuCorrection
from tracker.glove.files import parse_glove
from tracker.glove.imu_values import with_axes, with_drift
from tracker.glove.model import GloveModel, ImuAxes, ImuDrift
from tracker.hand.model import HandModel
from tracker.messages import ImuSample
from tracker.session.description import describe
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder

INERTIAL = Settings(engine="inertial")
DRIFT = ImuDrift(np.full(3, 0.002), np.full(3, 1e-4), np.array([0.01, 0, 0]), np.full(3, 1e-3))
AXES = ImuAxes(np.eye(3) + 0.01, np.diag([1.01, 0.99, 1.0]))


def measured_text() -> str:
    """The default glove's file with measurements of its first two IMUs."""
    text = library.text("gloves", library.DEFAULT_GLOVE)
    return with_axes(with_drift(text, {"dorsum": DRIFT}), {"thumb_metacarpal": AXES})


@pytest.fixture(scope="module")
def measured(hand: HandModel) -> GloveModel:
    return parse_glove(measured_text(), hand)


def packet(glove: GloveModel, k: int, celsius: float | None = None) -> ImuSample:
    n, rng = len(glove.imus), np.random.default_rng(k)
    warmth = None if celsius is None else np.full(n, celsius)
    accel, gyro = rng.normal(0, 5, (n, 3)), rng.normal(0, 1, (n, 3))
    t = 0.25 + k / 100
    return ImuSample(t, t, t, k, accel, gyro, np.ones(n, bool), warmth)


def test_the_file_has_what_was_written(measured: GloveModel) -> None:
    np.testing.assert_allclose(measured.imus[0].drift.gyro, DRIFT.gyro, rtol=1e-6)
    np.testing.assert_allclose(measured.imus[0].drift.accel_sd, DRIFT.accel_sd, rtol=1e-6)
    np.testing.assert_allclose(measured.imus[1].axes.accel, AXES.accel, atol=1e-7)
    assert measured.imus[0].axes is None and measured.imus[1].drift is None


def test_a_correction_beyond_the_data_sheet_is_rejected(hand: HandModel) -> None:
    text = library.text("gloves", library.DEFAULT_GLOVE)
    wrong = with_axes(text, {"dorsum": ImuAxes(np.eye(3) * 1.5, np.eye(3))})
    with raises(FileError, "glove.file_axes"):
        parse_glove(wrong, hand)


def test_errors_that_are_known_are_removed(measured: GloveModel) -> None:
    true = packet(measured, 1)
    gyro, accel = true.gyro.copy(), true.accel.copy()
    gyro[0] += DRIFT.gyro * 7.0
    accel[0] += DRIFT.accel * 7.0
    gyro[1] = np.linalg.solve(AXES.gyro, true.gyro[1])
    accel[1] = np.linalg.solve(AXES.accel, true.accel[1])
    wrong = replace(true, gyro=gyro, accel=accel, temperature=np.full(len(gyro), 32.0))
    fixed = ImuCorrection(measured).corrected(wrong)
    np.testing.assert_allclose(fixed.gyro, true.gyro, atol=1e-7)
    np.testing.assert_allclose(fixed.accel, true.accel, atol=1e-6)


def test_a_glove_without_measurements_is_left_alone(glove: GloveModel) -> None:
    sample = packet(glove, 1)
    assert ImuCorrection(glove).corrected(sample) is sample


def test_temperatures_are_recorded_and_tracked_again_identically(
    hand: HandModel, measured: GloveModel, tmp_path: Path
) -> None:
    sent = [packet(measured, k, 25.0 + k if k % 4 == 0 else None) for k in range(12)]
    texts = library.text("hands", measured.hand_name), measured_text()
    path = tmp_path / "warm.mcap"
    with SessionRecorder(path, describe(*texts, ClockAnchor(10**18, 0))) as recorder:
        for sample in sent:
            recorder.write(sample)
    with SessionReader(path) as reader:
        got = [m for m in reader.messages([ImuSample]) if isinstance(m, ImuSample)]
        again = Pipeline(hand, reader.info.glove, None, INERTIAL)
    for a, b in zip(sent, got, strict=True):
        assert (a.temperature is None) == (b.temperature is None)
        assert a.temperature is None or np.array_equal(a.temperature, b.temperature)
    live, stored = ImuCorrection(measured), ImuCorrection(again.glove)
    for a, b in zip(sent, got, strict=True):
        again.feed_imu(b)
        one, two = live.corrected(a), stored.corrected(b)
        assert np.array_equal(one.gyro, two.gyro) and np.array_equal(one.accel, two.accel)
    np.testing.assert_array_equal(again.get_state().celsius, np.full(len(measured.imus), 33.0))
