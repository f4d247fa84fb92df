"""The wire format: known bytes, round trips, and transmission errors."""

from __future__ import annotations

import time
import tracemalloc

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracker.sensors.decoder import MAX_FRAME_BYTES, FrameDecoder, Unwrapper
from tracker.sensors.protocol import (
    ErrorText,
    Frame,
    GloveStatus,
    Haptic,
    Hello,
    HelloRequest,
    ImuChip,
    Rate,
    Samples,
    Start,
    Stop,
    Temperatures,
    cobs_decode,
    cobs_encode,
    crc16,
    encode,
)

BYTES_PER_S = 9600  # seven IMUs at 100 Hz


@pytest.mark.parametrize(
    ("data", "code"),
    [  # the examples of Wikipedia's article on COBS
        ("00", "0101"),
        ("0000", "010101"),
        ("00 11 00", "01 02 11 01"),
        ("11 22 00 33", "03 11 22 02 33"),
        ("11 22 33 44", "05 11 22 33 44"),
        ("11 00 00 00", "02 11 01 01 01"),
    ],
)
def test_cobs_examples(data: str, code: str) -> None:
    assert cobs_encode(bytes.fromhex(data)) == bytes.fromhex(code)
    assert cobs_decode(bytes.fromhex(code)) == bytes.fromhex(data)


@pytest.mark.parametrize("n", [253, 254, 255, 508, 509])
def test_cobs_long_runs(n: int) -> None:
    run = bytes([1]) * n
    for data in (run, run + b"\0", b"\0" + run, run + b"\0" + run):
        code = cobs_encode(data)
        assert 0 not in code
        assert len(code) <= len(data) + 1 + len(data) // 254
        assert cobs_decode(code) == data


@given(st.binary(max_size=600))
def test_cobs_round_trip(data: bytes) -> None:
    assert cobs_decode(cobs_encode(data)) == data


def test_crc_check_value() -> None:
    assert crc16(b"123456789") == 0x29B1  # of CRC-16/CCITT-FALSE in the catalogue of CRCs


FRAMES: list[Frame] = [
    Hello(0xDEADBEEF, 7, 2000, 16, 200, 3, (1, 2, 3)),
    Hello(3, 2, chips=(ImuChip(0x71, 0), ImuChip(0x74, 2))),
    Temperatures((2513, None, -40)),
    GloveStatus(None, -1250, 0x7F, 65535),
    GloveStatus(3900, 2500, 0x3F, 0),
    ErrorText("IMU 3 fehlt: Überlauf"),
    HelloRequest(),
    Start(),
    Stop(),
    Rate(200),
    Haptic(2, 255, 1000),
]


def test_every_frame_round_trip() -> None:
    assert FrameDecoder().feed(b"".join(encode(f) for f in FRAMES)) == FRAMES


def test_a_greeting_of_older_firmware_has_no_chips() -> None:
    older, newer = encode(Hello(3, 2)), encode(Hello(3, 2, chips=(ImuChip(0x70, 0),) * 2))
    assert len(newer) == len(older) + 4
    first, second = FrameDecoder().feed(older + newer)
    assert isinstance(first, Hello) and first.chips == ()
    assert isinstance(second, Hello) and len(second.chips) == 2


def test_a_greeting_cut_off_in_its_chips_is_dropped() -> None:
    decoder = FrameDecoder()
    assert decoder.feed(encode(Hello(3, 5, chips=(ImuChip(0x70, 0),) * 2))) == []
    assert decoder.counters.length_errors == 1


def test_the_bytes_match_the_specification() -> None:
    assert cobs_decode(encode(Rate(200))[:-1])[:3] == bytes([0x84, 0xC8, 0x00])
    raw = np.array([[1, -2, 3, 4, 5, 6]], np.int16)
    body = cobs_decode(encode(Samples(0x0102, 0x03040506, raw))[:-1])
    assert body[:11] == bytes.fromhex("02 0201 06050403 0100 feff")
    assert len(body) == 1 + 6 + 12 + 2


def test_error_text_is_truncated_between_characters() -> None:
    (frame,) = FrameDecoder().feed(encode(ErrorText("ü" * 50)))
    assert frame == ErrorText("ü" * 30)


def packets(count: int, seed: int = 0) -> list[bytes]:
    rng = np.random.default_rng(seed)
    raw = rng.integers(-32768, 32767, (count, 7, 6)).astype(np.int16)
    return [encode(Samples(n, 10_000 * n, raw[n])) for n in range(count)]


@settings(max_examples=30)
@given(st.lists(st.integers(1, 400), min_size=1, max_size=30))
def test_pieces_of_any_size_give_the_same(sizes: list[int]) -> None:
    data, decoder, got, i = b"".join(packets(40)), FrameDecoder(), [], 0
    for k in range(10_000):
        if i >= len(data):
            break
        size = sizes[k % len(sizes)]
        got += decoder.feed(data[i : i + size])
        i += size
    assert [f.seq for f in got if isinstance(f, Samples)] == list(range(40))
    assert decoder.counters.errors == 0


def test_a_damaged_frame_affects_no_others() -> None:
    """One flipped bit: the frame is lost, or two if it created or removed a zero."""
    rng = np.random.default_rng(5)
    clean = packets(9)
    for _ in range(300):
        k = int(rng.integers(1, 8))
        bad = bytearray(clean[k])
        bad[rng.integers(len(bad))] ^= 1 << int(rng.integers(8))
        decoder = FrameDecoder()
        got = [f.seq for f in decoder.feed(b"".join([*clean[:k], bytes(bad), *clean[k + 1 :]]))]
        lost = sorted(set(range(9)) - set(got))
        assert lost in ([k], [k, k + 1])
        assert len(got) == len(set(got))
        assert decoder.counters.errors >= 1


@settings(max_examples=200)
@given(st.lists(st.binary(max_size=700), max_size=8))
def test_garbage_never_crashes_and_later_frames_are_received(pieces: list[bytes]) -> None:
    decoder = FrameDecoder()
    for piece in pieces:
        decoder.feed(piece)
    assert Start() in decoder.feed(b"\0" + encode(Start()))


def test_endless_garbage_takes_no_memory() -> None:
    decoder, block = FrameDecoder(), b"\x55" * 4096
    decoder.feed(block)
    tracemalloc.start()
    for _ in range(2000):
        decoder.feed(block)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 64_000
    assert decoder.counters.oversize == 1
    assert decoder.feed(b"\0" + encode(Stop())) == [Stop()]


def test_lengths_and_types_are_checked_separately() -> None:
    def framed(body: bytes) -> bytes:
        return cobs_encode(body + crc16(body).to_bytes(2, "little")) + b"\0"

    decoder = FrameDecoder()
    assert decoder.feed(framed(b"\x84\x01")) == []  # RATE of one byte
    assert decoder.feed(framed(b"\x02" + bytes(6))) == []  # SAMPLES of no IMU
    assert decoder.feed(framed(b"\x02" + bytes(6 + 17 * 12))) == []  # of too many
    assert decoder.feed(framed(b"\x04" + bytes(61))) == []
    assert decoder.feed(framed(b"\x77")) == []
    assert decoder.feed(b"\x05ab\0") == []  # runs past the end
    assert decoder.feed(b"\x01" * (MAX_FRAME_BYTES + 1) + b"\0") == []
    c = decoder.counters
    assert (c.length_errors, c.unknown, c.cobs_errors, c.oversize) == (4, 1, 1, 1)


def test_throughput_is_fifty_times_the_real_rate() -> None:
    data = b"".join(packets(3000))
    decoder, started = FrameDecoder(), time.process_time()
    count = sum(len(decoder.feed(data[i : i + 64])) for i in range(0, len(data), 64))
    rate = len(data) / (time.process_time() - started)
    assert count == 3000
    assert rate > 50 * BYTES_PER_S


@given(st.lists(st.integers(-100, 30_000), max_size=50))
def test_unwrapping(steps: list[int]) -> None:
    unwrap, true = Unwrapper(16), 40_000
    assert unwrap(true) == true
    for step in steps:
        true += step
        assert unwrap(true % 65536) == true
