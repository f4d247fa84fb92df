"""Keyed poses as programs read them: by JSON Schema, a plain socket, and NVIDIA's retargeters."""

from __future__ import annotations

import contextlib
import json
import socket
from typing import Any

import jsonschema
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from extensions.retargeting.poses import LANDMARKS, TIPS, PoseView, pose_text
from glovetrack.conventions import R_B_OPERATOR, operator_frame, to_mediapipe
from resources import folder
from tests.notices import raises
from tests.streaming.recorded_hand import RecordedHand, assert_near, assert_parallel
from tracker.base.clock import ClockAnchor
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.openxr import JOINTS, to_openxr
from tracker.messages import Estimate, Tracking
from tracker.simulation.gestures import pinch
from tracker.streaming.connection import LOOPBACK
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.registry import StreamSettings, open_streams, with_streams

R_BX = np.array([[0.0, 0, -1], [-1, 0, 0], [0, 1, 0]])
"""-z points to the tip, y leaves the back of the hand."""
FRAMES = ("world", "openxr", "wrist", "operator")
ANCHOR = ClockAnchor(1_732_538_096_123_456_789, 0)


@pytest.fixture
def dated(hand: HandModel, glove: GloveModel) -> Names:
    return Names.of(hand, glove, anchor=ANCHOR).with_openxr()


def received(e: Estimate, names: Names, options: dict[str, Any]) -> dict[str, Any]:
    """What a plain socket gets of the stream with these options."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind((LOOPBACK, 0))
        client.settimeout(60)
        table = {"poses": True, "poses_port": client.getsockname()[1]}
        table |= {f"poses_{name}": value for name, value in options.items()}
        (out,) = open_streams(StreamSettings(table), [names])["poses"]
        with contextlib.closing(out):
            out.send(e)
            return json.loads(client.recv(65536))


def arrays(message: dict[str, Any]) -> tuple[np.ndarray, np.ndarray]:
    """p (n, 3) and R (n, 3, 3) of the message's poses, by an independent library."""
    poses = message["poses"].values()
    q = Rotation.from_quat([pose["orientation_xyzw"] for pose in poses])
    return np.array([pose["position"] for pose in poses]), q.as_matrix()


@pytest.mark.parametrize("frame", FRAMES)
@pytest.mark.parametrize("joints", ["tips", "openxr", "landmarks"])
@pytest.mark.parametrize("matrix", [False, True])
def test_every_kind_of_message_matches_its_schema(
    make_estimate, dated: Names, frame: str, joints: str, matrix: bool
) -> None:
    schema = json.loads((folder("schemas") / "poses-1.schema.json").read_text("utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    for e in (
        make_estimate(lost=("thumb_tip",)),
        make_estimate(lost=dated.keypoints, tracking=Tracking.SEARCHING),
    ):
        message = json.loads(pose_text(e, dated, PoseView(joints, frame, matrix)))
        jsonschema.validate(message, schema, jsonschema.Draft202012Validator)
        assert message["poses"]["thumb_tip"]["position"] is None


def test_a_program_gets_named_tips_with_sd_state_and_instant(recorded: RecordedHand) -> None:
    """Of each instant of a recording."""
    row = recorded.names.keypoints.index("index_tip")
    for e in recorded.estimates:
        message = received(e, recorded.names.with_openxr(), {})
        assert tuple(message["poses"]) == TIPS
        assert (message["side"], message["frame"]) == ("right", "world")
        assert abs(message["t_unix_ns"] - recorded.unix_ns(e)) < 1000
        assert message["poses"]["index_tip"]["sd"] == pytest.approx(e.keypoint_sd[row], abs=1e-6)
        of_X = Rotation.from_matrix(R_BX)
        for name, pose in message["poses"].items():
            assert_near(pose["position"], recorded.points(e)[name])
            found = Rotation.from_quat(pose["orientation_xyzw"])
            assert_parallel(found, recorded.turns(e)[name] * of_X)


def test_openxr_joints_are_those_of_the_other_streams(make_estimate, dated: Names) -> None:
    e = make_estimate()
    p, R = arrays(received(e, dated, {"joints": "openxr", "frame": "openxr"}))
    wanted = to_openxr(e, dated.keypoints, np.array(dated.radii))
    assert_allclose(p, wanted.position, atol=1e-6)
    assert_allclose(R, Rotation.from_quat(wanted.orientation).as_matrix(), atol=1e-5)


@pytest.mark.parametrize("frame", FRAMES)
def test_matrices_are_the_same_poses_and_frames_differ_by_one_rigid_motion(
    make_estimate, dated: Names, frame: str
) -> None:
    e = make_estimate()
    message = received(e, dated, {"joints": "openxr", "frame": frame, "matrix": True})
    p, R = arrays(message)
    T = np.array([pose["matrix"] for pose in message["poses"].values()])
    assert_allclose(T[:, :3, 3], p)
    assert_allclose(T[:, :3, :3], R, atol=1e-5)
    p0, R0 = arrays(received(e, dated, {"joints": "openxr"}))
    world = np.zeros_like(T)
    world[:, :3, :3], world[:, :3, 3], world[:, 3, 3] = R0, p0, 1.0
    motion = T @ np.linalg.inv(world)
    assert_allclose(motion, np.broadcast_to(motion[0], motion.shape), atol=2e-5)


def test_the_operator_frame_is_that_of_dex_retargetings_own_detector(
    make_estimate, dated: Names
) -> None:
    """Its recipe (singular vectors of wrist, index and middle knuckle) on the streamed points."""
    for angles in ({}, {"index_mcp_flexion": 1.0, "thumb_ip_flexion": 0.7}):
        e = make_estimate(angles=angles)
        in_world, _ = arrays(received(e, dated, {"joints": "landmarks"}))
        ours, _ = arrays(received(e, dated, {"joints": "landmarks", "frame": "operator"}))
        from_wrist = in_world - in_world[0]
        frame = fitted(from_wrist) @ np.array([[0, 0, -1], [-1, 0, 0], [0, 1, 0]])
        ours_frame = operator_frame(from_wrist, Rotation.from_quat(e.keypoint_q[0]).as_matrix())
        off = Rotation.from_matrix(frame.T @ ours_frame).magnitude()
        assert np.rad2deg(off) < 0.1
        assert_allclose(ours, from_wrist @ frame, atol=1e-5)


def fitted(points: np.ndarray) -> np.ndarray:
    """The wrist frame in MANO's convention that dex-retargeting estimates from landmarks."""
    three = points[[0, 5, 9]]
    normal = np.linalg.svd(three - three.mean(axis=0))[2][2]
    x = three[0] - three[2]
    x = x - (x @ normal) * normal
    x /= np.linalg.norm(x)
    z = np.cross(x, normal)
    if z @ (three[1] - three[2]) < 0:
        normal, z = -normal, -z
    return np.column_stack([x, normal, z])


@pytest.mark.parametrize("side", ["right", "left"])
def test_the_fitted_frame_is_the_dorsums_up_to_the_arch_of_the_knuckles(side: str) -> None:
    from tests.fixtures import RESOURCES
    from tracker.hand.files import load_hand

    hand = load_hand(RESOURCES / "hands" / f"reference-{side}.toml")
    R, p = hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3))
    points = to_mediapipe(hand.keypoints(R, p), hand.keypoint_names)
    frame = operator_frame(points - points[0], np.eye(3))
    turn = np.rad2deg(Rotation.from_matrix(frame @ R_B_OPERATOR.T).as_rotvec())
    assert abs(turn[0]) == pytest.approx(2.44, abs=0.01) and abs(turn[1:]).max() < 1e-6
    mano = np.array([[0, 0, -1], [-1, 0, 0], [0, 1, 0]])
    if side == "left":
        mano = np.array([[0, 0, -1], [1, 0, 0], [0, -1, 0]])
    assert_allclose(frame, fitted(points - points[0]) @ mano, atol=1e-9)


def test_a_lost_wrist_loses_poses_relative_to_it(make_estimate, dated: Names) -> None:
    e = make_estimate(lost=("wrist",))
    for frame, lost in (("world", False), ("wrist", True), ("operator", True)):
        tip = json.loads(pose_text(e, dated, PoseView(frame=frame)))["poses"]["ring_tip"]
        assert (tip["state"] == "lost") == lost == (tip["position"] is None)


def test_landmarks_have_mediapipes_order() -> None:
    assert len(LANDMARKS) == 21 and LANDMARKS[0] == "wrist"
    assert LANDMARKS[4] == "thumb_tip" and LANDMARKS[5] == "index_proximal"
    assert LANDMARKS[20] == "little_tip"


def test_the_test_button_says_whether_a_program_receives(make_estimate, dated: Names) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind((LOOPBACK, 0))
        table = {"poses": True, "poses_port": client.getsockname()[1]}
        (out,) = open_streams(StreamSettings(table), [dated])["poses"]
        assert out.probe().code == "stream.test_nothing"
        out.send(make_estimate())
        assert out.probe().code == "stream.test_udp"
    with contextlib.closing(out):
        assert out.probe().code == "stream.test_refused"


def test_options_are_checked(dated: Names) -> None:
    with raises(StreamError, "option.choice", value="moon"):
        open_streams(with_streams(StreamSettings(), "poses?frame=moon"), [dated])


class Isaac:
    """One of NVIDIA's retargeters, fed with a message of the stream."""

    def __init__(self, retargeter) -> None:
        self.retargeter = retargeter

    def __call__(self, message: dict[str, Any]) -> np.ndarray:
        interface = pytest.importorskip("isaacteleop.retargeting_engine.interface")
        types = pytest.importorskip("isaacteleop.retargeting_engine.tensor_types")
        core = pytest.importorskip("isaacteleop.retargeting_engine.interface.retargeter_core_types")
        events = interface.ExecutionEvents(
            reset=False, execution_state=interface.ExecutionState.RUNNING
        )
        context = interface.ComputeContext(
            graph_time=core.GraphTime(sim_time_ns=0, real_time_ns=0), execution_events=events
        )
        inputs = {
            k: interface.OptionalTensorGroup(v) for k, v in self.retargeter.input_spec().items()
        }
        outputs = {k: interface.TensorGroup(v) for k, v in self.retargeter.output_spec().items()}
        self._fill(inputs["hand_right"], message, types.HandInputIndex)
        self.retargeter.compute(inputs, outputs, context)
        (out,) = outputs.values()
        return np.array([np.asarray(out[i]) for i in range(len(out))]).squeeze()

    @staticmethod
    def _fill(group, message: dict[str, Any], index) -> None:
        poses = [message["poses"][name] for name in JOINTS]
        valid = np.array([pose["position"] is not None for pose in poses])
        zero, one = [0.0] * 3, [0.0, 0.0, 0.0, 1.0]
        group[index.JOINT_POSITIONS] = np.float32([p["position"] or zero for p in poses])
        group[index.JOINT_ORIENTATIONS] = np.float32([p["orientation_xyzw"] or one for p in poses])
        group[index.JOINT_RADII] = np.full(len(JOINTS), 0.01, np.float32)
        group[index.JOINT_VALID] = valid.astype(np.uint8)


def test_nvidias_gripper_closes_on_a_pinch(make_estimate, dated: Names, hand: HandModel) -> None:
    theirs = pytest.importorskip("isaacteleop.retargeters")
    config = theirs.GripperRetargeterConfig(hand_side="right")
    gripper = Isaac(theirs.GripperRetargeter(config, name="gripper"))
    options = {"joints": "openxr"}
    assert gripper(received(make_estimate(), dated, options)) == 1.0
    closed = dict(zip(hand.joint_names, pinch(hand, "index"), strict=True))
    assert gripper(received(make_estimate(angles=closed), dated, options)) == -1.0
    lost = received(make_estimate(lost=("index_tip",)), dated, options)
    assert gripper(lost) == -1.0, "a lost tip changes nothing"


def test_nvidias_se3_retargeter_has_the_wrists_pose(recorded: RecordedHand) -> None:
    theirs = pytest.importorskip("isaacteleop.retargeters")
    config = theirs.Se3RetargeterConfig(
        input_device="hand_right", use_wrist_position=True, use_wrist_rotation=True,
        zero_out_xy_rotation=False, target_offset_roll=0.0, target_offset_pitch=0.0,
        target_offset_yaw=0.0,
    )  # fmt: skip
    retargeter = Isaac(theirs.Se3AbsRetargeter(config, name="se3"))
    for e in recorded.estimates[::5]:
        message = received(e, recorded.names.with_openxr(), {"joints": "openxr"})
        out = retargeter(message)
        assert_near(out[:3], recorded.points(e)["wrist"])
        wanted = recorded.turns(e)["wrist"] * Rotation.from_matrix(R_BX)
        assert_parallel(Rotation.from_quat(out[3:7]), wanted)
