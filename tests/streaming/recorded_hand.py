"""A hand that the application recorded, for end-to-end tests of outputs, and its values as
`glovetrack.open` returns them."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import glovetrack
from tracker.messages import Array, Estimate
from tracker.session.reader import SessionReader
from tracker.streaming.publisher import Names

__all__ = ["NEAR_DEG", "RecordedHand", "assert_near", "assert_parallel"]
COUNT = 20
NEAR_M, NEAR_DEG = 1e-4, 0.1
OPENXR_OF_G = np.array([[0.0, -1, 0], [0, 0, 1], [-1, 0, 0]])  # x right, y up, -z forward
PARTS = ("proximal", "intermediate", "distal", "tip")
OPENXR_JOINTS = {
    "wrist": "wrist",
    "thumb_metacarpal": "thumb_cmc",
    "thumb_proximal": "thumb_mcp",
    "thumb_distal": "thumb_ip",
    "thumb_tip": "thumb_tip",
    **{
        f"{finger}_{part}": f"{finger}_{joint}"
        for finger in ("index", "middle", "ring", "little")
        for part, joint in zip(PARTS, ("mcp", "pip", "dip", "tip"), strict=True)
    },
}
"""The keypoint of each joint that has one."""


class RecordedHand:
    """``estimates``: `COUNT` instants of the recording at ``path`` at which all points are known,
    as a replay sends them."""

    def __init__(self, path: Path) -> None:
        self.path = path
        with SessionReader(path) as reader:
            info = reader.info
            found = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)]
        whole = [e for e in found if e.keypoint_state.all() and e.angle_state.all()]
        assert len(whole) >= COUNT, "the hand was lost for too long"
        rows = np.linspace(0, len(whole) - 1, COUNT).round().astype(int)
        self.estimates = [whole[k] for k in rows]
        self.names = Names.of(info.hand, info.glove, anchor=info.anchor)

    @cached_property
    def recording(self) -> glovetrack.Recording:
        return glovetrack.open(self.path)

    def unix_ns(self, e: Estimate) -> int:
        return int(self.recording.t_unix_ns[self._row(e)])

    def points(self, e: Estimate) -> dict[str, Array]:
        """Each keypoint (3,) m in G."""
        row, hand = self._row(e), self.recording.hand
        return {name: hand.keypoints[name][row] for name in hand.keypoints}

    def turns(self, e: Estimate) -> dict[str, Rotation]:
        """The rotation from the axes of the bone that begins at each keypoint to G."""
        row, hand = self._row(e), self.recording.hand
        return {n: Rotation.from_quat(hand.orientations[n][row]) for n in hand.orientations}

    def angles(self, e: Estimate) -> dict[str, float]:
        row, hand = self._row(e), self.recording.hand
        return {name: float(hand.angles[name][row]) for name in hand.angles}

    def openxr(self, e: Estimate) -> dict[str, tuple[Array, Rotation]]:
        """Position (m) and rotation in OpenXR's world of the joints that are keypoints."""
        points, turns = self.points(e), self.turns(e)
        of_G = Rotation.from_matrix(OPENXR_OF_G)
        return {
            joint: (OPENXR_OF_G @ points[name], of_G * turns[name] * of_G.inv())
            for joint, name in OPENXR_JOINTS.items()
        }

    def rate_change_deg(self, e: Estimate, joint: str) -> float:
        """At most how much the rate (°/s) of an OpenXR joint's rotation changes at ``e``."""
        row, q = self._row(e), self.recording.hand.orientations[OPENXR_JOINTS[joint]]
        rows = slice(max(row - 1, 0), row + 2)
        turned = Rotation.from_quat(q[rows][:-1]).inv() * Rotation.from_quat(q[rows][1:])
        seconds = np.diff(self.recording.t_unix_ns[rows]) / 1e9
        return float(np.rad2deg(turned.magnitude() / seconds).sum())

    def _row(self, e: Estimate) -> int:
        (row,) = np.flatnonzero(np.abs(self.recording.t_unix_ns - self.names.wall_ns(e.t)) < 1000)
        return int(row)


def assert_near(found: Array, wanted: Array) -> None:
    """Within 0.1 mm."""
    assert np.linalg.norm(np.asarray(found) - wanted, axis=-1).max() < NEAR_M


def assert_parallel(found: Rotation, wanted: Rotation, near_deg: float = NEAR_DEG) -> None:
    assert np.rad2deg((found * wanted.inv()).magnitude()).max() < near_deg
