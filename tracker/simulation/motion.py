"""The interface of a motion, and modifications of motions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np

from tracker.messages import Array, CameraPose
from tracker.simulation.smooth import minimum_jerk


class Poses(NamedTuple):
    """The hand at n instants: angles (n, J) rad; the dorsum's R_GB (n, 3, 3) and p_GB (n, 3) m."""

    angles: Array
    R_GB: Array
    p_GB: Array


class SimulatedMotion(Protocol):
    """A hand moving, twice continuously differentiable in time."""

    @property
    def duration(self) -> float:
        """Seconds from t = 0; afterwards the last posture is held."""
        ...

    @property
    def follows_synergies(self) -> bool:
        """Whether distal angles come from the hand file's synergies and not from a measurement."""
        ...

    def poses(self, t: Array) -> Poses:
        """The hand at the times t (n,) s."""
        ...


def pose_at(motion: SimulatedMotion, t: float) -> tuple[Array, Array, Array]:
    """(angles (J,), R_GB (3, 3), p_GB (3,)) at one time."""
    poses = motion.poses(np.array([t]))
    return poses.angles[0], poses.R_GB[0], poses.p_GB[0]


@dataclass(frozen=True, eq=False)
class Still:
    """One constant posture: angles (J,), R_GB (3, 3), p_GB (3,)."""

    angles: Array
    R_GB: Array
    p_GB: Array
    duration: float = 10.0
    follows_synergies: bool = True

    def poses(self, t: Array) -> Poses:
        n = len(t)
        return Poses(
            np.tile(self.angles, (n, 1)), np.tile(self.R_GB, (n, 1, 1)), np.tile(self.p_GB, (n, 1))
        )


@dataclass(frozen=True, eq=False)
class Faster:
    """A motion played ``factor`` times as fast."""

    motion: SimulatedMotion
    factor: float

    @property
    def duration(self) -> float:
        return self.motion.duration / self.factor

    @property
    def follows_synergies(self) -> bool:
        return self.motion.follows_synergies

    def poses(self, t: Array) -> Poses:
        return self.motion.poses(np.asarray(t) * self.factor)


ALONG, DOWN = (0.8, 1.6), (0.6, 2.3)
"""Share of the speed, and Hz, of a hand's swing along the rows of an image and across them."""


@dataclass(frozen=True, eq=False)
class Swinging:
    """A motion that is moved to and fro in front of a camera, with a peak speed of ``speed``
    m/s."""

    motion: SimulatedMotion
    speed: float
    camera: CameraPose

    @property
    def duration(self) -> float:
        return self.motion.duration

    @property
    def follows_synergies(self) -> bool:
        return self.motion.follows_synergies

    def poses(self, t: Array) -> Poses:
        poses = self.motion.poses(t)
        shift = np.zeros((len(t), 3))
        for axis, (share, hz) in enumerate((ALONG, DOWN)):
            omega = 2 * np.pi * hz
            shift[:, axis] = share * self.speed / omega * np.sin(omega * np.asarray(t))
        return poses._replace(p_GB=poses.p_GB + shift @ self.camera.R_GC.T)


@dataclass(frozen=True, eq=False)
class Away:
    """A motion that leaves the view: shifted by ``shift_G`` (3,) m during each (t0, t1) of spans.

    The hand is fully away from t0 to t1 and takes ``travel`` seconds in each direction.
    """

    motion: SimulatedMotion
    spans: tuple[tuple[float, float], ...]
    shift_G: Array
    travel: float = 0.7

    @property
    def duration(self) -> float:
        return self.motion.duration

    @property
    def follows_synergies(self) -> bool:
        return self.motion.follows_synergies

    def poses(self, t: Array) -> Poses:
        poses = self.motion.poses(t)
        return poses._replace(p_GB=poses.p_GB + self._share(t)[:, None] * self.shift_G)

    def _share(self, t: Array) -> Array:
        """0 in view, 1 away."""
        share = np.zeros(len(t))
        for t0, t1 in self.spans:
            going = minimum_jerk((t - t0) / self.travel + 1)
            coming = minimum_jerk((t - t1) / self.travel)
            share = np.maximum(share, going * (1 - coming))
        return share
