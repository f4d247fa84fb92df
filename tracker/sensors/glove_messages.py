"""Messages from the glove's frames, in SI units and on the host's clock.

The ranges of an older glove are unknown. At rest |a| is 1 g, so the raw value is 32768 / range:
neighbouring ranges of accelerometers differ by a factor of two, which no bias hides. The
gyroscopes' range cannot be derived from rest.
"""

from __future__ import annotations

import math
from collections import Counter, deque
from typing import NamedTuple

import numpy as np

from tracker import GRAVITY
from tracker.base.clock import nanoseconds, seconds
from tracker.base.notices import notice, warning
from tracker.messages import Array, Event, ImuSample
from tracker.sensors.link_figures import Announcements
from tracker.sensors.packet_clock import PacketClock, PacketTime
from tracker.sensors.protocol import Pulse, Samples

DEGREE = np.pi / 180
USUAL_GYRO_DPS = 2000  # range of a glove that does not report it
RANGES_G = (2, 4, 8, 16)  # of the MPU-9250
SPAN = 0.5  # s of rest
STEADY = 0.05  # sd of |a| over its mean, at rest: a hand that is held still, not one laid down
WITHIN = math.log2(1.15)  # octaves; half an octave would be as near to the next range
AGREEING = 0.75  # share of the IMUs that must agree
FEWEST = 10  # packets


class Ranges(NamedTuple):
    """Values that correspond to a raw value of 32768."""

    accel_g: float
    gyro_dps: float


class RangeFromRest:
    """Evaluates raw samples until the glove has been still for `SPAN`."""

    def __init__(self) -> None:
        self._recent: deque[tuple[float, Array]] = deque()

    def look(self, raw: Array, t: float) -> int | None:
        """Adds raw accelerations (n, 3) at time ``t`` (s). Returns the range in g, None until
        known."""
        self._recent.append((t, np.linalg.norm(raw, axis=1)))
        while t - self._recent[0][0] > SPAN:
            self._recent.popleft()
        if len(self._recent) < FEWEST or t - self._recent[0][0] < 0.9 * SPAN:
            return None
        norms = np.array([row for _, row in self._recent])
        return _common_range(norms.mean(axis=0), norms.std(axis=0))


def _common_range(mean: Array, sd: Array) -> int | None:
    """The range in which most IMUs measure 1 g; IMUs that report zeros are ignored."""
    answering = mean > 0
    if not answering.any() or np.any(sd[answering] > STEADY * mean[answering]):
        return None
    votes = Counter(_fitting(float(m)) for m in mean[answering])
    best, count = votes.most_common(1)[0]
    return best if count >= AGREEING * np.count_nonzero(answering) else None


def _fitting(counts: float) -> int | None:
    """The range in which ``counts`` is 1 g; None if none matches."""
    for range_g in RANGES_G:
        if abs(math.log2(counts * range_g / 32768)) < WITHIN:
            return range_g
    return None


def range_at_rest(
    frame: Samples, t: float, at_rest: RangeFromRest, events: Announcements
) -> Ranges | None:
    """Returns the ranges of a glove that does not report them; None until gravity reveals them.

    ``t``: s by the glove's clock.
    """
    events.once("ranges", warning("glove.ranges_unknown"))
    accel_g = at_rest.look(frame.raw[:, :3].astype(float), t)
    if accel_g is None:
        return None
    found = warning("glove.range_from_rest", accel_g=accel_g, gyro_dps=USUAL_GYRO_DPS)
    events.once("range", found)
    return Ranges(accel_g, USUAL_GYRO_DPS)


def pulse_event(pulse: Pulse, clock: PacketClock, now: float) -> Event:
    """Returns a pulse at the instant by the glove's clock; before its first packet at its arrival,
    ``now`` (s), without ``t_device``."""
    known = clock.instant(pulse.t_us)
    t_device, t = (None, now) if known is None else known
    data: dict[str, object] = {"number": pulse.number, "t_device": t_device}
    what = notice("glove.pulse", number=pulse.number)
    return Event.of(seconds(nanoseconds(t)), "pulse", what, data)


def si_sample(
    frame: Samples, time_of: PacketTime, now: float, ranges: Ranges | None, imu_ok: int
) -> ImuSample:
    """Returns a packet in SI units, arrived at ``now`` (s); bit j of ``imu_ok``: IMU j
    can be trusted, since it responds and is not saturated.

    Nothing is valid while the ``ranges`` are unknown.
    """
    known = ranges or Ranges(np.nan, np.nan)
    raw = frame.raw.astype(float) / 32768.0
    valid = np.array([ranges is not None and bool(imu_ok >> j & 1) for j in range(len(raw))])
    accel = raw[:, :3] * (known.accel_g * GRAVITY)
    gyro = raw[:, 3:] * (known.gyro_dps * DEGREE)
    accel[~valid], gyro[~valid] = np.nan, np.nan
    return ImuSample(
        t=seconds(nanoseconds(time_of.t)),
        t_arrival=seconds(nanoseconds(now)),
        t_device=time_of.t_device,
        seq=time_of.seq,
        accel=accel,
        gyro=gyro,
        valid=valid,
    )
