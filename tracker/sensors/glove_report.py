"""State of a connected glove, for lists of settings."""

from __future__ import annotations

from typing import NamedTuple

from tracker.sensors.imu_watch import ImuReport
from tracker.sensors.serial_line import UsbPort


class GloveReport(NamedTuple):
    """None or empty where the glove or the system has not reported a value.

    ``requested_rate_hz`` is one of ``rates_hz``; ``rate_hz`` is measured by the glove's
    own clock. ``imu_ok`` is, for each IMU, whether it responds.
    """

    port: str
    adapter: UsbPort | None
    state: str
    baud: int
    rates_hz: tuple[int, ...]
    requested_rate_hz: int
    rate_hz: float | None
    glove_id: int | None
    firmware: tuple[int, int, int] | None
    protocol: int | None
    motors: int
    accel_range_g: float | None
    gyro_range_dps: float | None
    imu_ok: tuple[bool, ...]
    battery_mV: int | None
    temperature_cC: int | None
    latency_ms: int | None
    skew_ppm: float | None
    imus: tuple[ImuReport, ...] = ()
