"""Our MAVLink against pymavlink's: identical bytes, read correctly."""

from __future__ import annotations

import numpy as np
import pymavlink.dialects.v20.common as mavlink
import pytest

from extensions.applications.swarm.mavlink import (
    POSITION,
    TARGET,
    crc,
    heartbeats,
    position_of,
    positions,
    received,
    target_of,
    targets,
)

P = np.array([[1.5, -2.25, 3.0], [0.0, 0.0, 0.0], [100.0, 5.0, 0.0]])
V = np.array([[0.5, 0.0, -1.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
SYSTEMS = np.array([1, 7, 250], np.uint8)


def sender(system: int, sequence: int):
    link = mavlink.MAVLink(None, srcSystem=system, srcComponent=1)
    link.seq = sequence
    return link


def test_targets_are_byte_for_byte_those_of_pymavlink() -> None:
    ours = targets(P, V, SYSTEMS, 12.5, 42)
    for packet, p, v, system in zip(ours, P, V, SYSTEMS, strict=True):
        ned = p * [1, -1, -1], v * [1, -1, -1]
        message = mavlink.MAVLink_set_position_target_local_ned_message(
            12500, int(system), 1, mavlink.MAV_FRAME_LOCAL_NED, 0b110111000000,
            *ned[0], *ned[1], 0, 0, 0, 0, 0,
        )  # fmt: skip
        assert packet == message.pack(sender(255, 42))


def test_pymavlink_reads_positions_and_heartbeats() -> None:
    parser = mavlink.MAVLink(None)
    packets = positions(P, V, SYSTEMS, 3.25, 9) + heartbeats(SYSTEMS, 10)
    found = [m for packet in packets for m in parser.parse_buffer(packet)]
    assert len(found) == 6
    for message, p, system in zip(found, P, SYSTEMS, strict=False):
        assert message.get_type() == "LOCAL_POSITION_NED"
        assert message.get_srcSystem() == system
        assert (message.x, -message.y, -message.z) == pytest.approx(p)
        assert message.time_boot_ms == 3250
    assert {m.get_type() for m in found[3:]} == {"HEARTBEAT"}
    assert found[3].type == mavlink.MAV_TYPE_QUADROTOR


def test_messages_of_pymavlink_are_read() -> None:
    message = mavlink.MAVLink_local_position_ned_message(1, 4.0, 5.0, 6.0, 0.0, 0.0, 0.0)
    (one,) = received([message.pack(sender(9, 0))])
    assert (one.message, one.system) == (POSITION, 9)
    p, v = position_of(one)
    assert p == pytest.approx([4.0, -5.0, -6.0])
    assert v == pytest.approx([0.0, 0.0, 0.0])


def test_damaged_and_unknown_messages_are_skipped() -> None:
    good = targets(P[:1], V[:1], SYSTEMS[:1], 1.0, 0)[0]
    bad = bytearray(good)
    bad[20] ^= 1
    strange = mavlink.MAVLink_ping_message(1, 2, 3, 4).pack(sender(1, 0))
    found = received([b"\xfd\xff noise", bytes(bad) + strange + good, good[:-3]])
    assert [m.message for m in found] == [TARGET]
    system, p, v = target_of(found[0])
    assert system == 1
    assert p == pytest.approx(P[0])
    assert v == pytest.approx(V[0])


def test_the_sum_is_that_of_the_catalogue() -> None:
    """CRC-16/MCRF4XX of "123456789" is 6F91h."""
    assert crc(np.frombuffer(b"123456789", np.uint8)[None])[0] == 0x6F91
