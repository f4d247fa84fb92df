"""Causes of electrical faults, recognised by their pattern on the glove's line."""

from __future__ import annotations

from collections import deque

from tracker.base.notices import Notice, warning
from tracker.sensors.serial_line import reason

MOTOR_WITHIN = 0.5
"""s from the start of a motor to a restart that it caused; a board needs up to 0.4 s to greet."""
LOW_MV = 3300
"""Battery voltage below which a restart is a brown-out: the regulator needs 3.3 V."""
RESTARTS, RESTARTS_WITHIN = 3, 60.0
"""As many restarts within that many s are a weak supply, whatever the battery reports."""
DAMAGED, DAMAGED_WITHIN = 5, 1.0
"""As many damaged frames within that many s are a burst; single ones occur on any line."""
LOOSE, LOOSE_WITHIN = 3, 60.0
"""As many losses of one IMU within that many s are a loose wire rather than a broken chip."""
AGAIN = 60.0
"""s until the same cause is reported again."""


class LinkFaults:
    """Takes what happens on a line; times are s of one clock. Each method returns a notice, or
    None if there is nothing new to report."""

    def __init__(self, imu_count: int) -> None:
        self._motor = float("-inf")
        self._restarts: deque[float] = deque(maxlen=RESTARTS)
        self._damaged: deque[float] = deque(maxlen=DAMAGED)
        self._errors = 0
        self._lost: list[deque[float]] = [deque(maxlen=LOOSE) for _ in range(imu_count)]
        self._reported: dict[str, float] = {}

    def motor_started(self, now: float) -> None:
        """A motor was started. From any thread."""
        self._motor = now

    def restarted(self, now: float, battery_mV: int | None) -> Notice | None:
        """The glove has restarted; ``battery_mV`` is the last voltage that it reported."""
        self._restarts.append(now)
        if now - self._motor <= MOTOR_WITHIN:
            return self._once(now, warning("glove.reset_by_motor"))
        often = len(self._restarts) == RESTARTS and now - self._restarts[0] <= RESTARTS_WITHIN
        if often or (battery_mV is not None and battery_mV < LOW_MV):
            return self._once(now, warning("glove.brown_out"))
        return None

    def errors(self, now: float, count: int, frames: int) -> Notice | None:
        """``count`` of damaged frames and ``frames`` of good ones since the link was made."""
        if not frames:  # of another speed, or another device
            return None
        for _ in range(min(count - self._errors, DAMAGED)):
            self._damaged.append(now)
        self._errors = count
        if len(self._damaged) < DAMAGED or now - self._damaged[0] > DAMAGED_WITHIN:
            return None
        return self._once(now, warning("glove.cable_damaged"))

    def imu_lost(self, imu: int, now: float) -> Notice | None:
        """An IMU no longer answers."""
        times = self._lost[imu]
        times.append(now)
        if len(times) < LOOSE or now - times[0] > LOOSE_WITHIN:
            return None
        return self._once(now, warning("glove.imu_loose", imu=imu), f"glove.imu_loose {imu}")

    def _once(self, now: float, what: Notice, topic: str = "") -> Notice | None:
        topic = topic or what.code
        if now - self._reported.get(topic, float("-inf")) < AGAIN:
            return None
        self._reported[topic] = now
        return what


def not_opened(error: Exception) -> Notice:
    """Why a port cannot be opened, as precisely as the system reports it."""
    number, text = getattr(error, "errno", None), str(error)
    if number in (11, 16, 35) or "busy" in text.lower():  # 11, 35: its lock is taken
        return warning("glove.port_busy")
    if number == 13 or "ermission" in text:
        return warning("glove.port_denied", why=reason(error))
    return warning("glove.port_not_opened", why=reason(error))
