"""Commands to a glove's motors as events in a session: they shake its IMUs."""

from __future__ import annotations

from typing import NamedTuple

from tracker.base.notices import notice
from tracker.messages import Event

KIND = "motor_run"
MOST_MS = 5000
"""The firmware runs a motor no longer."""


class MotorRun(NamedTuple):
    """A motor starts with ``share`` 0..1 of its full amplitude, for ``duration`` s."""

    channel: int
    share: float
    duration: float


def motor_event(channel: int, amplitude: int, duration_ms: int, t: float) -> Event:
    """A command that was sent at ``t`` (s): amplitude 0..255."""
    values = {"channel": channel, "amplitude": amplitude, "duration_ms": duration_ms}
    what = notice(
        "glove.motor_run", motor=channel + 1, amplitude=amplitude, duration_ms=duration_ms
    )
    return Event.of(t, KIND, what, values)


def motor_of(event: Event) -> MotorRun | None:
    """The command in an event; None for any other event, and for values out of range."""
    if event.kind != KIND:
        return None
    values = [event.data.get(name) for name in ("channel", "amplitude", "duration_ms")]
    if not all(isinstance(v, int) and not isinstance(v, bool) for v in values):
        return None
    channel, amplitude, duration_ms = (int(str(v)) for v in values)
    if channel not in range(256) or amplitude not in range(256) or duration_ms < 0:
        return None
    return MotorRun(channel, amplitude / 255, min(duration_ms, MOST_MS) / 1000)
