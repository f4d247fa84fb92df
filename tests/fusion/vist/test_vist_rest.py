"""When a hand counts as keeping still, and what is made of a search."""

import numpy as np
import pytest

from tracker.fusion.chain.params import MatchParams
from tracker.fusion.vist.rest import is_still
from tracker.fusion.vist.tracker import Track, is_better
from tracker.messages import ImuSample, Tracking


def packets(turn: float, shake: float, silent: bool = False) -> list[ImuSample]:
    """Half a second at 100 Hz: a steady turn (rad/s), a force that swings by ``shake`` (m/s²)."""
    out = []
    for k in range(50):
        accel = np.array([[0.0, 0.0, 9.8 + shake * np.sin(0.5 * k)]])
        gyro = np.array([[turn + 0.1, 0.0, 0.0]])
        out.append(ImuSample(k / 100, k / 100, 0, k, accel, gyro, np.array([not silent])))
    return out


@pytest.mark.parametrize(
    ("turn", "shake", "silent", "still"),
    [
        (0.0, 0.0, False, True),
        (0.2, 1.0, False, True),  # sway and tremor
        (1.0, 0.0, False, False),
        (0.0, 6.0, False, False),
        (0.0, 0.0, True, False),
    ],
)
def test_rest(turn, shake, silent, still):
    bias = np.array([0.1, 0.0, 0.0])
    assert is_still(packets(turn, shake, silent), 0.49, 0, bias) is still


def track(**values) -> Track:
    return Track(seen=np.zeros(1), felt=np.zeros(1), tip_sd=np.array([0.01]), **values)


def test_lost_means_that_the_place_is_uncertain():
    t = track(tracking=Tracking.TRACKING, last_good=0.0)
    t.judge(5.0, False, MatchParams())
    assert t.tracking == Tracking.COASTING
    t.tip_sd = np.array([0.2])
    t.judge(5.1, False, MatchParams())
    assert t.tracking == Tracking.LOST
    t.judge(5.2, True, MatchParams())
    assert t.tracking == Tracking.TRACKING


@pytest.mark.parametrize(
    ("recognised", "matched", "expected", "believed"),
    [(10, 2, 12.0, True), (4, 0, 5.0, False), (6, 6, 8.0, False), (6, 1, 14.0, False)],
)
def test_a_found_place_must_explain_what_is_seen(recognised, matched, expected, believed):
    assert is_better(recognised, matched, expected) is believed
