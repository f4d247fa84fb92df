"""The orientation of a moving camera from its own gyroscope and accelerometer.

For a camera whose pose is not reported, such as one on the head. Gyroscope integration gives the
orientation; gravity corrects its tilt and the gyroscope's bias about level axes (Mahony, Hamel,
Pflimlin 2008, explicit complementary filter). The heading is integration alone and drifts slowly,
which turns the room and the hand together and does not show in the camera's frame. The
position is assumed to be fixed: a head sways little compared with the motion of a hand.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, replace

import numpy as np

from tracker import GRAVITY
from tracker.base.records import record
from tracker.geometry import so3
from tracker.messages import Array, BlobFrame, CameraImuSample, CameraPose

UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class CameraTiltParams:
    """``gain`` must be small against a head's accelerations and large against the drift of a
    gyroscope's bias."""

    gain: float = 0.3  # 1/s, of tilt towards the accelerometer's direction
    bias_gain: float = 0.01  # 1/s²
    trust: float = 1.0  # m/s² by which a specific force may differ from gravity to be used
    longest_step: float = 0.2  # s between samples, beyond which the tilt is reset
    memory: float = 1.0  # s of an image's delay, at most
    ahead: float = 0.1  # s beyond the newest sample, after which the camera is assumed to rest


@record("camera_tilt.rotation", shapes={"R_GC": "3 3", "rate": "3"})
@dataclass(frozen=True, eq=False)
class _CameraRotation:
    """At ``t`` (s): R_GC (3, 3) and the angular rate (3,) rad/s in C from then on."""

    t: float
    R_GC: Array
    rate: Array


@record("camera_tilt", shapes={"bias": "3"})
@dataclass(eq=False)
class CameraTiltSavedState:
    """The saved state: the gyroscope's bias (3,) rad/s, the last sample, rotations."""

    bias: Array
    last: CameraImuSample | None
    rotations: list[_CameraRotation]


class CameraTilt:
    """Feed samples in order, then ask for the pose at an exposure."""

    def __init__(self, nominal: CameraPose, params: CameraTiltParams | None = None) -> None:
        """``nominal`` gives the position and the heading at the start."""
        self._params, self._nominal = params or CameraTiltParams(), nominal
        self._bias = np.zeros(3)
        self._last: CameraImuSample | None = None
        self._rotations: deque[_CameraRotation] = deque()

    def feed(self, sample: CameraImuSample) -> None:
        """Adds the next sample; a late or non-finite one is ignored."""
        if not (np.isfinite(sample.gyro).all() and np.isfinite(sample.accel).all()):
            return
        last, R = self._last, self._rotations[-1].R_GC if self._rotations else self._nominal.R_GC
        if last is not None and sample.t <= last.t:
            return
        if last is None or sample.t - last.t > self._params.longest_step:
            R = _levelled(R, sample.accel)
        else:
            R = self._moved(R, last, sample)
        self._last = sample
        self._rotations.append(_CameraRotation(sample.t, R, sample.gyro - self._bias))
        while sample.t - self._rotations[0].t > self._params.memory:
            self._rotations.popleft()

    def _moved(self, R_GC: Array, last: CameraImuSample, sample: CameraImuSample) -> Array:
        """R_GC one sample later: turned by the gyroscope, then pulled towards gravity."""
        p, dt = self._params, sample.t - last.t
        R_GC = R_GC @ so3.exp(((last.gyro + sample.gyro) / 2 - self._bias) * dt)
        force = float(np.linalg.norm(sample.accel))
        if abs(force - GRAVITY) > p.trust:
            return R_GC
        off = np.cross(sample.accel / force, R_GC.T @ UP)  # rad in C, for small angles
        self._bias = self._bias - p.bias_gain * dt * off
        turned: Array = R_GC @ so3.exp(p.gain * dt * off)
        return turned

    def pose(self, t: float) -> CameraPose | None:
        """The camera at the time t (s); None before the first sample."""
        if not self._rotations:
            return None
        last = self._rotations[0]
        for later in reversed(self._rotations):
            if later.t <= t:
                last = later
                break
        ahead = min(max(t - last.t, 0.0), self._params.ahead)
        return CameraPose(last.R_GC @ so3.exp(last.rate * ahead), self._nominal.p_GC)

    def posed(self, frame: BlobFrame) -> BlobFrame:
        """Returns the frame with the camera's pose at its exposure, unless it already has one."""
        if frame.pose is not None or not self._rotations:
            return frame
        return replace(frame, pose=self.pose(frame.t))

    def get_state(self) -> CameraTiltSavedState:
        """The state to save."""
        return CameraTiltSavedState(self._bias, self._last, list(self._rotations))

    def set_state(self, state: CameraTiltSavedState) -> None:
        """Continues from `get_state`."""
        self._bias, self._last = state.bias, state.last
        self._rotations = deque(state.rotations)


def _levelled(R_GC: Array, accel: Array) -> Array:
    """R_GC after the smallest rotation that makes the measured force (3,) in C point up."""
    up = R_GC @ accel / max(float(np.linalg.norm(accel)), 1e-9)
    axis = np.cross(up, UP)
    sine = float(np.linalg.norm(axis))
    if sine < 1e-9:  # already level, or upside down, where the axis is undefined
        return R_GC if up[2] > 0 else so3.rx(np.pi) @ R_GC
    angle = float(np.arctan2(sine, up[2]))
    turned: Array = so3.exp(axis / sine * angle) @ R_GC
    return turned
