"""VMC: the conversion against geometry done another way, the messages by python-osc's parser."""

from __future__ import annotations

import socket
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from pythonosc.osc_bundle import OscBundle
from pythonosc.osc_message import OscMessage
from scipy.spatial.transform import Rotation

from extensions.osc.encode import message
from extensions.osc.vmc import OPENXR_JOINT, VmcPublisher
from extensions.osc.vmc_pose import AvatarHand, unity_pose
from tests.fixtures import RESOURCES
from tests.streaming.moving_hand import turning
from tests.streaming.posed_hand import posed_estimate, side_names
from tests.streaming.recorded_hand import (
    OPENXR_JOINTS,
    RecordedHand,
    assert_near,
    assert_parallel,
)
from tracker.base.clock import ClockAnchor
from tracker.gestures.values import GESTURES
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel
from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.messages import Estimate, Tracking
from tracker.streaming.publisher import Names

POSE = "/VMC/Ext/Tra/Pos"
# An avatar's axes, seen along its gaze, right-handed (east, north, up):
# it looks north, its right hand points east and its left hand west, palms down.
ENU_OF_UNITY = np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])
UNITY_OF_G = np.array([[0.0, -1, 0], [0, 0, 1], [1, 0, 0]])
UNITY_OF_RIGHT = np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])
"""Columns: the axes of a right hand's dorsum (x to the fingers, z dorsal) in the T-pose."""
UNITY_NAMES = {
    "thumb_metacarpal": "ThumbProximal",
    "thumb_proximal": "ThumbIntermediate",
    "thumb_distal": "ThumbDistal",
    **{
        f"{finger}_{part}": f"{finger.title()}{part.title()}"
        for finger in ("index", "middle", "ring", "little")
        for part in ("proximal", "intermediate", "distal")
    },
}
HAND_IN_ENU = {"right": np.eye(3), "left": np.diag([-1.0, -1.0, 1.0])}


def shipped(side: str) -> HandModel:
    return load_hand(RESOURCES / "hands" / f"reference-{side}.toml")


def compose(
    hand: HandModel, local: dict[str, np.ndarray]
) -> dict[str, tuple[np.ndarray, Rotation]]:
    """Poses in the hand bone's axes in Unity, as an avatar's player adds the local ones (7,) up."""
    out = {hand.segment_names[0]: (np.zeros(3), Rotation.identity())}
    for i, name in enumerate(hand.segment_names[1:], start=1):
        p, R = out[hand.segment_names[hand.parent[i]]]
        pose = local[name]
        out[name] = p + R.apply(pose[:3]), R * Rotation.from_quat(pose[3:])
    return out


@pytest.mark.parametrize("side", ["right", "left"])
def test_an_avatar_that_adds_the_bones_up_has_the_hands_shape(side: str) -> None:
    hand = shipped(side)
    angles = np.random.default_rng(7).uniform(*hand.angle_limits.T)
    _, truth = hand.forward(angles, HAND_IN_ENU[side], np.zeros(3))
    avatar, rows = AvatarHand(hand), range(len(hand.segments))
    local = np.column_stack([avatar.offsets, avatar.rotations(rows, angles)])
    found = compose(hand, dict(zip(hand.segment_names, local, strict=True)))
    positions = np.array([p for p, _ in found.values()])
    assert_allclose(positions @ ENU_OF_UNITY.T, truth, atol=1e-9)


@pytest.mark.parametrize("side", ["right", "left"])
def test_poses_of_segments_are_those_of_their_angles(side: str) -> None:
    names = side_names(side)
    e, avatar = posed_estimate(names, 3), AvatarHand(names.model)
    bones = range(1, len(names.model.segments))
    found = avatar.poses(bones, e)
    unknown = replace(e, segment_R=np.full_like(e.segment_R, np.nan))
    assert_allclose(found, avatar.poses(bones, unknown), atol=1e-7)


@pytest.mark.parametrize("side", ["right", "left"])
def test_the_rest_pose_is_the_t_pose(side: str) -> None:
    hand = shipped(side)
    avatar, angles = AvatarHand(hand), np.zeros(len(hand.joint_names))
    for i in range(len(hand.segments)):
        assert_allclose(avatar.rotations([i], angles)[0], [0, 0, 0, 1], atol=1e-7)


@pytest.mark.parametrize(("side", "sign"), [("right", -1), ("left", 1)])
def test_a_curled_finger_turns_about_unitys_z(side: str, sign: int) -> None:
    """A positive turn about +Z takes +X to +Y, also left-handed; the right finger goes down."""
    hand = shipped(side)
    angles = np.zeros(len(hand.joint_names))
    angles[hand.angle_index["index_pip_flexion"]] = np.pi / 2
    q = AvatarHand(hand).rotations([hand.index["index_intermediate"]], angles)[0]
    assert_allclose(q, [0, 0, sign * np.sqrt(0.5), np.sqrt(0.5)], atol=1e-9)


def test_unitys_world_pose() -> None:
    p, q = unity_pose(np.array([1.0, 2.0, 3.0]), np.array([0, 0, 0, 1.0]))
    assert_allclose(p, [-2.0, 3.0, 1.0])  # right = -y, up = z, forward = x
    assert_allclose(q, [0, 0, 0, 1])
    yaw_left = Rotation.from_euler("z", 90, degrees=True).as_quat()
    _, q = unity_pose(np.zeros(3), yaw_left)
    assert_allclose(q, [0, -np.sqrt(0.5), 0, np.sqrt(0.5)], atol=1e-12)


@pytest.mark.parametrize("text", ["", "a", "abc", "abcd", "abcde"])
def test_messages_are_read_by_another_library(text: str) -> None:
    """Also strings whose length is a multiple of four, which need four zeros."""
    read = OscMessage(message("/an/address", text, -7, 0.1, text))
    assert read.address == "/an/address"
    assert read.params == [text, -7, pytest.approx(0.1), text]


def received(hand: HandModel, estimate: Estimate) -> list[list[Any]]:
    """[address, arguments...] of every message of the bundle that a client gets."""
    (found,) = all_received(hand, [estimate])
    return found


def all_received(hand: HandModel, estimates: Sequence[Estimate]) -> list[list[list[Any]]]:
    """The same of each estimate, from one stream."""
    found = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind(("127.0.0.1", 0))
        client.settimeout(60)
        out = VmcPublisher(hand, "127.0.0.1", client.getsockname()[1])
        for estimate in estimates:
            out.send(estimate)
            found.append(OscBundle(client.recv(65536)))
        out.close()
    return [[[m.address, *m.params] for m in bundle] for bundle in found]


def bones(messages: list[list[Any]], address: str) -> dict[str, list[Any]]:
    return {m[1]: m[2:] for m in messages if m[0] == address}


def test_an_avatar_has_the_recorded_hand(recorded: RecordedHand) -> None:
    """Its bones, added up from the tracker's pose, are where the recording has the joints, also
    where they turn about axes without an angle; under Unity's names, with its shifted thumb."""
    hand = recorded.names.model
    rest, _ = hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3))
    for e, messages in zip(recorded.estimates, all_received(hand, recorded.estimates), strict=True):
        assert messages[0] == ["/VMC/Ext/OK", 1, 3, 0, 1]
        poses = bones(messages, "/VMC/Ext/Bone/Pos")
        assert len(poses) == 15
        tracker = np.array(bones(messages, "/VMC/Ext/Tra/Pos")["glovetrack-right"])
        p_wrist, R_wrist = tracker[:3], Rotation.from_quat(tracker[3:])
        # the hand bone's axes (x to the fingers, y up) in a tracker's (z to the fingers, y up)
        of_bone = R_wrist * Rotation.from_euler("y", -90, degrees=True)
        local = {name: np.array(poses[f"Right{bone}"]) for name, bone in UNITY_NAMES.items()}
        points, turns = recorded.points(e), recorded.turns(e)
        for name, (p, R) in list(compose(hand, local).items())[1:]:
            keypoint = OPENXR_JOINTS[name]
            assert_near(p_wrist + of_bone.apply(p), UNITY_OF_G @ points[keypoint])
            axes = (of_bone * R).as_matrix() @ UNITY_OF_RIGHT @ rest[hand.index[name]]
            found = Rotation.from_matrix(UNITY_OF_G.T @ axes)
            assert_parallel(found, turns[keypoint])


def test_a_lost_bone_is_sent_as_lost_without_a_pose(hand, make_estimate) -> None:
    e = make_estimate(lost=("wrist", "index_mcp_abduction"), tracking=Tracking.LOST)
    messages = received(hand, e)
    assert messages[0][-1] == 0
    poses = bones(messages, "/VMC/Ext/Bone/Pos")
    states = bones(messages, "/Glovetrack/Bone/State")
    assert "RightIndexProximal" not in poses and "RightIndexIntermediate" in poses
    assert states["RightIndexProximal"] == ["lost"]
    assert states["RightIndexIntermediate"] == ["measured"]
    assert states["glovetrack-right"] == ["lost"]
    assert not bones(messages, "/VMC/Ext/Tra/Pos")


def test_osc_has_a_bundle_of_joints_that_python_osc_reads(
    make_estimate, names: Names, hand
) -> None:
    openxr = names.with_openxr()
    e = make_estimate(lost=("middle_mcp",))
    wanted = to_openxr(e, openxr.keypoints, joint_radii(hand))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind(("127.0.0.1", 0))
        client.settimeout(60)
        publisher = VmcPublisher(hand, "127.0.0.1", client.getsockname()[1], openxr)
        publisher.send(e)
        client.recv(65536)  # VMC's own
        received = {m.params[0]: m.params[1:] for m in OscBundle(client.recv(65536))}
        assert all(m.address == OPENXR_JOINT for m in OscBundle(_again(publisher, e, client)))
        publisher.close()
    assert tuple(received) == JOINTS
    for i, name in enumerate(JOINTS):
        if name in ("palm", "middle_metacarpal", "middle_proximal"):
            assert received[name] == ["lost"]
        else:
            pose = [*wanted.position[i], *wanted.orientation[i], wanted.radius[i]]
            assert_allclose(received[name][:8], pose, atol=1e-6)


def _again(publisher: VmcPublisher, e, client: socket.socket) -> bytes:
    publisher.send(e)
    client.recv(65536)
    return client.recv(65536)


def test_a_gesture_has_its_value_and_whether_it_is_shown(names: Names, hand, make_estimate) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind(("127.0.0.1", 0))
        client.settimeout(60)
        out = VmcPublisher(hand, "127.0.0.1", client.getsockname()[1], names)
        out.send(make_estimate())
        out.close()
        messages = [[m.address, *m.params] for m in OscBundle(client.recv(65536))]
    gestures = bones(messages, "/Glovetrack/Gesture")
    assert set(gestures) == set(GESTURES)
    assert all(0.0 <= value <= 1.0 and shown in (0, 1) for value, shown in gestures.values())


def test_velocities_follow_in_unitys_world(names: Names, hand, make_estimate) -> None:
    """The hand turns about the vertical, counter-clockwise from above, and rises: Unity's y is up,
    and it counts turns by the left hand, so that the same turn is negative."""
    e = turning(make_estimate(lost=("thumb_tip",)), names)
    dated = replace(names, anchor=ClockAnchor(1_732_538_096_123_456_789, 0))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind(("127.0.0.1", 0))
        client.settimeout(60)
        out = VmcPublisher(hand, "127.0.0.1", client.getsockname()[1], dated, velocity=True)
        out.send(e)
        poses = bones([[m.address, *m.params] for m in OscBundle(client.recv(65536))], POSE)
        frame, *rest = [[m.address, *m.params] for m in OscBundle(client.recv(65536))]
        out.close()
    assert frame == ["/Glovetrack/Frame", "right", 7, 1_732_538_097_373_456_789]
    moving = bones(rest, "/Glovetrack/Velocity")
    assert set(moving) == set(names.keypoints) - {"thumb_tip"}
    p = np.array(poses["glovetrack-right"][:3])
    v, w = moving["wrist"][:3], moving["wrist"][3:6]
    assert_allclose(w, [0, -2, 0], atol=1e-6)
    # the velocity of a point that turns about y by the left-hand rule: v = -(w x p) of a right one
    assert_allclose(v, np.cross(p, [0, 2, 0]) * [1, 0, 1] + [0, 0.5, 0], atol=1e-5)
    assert moving["wrist"][6:] == pytest.approx([0.02, 0.03])
