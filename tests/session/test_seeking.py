"""Seeking: the amount of data read does not grow with the session, forward or backward."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from tracker.messages import Estimate, ImuSample, Message, StereoFrame
from tracker.session.mcap.records import McapFile
from tracker.session.reader import SessionReader

KINDS = (ImuSample, StereoFrame, Estimate)
SHORT_MS, LONG_MS = 3_000, 12_000


@pytest.fixture
def count_bytes(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Bytes of each read of a session file."""
    read: list[int] = []
    original = McapFile.at

    def counting(self: McapFile, offset: int, length: int) -> bytes:
        data = original(self, offset, length)
        read.append(len(data))
        return data

    monkeypatch.setattr(McapFile, "at", counting)
    return read


def session(path: Path, record: Callable[..., Path], maker, duration_ms: int) -> Path:
    return record(path, list(maker.stream(duration_ms)), images="jpeg")


def cost(reader: SessionReader, read: list[int], share: float) -> int:
    """Bytes read for the first tenth of a second from ``share`` of the session on."""
    begin = reader.anchor.monotonic(reader.span_ns[0]) + share * reader.duration
    read.clear()
    found: list[Message] = list(reader.messages(KINDS, begin, begin + 0.1))
    assert len(found) > 15
    return sum(read)


@pytest.mark.long
def test_a_seek_reads_no_more_in_a_longer_session(
    tmp_path: Path, record: Callable[..., Path], maker, count_bytes: list[int]
) -> None:
    costs: dict[int, list[int]] = {}
    for duration in (SHORT_MS, LONG_MS):
        path = session(tmp_path / f"{duration}.mcap", record, maker, duration)
        with SessionReader(path) as reader:
            assert reader.info.rig is not None
            shares = (0.9, 0.1, 0.8, 0.05, 0.5)  # forward and back
            costs[duration] = [cost(reader, count_bytes, s) for s in shares]
    assert max(costs[LONG_MS]) < 1.5 * max(costs[SHORT_MS])
    assert max(costs[LONG_MS]) < 0.1 * (tmp_path / f"{LONG_MS}.mcap").stat().st_size


def test_a_seek_returns_the_same_as_sequential_reading(
    tmp_path: Path, record: Callable[..., Path], maker
) -> None:
    path = session(tmp_path / "a.mcap", record, maker, SHORT_MS)
    with SessionReader(path) as reader:
        begin = reader.anchor.monotonic(reader.span_ns[0]) + 1.5
        whole = [m for m in reader.messages((ImuSample, Estimate)) if isinstance(m, Estimate)]
        late = [m for m in reader.messages((ImuSample, Estimate), begin) if isinstance(m, Estimate)]
    tail = whole[-len(late) :]
    assert len(late) > 100
    assert [replace(m).tracking for m in late] == [m.tracking for m in tail], "states are recalled"
    assert [m.t for m in late] == [m.t for m in tail]
