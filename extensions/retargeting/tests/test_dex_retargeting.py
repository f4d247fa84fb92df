"""dex-retargeting's published algorithms follow our data with our configurations, without torch."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("mujoco")
pytest.importorskip("yourdfpy")
pytest.importorskip("yaml")

import yaml

from extensions.retargeting.config import TYPES, landmark
from extensions.retargeting.tests.dex import Dex
from extensions.robot.tests.other_hands import written
from glovetrack.conventions import MEDIAPIPE, operator_frame, to_mediapipe
from tests.fixtures import RESOURCES
from tracker.cli import main
from tracker.geometry import so3
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel
from tracker.messages import Estimate
from tracker.session.reader import SessionReader
from tracker.simulation.gestures import pinch

EVERY = 25  # of 100 estimates per second
CONFIGS = Path(__file__).parents[1] / "configs"
KEYS = {
    *("type", "urdf_path", "add_dummy_free_joint", "target_link_human_indices", "wrist_link_name"),
    *("target_link_names", "target_joint_names", "target_origin_link_names"),
    *("target_task_link_names", "finger_tip_link_names", "scaling_factor", "normal_delta"),
    *("huber_delta", "project_dist", "escape_dist", "has_joint_limits", "ignore_mimic_joint"),
    "low_pass_alpha",
}
"""Fields of dex-retargeting's RetargetingConfig, which refuses others."""


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A simulated recording, tracked."""
    folder = tmp_path_factory.mktemp("dex")
    raw, tracked = folder / "raw.mcap", folder / "tracked.mcap"
    assert main(["simulate", "-o", str(raw), "--duration", "2.5", "--blobs-only"]) == 0
    assert main(["track", str(raw), "-o", str(tracked)]) == 0
    return tracked


@pytest.fixture(scope="module")
def landmarks(session: Path) -> np.ndarray:
    """(n, 21, 3) m from the wrist in the operator frame, in the last second of the recording."""
    out = []
    with SessionReader(session) as reader:
        names = reader.info.keypoint_names
        for e in list(reader.messages((Estimate,)))[-100::EVERY]:
            assert isinstance(e, Estimate)
            points = to_mediapipe(e.keypoints, names)
            R = so3.matrix_from_quat(e.keypoint_q[names.index("wrist")])
            points = points - points[0]
            out.append(points @ operator_frame(points, R))
    return np.array(out)


def wearer_model() -> HandModel:
    return load_hand(RESOURCES / "hands" / "reference-right.toml")


def configured(hand: Path, kind: str) -> Dex:
    """A configuration made for a hand's file, as its users have it."""
    out = hand.with_name(f"{hand.stem}_{kind}.yml")
    assert main(["retargeting-config", str(hand), "--type", kind, "-o", str(out)]) == 0
    return Dex(out)


@pytest.mark.long
def test_vectors_of_our_own_hand_as_a_robot_are_followed_within_millimetres(
    session: Path, landmarks: np.ndarray, tmp_path: Path
) -> None:
    """The robot has the wearer's joints, so that only wrong indices, frames or scales leave an
    error; the scaling factor of 0.96 leaves a few mm."""
    urdf = tmp_path / "own.urdf"
    assert main(["export", str(session), "--format", "urdf", "-o", str(urdf)]) == 0
    dex = configured(urdf, "vector")
    errors = []
    for points in landmarks:
        now, _ = dex.vectors(dex.retarget(points))
        errors.append(np.linalg.norm(now - dex.wanted(points), axis=1))
    assert np.median(errors[1:]) < 0.005
    assert np.percentile(errors[1:], 90) < 0.015


@pytest.mark.long
@pytest.mark.parametrize("name", ["numbered.urdf", "unnamed.xml"])
def test_fingers_of_another_hand_point_where_the_wearers_do(
    name: str, landmarks: np.ndarray, tmp_path: Path
) -> None:
    dex = configured(written(tmp_path, name), "vector")
    fingers = len(dex.config["target_task_link_names"]) // 2 + 1
    angles = []
    for points in landmarks:
        now, wanted = dex.vectors(dex.retarget(points))[0], dex.wanted(points)
        for k in range(1, fingers):  # the thumb is mounted differently
            both = now[k] @ wanted[k] / np.linalg.norm(now[k]) / np.linalg.norm(wanted[k])
            angles.append(np.rad2deg(np.arccos(np.clip(both, -1, 1))))
    assert np.median(angles) < 15.0


@pytest.mark.long
def test_positions_fit_with_the_free_base(landmarks: np.ndarray, tmp_path: Path) -> None:
    dex = configured(written(tmp_path, "numbered.urdf"), "position")
    for points in landmarks[:3]:
        q = dex.retarget(points)
    assert dex.robot.free == 6 and np.abs(q[:3]).max() < 0.2
    now, wanted = dex.vectors(q)[0], dex.wanted(points)
    spread = np.linalg.norm(wanted - wanted.mean(axis=0), axis=1).mean()
    assert np.linalg.norm(now - wanted, axis=1).mean() < 0.6 * spread


@pytest.mark.long
@pytest.mark.parametrize("finger", ["index", "middle"])
def test_dexpilot_closes_a_pinch_and_opens_it(finger: str, tmp_path: Path) -> None:
    dex = configured(written(tmp_path, "lettered.urdf"), "dexpilot")
    hand = wearer_model()

    def gap(angles: np.ndarray) -> float:
        R, p = hand.forward(angles, np.eye(3), np.zeros(3))
        points = to_mediapipe(hand.keypoints(R, p), hand.keypoint_names)
        points = points - points[0]
        for _ in range(3):
            q = dex.retarget(points @ operator_frame(points, np.eye(3)))
        row = next(
            k for k in range(dex.human.shape[1])
            if {*dex.human[:, k]} == {landmark("thumb", -1), landmark(finger, -1)}
        )  # fmt: skip
        return float(np.linalg.norm(dex.vectors(q)[0][row]))

    straight = np.zeros(len(hand.joint_names))
    assert gap(straight) > 0.06
    assert gap(pinch(hand, finger)) < 0.015
    assert gap(straight) > 0.06


@pytest.mark.parametrize("path", sorted(CONFIGS.glob("*.yml")), ids=lambda p: p.stem)
def test_shipped_configurations_have_the_fields_of_dex_retargeting(path: Path) -> None:
    data = yaml.safe_load(path.read_text())
    config, extra = data["retargeting"], data["glovetrack"]
    assert set(config) <= KEYS and config["type"] in TYPES
    assert path.stem.endswith(config["type"])
    R = np.array(extra["R_base_operator"])
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-5)
    indices = np.array(config.get("target_link_human_indices", [[0], [0]]))
    assert indices.max() < len(MEDIAPIPE)
    n = len(extra["fingers"])
    if config["type"] == "vector":
        assert indices.shape == (2, len(config["target_task_link_names"])) == (2, 2 * n - 1)
        assert len(config["target_origin_link_names"]) == 2 * n - 1
        assert list(indices[1, :n]) == [landmark(f, -1) for f in extra["fingers"]]
    elif config["type"] == "position":
        assert indices.shape == (len(config["target_link_names"]),) == (2 * n,)
    else:
        assert len(config["finger_tip_link_names"]) == n


def test_a_configuration_replaces_nothing_without_force(tmp_path: Path) -> None:
    out = tmp_path / "hand.yml"
    words = ["retargeting-config", "-o", str(out), "--type", "dexpilot"]
    if find_spec("gymnasium_robotics") is None:
        pytest.skip("the extra robot is not installed")
    assert main(words) == 0 and (tmp_path / "hand.urdf").is_file()
    assert main(words) == 1 and main([*words, "--force"]) == 0
    assert Dex(out).config["wrist_link_name"] == "palm"
