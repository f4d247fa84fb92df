"""A session with a reference that is tracked again."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from extensions.reference.registration import Registration
from extensions.reference.session import Described, read_imported, write_with_reference
from extensions.reference.timing import ReferenceTiming
from tracker.offline.options import SimulateOptions, TrackOptions
from tracker.offline.simulate import simulate
from tracker.offline.track import track
from tracker.session.reader import SessionReader


@pytest.mark.long
@pytest.mark.parametrize("smooth", [False, True])
def test_the_new_session_has_the_reference(smooth: bool, tmp_path: Path) -> None:
    """So another engine's accuracy is reported without another import."""
    whole, referenced = tmp_path / "whole.mcap", tmp_path / "referenced.mcap"
    simulate(whole, SimulateOptions(seed=4, duration=1.0, images=False))
    names = ("index_tip", "wrist")
    none = Registration(np.eye(3), np.zeros(3), 0.0, 1.0, np.zeros((2, 3)), np.zeros((2, 3)))
    about = Described(
        "lab.c3d", "c3d", 50.0, names, ReferenceTiming("clock", 0.0), none, none,
        np.zeros((2, 2)), 1.0, (),
    )  # fmt: skip
    with SessionReader(whole) as reader:
        stamps = np.arange(*reader.span_ns, 20_000_000)
        points = np.random.default_rng(1).normal(size=(len(stamps), 2, 3))
        write_with_reference(reader, referenced, about, stamps, points)
    track(referenced, tmp_path / "tracked.mcap", TrackOptions(smooth=smooth))
    with SessionReader(tmp_path / "tracked.mcap") as reader:
        found = read_imported(reader)
        assert list(reader.truth())
    np.testing.assert_array_equal(found.stamp_ns, stamps)
    np.testing.assert_array_equal(found.points, points)
    assert found.about.keypoints == names and found.about.file == "lab.c3d"
