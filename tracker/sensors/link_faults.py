"""Causes of electrical faults, recognised by their pattern on the glove's line."""

from __future__ import annotations

from collections import deque

from tracker.base.notices import Notice, notice, warning
from tracker.sensors.decoder import LinkCounters
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.link_figures import Announcements
from tracker.sensors.protocol import ImuChip
from tracker.sensors.serial_line import reason

OTHER_RATE = 0.05  # share by which the rate may differ from the request
MOTOR_WITHIN = 0.5
"""s from the start of a motor to a restart that it caused; a board needs up to 0.4 s to greet."""
LOW_MV = 3300
"""Battery voltage below which a restart is a brown-out: the regulator needs 3.3 V."""
RESTARTS, RESTARTS_WITHIN = 3, 60.0
"""(number, s): this many restarts within this time mean a weak supply, whatever the battery
reports."""
DAMAGED, DAMAGED_WITHIN = 5, 1.0
"""(number, s): this many damaged frames within this time are a burst; single ones occur on any
line."""
LOOSE, LOOSE_WITHIN = 3, 60.0
"""(number, s): this many losses of one IMU within this time mean a loose wire, not a broken
chip."""
AGAIN = 60.0
"""s until the same cause is reported again."""


class LinkFaults:
    """Receives the events of a line; times in s of one clock. Each method returns a notice, or
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
    if number in (11, 16, 35) or "busy" in text.lower():  # 11, 35: the port is locked
        return warning("glove.port_busy")
    if number == 13 or "ermission" in text:
        return warning("glove.port_denied", why=reason(error))
    return warning("glove.port_not_opened", why=reason(error))


def why_no_hello(now: LinkCounters, before: LinkCounters, baud: int) -> Notice:
    """Why a glove did not answer: bytes without a single frame mean another baud rate."""
    if now.frames == before.frames and now.errors > before.errors:
        return warning("glove.wrong_baud", baud=baud)
    return warning("glove.no_hello")


def other_glove(place: GlovePort, glove_id: int | None) -> Notice:
    """Reports that the device at ``place`` is not the expected glove."""
    if glove_id is None:
        return warning("glove.stranger_unknown", port=place.path, glove_id=place.glove_id)
    return warning("glove.stranger", port=place.path, found=glove_id, glove_id=place.glove_id)


def unknown_chip(imu: int, chip: ImuChip) -> Notice:
    """Reports a chip whose number is not in the list of known ones."""
    values = {"imu": imu, "chip": f"0x{chip.who_am_i:02X}"}
    if chip.selftest:
        return warning("glove.chip_refused", **values)
    return notice("glove.chip_unknown", **values)


def judge_rate(rate_hz: float | None, asked_hz: int, events: Announcements) -> None:
    """Reports, once, that packets arrive at another rate than requested."""
    if rate_hz is not None and abs(rate_hz / asked_hz - 1) > OTHER_RATE:
        events.once("rate", warning("glove.other_rate", rate_hz=rate_hz, asked_hz=asked_hz))
