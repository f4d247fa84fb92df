"""Biases measured at rest reach the filter, and nothing else changes."""

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.wearer_learning import FLOOR, with_gyro_bias
from tracker.vision.rig import ideal_rig


def test_a_measured_bias_is_known_before_the_hand_is_seen(hand, glove):
    engine = Pipeline(hand, glove, ideal_rig()).engine
    assert isinstance(engine, ChainEngine)
    before = engine.calibration()
    n = len(glove.imus)
    bias, sd = np.arange(3.0 * n).reshape(n, 3) * 1e-3, np.full(n, 1e-3)
    bias[2], sd[3] = np.nan, np.nan
    engine.apply_profile(with_gyro_bias(engine.profile(), engine.layout, bias, sd))
    after = engine.calibration()
    for i, imu in enumerate(glove.imus):
        row = after.segments.index(imu.segment)
        if i in (2, 3):
            np.testing.assert_array_equal(after.gyro_bias[row], before.gyro_bias[row])
            np.testing.assert_array_equal(after.gyro_bias_sd[row], before.gyro_bias_sd[row])
            continue
        assert after.gyro_bias[row] == pytest.approx(bias[i])
        assert after.gyro_bias_sd[row] == pytest.approx(np.full(3, np.hypot(1e-3, FLOOR)))
        np.testing.assert_array_equal(after.mounting_sd[row], before.mounting_sd[row])
    assert np.linalg.eigvalsh(engine.profile().P).min() > 0
