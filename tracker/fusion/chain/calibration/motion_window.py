"""Acceleration and images of a few seconds, as linear equations of the scale of the images.

The accelerometer measures metres, the images of one camera multiples of the hand's size. Packets
are integrated from readings alone: corrections of the filter's biases and mountings during a
window would look like acceleration. Equation numbers are those of docs/chain.md.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracker import GRAVITY
from tracker.base.records import record
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.state import ChainState
from tracker.fusion.time.imu_buffer import Intervals
from tracker.geometry import so3
from tracker.messages import Array, CameraPose

GRAVITY_G = np.array([0.0, 0.0, -GRAVITY])
SCALE, ACCEL_BIAS, GYRO_BIAS, GYRO_AXES, TILT = 0, slice(1, 4), slice(4, 7), slice(7, 16), 16
COLUMNS = 19
"""κ; and κ times these: accelerometer bias (3) m/s², gyro bias (3) rad/s, errors of the gyroscope's
matrix (3 x 3, by column), both biases negative, and the orientation error (3) rad at the start."""


@record(
    "chain.motion_window",
    shapes={
        "times": "k",
        "seen": "k 3",
        "by_motion": "k 3 c",
        "R_GI": "3 3 | 0",
        "bg": "3 | 0",
        "velocity": "3 c | 0",
        "place": "3 c | 0",
        "turn": "3 c | 0",
    },
)
@dataclass(eq=False)
class MotionWindow:
    """Positions of the root's IMU, and those that the packets integrate to.

    times (k,) s; seen (k, 3) multiples of the hand's size, from the camera, along axes of G;
    by_motion (k, 3, 19) m the same per unit of each unknown. The rest is the integration up to
    ``t``: R_GI (3, 3), bg (3,) rad/s subtracted, velocity, place, turn (3, 19). ``moved``: the
    camera has moved since the start, at ``camera``.
    """

    start: float = np.nan
    t: float = np.nan
    camera: CameraPose | None = None
    times: Array = field(default_factory=lambda: np.zeros(0))
    seen: Array = field(default_factory=lambda: np.zeros((0, 3)))
    by_motion: Array = field(default_factory=lambda: np.zeros((0, 3, COLUMNS)))
    R_GI: Array = field(default_factory=lambda: np.zeros(0))
    bg: Array = field(default_factory=lambda: np.zeros(0))
    velocity: Array = field(default_factory=lambda: np.zeros(0))
    place: Array = field(default_factory=lambda: np.zeros(0))
    turn: Array = field(default_factory=lambda: np.zeros(0))
    moved: bool = False

    @property
    def is_open(self) -> bool:
        """Whether it has begun."""
        return bool(np.isfinite(self.start))

    def integrate(self, way: Intervals, imu: int) -> bool:
        """Continues through the packets of one IMU; False where some are missing (eq. 79)."""
        if not way.valid[:, imu].all():
            return False
        dt = (way.stop - way.start)[:, None]
        if not len(dt):
            return True
        turned = (way.gyro[:, imu] - self.bg) * dt
        # 1. orientations: R (k, 3, 3) in the middle of each interval
        R, half, whole = np.empty((len(dt), 3, 3)), so3.exp(turned / 2), so3.exp(turned)
        for k in range(len(dt)):
            R[k] = self.R_GI @ half[k]
            self.R_GI = self.R_GI @ whole[k]
        # 2. what each unknown adds to rotation, velocity and place
        force = np.einsum("kij,kj->ki", R, way.accel[:, imu] * dt)
        moved = force + GRAVITY_G * dt
        step, faster = np.zeros((2, len(dt), 3, COLUMNS))
        step[..., GYRO_BIAS] = R * dt[..., None]
        for axis in range(3):
            columns = slice(GYRO_AXES.start + 3 * axis, GYRO_AXES.start + 3 * axis + 3)
            step[..., columns] = R * (way.gyro[:, imu, axis, None] * dt)[..., None]
        turns = self.turn + np.cumsum(step, axis=0)
        faster[...] = -so3.skew(force) @ (turns - step / 2)
        faster[..., SCALE] = moved
        faster[..., ACCEL_BIAS] += R * dt[..., None]
        faster[..., TILT:] = -so3.skew(moved)
        velocities = self.velocity + np.cumsum(faster, axis=0)
        farther = (velocities - faster / 2) * dt[..., None]
        self.place = self.place + farther.sum(axis=0)
        self.velocity, self.turn, self.t = velocities[-1], turns[-1], float(way.stop[-1])
        return True

    def add(self, seen: Array, camera: CameraPose) -> None:
        """Adds an image at ``t``, with the position ``seen`` (3,) from the ``camera`` in multiples
        of the size."""
        assert self.camera is not None
        by_motion = self.place.copy()
        by_motion[:, SCALE] -= camera.p_GC - self.camera.p_GC
        by_motion[:, SCALE] += self.place[:, GYRO_BIAS] @ self.bg  # the whole bias is unknown
        self.times = np.append(self.times, self.t)
        self.seen = np.concatenate([self.seen, seen[None]])
        self.by_motion = np.concatenate([self.by_motion, by_motion[None]])


def window_at(state: ChainState, layout: ChainLayout, camera: CameraPose) -> MotionWindow:
    """A window that begins at ``state``."""
    imu = int(layout.imu_of[0])
    zero = np.zeros((3, COLUMNS))
    return MotionWindow(
        start=state.t,
        t=state.t,
        camera=camera,
        R_GI=state.R_GB[0] @ state.R_IB[imu].T,
        bg=state.bg[imu].copy(),
        velocity=zero,
        place=zero,
        turn=zero,
    )
