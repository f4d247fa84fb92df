"""Hand files: their contents, and one clear error for each invalid one."""

import numpy as np
import pytest

from tests.fixtures import RESOURCES
from tests.notices import raises
from tracker.base.errors import FileError
from tracker.hand.files import load_hand, parse_hand
from tracker.hand.model import HandModel

TEXT = (RESOURCES / "hands" / "reference-right.toml").read_text()


def test_reference_hand_has_the_names_of_the_conventions(hand: HandModel) -> None:
    assert len(hand.keypoint_names) == 21
    assert hand.keypoint_names[0] == "wrist" and hand.keypoint_names[8] == "index_tip"
    assert {"thumb_cmc_twist", "index_mcp_abduction", "little_dip_flexion"} <= set(hand.joint_names)
    flat = hand.keypoints(*hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3)))
    assert np.linalg.norm(flat[hand.keypoint_names.index("middle_tip")]) == pytest.approx(
        hand.length, abs=1e-3
    )


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("length = 0.183", "length = nan", "toml.finite"),
        ("length = 0.183", "length = 0.25", "hand.length_sum"),
        ('side = "right"', 'side = "up"', "toml.choice"),
        ("schema = 1", "schema = 2", "toml.schema"),
        ("width = 0.08", "breadth = 0.08", "toml.missing"),
        ("width = 0.08", "width = 0.08\ncolour = 1", "toml.unknown_key"),
        ('parent = "index_proximal"', 'parent = "index_distal"', "hand.loop"),
        ("[segments.index_distal]", "[segments.tail]", "hand.unknown_segment"),
        ('of = "index_pip_flexion"', 'of = "index_dip_flexion"', "hand.loop"),
        ("ratio = 0.67", 'ratio = "much"', "toml.number"),
        ("length = 0.183", 'length = 0.183\nlength_to = "tail"', "toml.choice"),
        ("length = 0.183", 'length = 0.183\nlength_to = "little_distal"', "hand.length_sum"),
        ("[joints.index_pip]", '[joints.index_pip]\nstiff = ["abduction"]', "hand.abduction"),
        ("[joints.index_mcp]", '[joints.index_mcp]\nstiff = ["twist"]', "toml.names"),
        ("[joints.index_pip]", "[joints.index_pip]\nfist = 1.5", "toml.range"),
        ("[joints.index_pip]", "[joints.index_pip]\ngrip = 1", "toml.unknown_key"),
    ],
)
def test_an_invalid_file_is_rejected(old: str, new: str, code: str) -> None:
    assert old in TEXT
    with raises(FileError, code, file="my-hand.toml"):
        parse_hand(TEXT.replace(old, new, 1), "my-hand.toml")


def test_the_error_names_the_line() -> None:
    number = TEXT.splitlines().index("length = 0.082") + 1
    with raises(FileError, "toml.number", line=number, key="segments.dorsum.length"):
        parse_hand(TEXT.replace("length = 0.082", 'length = "long"', 1), "h.toml")


def test_the_left_hand_mirrors_the_right(hand: HandModel) -> None:
    left = load_hand(RESOURCES / "hands" / "reference-left.toml")
    mirror = np.array([1.0, -1.0, 1.0])
    rng = np.random.default_rng(3)
    low, high = hand.angle_limits.T
    angles = low + rng.random(len(low)) * (high - low)
    sign = np.array([1.0 if n.endswith("flexion") else -1.0 for n in hand.joint_names])
    right_points = hand.keypoints(*hand.forward(angles, np.eye(3), np.zeros(3)))
    left_points = left.keypoints(*left.forward(angles * sign, np.eye(3), np.zeros(3)))
    assert np.allclose(left_points, right_points * mirror, atol=1e-9)


def test_joint_properties_missing_in_a_file_have_defaults(hand: HandModel) -> None:
    joints = {j.name: j for j in hand.joints}
    assert [n for n, j in joints.items() if j.stiff] == ["thumb_mcp"]
    assert joints["thumb_cmc"].fist < joints["index_mcp"].fist == joints["little_dip"].fist
    assert [hand.segment_names[row] for row in hand.length_path] == [
        "dorsum", "middle_proximal", "middle_intermediate", "middle_distal",
    ]  # fmt: skip
    assert hand.segment_names[hand.root] == "dorsum"


def test_a_file_may_define_stiff_joints_and_their_flexion_in_a_fist() -> None:
    text = TEXT.replace("[joints.index_mcp]", '[joints.index_mcp]\nstiff = ["abduction"]', 1)
    text = text.replace("[joints.thumb_mcp]", "[joints.thumb_mcp]\nstiff = []\nfist = 0.7", 1)
    joints = {j.name: j for j in parse_hand(text).joints}
    assert [n for n, j in joints.items() if j.stiff] == ["index_mcp"]
    assert joints["thumb_mcp"].fist == 0.7


def test_length_may_be_measured_along_another_finger(hand: HandModel) -> None:
    parts = ("dorsum", "index_proximal", "index_intermediate", "index_distal")
    length = sum(hand.segments[hand.index[p]].length for p in parts)
    text = TEXT.replace("length = 0.183", f'length = {length}\nlength_to = "index_distal"', 1)
    other = parse_hand(text)
    assert [other.segment_names[row] for row in other.length_path] == list(parts)
