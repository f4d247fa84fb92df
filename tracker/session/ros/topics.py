"""Names of a session's topics."""

from __future__ import annotations

WORLD = "world"
SIDES = ("left", "right")
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


def image(camera: str) -> str:
    return f"/camera/{camera}/image/compressed"


def camera_info(camera: str) -> str:
    return f"/camera/{camera}/camera_info"


def blobs(camera: str) -> str:
    return f"/camera/{camera}/blobs"


def camera_frame(camera: str) -> str:
    return f"camera_{camera}"


def hand(side: str, what: str) -> str:
    """keypoints, keypoint_sd, joint_states, states or calibration of a hand."""
    return f"/hand/{side}/{what}"


def truth(side: str, what: str) -> str:
    """keypoints or joint_states as they really were."""
    return f"/truth/{side}/{what}"
