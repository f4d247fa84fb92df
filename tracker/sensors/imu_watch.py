"""State of each IMU of a glove: chip, self-test, temperature, saturation, stuck axes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array, IntArray
from tracker.sensors.protocol import (
    SELFTEST_ABSENT,
    SELFTEST_ACCEL,
    SELFTEST_GYRO,
    ImuChip,
)

CHIPS = {0x70: "MPU-6500", 0x71: "MPU-9250", 0x73: "MPU-9255"}
AXES = ("ax", "ay", "az", "gx", "gy", "gz")
FULL_SCALE = 32767
STUCK_PACKETS = 200
"""Number of identical readings, while other axes of the chip change, after which an axis is stuck:
the noise of an MPU-9250 is 2 LSB of its gyroscope and 6 of its accelerometer."""


class ImuReport(NamedTuple):
    """One IMU. Empty or None where the glove's firmware does not report a value."""

    chip: str = ""
    is_known_chip: bool = True
    selftest: str = ""
    """``passed``, ``not run`` or what failed."""
    temperature_cC: int | None = None
    saturated: int = 0
    """Saturated samples since the link was opened."""
    stuck: tuple[str, ...] = ()
    """Names of axes that no longer change."""


def saturated(raw: NDArray[np.int16]) -> NDArray[np.bool_]:
    """Which IMUs (n,) have an axis at the end of its range in ``raw`` (n, 6). -32768 on all axes is
    an IMU that does not respond, and is not saturated."""
    at_end = np.abs(raw.astype(np.int32)) >= FULL_SCALE
    return np.asarray(at_end.any(axis=1) & ~(raw == -32768).all(axis=1))


class ImuWatch:
    """Follows the packets of a glove with ``n`` IMUs."""

    def __init__(self, n: int) -> None:
        self.saturated: IntArray = np.zeros(n, np.int64)
        self.temperatures_cC: tuple[int | None, ...] = (None,) * n
        self._fresh = False
        self._last = np.zeros((n, 6), np.int16)
        self._same: IntArray = np.zeros((n, 6), np.int64)

    def add(self, raw: NDArray[np.int16]) -> NDArray[np.bool_]:
        """Adds a packet (n, 6); returns which IMUs (n,) are saturated in it."""
        found = saturated(raw)
        self.saturated += found
        self._same = np.where(raw == self._last, self._same + 1, 0)
        self._last = raw
        return found

    def set_temperatures(self, values_cC: tuple[int | None, ...]) -> None:
        """Stores the temperatures that the glove reports, 0.01 °C."""
        self.temperatures_cC, self._fresh = values_cC, True

    def take_temperatures(self) -> Array | None:
        """(n,) °C if reported since the last call; NaN for an IMU without a temperature."""
        n = len(self.saturated)
        if not self._fresh or len(self.temperatures_cC) != n:
            return None
        self._fresh = False
        return np.array([np.nan if v is None else v / 100 for v in self.temperatures_cC])

    def stuck(self, imu: int) -> tuple[str, ...]:
        """Axes of an IMU that are stuck while at least as many of them change: those of one
        sensor."""
        still = self._same[imu] >= STUCK_PACKETS
        if still.sum() > 3:  # the IMU does not respond, or the glove is simulated without noise
            return ()
        return tuple(axis for axis, is_stuck in zip(AXES, still, strict=True) if is_stuck)

    def newly_stuck(self) -> list[tuple[int, tuple[str, ...]]]:
        """IMUs with axes that have just become stuck, and these axes."""
        rows = np.flatnonzero((self._same == STUCK_PACKETS).any(axis=1))
        return [(int(j), axes) for j in rows if (axes := self.stuck(int(j)))]

    def reports(self, chips: tuple[ImuChip, ...]) -> tuple[ImuReport, ...]:
        """State of all IMUs; ``chips`` from the glove's HELLO, empty if it lists none."""
        return tuple(
            self._report(j, chips[j] if j < len(chips) else None)
            for j in range(len(self.saturated))
        )

    def _report(self, j: int, chip: ImuChip | None) -> ImuReport:
        temperatures = self.temperatures_cC
        return ImuReport(
            chip_name(chip.who_am_i) if chip else "",
            chip is None or chip.who_am_i in CHIPS,
            selftest_text(chip.selftest) if chip else "",
            temperatures[j] if j < len(temperatures) else None,
            int(self.saturated[j]),
            self.stuck(j),
        )

    def values(self) -> dict[str, float]:
        """Figures for the status and the recording."""
        out = {
            f"imu_{j}_temperature_c": value / 100
            for j, value in enumerate(self.temperatures_cC)
            if value is not None
        }
        counts = enumerate(self.saturated.tolist())
        return out | {f"imu_{j}_saturated": float(count) for j, count in counts if count}


def chip_name(who_am_i: int) -> str:
    """Name and number of a chip; empty where none responds."""
    if who_am_i == 0:
        return ""
    return f"{CHIPS.get(who_am_i, 'unknown chip')} (0x{who_am_i:02X})"


def selftest_text(flags: int) -> str:
    """The flags of a self-test in words."""
    if flags & SELFTEST_ABSENT:
        return "not run"
    failed = [
        name
        for flag, name in ((SELFTEST_ACCEL, "accelerometer"), (SELFTEST_GYRO, "gyroscope"))
        if flags & flag
    ]
    return f"{' and '.join(failed)} failed" if failed else "passed"
