"""Definitions of the ROS 2 types in a session, as text for the file's schemas (``ros2msg``).

Fields and constants as in the .msg files of ROS 2 Jazzy and vision_msgs 4, without comments.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

_FIELDS = {
    "builtin_interfaces/Time": "int32 sec, uint32 nanosec",
    "diagnostic_msgs/DiagnosticArray": "std_msgs/Header header, "
    "diagnostic_msgs/DiagnosticStatus[] status",
    "diagnostic_msgs/DiagnosticStatus": "byte OK=0, byte WARN=1, byte ERROR=2, byte STALE=3, "
    "byte level, string name, string message, string hardware_id, "
    "diagnostic_msgs/KeyValue[] values",
    "diagnostic_msgs/KeyValue": "string key, string value",
    "geometry_msgs/Point": "float64 x, float64 y, float64 z",
    "geometry_msgs/Pose": "geometry_msgs/Point position, geometry_msgs/Quaternion orientation",
    "geometry_msgs/PoseArray": "std_msgs/Header header, geometry_msgs/Pose[] poses",
    "geometry_msgs/PoseWithCovariance": "geometry_msgs/Pose pose, float64[36] covariance",
    "geometry_msgs/PoseWithCovarianceStamped": "std_msgs/Header header, "
    "geometry_msgs/PoseWithCovariance pose",
    "geometry_msgs/Quaternion": "float64 x, float64 y, float64 z, float64 w",
    "geometry_msgs/Transform": "geometry_msgs/Vector3 translation, "
    "geometry_msgs/Quaternion rotation",
    "geometry_msgs/TransformStamped": "std_msgs/Header header, string child_frame_id, "
    "geometry_msgs/Transform transform",
    "geometry_msgs/Vector3": "float64 x, float64 y, float64 z",
    "sensor_msgs/CameraInfo": "std_msgs/Header header, uint32 height, uint32 width, "
    "string distortion_model, float64[] d, float64[9] k, float64[9] r, float64[12] p, "
    "uint32 binning_x, uint32 binning_y, sensor_msgs/RegionOfInterest roi",
    "sensor_msgs/CompressedImage": "std_msgs/Header header, string format, uint8[] data",
    "sensor_msgs/Imu": "std_msgs/Header header, geometry_msgs/Quaternion orientation, "
    "float64[9] orientation_covariance, geometry_msgs/Vector3 angular_velocity, "
    "float64[9] angular_velocity_covariance, geometry_msgs/Vector3 linear_acceleration, "
    "float64[9] linear_acceleration_covariance",
    "sensor_msgs/JointState": "std_msgs/Header header, string[] name, float64[] position, "
    "float64[] velocity, float64[] effort",
    "sensor_msgs/RegionOfInterest": "uint32 x_offset, uint32 y_offset, uint32 height, "
    "uint32 width, bool do_rectify",
    "sensor_msgs/TimeReference": "std_msgs/Header header, builtin_interfaces/Time time_ref, "
    "string source",
    "std_msgs/Float64MultiArray": "std_msgs/MultiArrayLayout layout, float64[] data",
    "std_msgs/Header": "builtin_interfaces/Time stamp, string frame_id",
    "std_msgs/Int64MultiArray": "std_msgs/MultiArrayLayout layout, int64[] data",
    "std_msgs/MultiArrayDimension": "string label, uint32 size, uint32 stride",
    "std_msgs/MultiArrayLayout": "std_msgs/MultiArrayDimension[] dim, uint32 data_offset",
    "std_msgs/String": "string data",
    "tf2_msgs/TFMessage": "geometry_msgs/TransformStamped[] transforms",
    "vision_msgs/BoundingBox2D": "vision_msgs/Pose2D center, float64 size_x, float64 size_y",
    "vision_msgs/Detection2D": "std_msgs/Header header, "
    "vision_msgs/ObjectHypothesisWithPose[] results, vision_msgs/BoundingBox2D bbox, string id",
    "vision_msgs/Detection2DArray": "std_msgs/Header header, vision_msgs/Detection2D[] detections",
    "vision_msgs/ObjectHypothesis": "string class_id, float64 score",
    "vision_msgs/ObjectHypothesisWithPose": "vision_msgs/ObjectHypothesis hypothesis, "
    "geometry_msgs/PoseWithCovariance pose",
    "vision_msgs/Point2D": "float64 x, float64 y",
    "vision_msgs/Pose2D": "vision_msgs/Point2D position, float64 theta",
}
_RULE = "=" * 80


@cache
def definition(type_name: str) -> str:
    """The message definition of a type (``sensor_msgs/msg/Imu``) with those it uses."""
    name = type_name.replace("/msg/", "/")
    used = list(dict.fromkeys(_used(name)))
    return _text(name) + "".join(f"{_RULE}\nMSG: {n}\n{_text(n)}" for n in used)


def _text(name: str) -> str:
    return "\n".join(_FIELDS[name].split(", ")) + "\n"


def _used(name: str) -> Iterator[str]:
    """Types of the fields of ``name`` that are messages, each before the types of its own
    fields."""
    for inner in re.findall(r"\w+/\w+", _FIELDS[name]):
        yield inner
        yield from _used(inner)
