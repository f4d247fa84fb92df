"""Electrical faults of a simulated glove, applied to the bytes that it sends."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.sensors.protocol import Frame, GloveStatus, Samples

ELECTRIC_FAULTS = (
    "brown-out", "flexed cable", "loose select", "motor reset", "usb suspend", "wrong baud",
    "port busy", "port denied",
)  # fmt: skip
REFUSALS = {"port busy": BlockingIOError(11, "busy"), "port denied": PermissionError(13, "denied")}
"""Errors of opening the port."""
RESET_EVERY = 1.5
"""s between two restarts of a board whose supply is too weak."""
BURST = 0.2
"""s of a flexed cable's bad contact, and of the good contact after it."""
BURST_SHARE = 0.6
"""Of the frames in a burst that are damaged."""
LOOSE_IMU, LOOSE_FOR = 2, 1.0
"""The IMU with a loose select line, and s for which it is lost and for which it answers."""
NO_READING = -32768


class ElectricFault:
    """One of `ELECTRIC_FAULTS`, or none, from ``now`` (s) on."""

    def __init__(self, kind: str, now: float, rng: np.random.Generator) -> None:
        if kind and kind not in ELECTRIC_FAULTS:
            raise ValueError(f"{kind} is not one of {', '.join(ELECTRIC_FAULTS)}")
        self.kind, self._since, self._rng = kind, now, rng
        self._next_reset = now

    def is_reset_due(self, now: float) -> bool:
        """Whether the board restarts now."""
        if self.kind != "brown-out" or now < self._next_reset:
            return False
        self._next_reset = now + RESET_EVERY
        return True

    def frame(self, frame: Frame, now: float) -> Frame:
        """What the board sends in place of ``frame``."""
        if self.kind != "loose select" or int((now - self._since) / LOOSE_FOR) % 2:
            return frame
        if isinstance(frame, Samples):
            raw = frame.raw.copy()
            raw[min(LOOSE_IMU, len(raw) - 1)] = NO_READING
            return Samples(frame.seq, frame.t_us, raw)
        if isinstance(frame, GloveStatus):
            return replace(frame, imu_ok=frame.imu_ok & ~(1 << LOOSE_IMU))
        return frame

    def wire(self, data: bytes, now: float) -> bytes:
        """The bytes of a frame that arrive at the host."""
        if self.kind == "usb suspend":
            return b""
        if self.kind == "wrong baud":
            return bytes(b ^ 0x5A or 0xA5 for b in data[:-1]) + data[-1:]
        if self.kind != "flexed cable" or int((now - self._since) / BURST) % 2:
            return data
        if not data or self._rng.random() > BURST_SHARE:
            return data
        damaged = bytearray(data)
        damaged[int(self._rng.integers(len(data)))] ^= 1 << int(self._rng.integers(8))
        return bytes(damaged)
