"""Finds frames in a byte stream that may start in the middle of one and may lose or alter bytes."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.sensors.protocol import (
    CobsError,
    Frame,
    LengthError,
    UnknownType,
    cobs_decode,
    crc16,
    parse,
)

MAX_FRAME_BYTES = 256  # the longest frame, 16 IMUs of SAMPLES, has 203 stuffed bytes
MIN_BODY_BYTES = 3  # type and CRC


@dataclass
class LinkCounters:
    """Counts of decoded and rejected frames; each rejected frame is counted under one error."""

    frames: int = 0
    bytes: int = 0
    cobs_errors: int = 0
    crc_errors: int = 0
    length_errors: int = 0
    unknown: int = 0
    oversize: int = 0

    @property
    def errors(self) -> int:
        """Frames that were dropped, for any reason."""
        return (
            self.cobs_errors + self.crc_errors + self.length_errors + self.unknown + self.oversize
        )


class FrameDecoder:
    """Accepts bytes from a port in pieces of any size; stores at most one unfinished frame.

    The bytes before the first zero are the tail of a frame that began before the port was opened:
    they are checked like any other frame, and counted as an error if they are not one.
    """

    def __init__(self) -> None:
        self.counters = LinkCounters()
        self._rest = b""
        self._skipping = False

    def feed(self, data: bytes) -> list[Frame]:
        """The frames that ``data`` completes, in order."""
        self.counters.bytes += len(data)
        *chunks, self._rest = (self._rest + data).split(b"\0")
        frames = []
        for chunk in chunks:
            if self._skipping:
                self._skipping = False
                continue
            frame = self._frame(chunk) if chunk else None
            if frame is not None:
                frames.append(frame)
        self._bound()
        return frames

    def _bound(self) -> None:
        if len(self._rest) > MAX_FRAME_BYTES or self._skipping:
            if not self._skipping:
                self.counters.oversize += 1
            self._skipping = True
            self._rest = b""

    def _frame(self, chunk: bytes) -> Frame | None:
        if len(chunk) > MAX_FRAME_BYTES:
            self.counters.oversize += 1
            return None
        try:
            body = cobs_decode(chunk)
        except CobsError:
            self.counters.cobs_errors += 1
            return None
        if len(body) < MIN_BODY_BYTES:
            self.counters.length_errors += 1
            return None
        if crc16(body[:-2]) != int.from_bytes(body[-2:], "little"):
            self.counters.crc_errors += 1
            return None
        return self._parse(body[:-2])

    def _parse(self, body: bytes) -> Frame | None:
        try:
            frame = parse(body)
        except LengthError:
            self.counters.length_errors += 1
            return None
        except UnknownType:
            self.counters.unknown += 1
            return None
        self.counters.frames += 1
        return frame


class Unwrapper:
    """Unwraps a counter that wraps at 2**bits; small steps back remain small."""

    def __init__(self, bits: int) -> None:
        self._size = 1 << bits
        self._last: int | None = None

    def __call__(self, value: int) -> int:
        """The unwrapped count nearest to the last one."""
        if self._last is None:
            self._last = value
        else:
            half = self._size // 2
            self._last += (value - self._last + half) % self._size - half
        return self._last

    def reset(self) -> None:
        """Resets: the next value is returned unchanged."""
        self._last = None
