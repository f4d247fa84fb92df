"""The Isaac record of a session."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from extensions.conformance.run import read_records
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.messages import Estimate
from tracker.session.export.axes import AXES
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import export

Y_UP = AXES["y-up"].rows


@pytest.fixture
def tracked(tmp_path: Path, record: Callable[..., Path], maker) -> tuple[Path, list[Estimate]]:
    """Thirty random poses at 100 Hz, the thumb's keypoint 3 and angle 2 lost in some."""
    estimates = [maker.estimate(10.0 * k, lost=k % 10 > 7) for k in range(30)]
    return record(tmp_path / "in.mcap", estimates), estimates


def test_isaacs_record_has_every_estimate_with_its_stamps(tracked, tmp_path: Path) -> None:
    """That NVIDIA's replay opens such files is tested in extensions/conformance/tests."""
    path, estimates = tracked
    export(path, "isaac", tmp_path / "take.mcap")
    found = list(read_records(tmp_path / "take.mcap"))
    assert [side for side, _ in found] == ["right"] * len(estimates)
    for e, (_, record) in zip(estimates, found, strict=True):
        assert record.stamps.sample == round(e.t * 1e9)
        assert record.stamps.available >= record.stamps.sample
        assert record.joints["is_valid"].all() == (e.keypoint_state[3] != 0)
        wrist = record.joints[1]["position"]
        assert np.allclose(wrist, Y_UP @ e.keypoints[0], atol=1e-6)
    with raises(ConfigError, "export.not_supported"):
        export(path, "isaac", tmp_path / "o.mcap", ExportOptions(axes="ros"))
