"""Colours adapted to a session's light are reproducible, and so are the estimates."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tracker.messages import Estimate
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.offline.track_report import TrackReport
from tracker.session.reader import SessionReader
from tracker.simulation.render import Image, Renderer

pytestmark = pytest.mark.long

WARM = np.array([0.45, 1.0, 1.3])  # of blue, green and red, in the end
BEGIN, END = 0.7, 1.4  # s, start and end of the lamp's change


def lit(image: Image, t: float) -> Image:
    share = np.clip((t - BEGIN) / (END - BEGIN), 0.0, 1.0)
    return np.clip(image * WARM**share, 0, 255).astype(np.uint8)


def keypoints(path: Path, side: str) -> np.ndarray:
    with SessionReader(path, side=side) as reader:
        return np.array([m.keypoints for m in reader.messages((Estimate,))])


@pytest.mark.parametrize(("hands", "smooth"), [("right", True), ("both", False)])
def test_adapted_colours_are_reproducible(
    hands: str, smooth: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """For any number of threads that search the images."""
    drawn = Renderer.images
    monkeypatch.setattr(
        Renderer, "images", lambda self, t: tuple(lit(x, t) for x in drawn(self, t))
    )
    source = tmp_path / "in.mcap"
    simulate(source, SimulateOptions(seed=3, duration=2.3, fps=10, hands=hands))
    reports: list[TrackReport] = []
    for threads in (1, 3):
        out = tmp_path / f"{threads}.mcap"
        reports.append(track(source, out, TrackOptions(smooth=smooth), threads=threads))
    for report in reports:
        own = report.hands.get("right", report)
        assert "colours.followed" in [n.code for n in own.notices]
        assert own.lost_s < 0.5
    for side in ("left", "right") if hands == "both" else ("right",):
        one, three = (keypoints(tmp_path / f"{n}.mcap", side) for n in (1, 3))
        assert len(one) > 150 and np.isfinite(one[-1]).all()
        np.testing.assert_array_equal(one, three)
