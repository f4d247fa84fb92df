"""A recorded motion from a file: Leap, Qualisys or BVH, smoothed and moved into the camera's
volume."""

from __future__ import annotations

import re
import zipfile
import zlib
from pathlib import Path

import numpy as np

from tracker.base.errors import FileError
from tracker.base.files import check_regular
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array, CameraPose
from tracker.simulation.motion import Poses
from tracker.simulation.recorded.bvh import BvhJoint, joint_positions
from tracker.simulation.recorded.fit import RecordedFit, fit_hand
from tracker.simulation.recorded.track import PointTrack, mirrored, resampled
from tracker.vision.rig import default_pose

CUTOFF_HZ = 7.0
"""Cut-off frequency: hands move below it; above it is the recorder's noise."""


class SplineMotion:
    """Quintic splines through filtered samples: angles, quaternion and position of the dorsum.

    ``follows_synergies`` is False: the distal angles are those of the recorded person.
    """

    follows_synergies = False

    def __init__(self, t: Array, angles: Array, R_GB: Array, p_GB: Array, limits: Array) -> None:
        from scipy.interpolate import make_interp_spline  # deferred: loads scipy.optimize

        self.duration = float(t[-1])
        self.residual = np.nan  # m, median distance of the recorded points from the fitted hand
        q = so3.quat_from_matrix(R_GB)
        flips = np.cumprod(np.where(np.sum(q[1:] * q[:-1], axis=1) < 0, -1.0, 1.0))
        q[1:] *= flips[:, None]
        rate = 1 / float(t[1] - t[0])
        table = _low_pass(np.concatenate([angles, q, p_GB], axis=1), rate)
        self._count = angles.shape[1]
        table[:, : self._count] = np.clip(table[:, : self._count], limits[:, 0], limits[:, 1])
        self._spline = make_interp_spline(t, table, k=5)

    def poses(self, t: Array) -> Poses:
        edge = 0.005  # time differences extend slightly beyond both ends
        table = self._spline(np.clip(t, -edge, self.duration + edge))
        n = self._count
        R = so3.matrix_from_quat(table[:, n : n + 4])
        return Poses(table[:, :n], R, table[:, n + 4 :])


def _low_pass(values: Array, rate_hz: float) -> Array:
    """Zero-phase Butterworth filter of second order, forward and backward."""
    if 0.45 * rate_hz <= CUTOFF_HZ:
        return values
    from scipy.signal import butter, filtfilt  # deferred: loads scipy.stats

    b, a = butter(2, CUTOFF_HZ / (rate_hz / 2))
    out: Array = filtfilt(b, a, values, axis=0, padlen=min(12, len(values) - 1))
    return out


def in_working_volume(
    hand: HandModel,
    fit: RecordedFit,
    up: Array,
    t: Array,
    camera: CameraPose | None = None,
    depth: float = 0.36,
) -> SplineMotion:
    """The recording, rigidly transformed with ``up`` to G's z, into the centre of the image.

    It is rotated about the vertical so that the fingers point away from the camera on average; the
    centre of the path is at ``depth`` (m) on the camera's axis, farther where the path is wide.
    """
    camera = camera or default_pose()
    turn = _level(up)
    forward = turn @ np.mean(fit.R_GB[:, :, 0], axis=0)
    ahead = camera.R_GC[:, 2] if abs(camera.R_GC[2, 2]) < 0.99 else -camera.R_GC[:, 1]
    yaw = np.arctan2(ahead[1], ahead[0]) - np.arctan2(forward[1], forward[0])
    turn = so3.rz(float(yaw)) @ turn
    R, p = turn @ fit.R_GB, fit.p_GB @ turn.T
    centre_C = (p + R[:, :, 0] * hand.length / 2) @ camera.R_GC
    low, high = np.percentile(centre_C, [2, 98], axis=0)
    wide = np.max((high - low)[:2] / 2 * [1 / 0.8, 1 / 0.4])
    middle = np.array([0.0, 0.0, max(depth, wide)])
    shift = camera.R_GC @ (middle - (low + high) / 2) + camera.p_GC
    motion = SplineMotion(t, fit.angles, R, p + shift, hand.angle_limits)
    motion.residual = float(np.nanmedian(fit.residual))
    return motion


def _level(up: Array) -> Array:
    """The smallest rotation from ``up`` to z."""
    z = np.array([0.0, 0.0, 1.0])
    axis, cosine = np.cross(up, z), float(up @ z)
    sine = float(np.linalg.norm(axis))
    if sine < 1e-9:
        return np.eye(3) if cosine > 0 else so3.rx(np.pi)
    return np.asarray(so3.exp(axis / sine * np.arctan2(sine, cosine)))


_FINGER = {"thumb": "thumb", "index": "index", "middle": "middle", "mid": "middle",
           "ring": "ring", "little": "little", "pinky": "little"}  # fmt: skip
_PARTS = {"thumb": ("cmc", "mcp", "ip", "tip"), "": ("mcp", "pip", "dip", "tip")}


def read_bvh(path: Path, text: str) -> PointTrack:
    """All joints of one hand's fingers. The side comes from the names, else right."""
    try:
        joints, t, positions = joint_positions(text)
    except (ValueError, IndexError) as error:
        raise FileError(notice("motion.not_bvh", path=path, why=error)) from error
    side, rows = _hand_rows(joints)
    if len(rows) < 6:
        raise FileError(notice("motion.few_joints", path=path))
    up = np.array([0.0, 1.0, 0.0])
    return PointTrack(t, positions[:, list(rows.values())], tuple(rows), up, side, None)


def _hand_rows(joints: list[BvhJoint]) -> tuple[str, dict[str, int]]:
    """The side, and keypoint name to joint row; the right hand where a file has both."""
    sides = [_side(j.name) for j in joints]
    side = "left" if "left" in sides and "right" not in sides else "right"
    chains: dict[str, list[int]] = {}
    for i, joint in enumerate(joints):
        finger = next((f for word, f in _FINGER.items() if word in joint.name.lower()), None)
        if finger and sides[i] in (side, ""):
            chains.setdefault(finger, []).append(i)
    rows: dict[str, int] = {}
    for finger, chain in chains.items():
        parts = _PARTS.get(finger, _PARTS[""])
        for part, row in zip(parts[::-1], chain[::-1], strict=False):
            rows[f"{finger}_{part}"] = row
    return side, rows


def _side(name: str) -> str:
    low = name.lower()
    if "right" in low or re.search(r"(^r_|_r$|_r_|\.r$|\.r\.)", low):
        return "right"
    if "left" in low or re.search(r"(^l_|_l$|_l_|\.l$|\.l\.)", low):
        return "left"
    return ""


_PLACE = {"tip": "tip", "middle": "pip"}


def read_qualisys(path: Path, text: str) -> PointTrack:
    """Markers <finger>_middle, <finger>_tip and hand_*; missing ones are 0 or empty."""
    lines = text.splitlines()
    header = {line.split("\t")[0]: line.split("\t")[1:] for line in lines[:12] if line}
    if "MARKER_NAMES" not in header or "FREQUENCY" not in header:
        raise FileError(notice("motion.not_qualisys", path=path))
    names = header["MARKER_NAMES"]
    rows = [line.split("\t") for line in lines[11:] if line and line[0].isdigit()]
    try:
        rate = float(header["FREQUENCY"][0])
        table = np.array([[float(c or 0) for c in r] for r in rows])
    except ValueError as error:
        raise FileError(notice("motion.not_number", path=path, why=error)) from error
    columns = table.shape[1] - 3 * len(names) if table.ndim == 2 else -1
    if columns not in (0, 2):
        raise FileError(notice("motion.columns", path=path))
    points = table[:, columns:].reshape(len(table), len(names), 3)
    points[np.all(points == 0, axis=2)] = np.nan
    kept = {i: target for i, n in enumerate(names) if (target := _target(n))}
    return PointTrack(
        np.arange(len(table)) / rate, points[:, list(kept)], tuple(kept.values()),
        np.array([0.0, 0, 1]), "right", 1e-3,
    )  # fmt: skip


def _target(name: str) -> str | None:
    """The position of a marker on the hand, None if elsewhere."""
    finger, _, place = name.partition("_")
    if finger == "hand":
        return f"dorsum:{place}"
    if finger in ("thumb", *FINGERS) and place in _PLACE:
        part = "ip" if finger == "thumb" and place == "middle" else _PLACE[place]
        return f"{finger}_{part}"
    return None


MOST_BYTES = 500_000_000
"""Limit for an unpacked recording; an hour at 120 Hz takes 220 MB."""
UNPACKING = (zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError)
"""Exceptions raised for damaged archives; the last one if a password is required."""
TARGETS = (
    *(f"thumb_{part}" for part in ("cmc", "mcp", "ip", "tip")),
    *(f"{f}_{part}" for f in FINGERS for part in ("mcp", "pip", "dip", "tip")),
)


def read_leap(path: Path) -> PointTrack:
    """t (N,) s and joints (N, 5, 4, 3) mm: thumb to little finger, base to tip."""
    try:
        check_regular(path)
        with zipfile.ZipFile(path) as archive:
            if sum(part.file_size for part in archive.infolist()) > MOST_BYTES:
                raise FileError(
                    notice("file.unpacked_size", path=path, limit_mb=MOST_BYTES // 10**6)
                )
        with np.load(path, allow_pickle=False) as data:
            t, joints, side = data["t"], data["joints"], str(np.ravel(data["hand"])[0])
    except (OSError, ValueError, KeyError, EOFError, MemoryError, *UNPACKING) as error:
        raise FileError(notice("motion.not_leap", path=path, why=error)) from error
    if joints.shape != (len(t), 5, 4, 3) or side not in ("left", "right"):
        raise FileError(notice("motion.fingers", path=path))
    new = np.concatenate([[True], np.diff(t) > 1e-4])
    points = joints[new].reshape(-1, 20, 3).astype(float)
    up = np.array([0.0, 1.0, 0.0])
    return PointTrack(t[new] - t[0], points, TARGETS, up, side, 1e-3)


RATE_HZ = 50.0
"""For the fit; with a cut-off of 7 Hz a higher rate would add nothing."""


def load_motion(path: Path, hand: HandModel, camera: CameraPose | None = None) -> SplineMotion:
    """Recorded motion in the camera's working volume, for a hand of either side.

    Qualisys ``.tsv``, decoded Leap ``.npz`` or ``.bvh``. Raises FileError.
    """
    path = Path(path)
    track = resampled(mirrored(read_track(path), hand.side), RATE_HZ)
    fit = fit_hand(hand, track)
    return in_working_volume(hand, fit, track.up, track.t, camera)


def read_track(path: Path) -> PointTrack:
    """The recorded points of a file. Raises FileError."""
    kind = path.suffix.lower()
    if kind == ".npz":
        return read_leap(path).checked(str(path))
    if kind == ".tsv":
        return read_qualisys(path, read_text(path, 100_000_000)).checked(str(path))
    if kind == ".bvh":
        return read_bvh(path, read_text(path, 100_000_000)).checked(str(path))
    raise FileError(notice("motion.unknown_kind", path=path))
