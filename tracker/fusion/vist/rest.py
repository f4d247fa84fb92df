"""Zero-velocity update for a hand at rest while no camera sees it.

Without it the position of an unseen hand is a double integral, which diverges within a second. A
person who holds a posture provides this measurement at no cost.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tracker.fusion.vist.layout import V, VistLayout
from tracker.fusion.vist.state import VistState
from tracker.messages import Array, ImuSample

WINDOW = 0.3  # s, length of the evaluated window
STILL_RATE = 0.35  # rad/s mean angular rate; sway and tremor give 0.2
STILL_FORCE = 1.8  # m/s² sd of the specific force; tremor gives 1
SD = 0.05  # m/s, since sway continues and the same rest is used many times per second


def is_still(packets: Sequence[ImuSample], t: float, imu: int, bias: Array) -> bool:
    """Whether one IMU was at rest during the last `WINDOW` seconds before ``t``. bias (3,)
    rad/s."""
    recent = [s for s in packets if t - WINDOW <= s.t <= t]
    if len(recent) < 5 or not all(s.valid[imu] for s in recent):
        return False
    rate = np.array([s.gyro[imu] for s in recent]) - bias
    force = np.array([s.accel[imu] for s in recent])
    sd = np.linalg.norm(force.std(axis=0))
    return bool(np.linalg.norm(rate, axis=1).mean() < STILL_RATE and sd < STILL_FORCE)


def rest_rows(state: VistState, layout: VistLayout) -> tuple[Array, Array, Array]:
    """H (3, 21 n), innovation (3,) m/s and noise (3, 3) of v_GI = 0 for the root's IMU."""
    H = np.zeros((3, layout.size))
    H[:, V : V + 3] = np.eye(3)
    return H, -state.v_GI[0], np.eye(3) * SD**2
