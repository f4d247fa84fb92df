"""Devices that receive an application's commands, including the glove's motors.

A glove with one motor per finger has them in the order thumb, index, middle, ring, little finger.
Fingertip devices with three axes (Lee et al. 2021, Fig. 8B) have three motors per finger, from
channel `THREE` on, which pull the pad along `PULLS`; a force is the sum of three pulls.
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
LEAN = np.deg2rad(50.0)  # angle of each pull from the pad's normal
PULLS = np.array(
    [
        [np.sin(LEAN) * np.cos(a), np.sin(LEAN) * np.sin(a), np.cos(LEAN)]
        for a in np.deg2rad([0.0, 120.0, 240.0])
    ]
)
"""(3, 3) rows: directions in the distal segment's frame B in which three motors push the pad."""
LASTS_MS = 60  # a motor stops if no further command arrives
AGAIN = 0.03  # s after which an unchanged command is repeated
STEP = 8  # of 255: larger changes are sent immediately


@dataclass
class _Motor:
    amplitude: int = 0
    sent: float = -np.inf  # time of the last command, s of the samples' clock


def pulls(command: MotorCommand) -> np.ndarray:
    """Amplitudes (3,) 0..1 of three motors whose pulls add up to the force; negative ones are 0."""
    push = command.strength * np.array(command.direction)
    return np.clip(np.linalg.solve(PULLS.T, push), 0.0, 1.0)


class MotorSink:
    """Sends commands to motors, no more often than needed, and reports each as an event.

    Events are stamped with ``clock`` (s); the difference to the sample (``of``) is the latency from
    packet to motor.
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
        if not changes and not (amplitude and t - motor.sent >= AGAIN):
            return
        if not self._vibrate(channel, amplitude, LASTS_MS if amplitude else 1):
            return  # a later sample repeats it
        motor.amplitude, motor.sent = amplitude, t
        data: dict[str, object] = {"channel": channel, "amplitude": amplitude, "of": t}
        if changes:
            self._tell(Event(self._clock(), KIND, "", data))

    def close(self) -> None:
        """Stop all motors."""
        for channel, motor in self._motors.items():
            if motor.amplitude:
                self._vibrate(channel, 0, 1)
        self._motors.clear()


def _amplitudes(command: MotorCommand) -> dict[int, int]:
    """Amplitudes by channel."""
    finger = TIPS.index(command.tip)
    if command.axes == 1:
        return {finger: round(255 * min(max(command.strength, 0.0), 1.0))}
    return {THREE + 3 * finger + k: round(255 * u) for k, u in enumerate(pulls(command).tolist())}


def network_sinks() -> list[CommandSink]:
    """Sinks of vehicles and robots; connections are opened with the first command to an address."""
    return [VehicleSink(), ArmSink()]


def all_sinks(vibrate: Vibrate | None, tell: Callable[[Event], None]) -> list[CommandSink]:
    """All sinks of a hand: the network and, if present, the glove's motors; ``tell`` receives an
    event for each motor command."""
    motors: list[CommandSink] = [MotorSink(vibrate, monotonic, tell)] if vibrate is not None else []
    return [*motors, *network_sinks()]
