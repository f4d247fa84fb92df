"""The stereo camera as a session tells it: at the start, and at each change."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from tracker.errors import ConfigError
from tracker.messages import CameraPose
from tracker.session.decode import exact_pose, is_camera, pose_of
from tracker.session.mcap.input import McapInput, RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.ros import motion, sensors, topics
from tracker.session.ros.cdr import in_words
from tracker.vision.rig import Camera, StereoRig

_INFOS = {topics.camera_info(c): c for c in topics.SIDES}
_BEFORE_CONTENT = 12  # bytes of CDR header and stamp, which differ where nothing else does


@dataclass
class _Standing:
    """What has been said of the camera so far."""

    cameras: dict[str, Camera] = field(default_factory=dict)
    pose: CameraPose | None = None
    exact_at: int = -1  # log time of a pose to the last bit, which a transform does not replace
    said: dict[str, bytes] = field(default_factory=dict)

    def hear(self, raw: RawMessage) -> bool:
        """Whether the message says anything new."""
        content = raw.data[_BEFORE_CONTENT:]
        if self.said.get(raw.topic) == content:
            return False
        self.said[raw.topic] = content
        with in_words(raw.topic):
            if raw.topic in _INFOS:
                self.cameras[_INFOS[raw.topic]] = sensors.unpack_camera_info(raw.data)
            elif raw.topic == topics.CAMERA_POSE:
                self.pose, self.exact_at = exact_pose(raw.data), raw.log_time
            else:
                return self._hear_transform(raw)
        return True

    def _hear_transform(self, raw: RawMessage) -> bool:
        if self.exact_at == raw.log_time:
            return False
        for t in filter(is_camera, motion.unpack_transforms(raw.data)):
            self.pose = pose_of(t)
            return True
        return False

    def rig(self) -> StereoRig | None:
        """None where something is missing, or left and right are not of one calibration yet."""
        if len(self.cameras) < 2 or self.pose is None:
            return None
        try:
            return StereoRig(self.cameras["left"], self.cameras["right"], self.pose)
        except ConfigError:
            return None


def rig_changes(source: McapInput, moving: CameraPose | None) -> Iterator[tuple[int, StereoRig]]:
    """(log time ns, rig) of each calibration, the first one included; it holds until the next.

    ``moving`` is the pose at the start of a camera whose poses come with the images.
    """
    pose_topics = [] if moving is not None else [topics.TF_STATIC, topics.CAMERA_POSE]
    standing, changed = _Standing(pose=moving), -1
    for raw in ordered(source, frozenset([*_INFOS, *pose_topics])):
        if 0 <= changed < raw.log_time and (rig := standing.rig()) is not None:
            yield changed, rig
            changed = -1
        if standing.hear(raw):
            changed = raw.log_time
    if changed >= 0 and (rig := standing.rig()) is not None:
        yield changed, rig
