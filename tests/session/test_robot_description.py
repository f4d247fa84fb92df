"""Sessions contain the hand as a URDF, which an independent library can read."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import yourdfpy
from mcap_ros2.reader import read_ros2_messages

from tests.fixtures import RESOURCES
from tests.session.conftest import ANCHOR
from tracker.geometry import so3
from tracker.session.description import describe
from tracker.session.writer import RecorderParams, SessionRecorder


def test_its_links_match_the_sessions_frames(
    tmp_path: Path, record: Callable[..., Path], maker, session_info
) -> None:
    """With the angles of the JointState, for a hand of the size in its file."""
    hand = session_info.hand
    rng = np.random.default_rng(3)
    angles = rng.uniform(*hand.angle_limits.T)
    R, p = hand.forward(angles, so3.exp(rng.normal(size=3)), rng.normal(size=3))
    path = record(tmp_path / "a.mcap", [replace(maker.estimate(0.0), angles=angles,
                                                segment_R=R, segment_p=p)])  # fmt: skip
    messages = {m.channel.topic: m.ros_msg for m in read_ros2_messages(path)}
    text = tmp_path / "hand.urdf"
    text.write_text(messages["/robot_description"].data)
    robot = yourdfpy.URDF.load(str(text), build_scene_graph=True, load_meshes=False)
    joints = messages["/hand/right/joint_states"]
    positions = dict(zip(joints.name, joints.position, strict=True))
    assert set(positions) <= set(robot.actuated_joint_names)
    robot.update_cfg([positions.get(name, 0.0) for name in robot.actuated_joint_names])
    root = hand.segments[hand.root].name
    frames = {t.child_frame_id: t.transform for t in messages["/tf"].transforms}
    assert set(frames) <= set(robot.link_map)
    base = robot.get_transform(f"right_{root}")
    for i, segment in enumerate(hand.segments):
        found = np.linalg.inv(base) @ robot.get_transform(f"right_{segment.name}")
        assert np.allclose(found[:3, 3], R[hand.root].T @ (p[i] - p[hand.root]), atol=1e-6)
        assert np.allclose(found[:3, :3], R[hand.root].T @ R[i], atol=1e-6)


def test_each_of_both_hands_has_its_own(tmp_path: Path, session_info) -> None:
    hand = (RESOURCES / "hands" / "reference-left.toml").read_text()
    glove = (RESOURCES / "gloves" / "vist-small-left.toml").read_text()
    both = replace(session_info, others=(describe(hand, glove, ANCHOR),))
    with SessionRecorder(tmp_path / "b.mcap", both, RecorderParams(sync=False)):
        pass
    found = {
        m.channel.topic: m.ros_msg.data
        for m in read_ros2_messages(tmp_path / "b.mcap")
        if "robot_description" in m.channel.topic
    }
    assert set(found) == {f"/hand/{side}/robot_description" for side in ("left", "right")}
    for side in ("left", "right"):
        assert f'"{side}_index_distal"' in found[f"/hand/{side}/robot_description"]
