"""The positions in which a glove rests for the measurement of its IMUs' axes.

A position is the direction of gravity in the frame B of the back of the hand. The fit
(`tracker.calibration.imu_axes`) needs rests in different directions, not these exact ones.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tracker.calibration.imu_axes import FEWEST, AxesResult, RestFinder, fit_axes
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.messages import Array, ImuSample

_UP = {
    "palm_down": (0, 0, 1),
    "fingers_raised": (1, 0, 1),
    "fingers_up": (1, 0, 0),
    "palm_up_raised": (1, 0, -1),
    "palm_up": (0, 0, -1),
    "thumb_up": (0, 1, 0),
    "thumb_up_raised": (1, 1, 0),
    "thumb_side_raised": (0, 1, 1),
    "little_side_raised": (0, -1, 1),
    "thumb_down": (0, -1, 0),
    "fingers_lowered": (-1, 0, 1),
    "fingers_down": (-1, 0, 0),
}
"""The upward direction in B of a right hand: x along the fingers, y to the thumb, z out of the back
of the hand. Neighbours in this order differ by a movement that a worn hand can make."""
POSITION_NAMES = tuple(_UP)
TOLERANCE = np.deg2rad(22.0)
"""Of a position: half of the least angle between two of them."""
HOLD_S = 1.5
"""s of rest after which a position counts."""
LARGEST_SD = 0.007
"""Standard deviation of an element above which a result is not used; that of the prior is 0.01."""
LARGEST_MISFIT = 3.0
"""Standard deviations of the residuals above which the IMU moved during its rests."""


def up_B(name: str, side: str) -> Array:
    """(3,) unit vector upward in B of the back of the hand in a position."""
    x, y, z = _UP[name]
    up = np.array([x, -y if side == "left" else y, z], float)
    return up / np.linalg.norm(up)


def orientation(name: str, side: str) -> Array:
    """R_GB (3, 3) of the back of the hand in a position."""
    up = up_B(name, side)
    over = so3.rx(np.pi) if up[2] < -0.5 else np.eye(3)  # palm up: turned about the forearm
    axis = np.cross(over @ up, [0.0, 0.0, 1.0])
    sine = float(np.linalg.norm(axis))
    if sine < 1e-9:
        return over
    turn: Array = so3.exp(axis / sine * np.arctan2(sine, (over @ up)[2]))
    return turn @ over


class ImuAxesRow(NamedTuple):
    """One IMU: its result, None if it did not answer in enough rests."""

    name: str
    result: AxesResult | None

    @property
    def is_usable(self) -> bool:
        """Whether the rests determine the errors and agree with each other."""
        r = self.result
        if r is None:
            return False
        sd = max(float(r.gyro_sd.max()), float(r.accel_sd.max()))
        return sd <= LARGEST_SD and r.misfit <= LARGEST_MISFIT


@dataclass(eq=False)
class PositionGuide:
    """Which positions were held, from packets in order of time.

    ``held`` are names of positions; a rest in another direction is used too, without a name.
    """

    glove: GloveModel
    held: list[str] = field(default_factory=list)
    found: RestFinder = field(default_factory=RestFinder)
    _last: float = -np.inf

    def add(self, sample: ImuSample) -> None:
        """Takes a packet that is newer than all before; an older one is ignored."""
        if sample.t <= self._last:
            return
        self._last = sample.t
        self.found.add(sample)
        here = self.here
        if here and here not in self.held and self.found.rest_s >= HOLD_S:
            self.held.append(here)

    @property
    def asked(self) -> str:
        """The next position; empty if all were held."""
        return next((name for name in POSITION_NAMES if name not in self.held), "")

    @property
    def here(self) -> str:
        """The position of the present rest; empty while the glove moves or rests elsewhere."""
        if self.found.rest_s == 0.0 or not self.found.rests:
            return ""
        return self._position(self.found.rests[-1].accel)

    @property
    def share(self) -> float:
        """0 to 1 of `HOLD_S` at rest in a position that was not held before."""
        here = self.here
        if not here or here in self.held:
            return 0.0
        return min(self.found.rest_s / HOLD_S, 1.0)

    @property
    def is_enough(self) -> bool:
        """Whether there are enough different rests for a result."""
        return self.found.positions() >= FEWEST

    def _position(self, accel: Array) -> str:
        """Of accel (n, 3), by the IMU on the back of the hand; empty if none is near."""
        imus = self.glove.imus
        row = next((j for j, imu in enumerate(imus) if imu.segment == "dorsum"), 0)
        size = float(np.linalg.norm(accel[row]))
        if not np.isfinite(size) or size < 1e-6:
            return ""
        up = imus[row].R_BI @ accel[row] / size
        near = [float(up @ up_B(name, self.glove.side)) for name in POSITION_NAMES]
        best = int(np.argmax(near))
        return POSITION_NAMES[best] if near[best] > np.cos(TOLERANCE) else ""

    def result(self) -> list[ImuAxesRow]:
        """A row per IMU in the glove's order; takes 0.1 s to 1 s."""
        names = self.glove.imu_names
        return [ImuAxesRow(name, fit_axes(self.found, j)) for j, name in enumerate(names)]
