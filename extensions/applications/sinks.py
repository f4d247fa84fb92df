"""All the devices that commands of an application can go to."""

from __future__ import annotations

from collections.abc import Callable

from extensions.applications.arm.stream import ArmSink
from extensions.applications.motors import MotorSink
from extensions.applications.stage import CommandSink
from extensions.applications.swarm.vehicles import VehicleSink
from tracker.base.clock import monotonic
from tracker.live.listeners import Vibrate
from tracker.messages import Event


def network_sinks() -> list[CommandSink]:
    """Vehicles and robots, at the addresses that commands name; none is opened before."""
    return [VehicleSink(), ArmSink()]


def all_sinks(vibrate: Vibrate | None, tell: Callable[[Event], None]) -> list[CommandSink]:
    """And the glove's motors, where it has some; ``tell`` gets an event of what they are told."""
    motors: list[CommandSink] = [MotorSink(vibrate, monotonic, tell)] if vibrate is not None else []
    return [*motors, *network_sinks()]
