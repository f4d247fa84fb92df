"""A fitted recording as a smooth motion in the camera's working volume."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import make_interp_spline
from scipy.signal import butter, filtfilt

from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.messages import Array, CameraPose
from tracker.simulation.motion import Poses
from tracker.simulation.recorded.fit import Fit
from tracker.vision.rig import default_pose

CUTOFF_HZ = 7.0
"""Hands move below this; what is above is the recorder's noise."""


class SplineMotion:
    """Quintic splines through filtered samples: angles, quaternion and position of the dorsum.

    ``follows_synergies`` is False: the distal angles are those of the recorded person.
    """

    follows_synergies = False

    def __init__(self, t: Array, angles: Array, R_GB: Array, p_GB: Array, limits: Array) -> None:
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
        edge = 0.005  # differences in time reach a little beyond both ends
        table = self._spline(np.clip(t, -edge, self.duration + edge))
        n = self._count
        R = so3.matrix_from_quat(table[:, n : n + 4])
        return Poses(table[:, :n], R, table[:, n + 4 :])


def _low_pass(values: Array, rate_hz: float) -> Array:
    """Zero-lag Butterworth of second order, run both ways."""
    if 0.45 * rate_hz <= CUTOFF_HZ:
        return values
    b, a = butter(2, CUTOFF_HZ / (rate_hz / 2))
    out: Array = filtfilt(b, a, values, axis=0, padlen=min(12, len(values) - 1))
    return out


def in_working_volume(
    hand: HandModel,
    fit: Fit,
    up: Array,
    t: Array,
    camera: CameraPose | None = None,
    depth: float = 0.36,
) -> SplineMotion:
    """The recording moved as a whole, ``up`` to G's z, into the middle of the image.

    Turned about the vertical so that the fingers point away from the camera on average; the middle
    of the path's range comes to ``depth`` (m) on the camera's axis, further where the path is wide.
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
    """A rotation that takes ``up`` to z the shortest way."""
    z = np.array([0.0, 0.0, 1.0])
    axis, cosine = np.cross(up, z), float(up @ z)
    sine = float(np.linalg.norm(axis))
    if sine < 1e-9:
        return np.eye(3) if cosine > 0 else so3.rx(np.pi)
    return np.asarray(so3.exp(axis / sine * np.arctan2(sine, cosine)))
