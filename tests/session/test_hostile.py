"""Malicious files: bounded time and memory, and error messages."""

import json
import struct
import time
import tracemalloc
from collections.abc import Callable, Iterator
from pathlib import Path

import lz4.frame
import numpy as np
import pytest
import zstandard

from tests.notices import raises, shows
from tracker.base.errors import FileError, GlovetrackError
from tracker.cli import main
from tracker.messages import Event
from tracker.session.mcap import chunks, index
from tracker.session.mcap.container import McapOutput
from tracker.session.mcap.input import McapInput
from tracker.session.reader import SessionReader
from tracker.session.recover import recover
from tracker.session.verify import is_ok, verify
from tracker.session.writer import SessionRecorder

Record = Callable[..., Path]
MAGIC = b"\x89MCAP0\r\n"
HEADER = b"\x01" + struct.pack("<Q", 8) + bytes(8)
SECONDS, BYTES = 2.0, 10**9  # limit for any file of a few megabytes


@pytest.fixture
def session(tmp_path: Path, record: Record, maker) -> Path:
    return record(tmp_path / "a.mcap", list(maker.stream(1500, images=False)))


def chunk(content: bytes, name: str = "lz4") -> bytes:
    """A chunk record with correct sizes and without a checksum."""
    compress = lz4.frame.compress if name == "lz4" else zstandard.compress
    packed = compress(content)
    body = struct.pack("<QQQII", 0, 1, len(content), 0, len(name)) + name.encode()
    body += struct.pack("<Q", len(packed)) + packed
    return b"\x06" + struct.pack("<Q", len(body)) + body


EMPTY_MESSAGE = b"\x05" + struct.pack("<Q", 22) + bytes(22)
UNKNOWN = b"\x99" + struct.pack("<Q", 0)


@pytest.fixture
def work(monkeypatch) -> dict[str, int]:
    """Counts the bytes that are unpacked and the records that are looked at."""
    done = {"bytes": 0, "records": 0}

    def decompress(name: str, packed: bytes, size: int) -> bytes:
        data = unpack(name, packed, size)
        done["bytes"] += len(data)
        return data

    def records(block: bytes) -> Iterator[tuple[int, bytes]]:
        for record in split(block):
            done["records"] += 1
            yield record

    unpack, split = chunks.decompress, chunks.records
    monkeypatch.setattr(chunks, "decompress", decompress)
    monkeypatch.setattr(chunks, "records", records)
    monkeypatch.setattr(index, "records", records)
    return done


@pytest.mark.long
@pytest.mark.parametrize(
    ("content", "count"),
    [
        (bytes(200 * 2**20), 1),
        (bytes(4 * 2**20), 200),
        (UNKNOWN * (20 * 10**6), 1),
        (EMPTY_MESSAGE * (6 * 10**6), 1),
        (EMPTY_MESSAGE * 900, 500),
    ],
    ids=["one of zeros", "many of zeros", "unknown", "one of messages", "very many"],
)
def test_decompressed_chunks_are_bounded(
    tmp_path: Path, work: dict[str, int], content: bytes, count: int
) -> None:
    """Work is proportional to the file's size, not to the size that a chunk unpacks to.

    Counted, because a time limit is either loose or fails on a slow computer.
    """
    path = tmp_path / "bomb.mcap"
    path.write_bytes(MAGIC + HEADER + chunk(content) * count)
    content = b""
    size = path.stat().st_size
    for readings, words in ((1, ["info"]), (1, ["verify"]), (2, ["export", "--format", "csv"])):
        work.update(bytes=0, records=0)
        more = ["-o", str(tmp_path / "o")] if words[0] == "export" else []
        main([words[0], str(path), *words[1:], *more])
        assert 0 < work["bytes"] <= readings * max(250 * size, count * 4 * 2**20)
        assert work["records"] <= readings * (66 * count + size // 4)
    tracemalloc.start()
    verify(path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < BYTES


def test_a_chunk_that_swells_too_much_is_not_unpacked(tmp_path: Path, work) -> None:
    """Zstandard reduces zeros ten thousand times; sensors' data are reduced ten times at most."""
    path = tmp_path / "bomb.mcap"
    path.write_bytes(MAGIC + HEADER + chunk(bytes(200 * 2**20), "zstd"))
    assert not is_ok(verify(path))
    assert work["bytes"] == 0


def attached(path: Path, session_info, **texts: str) -> Path:
    """A session with other attachments."""
    out = McapOutput(path, sync=False)
    out.metadata("glovetrack", session_info.metadata())
    for name, text in {**session_info.attachments(), **texts}.items():
        out.attach(name, text, 0)
    out.finish()
    return path


@pytest.mark.parametrize(
    "text",
    [
        ".".join("a" * 40_000) + " = 1",
        "[" + ".".join("a" * 40_000) + "]",
        "a = " + "[" * 5000,
        "a = " + "{a=" * 5000,
        "length = " + "1" * 400,
        "length = " + "1" * 5000,
        "name = '''" * 50_000,
        'name = "' + '\\"' * 490_000,
        "x" * 30_000_000,
        "schema = 1e400",
    ],
    ids=lambda text: text[:12],
)
def test_every_toml_is_read_or_rejected_in_time(tmp_path: Path, session_info, text: str) -> None:
    started = time.process_time()
    path = attached(tmp_path / "a.mcap", session_info, **{"hand.toml": text})
    started = time.process_time()
    found = verify(path)
    assert time.process_time() - started < SECONDS
    assert not is_ok(found)
    assert any("hand.toml" in str(f.what) and len(str(f.what)) < 600 for f in found)


NAMES = ["a,b", "=cmd|' /C calc'!A0,x\\ny", "../../x y", "k" * 300_000, "a\\u001b[2J", ""]


@pytest.mark.parametrize("name", NAMES, ids=range(len(NAMES)))
@pytest.mark.parametrize("where", ["keypoint", "imu"])
def test_path_traversal_is_rejected_with_its_line(session_info, name: str, where: str) -> None:
    from tracker.glove.files import parse_glove

    place = 'segment = "dorsum"\nposition = [0, 0, 0]\n'
    more = f'\n[keypoints."{name}"]\n{place}'
    if where == "imu":
        more = f'\n[[imu]]\nname = "{name}"\n{place}orientation_xyzw = [0, 0, 0, 1]\n'
    line = session_info.glove_text.count("\n") + (2 if where == "keypoint" else 3)
    with pytest.raises(FileError) as caught:
        parse_glove(session_info.glove_text + more, session_info.hand, "g.toml")
    output = str(caught.value)
    assert f"g.toml, line {line}: {where}" in output
    assert len(output) < 600 and output.isprintable()


@pytest.mark.parametrize("wall", [str(2**63 - 1), "1" * 30, "-1", str(2**31 * 10**9)])
def test_an_impossible_clock_is_reported_and_leaves_nothing(
    tmp_path: Path, session_info, maker, wall: str, capsys: pytest.CaptureFixture[str]
) -> None:
    good = tmp_path / "good.mcap"
    with SessionRecorder(good, session_info) as recorder:
        for k in range(50):
            recorder.write(maker.imu(10.0 * k, k))
            recorder.write(maker.blob_frame(10.0 * k, k))
    path = tmp_path / "in.mcap"
    out = McapOutput(path, sync=False)
    out.metadata("glovetrack", {**session_info.metadata(), "wall_clock_ns": wall})
    for name, text in session_info.attachments().items():
        out.attach(name, text, 0)
    source = McapInput(good)
    for i in range(len(source.contents.spans)):
        for m in source.messages_in(source.contents.spans[i]):
            channel = out.channel(m.topic, m.type)
            out.write(channel, m.log_time, m.publish_time, m.data, m.sequence)
    source.close()
    out.finish()
    before = sorted(tmp_path.iterdir())
    status = main(["track", str(path), "-o", str(tmp_path / "out.mcap")])
    output = capsys.readouterr().err
    assert status == 1 and shows(output, "session.start_time")
    assert sorted(tmp_path.iterdir()) == before
    assert not is_ok(verify(path))


def test_messages_of_the_far_future_are_damage(tmp_path: Path, session_info) -> None:
    path = tmp_path / "a.mcap"
    out = McapOutput(path, sync=False)
    out.metadata("glovetrack", session_info.metadata())
    for name, text in session_info.attachments().items():
        out.attach(name, text, 0)
    channel = out.channel("/events", "std_msgs/msg/String")
    out.write(channel, 2**64 - 2, 0, b"\0\1\0\0\2\0\0\0x\0", 0)
    out.finish()
    assert not is_ok(verify(path))
    with SessionReader(path) as reader:
        assert list(reader.messages()) == []


def test_deeply_nested_events_are_notes(tmp_path: Path, session_info) -> None:
    from tracker.session.ros import motion, topics

    path = tmp_path / "a.mcap"
    with SessionRecorder(path, session_info) as recorder:
        recorder.write(Event(recorder.info.anchor.monotonic(session_info.anchor.wall_ns), "x", ""))
    deep = "[" * 100_000
    out = McapOutput(tmp_path / "b.mcap", sync=False)
    for name, text in session_info.attachments().items():
        out.attach(name, text, 0)
    out.write(out.channel(topics.EVENTS, motion.STRING), 10**18, 0, motion.pack_string(deep), 0)
    out.finish()
    with SessionReader(tmp_path / "b.mcap") as reader:
        (found,) = reader.messages([Event])
    assert found.text == deep


def test_file_contents_do_not_control_the_terminal(
    tmp_path: Path, session_info, capsys: pytest.CaptureFixture[str]
) -> None:
    out = McapOutput(tmp_path / "a.mcap", sync=False)
    output = {"engine": "\x1b]0;owned\x07\x1b[2Jchain", "version": "1\r\n2\x9b31m\u202e"}
    out.metadata("glovetrack", {**session_info.metadata(), **output})
    out.channel("/evil\x1b[2J\n/topic", "std_msgs/msg/String")
    out.finish()
    for words in ("info", "verify"):
        main([words, str(tmp_path / "a.mcap")])
    text = "".join(capsys.readouterr())
    assert "chain" in text and "/evil" in text
    assert all(c.isprintable() or c == "\n" for c in text)
    assert "version 12" in text.replace("31m", "")


def test_a_flipped_bit_is_reported_with_the_remedy(session: Path) -> None:
    data = bytearray(session.read_bytes())
    source = McapInput(session)
    span = source.contents.spans[len(source.contents.spans) // 2]
    source.close()
    data[span.offset + span.length // 2] ^= 8
    bad = session.with_name("bad.mcap")
    bad.write_bytes(data)
    with raises(FileError, "session.chunk_damaged"), SessionReader(bad) as reader:
        list(reader.messages())
    assert is_ok(verify(recover(bad).path))


def test_a_damaged_attachment_does_not_affect_others(session: Path, session_info) -> None:
    data = bytearray(session.read_bytes())
    at = data.index(session_info.hand_text.encode()[:100])
    data[at + 50] ^= 1
    bad = session.with_name("bad.mcap")
    bad.write_bytes(data)
    saved = recover(bad)
    with SessionReader(saved.path) as reader:
        assert "hand.toml" not in reader.attachments
        assert reader.attachments["glove.toml"] == session_info.glove_text
    assert any("attachment" in str(d.what) for d in saved.damage)


@pytest.mark.long
@pytest.mark.parametrize(
    ("summed", "ms", "bits"),
    [(True, 200, 100), (False, 1500, 50)],
    ids=["with a checksum", "without"],
)
def test_verify_detects_every_flipped_bit(
    tmp_path: Path, record: Record, maker, summed: bool, ms: int, bits: int
) -> None:
    """For the whole file for one with a checksum of its data; of records and indexes for others."""
    session = record(tmp_path / "a.mcap", list(maker.stream(ms, images=False)))
    data, rng = session.read_bytes(), np.random.default_rng(5)
    if not summed:
        (start,) = struct.unpack("<Q", data[-28:-20])
        data = data[: start - 4] + bytes(4) + data[start:]
    assert is_ok(verify(written(session, data)))
    missed = []
    for at in rng.integers(0, len(data), bits):
        spoilt = bytearray(data)
        spoilt[at] ^= 1 << int(rng.integers(8))
        try:
            fine = is_ok(verify(written(session, bytes(spoilt))))
        except GlovetrackError:
            continue
        if fine:
            missed.append(int(at))
    assert not missed if summed else len(missed) <= 1


def written(session: Path, data: bytes) -> Path:
    path = session.with_name("flipped.mcap")
    path.write_bytes(data)
    return path


def test_json_about_a_malicious_file_is_valid(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = McapOutput(tmp_path / "a.mcap", sync=False)
    out.metadata("glovetrack", {"engine": '"\x1b]0;\\', "version": "\ud7ff"})
    out.finish()
    main(["info", str(tmp_path / "a.mcap"), "--json", "-"])
    assert json.loads(capsys.readouterr().out)["engine"] == '"\x1b]0;\\'


def test_too_many_channels_are_rejected(tmp_path: Path) -> None:
    """Reading allows all 65,536 ids; a writer has one fewer, since it begins with 1."""

    def record_of(kind: int, body: bytes) -> bytes:
        return bytes([kind]) + struct.pack("<Q", len(body)) + body

    def text(value: str) -> bytes:
        return struct.pack("<I", len(value)) + value.encode()

    channels = [
        record_of(4, struct.pack("<HH", k, 0) + text(f"/t{k}") + text("json") + bytes(4))
        for k in range(65_536)
    ]
    message = record_of(5, struct.pack("<HIQQ", 1, 0, 10**18, 10**18) + b"{}")
    (tmp_path / "a.mcap").write_bytes(MAGIC + HEADER + b"".join(channels) + message)
    with raises(FileError, "session.many_channels"):
        recover(tmp_path / "a.mcap", tmp_path / "b.mcap")
    assert [p.name for p in tmp_path.iterdir()] == ["a.mcap"]
