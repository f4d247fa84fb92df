"""Sessions with one camera and with none: one image stream or none, tracked again and exported."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.notices import shows
from tracker.cli import main
from tracker.messages import BlobFrame, Estimate, StereoFrame
from tracker.session.reader import SessionReader

SHORT = ["--duration", "2", "--fps", "20", "--seed", "4"]


def simulate(path: Path, *words: str) -> Path:
    assert main(["simulate", "-o", str(path), *SHORT, *words]) == 0
    return path


@pytest.fixture(scope="module")
def one(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return simulate(tmp_path_factory.mktemp("one") / "one.mcap", "--lenses", "one")


def test_it_has_one_image_stream_and_one_camera(one: Path) -> None:
    with SessionReader(one) as reader:
        assert not [name for name in reader.topic_names if name.startswith("/camera/right")]
        assert reader.rig().one_camera
        assert [rig for _, rig in reader.rig_changes()] == []
        frames = [m for m in reader.messages((StereoFrame,)) if isinstance(m, StereoFrame)]
    assert len(frames) > 30
    assert all(f.left is not None and f.right is None for f in frames)


def test_it_is_complete_tracked_again_and_exported(one: Path, tmp_path: Path) -> None:
    out, again, report = tmp_path / "out.mcap", tmp_path / "again.mcap", tmp_path / "r.json"
    command = ["track", str(one), "-o", str(out), "--with-sensors", "--json", str(report)]
    assert main(command) == 0
    assert json.loads(report.read_text())["lost_s"] < 0.5
    assert main(["verify", str(out)]) == 0
    with SessionReader(out) as reader:
        estimates = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)]
        assert reader.rig().one_camera
    assert estimates[-1].keypoint_sd.min() > 0.008  # 5 % of the distance, over three axes
    assert main(["track", str(out), "-o", str(again)]) == 0
    assert main(["compare", str(out), str(again)]) == 0
    assert main(["export", str(out), "--format", "csv", "-o", str(tmp_path / "out.csv")]) == 0
    assert len((tmp_path / "out.csv").read_text().splitlines()) > 100


def test_vist_and_smoothing_report_that_they_need_two_cameras(
    one: Path, tmp_path: Path, capsys
) -> None:
    command = ["track", str(one), "-o", str(tmp_path / "o.mcap")]
    assert main([*command, "--engine", "vist"]) == 1
    assert shows(capsys.readouterr().err, "engine.needs_both_lenses", engine="vist")
    assert main([*command, "--smooth"]) == 1
    assert shows(capsys.readouterr().err, "track.smooth_lenses")
    assert main([*command, "--lenses", "right"]) == 1
    assert shows(capsys.readouterr().err, "camera.one_is_left")


def test_a_measured_hand_has_its_length(one: Path, tmp_path: Path, capsys) -> None:
    out = tmp_path / "o.mcap"
    command = ["track", str(one), "-o", str(out)]
    assert main([*command, "--hand-length", "30"]) == 1
    assert shows(capsys.readouterr().err, "calibration.hand_length")
    assert main([*command, "--hand-length", "186"]) == 0


def test_without_a_camera_it_contains_the_glove_alone(tmp_path: Path) -> None:
    source = simulate(tmp_path / "none.mcap", "--lenses", "none")
    with SessionReader(source) as reader:
        assert not [name for name in reader.topic_names if name.startswith("/camera")]
        assert not any(isinstance(m, BlobFrame) for m in reader.messages())
    out = tmp_path / "out.mcap"
    assert main(["track", str(source), "-o", str(out), "--engine", "inertial"]) == 0
    with SessionReader(out) as reader:
        last = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)][-1]
    assert np.isfinite(last.angles).any() and np.isnan(last.keypoints).all()
