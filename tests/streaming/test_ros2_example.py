"""The example node's messages, from a payload of ours; rclpy itself is not here."""

from __future__ import annotations

import json
import math
import runpy
from pathlib import Path

from numpy.testing import assert_allclose

from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import OPENXR, Names

NODE = Path(__file__).parents[2] / "docs" / "examples" / "ros2" / "glovetrack_node.py"


def test_the_node_has_every_pose_in_order_and_nothing_for_what_is_lost(
    make_estimate, hand, glove
) -> None:
    node = runpy.run_path(str(NODE))
    e = make_estimate(lost=("index_tip", "thumb_ip_flexion"), angles={"index_pip_flexion": 0.7})
    names = Names.of(hand, glove, OPENXR)
    estimate = json.loads(to_json(e, names))
    wanted = to_openxr(e, names.keypoints, joint_radii(hand))
    found = node["poses"](estimate)
    assert tuple(name for name, _, _ in found) == JOINTS
    for i, (name, place, turn) in enumerate(found):
        if name == "index_tip":
            assert all(map(math.isnan, (*place, *turn)))
        else:
            assert_allclose(place, wanted.position[i], atol=1e-6)
            assert_allclose(turn, wanted.orientation[i], atol=1e-6)
    angles = dict(zip(*node["joint_states"](estimate), strict=True))
    assert "thumb_ip_flexion" not in angles and angles["index_pip_flexion"] == 0.7
