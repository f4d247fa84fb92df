"""A hand measured with a ruler."""

from __future__ import annotations

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.fusion.chain.calibration.measured import RULER_SD, measured_profile
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import PriorParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.reports import length_gain
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel


def test_the_length_and_its_sd_are_those_of_the_ruler(hand: HandModel, glove: GloveModel) -> None:
    layout = ChainLayout(hand, glove)
    gain, n = length_gain(layout), layout.n_dynamic
    profile = measured_profile(layout, 0.170)
    lengths = slice(layout.blocks.scale - n, layout.blocks.joint - n, 2)
    prior = initial_covariance(layout, PriorParams())[n:, n:]
    before = float(gain @ prior[lengths, lengths] @ gain) ** 0.5
    after = float(gain @ profile.P[lengths, lengths] @ gain) ** 0.5
    assert gain @ profile.scale[:, 0] == pytest.approx(0.170, abs=RULER_SD / 2)
    assert after == pytest.approx(1 / np.hypot(1 / before, 1 / RULER_SD), rel=1e-6)
    # girths follow by their correlation with lengths: the regression on the length
    p, length = PriorParams(), float(gain.sum())
    expected = p.alike * p.common_length * p.common_girth * length / (before**2 + RULER_SD**2)
    assert profile.scale[:, 1] == pytest.approx(1 + expected * (0.170 - length), rel=1e-9)


def test_a_hand_of_a_metre_is_rejected(hand: HandModel, glove: GloveModel) -> None:
    with raises(ConfigError, "calibration.hand_length"):
        measured_profile(ChainLayout(hand, glove), 0.018)
