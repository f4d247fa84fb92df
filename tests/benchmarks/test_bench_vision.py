"""The benchmark's own arithmetic: rows name what they compare."""

import numpy as np
import pytest

from tests.benchmarks.peers_vision import PlainOpenCv
from tests.benchmarks.rows import interleaved
from tests.benchmarks.vision import cpd_rows, make_images
from tracker.vision.colours import ColourProfile, HueRange

CENTRES = {"red": 0, "yellow": 28, "green": 65, "blue": 110}
PROFILE = ColourProfile(
    "four", tuple(HueRange(n, ((h - 11) % 180, h + 11)) for n, h in CENTRES.items())
)


def test_rounds_interleave_the_calls() -> None:
    order: list[str] = []
    interleaved([lambda: order.append("a"), lambda: order.append("b")], rounds=2, inner=2)
    assert "".join(order) == "ab" + "aabb" * 2


def test_each_call_may_have_its_own_number_of_runs() -> None:
    order: list[str] = []
    seconds = interleaved([lambda: order.append("a"), lambda: order.append("b")], 1, [3, 1])
    assert "".join(order) == "ab" + "aaab"
    assert seconds.shape == (2,)


def test_peer_finds_the_markers_too() -> None:
    """A peer that detects nothing would make any ratio look good."""
    (image,) = make_images(PROFILE, "plain", 1, 1)
    uv, hue = PlainOpenCv(PROFILE, (8.5, 51.2)).detect(image.image)
    d = np.hypot(*np.moveaxis(image.uv[:, None] - uv[None], 2, 0))
    found = (d < 4) & (image.hue[:, None] == hue[None])
    assert found.any(axis=1).mean() > 0.95


def test_ratio_is_ours_over_theirs() -> None:
    pytest.importorskip("pycpd")
    for row in cpd_rows(rounds=1, seed=0):
        assert row.peer_value is not None
        assert row.ratio == pytest.approx(row.value / row.peer_value)
        assert row.ratio < 0.1
