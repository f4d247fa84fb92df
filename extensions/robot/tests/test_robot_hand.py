"""The content read from an MJCF: fingers, palm, limits; the mirrored hand; its URDF."""

from __future__ import annotations

import numpy as np
import pytest

from extensions.robot.retarget import Retargeter
from extensions.robot.settings import RobotSettings
from extensions.robot.tests.hands import adroit, shadow
from extensions.robot.wearer_hand import FINGERS
from tests.notices import raises
from tracker.base.errors import ConfigError


def test_the_shadow_hand_is_read_as_in_its_file() -> None:
    hand = shadow()
    assert hand.name == "shadow_right"
    assert [f.name for f in hand.anatomy.fingers] == list(FINGERS)
    assert len(hand.joint_names) == 22  # of 24: the wrist's two are carried
    assert not {"WRJ0", "WRJ1"} & set(hand.joint_names)
    index = hand.anatomy.fingers[1]
    assert [hand.joint_names[j] for j in index.joints] == ["FFJ3", "FFJ2", "FFJ1", "FFJ0"]
    assert index.length == pytest.approx(0.045 + 0.025 + 0.026)  # the file's numbers
    assert index.knuckle == pytest.approx([0.095 - 0.099, 0.022, 0.0], abs=1e-6)
    row = hand.joint_names.index("THJ0")
    assert hand.limits[row] == pytest.approx([-1.571, 0.0])
    assert hand.torque[row] == pytest.approx(0.81)


def test_the_last_two_joints_of_a_shadow_finger_are_coupled() -> None:
    couplings = shadow().anatomy.couplings
    assert len(couplings) == 4
    names = [{shadow().joint_names[j] for j in np.flatnonzero(row)} for row in couplings]
    assert names == [{f"{f}J0", f"{f}J1"} for f in ("FF", "MF", "RF", "LF")]


def test_a_left_hand_is_the_mirrored_right_one_at_every_posture() -> None:
    right, left = shadow(), shadow("left")
    assert (right.anatomy.side, left.anatomy.side) == ("right", "left")
    assert left.joint_names == right.joint_names
    assert left.limits == pytest.approx(right.limits)
    one, other = Retargeter(right, 1.0), Retargeter(left, 1.0)
    rng = np.random.default_rng(3)
    for _ in range(5):
        q = rng.uniform(*right.limits.T)
        assert other.tips(q) == pytest.approx(one.tips(q) * [1, -1, 1], abs=1e-5)


def test_another_model_is_loaded_by_its_path_even_with_an_arm() -> None:
    hand = adroit()
    assert hand.name == "adroit_relocate_right"
    assert len(hand.joint_names) == 22
    assert hand.anatomy.side == "right"
    assert all(f.length == pytest.approx(0.0965, abs=2e-3) for f in hand.anatomy.fingers)


def test_a_model_without_a_hand_is_an_error(tmp_path) -> None:
    from extensions.robot.hand import load_hand

    path = tmp_path / "ball.xml"
    path.write_text("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")
    with raises(ConfigError, "robot.no_fingers"):
        load_hand(RobotSettings(model=str(path)))
    path.write_text("<mujoco><worldbody>")
    with raises(ConfigError, "robot.not_usable"):
        load_hand(RobotSettings(model=str(path)))
    with raises(ConfigError, "robot.unknown_hand"):
        load_hand(RobotSettings(model="nowhere"))


def test_a_reader_of_urdf_finds_the_fingertips_where_mujoco_has_them(tmp_path) -> None:
    yourdfpy = pytest.importorskip("yourdfpy")
    from extensions.robot.urdf import robot_urdf

    hand = shadow()
    path = tmp_path / "hand.urdf"
    path.write_text(robot_urdf(hand))
    robot = yourdfpy.URDF.load(str(path), load_meshes=False)
    q = np.random.default_rng(1).uniform(*hand.limits.T)
    robot.update_cfg(dict(zip(hand.joint_names, q, strict=True)))
    tips = Retargeter(hand, 1.0).tips(q)
    for k, (finger, name) in enumerate(zip(hand.anatomy.fingers, _bodies(), strict=True)):
        T = robot.get_transform(name, "palm_frame")
        assert T[:3, :3] @ finger.tip + T[:3, 3] == pytest.approx(tips[k], abs=1e-6)


def _bodies() -> list[str]:
    from extensions.robot.fingers import plain

    return [plain(shadow().model.body(f.body).name) for f in shadow().anatomy.fingers]
