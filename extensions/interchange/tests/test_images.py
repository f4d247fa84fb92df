"""Films and folders of images, read by OpenCV and Pillow."""

import csv
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from PIL import Image

from tests.notices import raises
from tracker.base.errors import FileError
from tracker.cli import main
from tracker.messages import CameraPose
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import export
from tracker.session.writer import SessionRecorder


def test_mp4_in_opencv(tmp_path: Path, record: Callable[..., Path], maker, session_info) -> None:
    pose = CameraPose(np.diag([1.0, -1, -1]), np.array([0.0, 0, 0.5]))
    info = replace(session_info, rig=replace(session_info.rig, pose=pose))
    hand = info.hand
    angles = np.zeros(len(hand.joint_names))
    R, p = hand.forward(angles, np.eye(3), np.zeros(3))
    keypoints = info.glove.keypoint_positions(hand, R, p)
    with SessionRecorder(tmp_path / "in.mcap", info) as recorder:
        for k in range(10):
            frame = maker.image(20.0 * k, k)
            recorder.write(replace(frame, left=np.zeros((48, 64, 3), np.uint8)))
            recorder.write(replace(maker.estimate(20.0 * k), keypoints=keypoints))
    export(tmp_path / "in.mcap", "mp4", tmp_path / "o.mp4")
    video = cv2.VideoCapture(str(tmp_path / "o.mp4"))
    assert video.get(cv2.CAP_PROP_FRAME_COUNT) == 10
    assert video.get(cv2.CAP_PROP_FPS) == pytest.approx(50, rel=0.02)
    _, image = video.read()
    u, v = np.round(info.rig.project((keypoints[0] - pose.p_GC) @ pose.R_GC)).astype(int)
    assert image[v, u, 1] > 100


@pytest.fixture
def filmed(tmp_path: Path, maker, session_info) -> Path:
    """Twenty grey images at 50 a second, each brighter than the last, and a still hand."""
    info = replace(
        session_info,
        rig=replace(
            session_info.rig, pose=CameraPose(np.diag([1.0, -1, -1]), np.array([0.0, 0, 0.5]))
        ),
    )
    still = maker.estimate(0)
    with SessionRecorder(tmp_path / "in.mcap", info) as recorder:
        for k in range(20):
            grey = np.full((48, 64, 3), 10 * k, np.uint8)
            recorder.write(replace(maker.image(20.0 * k, k), left=grey))
            recorder.write(replace(still, t=maker.estimate(20.0 * k).t))
    return tmp_path / "in.mcap"


def test_png_folder_in_pillow(filmed: Path, tmp_path: Path) -> None:
    out = tmp_path / "images"
    assert main(["export", str(filmed), "--format", "png", "-o", str(out), "--every", "4"]) == 0
    names = sorted(p.name for p in out.glob("*.png"))
    assert names == [f"{k:06d}.png" for k in range(5)]
    with (out / "pictures.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [r["file"] for r in rows] == names
    assert float(rows[1]["t"]) - float(rows[0]["t"]) == pytest.approx(0.08, abs=1e-6)
    with Image.open(out / names[2]) as image:
        assert image.size == (64, 48)
        assert np.median(np.asarray(image)) == pytest.approx(80, abs=4)
    assert json.loads((tmp_path / "images.json").read_text())["pictures"] == 5
    with raises(FileError, "file.occupied"):
        export(filmed, "png", out)
    assert not list(tmp_path.glob(".*.part"))


@pytest.mark.parametrize(("rate", "count"), [(25.0, 10), (100.0, 39)])
def test_a_film_at_another_rate_lasts_as_long(
    filmed: Path, tmp_path: Path, rate: float, count: int
) -> None:
    export(filmed, "mp4", tmp_path / "o.mp4", ExportOptions(rate=rate))
    video = cv2.VideoCapture(str(tmp_path / "o.mp4"))
    assert video.get(cv2.CAP_PROP_FPS) == pytest.approx(rate, rel=0.01)
    assert video.get(cv2.CAP_PROP_FRAME_COUNT) == count
