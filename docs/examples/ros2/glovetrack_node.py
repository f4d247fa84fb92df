"""A ROS 2 node that publishes what Glovetrack streams by WebSocket.

    glovetrack devices --stream websocket --stream-joints openxr
    python glovetrack_node.py ws://127.0.0.1:9751/

Topics, of the side that a message names: /hand/<side>/joint_states (JointState with velocities),
/hand/<side>/openxr (PoseArray, 26 poses in the order of XrHandJointEXT, NaN where lost)
and /tf, a frame `<side>_<joint>` under `openxr` for each joint that is not lost. It needs rclpy and
`websockets`. It is tested with stand-ins for rclpy, and has not been run with rclpy itself.
"""

from __future__ import annotations

import json
import math
import sys
import time
from typing import Any

LOST = [math.nan] * 3, [math.nan] * 4


def joint_states(estimate: dict[str, Any]) -> tuple[list[str], list[float]]:
    """Names and angles (rad) of what is known: a JointState has no word for what is lost."""
    known = {n: a["value"] for n, a in estimate["angles"].items() if a["value"] is not None}
    return list(known), list(known.values())


def rates(estimate: dict[str, Any]) -> list[float]:
    """rad/s of the angles of `joint_states`, NaN where unknown; none of a stream of schema 1."""
    known = [a for a in estimate["angles"].values() if a["value"] is not None]
    if not all("rate" in a for a in known):
        return []
    return [math.nan if a["rate"] is None else a["rate"] for a in known]


def stamp(estimate: dict[str, Any]) -> tuple[int, int]:
    """s and ns since 1970 of the instant of the pose; the current time for a stream of schema 1."""
    at = estimate.get("t_unix_ns")
    return divmod(time.time_ns() if at is None else at, 10**9)


def poses(estimate: dict[str, Any]) -> list[tuple[str, list[float], list[float]]]:
    """(joint, position m, quaternion xyzw) of every joint in OpenXR's order; NaN where lost."""
    out = []
    for name, joint in estimate["joints"].items():
        lost = joint["position"] is None
        place, turn = LOST if lost else (joint["position"], joint["orientation_xyzw"])
        out.append((name, place, turn))
    return out


def run(url: str) -> None:
    """Publish until the stream ends."""
    import rclpy
    from geometry_msgs.msg import Pose, PoseArray, TransformStamped
    from sensor_msgs.msg import JointState
    from tf2_ros import TransformBroadcaster
    from websockets.sync.client import connect

    rclpy.init()
    node = rclpy.create_node("glovetrack")
    frames = TransformBroadcaster(node)
    publishers: dict[str, Any] = {}

    def publisher(kind: Any, topic: str) -> Any:
        if topic not in publishers:
            publishers[topic] = node.create_publisher(kind, topic, 10)
        return publishers[topic]

    with connect(url) as stream:
        for text in stream:
            estimate = json.loads(text)
            side = estimate["side"]
            state = JointState()
            state.header.stamp.sec, state.header.stamp.nanosec = stamp(estimate)
            state.name, state.position = joint_states(estimate)
            state.velocity = rates(estimate)
            publisher(JointState, f"/hand/{side}/joint_states").publish(state)
            array = PoseArray()
            array.header.stamp, array.header.frame_id = state.header.stamp, "openxr"
            for name, place, turn in poses(estimate):
                pose = Pose()
                pose.position.x, pose.position.y, pose.position.z = place
                o = pose.orientation
                o.x, o.y, o.z, o.w = turn
                array.poses.append(pose)
                if not math.isnan(place[0]):
                    frame = TransformStamped()
                    frame.header, frame.child_frame_id = array.header, f"{side}_{name}"
                    t = frame.transform.translation
                    t.x, t.y, t.z = place
                    frame.transform.rotation = pose.orientation
                    frames.sendTransform(frame)
            publisher(PoseArray, f"/hand/{side}/openxr").publish(array)


if __name__ == "__main__":
    run(sys.argv[1] if len(sys.argv) > 1 else "ws://127.0.0.1:9751/")
