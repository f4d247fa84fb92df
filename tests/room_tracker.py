"""A tracker of another system on the back of a simulated hand: what that system would report."""

from __future__ import annotations

import heapq
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tracker.base.clock import nanoseconds, seconds
from tracker.geometry import so3
from tracker.messages import ImuSample, WristPose
from tracker.simulation.scenario import Simulation

NOWHERE = np.full(4, np.nan)


@dataclass(frozen=True)
class RoomTracker:
    """How it measures: rate in Hz, latency in s, noise in m and rad, its pose on the hand's root
    segment (p_BT m, the rotation vector of R_BT), and whether it measures rotations."""

    rate: float = 100.0
    latency: float = 0.012
    position_sd: float = 0.001
    rotation_sd: float = 0.01
    p_BT: tuple[float, float, float] = (0.03, -0.01, 0.04)
    turned: tuple[float, float, float] = (0.4, -0.3, 1.1)
    with_rotation: bool = True

    def poses(self, sim: Simulation, start: float = 0.0, end: float = np.inf) -> list[WristPose]:
        """What it reports of the hand from ``start`` to ``end`` (s)."""
        rng = np.random.default_rng(8)
        t = np.arange(max(start, 0.1), min(end, sim.duration - 0.1), 1 / self.rate)
        t = np.array([seconds(nanoseconds(each)) for each in t])
        return [self.pose(sim, float(each), rng) for each in t]

    def pose(self, sim: Simulation, t: float, rng: np.random.Generator) -> WristPose:
        true, p_BT, R_BT = sim.truth(t), np.array(self.p_BT), so3.exp(np.array(self.turned))
        R_GB, p_GB = true.R_GB[0], true.p_GB[0]
        p_GT = p_GB + R_GB @ p_BT + rng.normal(0, self.position_sd, 3)
        R_GT = R_GB @ R_BT @ so3.exp(rng.normal(0, self.rotation_sd, 3))
        return WristPose(
            t=t,
            t_arrival=seconds(nanoseconds(t + self.latency)),
            side=sim.hand.side,
            p_GT=p_GT,
            q_GT=so3.quat_from_matrix(R_GT) if self.with_rotation else NOWHERE.copy(),
            p_BT=p_BT,
            q_BT=so3.quat_from_matrix(R_BT),
            position_variance=self.position_sd**2,
            rotation_variance=self.rotation_sd**2,
        )


def in_order(sim: Simulation, poses: list[WristPose]) -> Iterator[ImuSample | WristPose]:
    """Packets and poses in the order of arrival."""
    return heapq.merge(sim.imu_samples(), poses, key=lambda m: m.t_arrival)
