"""Names of a session's topics."""

from __future__ import annotations

WORLD = "world"
TF, TF_STATIC = "/tf", "/tf_static"
STATUS, EVENTS = "/tracker/status", "/events"
CAMERA_POSE = "/camera/left/extrinsics"
"""R_GC and p_GC as twelve numbers: a quaternion would not give the matrix back to the last bit."""

CAMERA_IMU = "/camera/imu/data_raw"


def imu(side: str, name: str) -> str:
    return f"/glove/{side}/imu/{name}"


def packets(side: str) -> str:
    """One TimeReference per packet, after the packet's Imu messages: the glove's own clock."""
    return f"/glove/{side}/packets"


def temperatures(side: str) -> str:
    """°C of each IMU, in the order of the glove file; before the packet from which they apply."""
    return f"/glove/{side}/temperatures"


def wrist_pose(side: str) -> str:
    """Pose of a tracker on the hand, measured by another system, for other programs."""
    return f"/room/{side}/pose"


def wrist_exact(side: str) -> str:
    """The exact pose and the tracker's mounting on the hand, as numbers."""
    return f"/room/{side}/tracker"


def image(camera: str) -> str:
    return f"/camera/{camera}/image/compressed"


def camera_info(camera: str) -> str:
    return f"/camera/{camera}/camera_info"


def blobs(camera: str) -> str:
    return f"/camera/{camera}/blobs"


def cloth(camera: str) -> str:
    """The glove's own colours around the blobs, before these; if the colour profile has them."""
    return f"/camera/{camera}/cloth"


def camera_frame(camera: str) -> str:
    return f"camera_{camera}"


def hand(side: str, what: str) -> str:
    """keypoints, keypoint_sd, joint_states, states or calibration of a hand."""
    return f"/hand/{side}/{what}"


def description(side: str, alone: bool) -> str:
    """The URDF of a hand: on ROS's usual topic if it is ``alone`` in its session."""
    return "/robot_description" if alone else hand(side, "robot_description")


def truth(side: str, what: str) -> str:
    """True keypoints or joint_states."""
    return f"/truth/{side}/{what}"


def reference(side: str, what: str) -> str:
    """keypoints or joint_states measured by a laboratory, see extensions/reference."""
    return f"/reference/{side}/{what}"


def reference_about(side: str) -> str:
    """The attachment that describes the reference of a hand."""
    return f"reference_{side}.json"


ROBOT = (
    "robot_description", "model", "memory", "joint_commands", "joint_states", "scene", "contact",
)  # fmt: skip
"""What there is of a robot that follows the hand, see extensions/robot/docs/robot.md."""


def robot(name: str, what: str) -> str:
    """One of `ROBOT`."""
    return f"/robot/{name}/{what}"


def robot_of(topic: str) -> tuple[str, str]:
    """The robot's name and the kind of its topic; both empty for other topics."""
    root, _, rest = topic.removeprefix("/").partition("/")
    name, _, what = rest.partition("/")
    return (name, what) if root == "robot" and what in ROBOT else ("", "")
