"""Hands of other makes by their path: fingers are found, may be corrected, and follow."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from extensions.robot.finger_map import FingerMap, map_from_text, map_given, read_map, write_map
from extensions.robot.retarget import Retargeter
from extensions.robot.settings import RobotSettings
from extensions.robot.teleop import Teleop
from extensions.robot.tests.hands import wearer, wearer_model
from extensions.robot.tests.other_hands import BONES, THUMB, written
from extensions.robot.wearer_hand import FINGERS
from glovetrack.conventions import R_B_OPERATOR
from tests.notices import raises, shows
from tracker.base.errors import ConfigError, FileError
from tracker.base.frozen_dict import FrozenDict
from tracker.cli import main
from tracker.simulation.gestures import FIST
from tracker.simulation.postures import posture

LINKS = {
    "numbered.urdf": "link_15.0_tip link_3.0_tip link_7.0_tip link_11.0_tip",
    "left.urdf": "link_15.0_tip link_3.0_tip link_7.0_tip link_11.0_tip",
    "lettered.urdf": "rh_THtip rh_FFtip rh_MFtip rh_RFtip rh_LFtip",
    "unnamed.xml": "e_3 a_3 b_3 c_3 d_3",
}
RIGHT = [name for name in LINKS if name != "left.urdf"]


@pytest.fixture
def hand_file(tmp_path: Path) -> Callable[[str], Path]:
    return lambda name: written(tmp_path, name)


def read(path: Path, fingers: str = ""):
    from extensions.robot.hand import read_hand

    return read_hand(path, map_from_text(fingers))


def load(path: Path, side: str = "right", fingers: str = ""):
    from extensions.robot.hand import load_hand

    return load_hand(RobotSettings(model=str(path), side=side, fingers=fingers, objects=""))


@pytest.mark.parametrize("name", LINKS)
def test_fingers_are_found_by_name_or_by_position(name, hand_file) -> None:
    file = read(hand_file(name))
    found = [file.fingers.links[f] for f in FINGERS if file.fingers.links[f]]
    assert found == LINKS[name].split()
    assert set(file.found.how.values()) == {"name" if name == "lettered.urdf" else "position"}
    assert file.anatomy.side == ("left" if name == "left.urdf" else "right")
    lengths = [f.length for f in file.anatomy.fingers]
    assert lengths == pytest.approx([sum(THUMB)] + [sum(BONES)] * (len(found) - 1), abs=1e-6)


@pytest.mark.parametrize("name", LINKS)
def test_the_palms_axes_are_those_of_the_base_by_construction(name, hand_file) -> None:
    """x of P along the fingers, z out of the back; the files have z along the fingers and x out of
    the palm, which is dex-retargeting's convention."""
    file = read(hand_file(name))
    np.testing.assert_allclose(file.anatomy.R_WP @ R_B_OPERATOR, np.eye(3), atol=1e-6)


@pytest.mark.parametrize("name", ["numbered.urdf", "lettered.urdf"])
def test_a_reader_of_urdf_has_the_fingertips_at_the_same_positions(name, hand_file) -> None:
    yourdfpy = pytest.importorskip("yourdfpy")
    path = hand_file(name)
    hand, file = load(path), read(path)
    robot = yourdfpy.URDF.load(str(path), load_meshes=False, load_collision_meshes=False)
    base = "base_link" if name == "numbered.urdf" else "rh_palm"
    q = np.random.default_rng(1).uniform(*hand.limits.T)
    q = _with_mimics(hand, q)
    joints = [file.model.joint(j).name for j in range(file.model.njnt)]
    robot.update_cfg(dict(zip(joints, q, strict=True)))
    tips = Retargeter(hand, 1.0).tips(q)
    middle = {"numbered.urdf": [0, 0, 0.09], "lettered.urdf": [0, 0.011, 0.095]}[name]
    for row, finger in enumerate(FINGERS):
        if link := file.fingers.links[finger]:
            at = robot.get_transform(link, base)[:3, 3] - middle
            assert R_B_OPERATOR @ at == pytest.approx(tips[row], abs=1e-6)


def _with_mimics(hand, q: np.ndarray) -> np.ndarray:
    for row, to in zip(hand.anatomy.couplings, hand.anatomy.coupled_to, strict=True):
        j, source = int(np.argmax(row == 1.0)), int(np.argmax(row < 0))
        q[j] = to - row[source] * q[source]
    return q


@pytest.mark.parametrize("name", RIGHT)
def test_the_mirrored_hand_is_the_other_side_at_every_posture(name, hand_file) -> None:
    path = hand_file(name)
    right, left = load(path), load(path, "left")
    one, other = Retargeter(right, 1.0), Retargeter(left, 1.0)
    rng = np.random.default_rng(3)
    for _ in range(3):
        q = rng.uniform(*right.limits.T)
        assert other.tips(q) == pytest.approx(one.tips(q) * [1, -1, 1], abs=1e-5, nan_ok=True)


def test_a_joint_that_mimics_another_is_coupled_to_it(hand_file) -> None:
    hand = load(hand_file("lettered.urdf"))
    j1, j2 = hand.joint_names.index("FFJ1"), hand.joint_names.index("FFJ2")
    row = next(i for i, r in enumerate(hand.anatomy.couplings) if r[j1])
    assert hand.anatomy.couplings[row, [j1, j2]] == pytest.approx([1.0, -0.9])
    assert hand.anatomy.coupled_to[row] == pytest.approx(0.02)
    fingers = Retargeter(hand, 100.0)
    wanted = fingers.tips(_with_mimics(hand, np.where(hand.limits[:, 1] > 1, 0.8, 0.0)))
    for _ in range(30):
        q = fingers.step(wanted, np.ones(5, bool), 0.01)
    assert fingers.error.max() < 1e-3
    assert q[j1] - 0.9 * q[j2] == pytest.approx(0.02, abs=0.02)


def test_what_does_not_belong_to_the_hand_is_removed(hand_file) -> None:
    file = read(hand_file("lettered.urdf"))
    names = {file.model.body(b).name for b in range(file.model.nbody)}
    assert "rh_palm" in names and "camera" not in names
    assert not [j for j in range(file.model.njnt) if "WRJ" in file.model.joint(j).name]
    other = read(hand_file("unnamed.xml")).model
    assert "lamp" not in {other.body(b).name for b in range(other.nbody)}


def test_links_without_a_shape_are_drawn_along_their_bones(hand_file) -> None:
    """The meshes of this file are not there: capsules end at the next joints."""
    model = read(hand_file("numbered.urdf")).model
    geom = model.geom(int(model.body_geomadr[model.body("link_1.0").id]))
    assert geom.type[0] == 3 and geom.size[1] == pytest.approx(BONES[0] / 2)


@pytest.mark.long
@pytest.mark.parametrize("name", LINKS)
def test_each_hand_follows_a_fist_and_is_stable(name, hand_file) -> None:
    side = "left" if name == "left.urdf" else "right"
    teleop = Teleop(
        RobotSettings(model=str(hand_file(name)), side=side, objects=""),
        load(hand_file(name), side),
    )
    fist = posture(wearer_model(side), FIST)
    for k in range(150):
        shown = wearer(min(k / 100, 1.0) * fist, (0.0, 0.0, 0.3), t=k * 0.01, side=side)
        state = teleop.feed(shown)
    for finger in teleop.hand.anatomy.fingers:
        if finger.name != "thumb":
            assert np.abs(state.joints[list(finger.joints)]).sum() > 2.0
    assert np.abs(state.joints - state.command).max() < 0.25  # fingers may rest on the palm
    first = teleop.fingers.tips(np.clip(0.0, *teleop.hand.limits.T))
    last = teleop.fingers.tips(state.joints)
    palmwards = (last - first)[[FINGERS.index(f.name) for f in teleop.hand.anatomy.fingers], 2]
    assert (palmwards[1:] < -0.01).all()


def test_a_users_choice_counts_and_the_others_are_found_around_it(hand_file) -> None:
    path = hand_file("numbered.urdf")
    file = read(path, "index=link_11.0_tip")
    assert [file.fingers.links[f] for f in FINGERS[1:]] == [
        "link_11.0_tip", "link_3.0_tip", "link_7.0_tip", ""
    ]  # fmt: skip
    assert file.found.how["index"] == "user"
    absent = read(path, "ring=")
    assert absent.fingers.links["ring"] == "" and absent.fingers.links["little"] == "link_11.0_tip"
    last_joint = read(path, "middle=link_7.0")  # a moving link: its end, not the link fixed to it
    assert last_joint.fingers.links["middle"] == "link_7.0"
    assert read(path, "palm=base_link").fingers.links["palm"] == "base_link"


def test_wrong_choices_are_errors_with_a_code(hand_file) -> None:
    path = hand_file("numbered.urdf")
    with raises(ConfigError, "robot.no_link"):
        read(path, "index=nothing")
    with raises(ConfigError, "robot.finger"):
        RobotSettings(fingers="toe=link_3.0_tip")
    with raises(ConfigError, "robot.finger"):
        RobotSettings(fingers="a word")
    with raises(ConfigError, "robot.link_twice"):
        RobotSettings(fingers="index=a,ring=a")
    with raises(ConfigError, "robot.no_fingers"):
        read(path, "thumb=")


def test_links_are_kept_as_text_and_in_files(tmp_path: Path) -> None:
    fingers = FingerMap(FrozenDict({"thumb": "a,b=c", "index": "x/y:z", "little": "", "palm": "p"}))
    assert map_from_text(fingers.text) == fingers
    path = tmp_path / "links.toml"
    write_map(path, fingers)
    assert read_map(path) == fingers == map_given(str(path))
    with pytest.raises(FileError):
        write_map(path, fingers)
    path.write_text("[other]\n")
    with raises(ConfigError, "robot.no_finger_table"):
        read_map(path)
    assert fingers.with_link("ring", "x/y:z").links.get("index") is None


def test_the_command_lists_fingers_and_writes_links_that_teleop_reads(
    tmp_path: Path, hand_file, capsys
) -> None:
    path, links = hand_file("numbered.urdf"), tmp_path / "links.toml"
    assert main(["robot-hand", str(path), "-o", str(links), "--json", "-"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert (report["side"], report["palm"]) == ("right", "base_link")
    assert report["fingers"]["ring"]["link"] == "link_11.0_tip"
    assert report["fingers"]["little"]["length"] is None
    assert read_map(links).links["thumb"] == "link_15.0_tip"
    assert main(["robot-hand", str(path), "--fingers", str(links)]) == 0
    assert "link_3.0_tip" in capsys.readouterr().out
    assert main(["robot-hand", str(path), "--fingers", "thumb="]) == 1
    shown = capsys.readouterr()
    assert "link_3.0_tip" in shown.out and shows(shown.err, "robot.no_fingers")


def test_a_damaged_urdf_is_an_error(tmp_path: Path) -> None:
    path = tmp_path / "hand.urdf"
    for text, code in (
        ("<robot", "robot.not_usable"),
        ("<robot name='a'><link/></robot>", "robot.not_usable"),
        ("<robot name='a'><link name='b'/></robot>", "robot.no_fingers"),
    ):
        path.write_text(text)
        with raises(ConfigError, code):
            read(path)
