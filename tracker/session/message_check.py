"""Checks whether the content of a stored message matches its type, without using it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from tracker.base.damage import LeftOut
from tracker.session.images import check_image
from tracker.session.mcap.input import RawMessage
from tracker.session.rigs import exact_pose
from tracker.session.ros import motion, sensors, topics
from tracker.session.ros.cdr import CdrError

_OURS = (
    "/glove/",
    "/camera/",
    "/hand/",
    "/tf",
    "/tracker/",
    "/events",
    "/truth/",
    "/robot",
    "/room/",
    "/reference/",
)
"""Topics of others may have messages of the same type name and another version."""
_DECODERS: dict[str, Callable[[bytes], object]] = {
    sensors.IMU: sensors.unpack_imu,
    sensors.IMAGE: sensors.unpack_image,
    sensors.CAMERA_INFO: sensors.unpack_camera_info,
    sensors.TIME_REFERENCE: sensors.unpack_time_reference,
    sensors.DETECTIONS: sensors.unpack_detections,
    sensors.CLOTH: sensors.unpack_cloth,
    motion.TF: motion.unpack_transforms,
    motion.POSES: motion.unpack_poses,
    motion.JOINTS: motion.unpack_joints,
    motion.DIAGNOSTICS: motion.unpack_diagnostics,
    motion.POSE_COVARIANCE: motion.unpack_pose_with_covariance,
    motion.STRING: motion.unpack_string,
    motion.NUMBERS: motion.unpack_numbers,
}


def check_message(raw: RawMessage) -> None:
    """Decode a message of a topic that sessions have. Raises one of `DAMAGE`
    where it is damaged; images are checked without decoding them."""
    decode = _DECODERS.get(raw.type)
    if decode is None or not raw.topic.startswith(_OURS):
        return
    found = decode(raw.data)
    if isinstance(found, sensors.ImageMessage):
        check_image(found.data, found.frame)
    elif raw.topic == topics.CAMERA_POSE:
        exact_pose(raw.data)
    elif raw.topic == topics.STATUS:
        _check_numbers(motion.unpack_diagnostics(raw.data)[1])


def _check_numbers(statuses: Iterable[motion.Diagnostic]) -> None:
    for status in statuses:
        for name, value in status.values.items():
            try:
                float(value)
            except ValueError as error:
                raise CdrError(f"{name} of a status is not a number") from error


def sound(messages: Iterable[RawMessage], left_out: LeftOut) -> Iterator[RawMessage]:
    """``messages`` without the damaged ones, which are counted in ``left_out``."""
    for raw in messages:
        is_sound = False
        with left_out.reading(raw.topic, raw.log_time):
            check_message(raw)
            is_sound = True
        if is_sound:
            yield raw
