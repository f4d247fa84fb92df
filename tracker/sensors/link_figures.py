"""Figures and events of a glove's link, for the status, the screen and the log."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

from tracker.base.notices import Notice, warning
from tracker.messages import Event
from tracker.sensors.decoder import LinkCounters
from tracker.sensors.imu_watch import ImuWatch

LOW_BATTERY_MV = 3500  # V, of a lithium cell with about a tenth of its charge
RECOVERED_MV = 100  # V above it, before a warning is repeated


@dataclass(eq=False)
class LinkFigures:
    """Counts since the link was opened; None if not known yet."""

    packets: int = 0
    lost: int = 0
    repeated: int = 0  # packets that had arrived before, which are ignored
    resets: int = 0
    clock_jumps: int = 0
    opened: int = 0
    dropped: int = 0  # packets that the glove itself had no time to send
    battery_mV: int | None = None
    temperature_cC: int | None = None
    skew_ppm: float | None = None  # host's time gained on the glove's clock
    latency_ms: int | None = None  # delay added by the USB adapter
    counters: LinkCounters = field(default_factory=LinkCounters)
    imus: ImuWatch = field(default_factory=lambda: ImuWatch(0))

    @property
    def reopened(self) -> int:
        """Number of times the port was reopened after a disconnection."""
        return max(0, self.opened - 1)

    def values(self) -> dict[str, float]:
        """The known figures, under their names in the status."""
        known: dict[str, float | None] = {
            "battery_v": None if self.battery_mV is None else self.battery_mV / 1000,
            "battery_low": None if self.battery_mV is None else float(is_low(self.battery_mV)),
            "temperature_c": None if self.temperature_cC is None else self.temperature_cC / 100,
            "link_cobs_errors": self.counters.cobs_errors,
            "link_crc_errors": self.counters.crc_errors,
            "link_length_errors": self.counters.length_errors,
            "link_other_errors": self.counters.unknown + self.counters.oversize,
            "link_reopened": self.reopened,
            "link_latency_ms": self.latency_ms,
            "glove_resets": self.resets,
            "glove_repeated": self.repeated,
            "glove_clock_jumps": self.clock_jumps,
            "glove_dropped": self.dropped,
            "glove_skew_ppm": self.skew_ppm,
        }
        found = {key: float(value) for key, value in known.items() if value is not None}
        return found | self.imus.values()


class Announcements:
    """Events of the link until they are drained. ``clock`` gives s. For the thread that polls, but
    any may `add`."""

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._events: deque[Event] = deque()
        self.topics: set[str] = set()
        """Topics that `once` has reported."""

    def report(self, what: Notice | None) -> None:
        """Adds an event with the current time; does nothing for None."""
        if what is not None:
            self._events.append(Event.of(self._clock(), "device", what))

    def once(self, topic: str, what: Notice) -> None:
        """Reports it unless ``topic`` has been reported."""
        if topic not in self.topics:
            self.topics.add(topic)
            self.report(what)

    def add(self, event: Event) -> None:
        """Adds an event with a given time."""
        self._events.append(event)

    def drain(self) -> list[Event]:
        """The events since the last call, oldest first."""
        return [self._events.popleft() for _ in range(len(self._events))]


class LowBattery:
    """Reports once that the battery is low, and again only after it was charged."""

    def __init__(self) -> None:
        self._reported = False

    def look(self, battery_mV: int | None) -> Notice | None:
        """Evaluates the battery's voltage; returns a warning or None."""
        if battery_mV is None:
            return None
        if self._reported and battery_mV > LOW_BATTERY_MV + RECOVERED_MV:
            self._reported = False
        if self._reported or not is_low(battery_mV):
            return None
        self._reported = True
        return warning("glove.battery_low", volts=battery_mV / 1000)


def is_low(battery_mV: int) -> bool:
    """The one threshold of all warnings."""
    return battery_mV < LOW_BATTERY_MV
