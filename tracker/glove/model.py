"""A glove: IMUs and coloured markers fixed to the segments of a hand.

Positions refer to the hand named in the glove's file. Arrays are in file order (IMUs) or ordered by
id (markers), for vectorised code.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tracker.hand.model import HandModel
from tracker.messages import Array, IntArray


@dataclass(frozen=True)
class ImuNoise:
    """Measured noise of an IMU at rest (`tracker.offline.imu_noise`)."""

    gyro: float
    """rad/s/√Hz"""
    accel: float
    """m/s²/√Hz"""
    gyro_bias: float
    """rad/s/√s: random walk of the bias."""
    accel_bias: float
    """m/s²/√s: likewise for the accelerometer."""


@dataclass(frozen=True, eq=False)
class ImuDrift:
    """Change of an IMU's biases with its temperature, and the standard deviations (each (3,)):
    ``gyro`` rad/s/°C, ``accel`` m/s²/°C (`tracker.calibration.imu_drift`)."""

    gyro: Array
    gyro_sd: Array
    accel: Array
    accel_sd: Array


@dataclass(frozen=True, eq=False)
class ImuAxes:
    """Correction of an IMU's scale and cross-axis errors: ``gyro`` and ``accel`` (3, 3), by which
    measured values are multiplied (`tracker.calibration.imu_axes`)."""

    gyro: Array
    accel: Array


@dataclass(frozen=True, eq=False)
class ImuVibration:
    """Noise that each motor (m,) adds to an IMU at full amplitude: ``gyro`` rad/s/√Hz, ``accel``
    m/s²/√Hz (`tracker.calibration.motor_vibration`)."""

    gyro: Array
    accel: Array


@dataclass(frozen=True, eq=False)
class Imu:
    """``position`` (3,) m of I in B; ``R_BI`` (3, 3) the nominal mounting; ``noise``, ``drift``,
    ``axes`` and ``vibration`` if they were measured."""

    name: str
    segment: str
    position: Array
    R_BI: Array
    noise: ImuNoise | None = None
    drift: ImuDrift | None = None
    axes: ImuAxes | None = None
    vibration: ImuVibration | None = None


@dataclass(frozen=True, eq=False)
class Marker:
    """A fabric patch: ``position`` (3,) m and outward ``normal`` (3,) in B; ``size`` m."""

    id: int
    hue: str
    shape: str  # "circle" or "square"
    size: float
    segment: str
    position: Array
    normal: Array


@dataclass(frozen=True, eq=False)
class Keypoint:
    """An extra named point of the glove, ``position`` (3,) m in B."""

    name: str
    segment: str
    position: Array


@dataclass(frozen=True, eq=False)
class GloveModel:
    """Sensors and markers of one glove."""

    name: str
    side: str
    hand_name: str
    imus: tuple[Imu, ...]
    markers: tuple[Marker, ...]
    keypoints: tuple[Keypoint, ...]

    @cached_property
    def imu_names(self) -> tuple[str, ...]:
        return tuple(i.name for i in self.imus)

    @cached_property
    def hues(self) -> tuple[str, ...]:
        """Hue names in order of first use."""
        return tuple(dict.fromkeys(m.hue for m in self.markers))

    @cached_property
    def marker_position(self) -> Array:
        """(M, 3) m, in each marker's B."""
        return np.array([m.position for m in self.markers], float).reshape(-1, 3)

    @cached_property
    def marker_normal(self) -> Array:
        """(M, 3), in each marker's B."""
        return np.array([m.normal for m in self.markers], float).reshape(-1, 3)

    @cached_property
    def marker_size(self) -> Array:
        return np.array([m.size for m in self.markers], float)

    @cached_property
    def marker_hue(self) -> IntArray:
        """(M,) index into `hues`."""
        return np.array([self.hues.index(m.hue) for m in self.markers], np.int64)

    def marker_segment(self, hand: HandModel) -> IntArray:
        """(M,) row of each marker's segment."""
        return np.array([hand.index[m.segment] for m in self.markers], np.int64)

    def imu_segment(self, hand: HandModel) -> IntArray:
        """(n,) row of each IMU's segment."""
        return np.array([hand.index[i.segment] for i in self.imus], np.int64)

    def keypoint_names(self, hand: HandModel) -> tuple[str, ...]:
        """The skeleton's keypoints, then the glove's own."""
        return (*hand.keypoint_names, *(k.name for k in self.keypoints))

    def keypoint_positions(
        self, hand: HandModel, R: Array, p: Array, scale: Array | None = None
    ) -> Array:
        """(K, 3) m in G of all keypoints, from segment poses R (S, 3, 3), p (S, 3)."""
        points = [hand.keypoints(R, p, scale)]
        for k in self.keypoints:
            i = hand.index[k.segment]
            offset = k.position if scale is None else k.position * scale[i]
            points.append((p[i] + R[i] @ offset)[None])
        return np.concatenate(points)

    def keypoint_segments(self, hand: HandModel) -> IntArray:
        """(K,) row of the segment that each keypoint moves with."""
        extra = [hand.index[k.segment] for k in self.keypoints]
        return np.array([*hand.keypoint_segment, *extra], np.int64)
