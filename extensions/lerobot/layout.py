"""The common layout of all episodes of a data set, and the names of its values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

from tracker.hand.openxr import JOINTS

CODEBASE = "v3.0"
STATE, VALID, ACTION = "observation.state", "observation.state.valid", "action"
CAMERA = "observation.images."
COUNTERS = {
    "timestamp": "float32",
    "frame_index": "int64",
    "episode_index": "int64",
    "index": "int64",
    "task_index": "int64",
}
"""Scalar columns of every data set."""
POSITIONS, TURNS, WRIST = 3 * len(JOINTS), 4 * len(JOINTS), 7


class HandNames(NamedTuple):
    """A hand of the data set and its joint angles."""

    side: str
    angles: tuple[str, ...]

    @property
    def numbers(self) -> int:
        """Number of values per frame."""
        return POSITIONS + TURNS + WRIST + len(self.angles)

    @property
    def names(self) -> list[str]:
        """``right_palm_x`` … ``right_palm_qx`` … ``right_wrist_pose_x`` … and angles in rad."""
        s = self.side
        named = [f"{s}_{joint}_{c}" for joint in JOINTS for c in "xyz"]
        named += [f"{s}_{joint}_q{c}" for joint in JOINTS for c in "xyzw"]
        named += [f"{s}_wrist_pose_{c}" for c in ("x", "y", "z", "qx", "qy", "qz", "qw")]
        return named + [f"{s}_{angle}" for angle in self.angles]


class DatasetCamera(NamedTuple):
    """A camera whose images are exported; size in px; ``kind`` is jpeg or png."""

    name: str
    height: int
    width: int
    kind: str

    @property
    def key(self) -> str:
        return f"{CAMERA}{self.name}"


@dataclass(frozen=True)
class Layout:
    """``robot``: names of the joints that are the action; empty if it is the next state.

    ``video``: images are stored as videos.
    """

    fps: int
    hands: tuple[HandNames, ...]
    cameras: tuple[DatasetCamera, ...] = ()
    robot: tuple[str, ...] = ()
    video: bool = False

    @property
    def state_names(self) -> list[str]:
        return [name for hand in self.hands for name in hand.names]

    @property
    def action_names(self) -> list[str]:
        return list(self.robot) or self.state_names

    def features(self) -> dict[str, dict[str, Any]]:
        """The features for ``meta/info.json``."""
        names = self.state_names
        out: dict[str, dict[str, Any]] = {
            STATE: {"dtype": "float32", "shape": [len(names)], "names": names},
            VALID: {"dtype": "float32", "shape": [len(names)], "names": names},
            ACTION: {
                "dtype": "float32",
                "shape": [len(self.action_names)],
                "names": self.action_names,
            },
        }
        for camera in self.cameras:
            out[camera.key] = self._image(camera)
        for name, kind in COUNTERS.items():
            out[name] = {"dtype": kind, "shape": [1], "names": None}
        return out

    def _image(self, camera: DatasetCamera) -> dict[str, Any]:
        shape = [camera.height, camera.width, 3]
        feature: dict[str, Any] = {"shape": shape, "names": ["height", "width", "channels"]}
        if not self.video:
            return {"dtype": "image", **feature}
        film = {
            "video.height": camera.height,
            "video.width": camera.width,
            "video.codec": "h264",
            "video.pix_fmt": "yuv420p",
            "video.is_depth_map": False,
            "video.fps": self.fps,
            "video.channels": 3,
            "has_audio": False,
        }
        return {"dtype": "video", **feature, "info": film}
