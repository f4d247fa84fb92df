"""What all planar estimators share at their public door."""

from __future__ import annotations

from typing import Any, Generic, NamedTuple, Protocol, TypeVar

import numpy as np

from tracker.inertial.plane import SENSORS, ComplexArray
from tracker.messages import Array


class PlanarReadings(NamedTuple):
    """A recording of n samples: gyro (n, 2) rad/s about the plane's normal, accel (n, 2) m/s² in
    each phalanx's own axes, root (n,) m/s² the specific force of joint 0 in P."""

    gyro: Array
    accel: ComplexArray
    root: ComplexArray


class PlanarEstimator(Protocol):
    """Angles θ (2,) of the two phalanges that carry sensors, one sample at a time."""

    def update(self, gyro: Array, accel: ComplexArray, root: complex) -> Array:
        """Take one sample; return θ (2,) rad in P."""

    def run(self, readings: PlanarReadings) -> Array:
        """θ (n, 2) of n samples: the same as n calls of `update`."""


S = TypeVar("S", bound=tuple[Any, ...])


class WithState(Generic[S]):
    """What changes of an estimator is one named tuple of arrays, or of such tuples."""

    def __init__(self, state: S) -> None:
        self._state = state

    @property
    def state(self) -> S:
        """A copy that shares nothing with the estimator."""
        return _copied(self._state)

    @state.setter
    def state(self, value: S) -> None:
        self._state = _copied(value)


def _copied(state: S) -> S:
    return type(state)(*(_copied(a) if isinstance(a, tuple) else np.array(a) for a in state))


def start_angles(theta: Array | tuple[float, float]) -> Array:
    """The known initial angles as a new (2,) array."""
    return np.array(theta, float).reshape(SENSORS).copy()
