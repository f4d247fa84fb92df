"""Virtual touch: a fingertip that enters a sphere starts its motor."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracker.hand.names import CHAINS
from tracker.messages import Array, Estimate, Validity
from tracker.streaming.publisher import Names

Vibrate = Callable[[int, int, int], object]
"""channel, amplitude 0..255, duration in ms: `tracker.sensors.glove_link.GloveLink.vibrate`."""


@dataclass(frozen=True, eq=False)
class Sphere:
    """center_G (3,) and radius, m."""

    center_G: Array
    radius: float


@dataclass(frozen=True)
class HapticParams:
    """Parameters of the vibration. ``motors``: channel of the glove for each fingertip keypoint."""

    amplitude: int = 200
    duration_ms: int = 80
    leave: float = 0.005  # m beyond the surface at which contact ends (hysteresis against tremor)
    motors: Mapping[str, int] = field(
        default_factory=lambda: {f"{finger}_tip": i for i, finger in enumerate(CHAINS)}
    )

    def __post_init__(self) -> None:
        if not 0 <= self.amplitude <= 255 or not 0 < self.duration_ms <= 65535:
            raise ValueError("amplitude is 0..255 and duration 1..65535 ms")
        if self.leave < 0 or any(not 0 <= c <= 255 for c in self.motors.values()):
            raise ValueError("leave is not negative and motor channels are 0..255")


class ContactRule:
    """Tracks which fingertip is in which sphere and reports those that have just entered."""

    def __init__(self, spheres: Sequence[Sphere], leave: float) -> None:
        self._centers = np.array([s.center_G for s in spheres], float).reshape(-1, 3)
        self._radii = np.array([s.radius for s in spheres], float)
        self._leave = leave
        self._inside: dict[str, NDArray[np.bool_]] = {}

    def entered(self, tip: str, position: Array | None) -> bool:
        """Whether the tip at ``position`` (3,) m in G has entered a sphere since the last call.

        None where the tip is lost: it is not known to have left, so nothing changes.
        """
        if position is None:
            return False
        distance = np.linalg.norm(self._centers - position, axis=1)
        before = self._inside.get(tip, np.zeros(len(self._radii), bool))
        now = distance <= self._radii + np.where(before, self._leave, 0.0)
        self._inside[tip] = now
        return bool((now & ~before).any())


class HapticPublisher:
    """Runs the motor of every fingertip that enters a sphere."""

    name = "vibration motors"

    def __init__(
        self,
        names: Names,
        spheres: Sequence[Sphere],
        vibrate: Vibrate,
        params: HapticParams | None = None,
    ) -> None:
        self._vibrate, self._params = vibrate, params or HapticParams()
        self._rule = ContactRule(spheres, self._params.leave)
        self._tips = [
            (names.keypoints.index(tip), tip, channel)
            for tip, channel in self._params.motors.items()
            if tip in names.keypoints
        ]

    def send(self, estimate: Estimate) -> None:
        for row, tip, channel in self._tips:
            known = estimate.keypoint_state[row] != Validity.LOST
            if self._rule.entered(tip, estimate.keypoints[row] if known else None):
                self._vibrate(channel, self._params.amplitude, self._params.duration_ms)

    def close(self) -> None:
        """Does nothing: motors stop after their duration."""
