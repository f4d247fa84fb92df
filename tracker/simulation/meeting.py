"""How two hands move together: apart, near, touching, one over the other, crossed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.messages import Array, CameraPose
from tracker.simulation.motion import Motion, Poses
from tracker.simulation.random_postures import PostureParams
from tracker.simulation.smooth import minimum_jerk, rng_for

CLOSE = PostureParams(near=0.30, far=0.36, wide=0.03, high=0.08, roll_deg=25.0, yaw_deg=10.0)
"""Postures of hands that stay before the middle of the camera."""


@dataclass(frozen=True)
class MeetingParams:
    """Separations (m) along the image's rows between the middles of two palms, the right hand's
    less the left one's: negative where arms are crossed."""

    apart: tuple[float, float] = (0.18, 0.25)
    near: tuple[float, float] = (0.12, 0.15)
    touching: tuple[float, float] = (0.095, 0.11)
    folded: tuple[float, float] = (0.02, 0.06)
    crossed: tuple[float, float] = (-0.16, -0.12)
    over: float = 0.095  # m along the optical axis between hands of which one is over the other
    width: float = 0.09  # m of separation, from which on neither is over the other
    first_hold: float = 1.5  # s apart
    period: float = 2.0  # s from one to the next
    move: float = 0.9  # s that going there takes


class Meeting:
    """Where two hands are to each other at any time, drawn from a seed."""

    def __init__(self, seed: int, duration: float, params: MeetingParams | None = None) -> None:
        self._params = p = params or MeetingParams()
        rng = rng_for(seed, "meeting")
        count = max(int(np.ceil((duration - p.first_hold) / p.period)), 0)
        kinds = (p.apart, p.near, p.touching, p.folded, p.crossed)
        drawn = rng.choice(len(kinds), count, p=[0.15, 0.2, 0.25, 0.2, 0.2])
        self._separation = np.array(
            [rng.uniform(*p.apart), *(rng.uniform(*kinds[k]) for k in drawn)]
        )
        self._upper = float(rng.choice([-1.0, 1.0]))  # which hand is nearer to the camera

    def offset(self, t: Array) -> Array:
        """(n, 3) m in C from the left to the right hand at the times t (n,) s."""
        p = self._params
        start = p.first_hold + p.period * np.arange(len(self._separation) - 1)
        steps = np.diff(self._separation)
        share = minimum_jerk((np.asarray(t, float)[:, None] - start) / p.move)
        along = self._separation[0] + share @ steps
        depth = self._upper * p.over * np.exp(-((along / p.width) ** 4))
        return np.column_stack([along, np.zeros(len(along)), depth])


@dataclass(frozen=True, eq=False)
class OneOfTwo:
    """A motion about the centre, shifted to its position in a meeting; ``side`` is the hand's."""

    motion: Motion
    meeting: Meeting
    side: str
    camera: CameraPose

    @property
    def duration(self) -> float:
        return self.motion.duration

    @property
    def follows_synergies(self) -> bool:
        return self.motion.follows_synergies

    def poses(self, t: Array) -> Poses:
        poses = self.motion.poses(t)
        half = 0.5 if self.side == "right" else -0.5
        shift = half * self.meeting.offset(t) @ self.camera.R_GC.T
        return poses._replace(p_GB=poses.p_GB + shift)
