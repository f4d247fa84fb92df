"""One of two cameras, or a device with only one."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.cli import main
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.messages import BlobFrame, Blobs
from tracker.vision.lenses import one_camera_rig, through
from tracker.vision.rig import ideal_rig

FRAME = BlobFrame(1.0, 1.1, ("red",), Blobs.empty(), Blobs.empty())


def test_only_the_cameras_in_use_have_blobs() -> None:
    assert through(FRAME, "both") is FRAME
    left, right = through(FRAME, "left"), through(FRAME, "right")
    assert left.left is FRAME.left and left.right is None
    assert right.right is FRAME.right and right.left is None


@pytest.mark.parametrize(
    ("engine", "lenses", "code"),
    [("vist", "left", "engine.needs_both_lenses"), ("chain", "middle", "camera.lenses")],
)
def test_invalid_combinations_are_rejected(
    hand, glove, engine: str, lenses: str, code: str
) -> None:
    with raises(ConfigError, code):
        Pipeline(hand, glove, ideal_rig(), Settings(engine=engine, lenses=lenses))


def test_a_single_camera_projects_as_in_a_pair() -> None:
    camera, pose = ideal_rig().left, ideal_rig().pose
    rig = one_camera_rig(camera, pose)
    p_C = np.array([[0.05, -0.02, 0.4]])
    assert np.array_equal(rig.project(p_C), ideal_rig().project(p_C))
    assert rig.fx == ideal_rig().fx


def test_a_recording_is_tracked_with_one_camera(tmp_path: Path) -> None:
    source, out, report = (tmp_path / n for n in ("in.mcap", "out.mcap", "r.json"))
    short = ["--duration", "3", "--fps", "20", "--blobs-only", "--seed", "4"]
    assert main(["simulate", "-o", str(source), *short]) == 0
    command = ["track", str(source), "-o", str(out), "--lenses", "left", "--json", str(report)]
    assert main(command) == 0
    result = json.loads(report.read_text())
    assert result["lost_s"] < 0.5
    assert 1.0 < result["error_mm"]["mean"] < 30.0
    assert main([*command, "--smooth"]) == 1
