"""Vibration that SteamVR's applications ask for, by VMT's OSC: a protocol of remote control."""

from __future__ import annotations

import math
from collections.abc import Sequence
from concurrent.futures import Future
from dataclasses import dataclass, replace

from extensions.osc import decode
from extensions.osc.decode import OscError
from tracker.base.notices import notice
from tracker.hand.names import CHAINS
from tracker.streaming.connection import LOOPBACK, StreamError, option
from tracker.streaming.remote.doors import DatagramDoor, Door
from tracker.streaming.remote.reception import Answer
from tracker.streaming.remote.registry import DoorKind
from tracker.streaming.remote.request import (
    MOST_AMPLITUDE,
    MOST_MS,
    Reply,
    Request,
    RequestError,
)

RIGHT, LEFT = 57, 56
"""The last two devices of VMT: the first ones are used by full-body trackers."""
HAPTIC = "/VMT/Out/Haptic"
SHORTEST = 0.02  # s: a pulse of zero length is the shortest that is felt
ALL = "all"


@dataclass(frozen=True)
class HapticOptions:
    host: str = option(LOOPBACK, "listening address")
    port: int = option(39571, "port to which VMT's driver sends")
    right: int = option(RIGHT, "number of the right hand's device, 0 to 57")
    left: int = option(LEFT, "number of the left hand's device, 0 to 57")
    fingers: str = option("all", "motors that vibrate: a list such as thumb,index, or all")


class HapticDoor:
    """Listens where VMT's driver sends its messages. Other messages than vibration are ignored."""

    def __init__(
        self, answer: Answer, sides: dict[int, str], fingers: str, host: str, port: int
    ) -> None:
        """``sides``: of each device; ``fingers``: a list with commas, or `ALL`."""
        motors = _motors(fingers)

        def parse(data: bytes, t: float) -> Request | None:
            return haptic(data, t, sides)

        def each(request: Request) -> Future[Reply]:
            futures = [answer(replace(request, finger=f)) for f in motors]
            return futures[0]

        self._door: Door = DatagramDoor("VMT", (parse, lambda _: b""), each, host, port)
        self.port, self.counts, self.close = self._door.port, self._door.counts, self._door.close


def _motors(fingers: str) -> Sequence[str]:
    """Raises StreamError for a finger that there is none of."""
    names = tuple(CHAINS) if fingers == ALL else tuple(f.strip() for f in fingers.split(","))
    for name in names:
        if name not in CHAINS:
            known = ", ".join(CHAINS)
            raise StreamError(notice("vr.unknown_finger", name=name, known=known, all=ALL))
    return names


def haptic(data: bytes, t: float, sides: dict[int, str]) -> Request | None:
    """A request of ``/VMT/Out/Haptic index frequency amplitude duration``; None for other messages
    and devices. Raises RequestError for a message that cannot be read.

    Amplitude is 0 to 1, duration in s. The frequency is ignored: the motors have one.
    """
    try:
        address, values = decode.message(data)
    except OscError as error:
        raise RequestError(notice("osc.expected", why=error)) from error
    if address != HAPTIC:
        return None
    numbers = [v for v in values if isinstance(v, int | float)]
    if len(numbers) != 4 or not all(map(math.isfinite, numbers)):
        raise RequestError(notice("vr.haptic_values", address=HAPTIC))
    index, _, amplitude, duration = numbers
    if int(index) not in sides or amplitude <= 0:
        return None
    strength = round(min(amplitude, 1.0) * MOST_AMPLITUDE)
    ms = round(1000 * min(max(duration, SHORTEST), MOST_MS / 1000))
    return Request("vibrate", t, amplitude=strength, duration_ms=ms, side=sides[int(index)])


def _haptics(options: HapticOptions, answer: Answer) -> Door:
    sides = {options.right: "right", options.left: "left"}
    return HapticDoor(answer, sides, options.fingers, options.host, options.port)


HAPTICS = DoorKind(
    name="vmt",
    title="SteamVR vibration (VMT)",
    options=HapticOptions,
    make=_haptics,
    order=22,
)
