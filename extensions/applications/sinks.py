"""The devices that commands of an application can go to, and how the glove's motors take them.

Motor ``i`` of a glove with one a finger is that of thumb, index, middle, ring or little finger.
Fingertip devices of three axes (Lee et al. 2021, Fig. 8B) have three motors a finger, from channel
`THREE` on, which pull the pad along `PULLS`: a push is the sum of three pulls.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from extensions.applications.arm.stream import ArmSink
from extensions.applications.hand import TIPS
from extensions.applications.interface import Command, MotorCommand
from extensions.applications.stage import CommandSink
from extensions.applications.swarm.vehicles import VehicleSink
from tracker.base.clock import monotonic
from tracker.live.listeners import Vibrate
from tracker.messages import Event

KIND = "motor"
THREE = len(TIPS)
LEAN = np.deg2rad(50.0)  # of each pull from the pad's normal
PULLS = np.array(
    [
        [np.sin(LEAN) * np.cos(a), np.sin(LEAN) * np.sin(a), np.cos(LEAN)]
        for a in np.deg2rad([0.0, 120.0, 240.0])
    ]
)
"""(3, 3) rows: the directions in the distal segment's frame B that three motors push the pad in."""
LASTS_MS = 60  # a motor that hears no more stops by itself
AGAIN = 0.03  # s after which it is told the same again
STEP = 8  # of 255: a change that is told at once


@dataclass
class _Motor:
    amplitude: int = 0
    told: float = -np.inf  # when, s of the samples' clock


def pulls(command: MotorCommand) -> np.ndarray:
    """(3,) 0..1 of the three motors whose pulls make the push, as far as they only push."""
    push = command.strength * np.array(command.direction)
    return np.clip(np.linalg.solve(PULLS.T, push), 0.0, 1.0)


class MotorSink:
    """Tells motors what to do, no oftener than needed; what it tells is an event as well.

    ``clock`` (s) stamps these: from the sample (``of``) to it is the way from packet to motor.
    """

    def __init__(
        self,
        vibrate: Vibrate,
        clock: Callable[[], float],
        tell: Callable[[Event], None] = lambda _: None,
    ) -> None:
        self._vibrate, self._clock, self._tell = vibrate, clock, tell
        self._motors: dict[int, _Motor] = {}

    def take(self, commands: Sequence[Command], t: float) -> None:
        wanted: dict[int, int] = {}
        for command in commands:
            if isinstance(command, MotorCommand) and command.tip in TIPS:
                wanted |= _amplitudes(command)
        for channel in [c for c, m in self._motors.items() if m.amplitude and c not in wanted]:
            wanted[channel] = 0
        for channel, amplitude in wanted.items():
            self._drive(channel, amplitude, t)

    def _drive(self, channel: int, amplitude: int, t: float) -> None:
        motor = self._motors.setdefault(channel, _Motor())
        changes = abs(amplitude - motor.amplitude) >= STEP or bool(amplitude) != bool(
            motor.amplitude
        )
        if not changes and not (amplitude and t - motor.told >= AGAIN):
            return
        if not self._vibrate(channel, amplitude, LASTS_MS if amplitude else 1):
            return  # the next sample tells it again
        motor.amplitude, motor.told = amplitude, t
        data: dict[str, object] = {"channel": channel, "amplitude": amplitude, "of": t}
        if changes:
            self._tell(Event(self._clock(), KIND, "", data))

    def close(self) -> None:
        """All motors rest."""
        for channel, motor in self._motors.items():
            if motor.amplitude:
                self._vibrate(channel, 0, 1)
        self._motors.clear()


def _amplitudes(command: MotorCommand) -> dict[int, int]:
    """By channel."""
    finger = TIPS.index(command.tip)
    if command.axes == 1:
        return {finger: round(255 * min(max(command.strength, 0.0), 1.0))}
    return {THREE + 3 * finger + k: round(255 * u) for k, u in enumerate(pulls(command).tolist())}


def network_sinks() -> list[CommandSink]:
    """Vehicles and robots, at the addresses that commands name; none is opened before."""
    return [VehicleSink(), ArmSink()]


def all_sinks(vibrate: Vibrate | None, tell: Callable[[Event], None]) -> list[CommandSink]:
    """All of a hand: those on the network and, if the glove has motors, these; ``tell`` receives an
    event for each motor command."""
    motors: list[CommandSink] = [MotorSink(vibrate, monotonic, tell)] if vibrate is not None else []
    return [*motors, *network_sinks()]
