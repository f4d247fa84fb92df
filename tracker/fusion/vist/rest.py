"""A hand that keeps still while no camera sees it: its velocity is known to be about zero.

Without this an unseen hand's position is a double integral, lost in a second. A person who holds
a posture gives the filter this much for free.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tracker.fusion.vist.layout import V, VistLayout
from tracker.fusion.vist.state import VistState
from tracker.messages import Array, ImuSample

WINDOW = 0.3  # s looked back on
STILL_RATE = 0.35  # rad/s mean angular rate; sway and tremor give 0.2
STILL_FORCE = 1.8  # m/s² sd of the specific force; tremor gives 1
SD = 0.05  # m/s, for sway goes on and the same rest is used many times a second


def is_still(packets: Sequence[ImuSample], t: float, imu: int, bias: Array) -> bool:
    """Whether one IMU rested for the last `WINDOW` seconds before ``t``. bias (3,) rad/s."""
    lately = [s for s in packets if t - WINDOW <= s.t <= t]
    if len(lately) < 5 or not all(s.valid[imu] for s in lately):
        return False
    rate = np.array([s.gyro[imu] for s in lately]) - bias
    force = np.array([s.accel[imu] for s in lately])
    sd = np.linalg.norm(force.std(axis=0))
    return bool(np.linalg.norm(rate, axis=1).mean() < STILL_RATE and sd < STILL_FORCE)


def rest_rows(state: VistState, layout: VistLayout) -> tuple[Array, Array, Array]:
    """H (3, 21 n), innovation (3,) m/s and noise (3, 3) of v_GI = 0 for the root's IMU."""
    H = np.zeros((3, layout.size))
    H[:, V : V + 3] = np.eye(3)
    return H, -state.v_GI[0], np.eye(3) * SD**2
