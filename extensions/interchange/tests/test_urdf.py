"""URDF files, read by yourdfpy."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yourdfpy

from tracker.messages import Estimate
from tracker.session.export.run import export
from tracker.session.writer import SessionRecorder


@pytest.fixture
def tracked(tmp_path: Path, record: Callable[..., Path], maker) -> tuple[Path, list[Estimate]]:
    """Thirty random poses at 100 Hz, the thumb's keypoint 3 and angle 2 lost in some."""
    estimates = [maker.estimate(10.0 * k, lost=k % 10 > 7) for k in range(30)]
    return record(tmp_path / "in.mcap", estimates), estimates


def test_urdf_moves_like_the_hand(tracked, tmp_path: Path, session_info) -> None:
    path, estimates = tracked
    export(path, "urdf", tmp_path / "o.urdf")
    robot = yourdfpy.URDF.load(str(tmp_path / "o.urdf"), load_meshes=False)
    hand, e = session_info.hand, estimates[3]
    assert set(hand.joint_names) < set(robot.actuated_joint_names)
    robot.update_cfg(dict(zip(hand.joint_names, e.angles, strict=True)))
    R, p = hand.forward(e.angles, np.eye(3), np.zeros(3))
    for i, name in enumerate(hand.segment_names):
        T = robot.get_transform(name, hand.segment_names[0])
        assert np.allclose(T[:3, 3], p[i], atol=1e-6), name
        assert np.allclose(T[:3, :3], R[i], atol=1e-6), name


def test_urdf_has_the_calibrated_size(tmp_path: Path, session_info, maker) -> None:
    calibration = maker.calibration(0)
    scale = np.array([[1.2, 1.0, 1.0], [0.9, 1, 1]])
    with SessionRecorder(tmp_path / "in.mcap", session_info) as recorder:
        recorder.write(replace(calibration, scale=scale))
    export(tmp_path / "in.mcap", "urdf", tmp_path / "o.urdf")
    robot = yourdfpy.URDF.load(str(tmp_path / "o.urdf"), load_meshes=False)
    hand = session_info.hand
    T = robot.get_transform("index_proximal", "dorsum")
    origin = hand.segments[hand.index["index_proximal"]].origin
    assert np.allclose(T[:3, 3], origin * [1.2, 1, 1], atol=1e-9)
