"""A wearer who follows the glove set-up's instructions: at rest, bending one finger, tilting the
hand."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array, ImuSample
from tracker.simulation.imu import ImuSimulator
from tracker.simulation.motion import Poses
from tracker.simulation.postures import posture
from tracker.simulation.wearer import Wearer, WearerParams

FREQUENCY = 0.9  # Hz
REST = "rest"
COUPLING = 0.15
"""Motion of a neighbour relative to that of the finger being moved."""
TIP = np.deg2rad(25.0)
BLOCK = 200  # packets simulated at once


@dataclass(frozen=True, eq=False)
class Wiggle:
    """``part`` ("rest", "hand", "thumb" or a finger) oscillates, the rest is still."""

    hand: HandModel
    part: str
    duration: float = 600.0
    follows_synergies: bool = True

    def poses(self, t: Array) -> Poses:
        """Palm down, 20 cm above the origin of G."""
        n = len(t)
        bend = (1 - np.cos(2 * np.pi * FREQUENCY * t)) / 2  # 0..1, starts at rest
        flexed = posture(self.hand, _flexion(self.part))
        angles = np.outer(bend, flexed)
        R_GB = np.tile(np.eye(3), (n, 1, 1))
        if self.part == "hand":
            R_GB = so3.exp(np.outer(bend * TIP, [0.0, 1.0, 0.0]))
        return Poses(angles, R_GB, np.tile([0.0, 0.0, 0.2], (n, 1)))


def _flexion(part: str) -> dict[str, float]:
    """Angles in degrees of the bent finger; its neighbours follow partially."""
    if part == "thumb":
        return {"thumb_cmc_flexion": 20, "thumb_mcp_flexion": 45, "thumb_ip_flexion": 40}
    if part not in FINGERS:
        return {}
    out: dict[str, float] = {}
    at = FINGERS.index(part)
    for k, finger in enumerate(FINGERS):
        share = {0: 1.0, 1: COUPLING}.get(abs(k - at), 0.0)
        out |= {f"{finger}_mcp_flexion": 50 * share, f"{finger}_pip_flexion": 70 * share}
    return out


def wiggling_wearer(hand: HandModel, glove: GloveModel, part: str, seed: int) -> Wearer:
    """A random wearer; the cloth does not slip while the hand lies on the table."""
    return Wearer.random(hand, glove, seed, WearerParams(wobble_deg=0.0) if part == REST else None)


class InstructedWearer:
    """Packets of a wearer who performs ``part``, which may be changed at any time."""

    def __init__(self, hand: HandModel, glove: GloveModel, seed: int = 1) -> None:
        self.part = REST
        self._make: Callable[[str], ImuSimulator] = lambda part: ImuSimulator(
            wiggling_wearer(hand, glove, part, seed), Wiggle(hand, part), seed
        )

    def samples(self) -> Iterator[ImuSample]:
        """Endless; a block of each part is simulated once and repeated."""
        blocks: dict[str, list[ImuSample]] = {}
        period = 0.0
        k = 0
        while True:
            part = self.part
            if part not in blocks:
                simulator = self._make(part)
                period = simulator.period
                blocks[part] = list(simulator.samples(0.0, BLOCK * period))
            block = blocks[part]
            sample = block[k % len(block)]
            t = k * period
            yield replace(sample, t=t, t_arrival=t, t_device=t, seq=k)
            k += 1
