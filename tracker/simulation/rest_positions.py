"""A simulated wearer who rests the hand in the positions of `tracker.calibration.imu_positions`."""

from __future__ import annotations

import numpy as np

from tracker.calibration.imu_positions import orientation
from tracker.simulation.posture_requests import PostureRequest
from tracker.simulation.postures import posture
from tracker.simulation.scenario import Simulation

MOVE_S = 1.2


def rest_request(name: str, simulation: Simulation, t: float) -> list[PostureRequest]:
    """From ``t`` (s) on, the flat hand moves into the position and rests there."""
    hand = simulation.hand
    R_GB, p_GB = orientation(name, hand.side), simulation.motion.poses(np.zeros(1)).p_GB[0]
    place = (*R_GB.ravel().tolist(), *p_GB.tolist())
    return [PostureRequest(t, tuple(posture(hand, {}).tolist()), 0.0, place, MOVE_S)]
