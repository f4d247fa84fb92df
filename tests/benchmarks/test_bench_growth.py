"""Gloves of other sizes, long sessions, and the exponent of the costs."""

from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks import growth_time as bench_growth_time
from tests.benchmarks.growth import Curve, markdown, plot, write_session
from tests.benchmarks.growth_gloves import with_fingers, with_imus, with_markers
from tests.benchmarks.growth_time import tracked_for
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import ImuSample
from tracker.session.reader import SessionReader


def test_exponent_is_the_slope_on_logarithmic_axes() -> None:
    sizes = (1.0, 2.0, 5.0)
    curve = Curve("things", sizes, "ms", tuple(3.0 * s**1.5 for s in sizes))
    assert curve.exponent == pytest.approx(1.5)
    assert "| things | 1, 2, 5 | 3, 8.49, 33.5 ms | 1.50 |" in markdown([curve])


def test_an_hour_is_measured_by_its_last_minutes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bench_growth_time, "MINUTE", 0.5)
    costs, memory = tracked_for([1, 2, 4])
    assert len(costs) == len(memory) == 3
    assert min(costs) > 0 and min(memory) > 0


def test_further_fingers_have_the_sensors_of_the_middle_one(
    hand: HandModel, glove: GloveModel
) -> None:
    five = with_fingers(hand, glove, 5)
    assert len(five.imus) == 11 and len(five.markers) == 57
    assert {i.segment for i in five.imus} >= {"ring_proximal", "little_intermediate"}
    assert [m.id for m in five.markers] == list(range(57))
    assert with_fingers(hand, glove, 3).imus == glove.imus


def test_imus_and_markers_are_added_to_the_gloves_own(hand: HandModel, glove: GloveModel) -> None:
    full = with_imus(hand, glove, 16)
    assert {i.segment for i in full.imus} == set(hand.segment_names)
    hundred = with_markers(glove, 100)
    positions = np.array([m.position for m in hundred.markers])
    assert len({(m.segment, *m.position) for m in hundred.markers}) == len(positions) == 100


@pytest.mark.long
def test_a_long_session_repeats_its_piece(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tests.benchmarks.growth.PIECE", 2.0)
    path = tmp_path / "long.mcap"
    write_session(path, 6.0)
    with SessionReader(path) as reader:
        t = np.array([m.t for m in reader.messages((ImuSample,)) if isinstance(m, ImuSample)])
    assert len(t) == pytest.approx(600, abs=10)
    assert np.all(np.diff(t) > 0) and np.ptp(t) == pytest.approx(6.0, abs=0.1)


def test_plot_is_a_image(tmp_path: Path) -> None:
    plot([Curve("a", (1.0, 2.0), "s", (1.0, 2.0))], tmp_path / "new" / "growth.png")
    assert (tmp_path / "new" / "growth.png").read_bytes()[:4] == b"\x89PNG"
