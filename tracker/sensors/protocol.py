"""Frames of the glove link, version 1, as they cross the wire.

A frame is ``COBS(type:u8 | payload | crc16:u16) 0x00``, little-endian, CRC-16/CCITT-FALSE over type
and payload. The number of IMUs in a SAMPLES frame follows from its length.
"""

from __future__ import annotations

import binascii
import struct
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

VERSION = 1
MAX_IMUS = 16  # as many as STATUS has bits for
RATES_HZ = (50, 100, 200)
BAUD = 250_000
BAUDS = (BAUD, 115_200)  # the second carries seven IMUs at 100 Hz, not at 200
BITS_PER_BYTE = 10  # 8N1
NO_BATTERY_MV = 0xFFFF

_HELLO = struct.Struct("<BBBBIBHBHB")
_SAMPLES = struct.Struct("<HI")
_STATUS = struct.Struct("<HhHH")
_PULSE = struct.Struct("<HI")
_HAPTIC = struct.Struct("<BBH")
_CHIP = struct.Struct("<BB")
_TEMPERATURE = struct.Struct("<h")
NO_TEMPERATURE = -32768
_IMU_BYTES = 12
_ERROR_BYTES = 60


class ImuChip(NamedTuple):
    """One IMU's chip: its WHO_AM_I, 0 where none responds, and the flags of its self-test."""

    who_am_i: int
    selftest: int


SELFTEST_ACCEL, SELFTEST_GYRO, SELFTEST_ABSENT = 0x01, 0x02, 0x80
"""Flags: the accelerometer failed, the gyroscope failed, the IMU did not respond."""


@dataclass(frozen=True)
class Hello:
    """The glove's description of itself. ``chips`` is empty with firmware before 1.3."""

    glove_id: int
    imu_count: int
    gyro_range_dps: int = 2000
    accel_range_g: int = 16
    rate_hz: int = 100
    haptic_channels: int = 0
    firmware: tuple[int, int, int] = (1, 0, 0)
    protocol: int = VERSION
    chips: tuple[ImuChip, ...] = ()


@dataclass(frozen=True, eq=False)
class Samples:
    """One packet of all IMUs: raw (n, 6) int16, columns ax ay az gx gy gz, LSB = range / 32768."""

    seq: int  # wraps at 2**16
    t_us: int  # wraps at 2**32
    raw: NDArray[np.int16]


@dataclass(frozen=True)
class GloveStatus:
    """The glove's own health; bit j of ``imu_ok`` is set while IMU j answers."""

    battery_mV: int | None
    temperature_cC: int
    imu_ok: int
    dropped: int


@dataclass(frozen=True)
class ErrorText:
    """A text from the firmware."""

    text: str


@dataclass(frozen=True)
class Pulse:
    """A rising edge on the glove's synchrony pin, on the clock of its samples."""

    number: int  # from 1, wraps at 2**16
    t_us: int  # wraps at 2**32


@dataclass(frozen=True)
class Temperatures:
    """For every IMU, once a second; None where an IMU does not respond. Firmware from 1.3."""

    values_cC: tuple[int | None, ...]


@dataclass(frozen=True)
class HelloRequest:
    """Host: who are you?"""


@dataclass(frozen=True)
class Start:
    """Host: send samples."""


@dataclass(frozen=True)
class Stop:
    """Host: send no more samples."""


@dataclass(frozen=True)
class Rate:
    """Host: sample at this rate from now on."""

    rate_hz: int


@dataclass(frozen=True)
class Haptic:
    """Host: run a vibration motor."""

    channel: int
    amplitude: int
    duration_ms: int


Frame = (
    Hello
    | Samples
    | GloveStatus
    | ErrorText
    | Pulse
    | Temperatures
    | HelloRequest
    | Start
    | Stop
    | Rate
    | Haptic
)


class LengthError(ValueError):
    """The payload's length does not match its type."""


class UnknownType(ValueError):
    """The frame type is unknown."""


def crc16(data: bytes) -> int:
    """CRC-16/CCITT-FALSE: poly 0x1021, init 0xFFFF, not reflected, no final xor."""
    return binascii.crc_hqx(data, 0xFFFF)


def encode(frame: Frame) -> bytes:
    """The bytes of a frame with its closing zero."""
    kind, pack, _ = _CODECS[type(frame)]
    body = bytes([kind]) + pack(frame)
    return cobs_encode(body + crc16(body).to_bytes(2, "little")) + b"\0"


def parse(body: bytes) -> Frame:
    """The frame of a checked body ``type | payload``. Raises LengthError or UnknownType."""
    unpack = _PARSERS.get(body[0])
    if unpack is None:
        raise UnknownType(body[0])
    try:
        return unpack(body[1:])
    except struct.error as error:
        raise LengthError(str(error)) from error


def _pack_hello(h: Hello) -> bytes:
    head = _HELLO.pack(
        h.protocol,
        *h.firmware,
        h.glove_id,
        h.imu_count,
        h.gyro_range_dps,
        h.accel_range_g,
        h.rate_hz,
        h.haptic_channels,
    )
    return head + b"".join(_CHIP.pack(*chip) for chip in h.chips)


def _unpack_hello(payload: bytes) -> Hello:
    head, rest = payload[: _HELLO.size], payload[_HELLO.size :]
    protocol, major, minor, patch, glove_id, imus, gyro, accel, rate, haptic = _HELLO.unpack(head)
    if len(rest) not in (0, _CHIP.size * imus):
        raise LengthError(f"{len(payload)} bytes of a greeting with {imus} IMUs")
    chips = tuple(ImuChip(*fields) for fields in _CHIP.iter_unpack(rest))
    firmware = (major, minor, patch)
    return Hello(glove_id, imus, gyro, accel, rate, haptic, firmware, protocol, chips)


def _pack_samples(s: Samples) -> bytes:
    return _SAMPLES.pack(s.seq, s.t_us) + s.raw.astype("<i2").tobytes()


def _unpack_samples(payload: bytes) -> Samples:
    count, rest = divmod(len(payload) - _SAMPLES.size, _IMU_BYTES)
    if rest or not 1 <= count <= MAX_IMUS:
        raise LengthError(f"{len(payload)} bytes of samples")
    seq, t_us = _SAMPLES.unpack_from(payload)
    raw = np.frombuffer(payload, "<i2", offset=_SAMPLES.size).reshape(count, 6)
    return Samples(seq, t_us, raw)


def _pack_status(s: GloveStatus) -> bytes:
    battery = NO_BATTERY_MV if s.battery_mV is None else s.battery_mV
    return _STATUS.pack(battery, s.temperature_cC, s.imu_ok, s.dropped)


def _unpack_status(payload: bytes) -> GloveStatus:
    battery, temperature, imu_ok, dropped = _STATUS.unpack(payload)
    return GloveStatus(None if battery == NO_BATTERY_MV else battery, temperature, imu_ok, dropped)


def _pack_error(e: ErrorText) -> bytes:
    # A character that the limit would split is left out.
    return e.text.encode()[:_ERROR_BYTES].decode(errors="ignore").encode()


def _unpack_error(payload: bytes) -> ErrorText:
    if len(payload) > _ERROR_BYTES:
        raise LengthError(f"{len(payload)} bytes of text")
    return ErrorText(payload.decode(errors="replace"))


def _pack_temperatures(t: Temperatures) -> bytes:
    values = (NO_TEMPERATURE if v is None else v for v in t.values_cC)
    return b"".join(map(_TEMPERATURE.pack, values))


def _unpack_temperatures(payload: bytes) -> Temperatures:
    count = len(payload) / _TEMPERATURE.size
    if not (1 <= count <= MAX_IMUS and count.is_integer()):
        raise LengthError(f"{len(payload)} bytes of temperatures")
    values = (v for (v,) in _TEMPERATURE.iter_unpack(payload))
    return Temperatures(tuple(None if v == NO_TEMPERATURE else v for v in values))


def _unpack_rate(payload: bytes) -> Rate:
    return Rate(*struct.unpack("<H", payload))


def _empty(make: Callable[[], Frame]) -> Callable[[bytes], Frame]:
    def unpack(payload: bytes) -> Frame:
        if payload:
            raise LengthError(f"{len(payload)} bytes where none belong")
        return make()

    return unpack


_CODECS: dict[type, tuple[int, Callable[..., bytes], Callable[[bytes], Frame]]] = {
    Hello: (0x01, _pack_hello, _unpack_hello),
    Samples: (0x02, _pack_samples, _unpack_samples),
    GloveStatus: (0x03, _pack_status, _unpack_status),
    ErrorText: (0x04, _pack_error, _unpack_error),
    Pulse: (
        0x05,
        lambda f: _PULSE.pack(f.number, f.t_us),
        lambda payload: Pulse(*_PULSE.unpack(payload)),
    ),
    Temperatures: (0x06, _pack_temperatures, _unpack_temperatures),
    HelloRequest: (0x81, lambda f: b"", _empty(HelloRequest)),
    Start: (0x82, lambda f: b"", _empty(Start)),
    Stop: (0x83, lambda f: b"", _empty(Stop)),
    Rate: (0x84, lambda f: struct.pack("<H", f.rate_hz), _unpack_rate),
    Haptic: (
        0x85,
        lambda f: _HAPTIC.pack(f.channel, f.amplitude, f.duration_ms),
        lambda payload: Haptic(*_HAPTIC.unpack(payload)),
    ),
}
_PARSERS = {kind: unpack for kind, _, unpack in _CODECS.values()}


# ---- Consistent Overhead Byte Stuffing (Cheshire & Baker 1999, doi:10.1109/90.769765)
#
# It rewrites bytes so that no zero is left, for at most one byte more in 254; a zero then ends a
# frame regardless of the preceding bytes.

MAX_RUN = 254


class CobsError(ValueError):
    """The bytes are not a COBS encoding."""


def cobs_encode(data: bytes) -> bytes:
    """``data`` without zeros (the closing zero is not added)."""
    out = bytearray()
    blocks = data.split(b"\0")
    for n, block in enumerate(blocks):
        last = n == len(blocks) - 1
        while len(block) >= MAX_RUN:
            out += b"\xff" + block[:MAX_RUN]
            block = block[MAX_RUN:]
            if last and not block:
                return bytes(out)  # a full run at the end encodes no zero
        out.append(len(block) + 1)
        out += block
    return bytes(out)


def cobs_decode(data: bytes) -> bytes:
    """Inverts `cobs_encode`. Raises CobsError for an empty text, a zero or a run cut short."""
    if not data or 0 in data:
        raise CobsError("empty, or a zero inside")
    out = bytearray()
    i, n = 0, len(data)
    while i < n:
        code = data[i]
        end = i + code
        if end > n:
            raise CobsError("a run goes past the end")
        out += data[i + 1 : end]
        i = end
        if code <= MAX_RUN and i < n:
            out.append(0)
    return bytes(out)
