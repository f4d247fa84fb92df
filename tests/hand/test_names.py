"""Bones: which keypoints are connected on screen and in streams."""

from tracker.hand.model import HandModel
from tracker.hand.names import bones


def test_every_keypoint_except_the_wrist_ends_one_bone(hand: HandModel) -> None:
    names = (*hand.keypoint_names, "a point of the glove")
    ends = [names[b] for _, b in bones(names)]
    assert sorted(ends) == sorted(n for n in hand.keypoint_names if n != "wrist")


def test_bones_are_within_a_finger_and_start_at_the_wrist(hand: HandModel) -> None:
    names = hand.keypoint_names
    for a, b in bones(names):
        assert names[a] == "wrist" or names[a].split("_")[0] == names[b].split("_")[0]
    assert sum(names[a] == "wrist" for a, _ in bones(names)) == 5


def test_a_missing_keypoint_is_skipped() -> None:
    assert bones(("index_tip", "index_mcp", "thumb_mcp", "wrist")) == [(3, 2), (3, 1), (1, 0)]
