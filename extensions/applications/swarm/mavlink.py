"""Encodes and decodes three messages of MAVLink 2 (mavlink.io, common.xml) in bulk.

SET_POSITION_TARGET_LOCAL_NED sets a vehicle's target; HEARTBEAT and LOCAL_POSITION_NED are its
replies. Local frames are north, east, down, which are x, -y, -z of G (z up).
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array

MAGIC = 0xFD
HEAD, TAIL = 10, 2  # bytes around a payload
HEARTBEAT, POSITION, TARGET = 0, 32, 84  # message ids
EXTRA = {HEARTBEAT: 50, POSITION: 185, TARGET: 143}
"""CRC_EXTRA of each message, which distinguishes different definitions."""
LENGTH = {HEARTBEAT: 9, POSITION: 28, TARGET: 53}
LOCAL_NED = 1  # MAV_FRAME
POSITION_AND_VELOCITY = 0b110111000000  # POSITION_TARGET_TYPEMASK: ignore the rest
QUADROTOR, NO_AUTOPILOT, ACTIVE, VERSION = 2, 8, 4, 3
STATION, ANY = 255, 1  # our system and component; the vehicle's component
Bytes = NDArray[np.uint8]

TARGET_ROW = np.dtype(
    [("ms", "<u4"), ("p", "<f4", 3), ("v", "<f4", 3), ("a", "<f4", 3), ("yaw", "<f4"),
     ("yaw_rate", "<f4"), ("mask", "<u2"), ("system", "u1"), ("component", "u1"), ("frame", "u1")]
)  # fmt: skip
POSITION_ROW = np.dtype([("ms", "<u4"), ("p", "<f4", 3), ("v", "<f4", 3)])


class ReceivedMessage(NamedTuple):
    """A complete message: its id, its sender, and its payload including omitted zeros."""

    message: int
    system: int
    payload: bytes


def to_ned(p_G: Array) -> Array:
    """Vectors (..., 3) of G in north, east, down; its own inverse."""
    return np.asarray(p_G * np.array([1.0, -1.0, -1.0]))


def _crc_table() -> NDArray[np.uint16]:
    out = np.zeros(256, np.uint16)
    for i in range(256):
        crc = i
        for _ in range(8):
            crc = crc >> 1 ^ (0x8408 if crc & 1 else 0)
        out[i] = crc
    return out


_TABLE = _crc_table()


def crc(rows: Bytes) -> NDArray[np.uint16]:
    """(n,) CRC-16/MCRF4XX of n rows of bytes at once."""
    out = np.full(len(rows), 0xFFFF, np.uint16)
    for column in rows.T:
        out = (out >> 8) ^ _TABLE[(out ^ column) & 0xFF]
    return out


def targets(p: Array, v: Array, systems: NDArray[np.uint8], t: float, sequence: int) -> list[bytes]:
    """Packets with the targets of n vehicles: p (n, 3) m and v (n, 3) m/s in G."""
    rows = np.zeros(len(p), TARGET_ROW)
    rows["ms"] = int(1e3 * t) % 2**32
    rows["p"], rows["v"] = to_ned(p), to_ned(v)
    rows["mask"], rows["system"], rows["component"] = POSITION_AND_VELOCITY, systems, ANY
    rows["frame"] = LOCAL_NED
    return packets(TARGET, _bytes(rows), np.full(len(p), STATION, np.uint8), sequence)


def positions(
    p: Array, v: Array, systems: NDArray[np.uint8], t: float, sequence: int
) -> list[bytes]:
    """Packets with the positions and velocities of n vehicles in G."""
    rows = np.zeros(len(p), POSITION_ROW)
    rows["ms"] = int(1e3 * t) % 2**32
    rows["p"], rows["v"] = to_ned(p), to_ned(v)
    return packets(POSITION, _bytes(rows), systems, sequence)


def heartbeats(systems: NDArray[np.uint8], sequence: int) -> list[bytes]:
    """Heartbeat packets of n vehicles."""
    payload = struct.pack("<IBBBBB", 0, QUADROTOR, NO_AUTOPILOT, 0, ACTIVE, VERSION)
    rows = np.tile(np.frombuffer(payload, np.uint8), (len(systems), 1))
    return packets(HEARTBEAT, rows, systems, sequence)


def _bytes(rows: NDArray[np.void]) -> Bytes:
    return np.frombuffer(rows.tobytes(), np.uint8).reshape(len(rows), rows.dtype.itemsize)


def packets(message: int, payload: Bytes, systems: NDArray[np.uint8], sequence: int) -> list[bytes]:
    """Packets of n payloads (n, LENGTH), without trailing zeros."""
    n, width = payload.shape
    size = width - np.argmax(payload[:, ::-1] != 0, axis=1)
    size[~payload.any(axis=1)] = 1
    out: list[bytes] = [b""] * n
    for length in np.unique(size):
        rows = np.flatnonzero(size == length)
        body = np.zeros((len(rows), HEAD - 1 + length), np.uint8)
        body[:, 0] = length
        body[:, 3] = sequence % 256
        body[:, 4], body[:, 5] = systems[rows], ANY
        body[:, 6:9] = message & 0xFF, message >> 8 & 0xFF, message >> 16
        body[:, 9:] = payload[rows, :length]
        extra = np.full((len(rows), 1), EXTRA[message], np.uint8)
        sums = crc(np.concatenate([body, extra], axis=1))
        for row, head, checked in zip(rows, body, sums, strict=True):
            out[row] = bytes([MAGIC]) + head.tobytes() + int(checked).to_bytes(2, "little")
    return out


def received(datagrams: Sequence[bytes]) -> list[ReceivedMessage]:
    """The complete messages of known types in datagrams; damaged ones are ignored.

    Messages of equal length are checked together, since a swarm sends hundreds at a time.
    """
    found = [piece for data in datagrams for piece in _pieces(data)]
    out: list[ReceivedMessage] = []
    for size in sorted({len(piece) for piece in found}):
        same = [piece for piece in found if len(piece) == size]
        rows = np.frombuffer(b"".join(same), np.uint8).reshape(-1, size)
        extra = np.array([EXTRA[_message(piece)] for piece in same], np.uint8)
        sums = crc(np.concatenate([rows[:, 1:-TAIL], extra[:, None]], axis=1))
        right = sums == rows[:, -2] + (rows[:, -1].astype(np.uint16) << 8)
        for piece in (piece for piece, good in zip(same, right, strict=True) if good):
            message = _message(piece)
            payload = piece[HEAD:-TAIL].ljust(LENGTH[message], b"\0")
            out.append(ReceivedMessage(message, piece[5], payload))
    return out


def _pieces(data: bytes) -> Iterator[bytes]:
    """Candidate packets of known messages."""
    at = 0
    while at + HEAD + TAIL <= len(data):
        end = at + HEAD + data[at + 1] + TAIL
        if data[at] == MAGIC and end <= len(data) and _message(data[at:end]) in EXTRA:
            yield data[at:end]
            at = end
        else:
            at += 1


def _message(packet: bytes) -> int:
    return int.from_bytes(packet[7:10], "little")


def position_of(message: ReceivedMessage) -> tuple[Array, Array]:
    """Position p (3,) m and velocity v (3,) m/s in G of a LOCAL_POSITION_NED."""
    row = np.frombuffer(message.payload, POSITION_ROW, 1)[0]
    return to_ned(row["p"].astype(float)), to_ned(row["v"].astype(float))


def target_of(message: ReceivedMessage) -> tuple[int, Array, Array]:
    """Target system, and p and v (3,) in G, of a SET_POSITION_TARGET_LOCAL_NED."""
    row = np.frombuffer(message.payload, TARGET_ROW, 1)[0]
    return int(row["system"]), to_ned(row["p"].astype(float)), to_ned(row["v"].astype(float))
