"""Killed processes, full disks, damaged and malicious files."""

import json
import os
import struct
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import lz4.frame
import numpy as np
import pytest
import zstandard
from mcap.writer import Writer

from tests.notices import raises, shows
from tests.session.conftest import START
from tests.session.kill_drill import drill
from tracker.base.errors import FileError, GlovetrackError
from tracker.cli import main
from tracker.messages import Estimate, ImuSample
from tracker.session.compare import compare
from tracker.session.mcap import disk
from tracker.session.mcap.container import McapOutput
from tracker.session.mcap.input import McapInput
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.recover import recover
from tracker.session.verify import is_ok, verify
from tracker.session.writer import SessionRecorder, new_session

Record = Callable[..., Path]


@pytest.fixture
def session(tmp_path: Path, record: Record, maker) -> Path:
    return record(tmp_path / "a.mcap", list(maker.stream(1500, images=False)))


def test_a_killed_recording_loses_less_than_half_a_second(tmp_path: Path) -> None:
    for kill in drill(tmp_path, kills=6, seed=4):
        assert kill.written > 0 and kill.gaps == 0
        assert kill.lost_s <= 0.5


def test_recovered_messages_are_those_of_the_file(session: Path) -> None:
    data = session.read_bytes()
    cut = session.with_name("cut.mcap")
    cut.write_bytes(data[: len(data) // 2])
    saved = recover(cut)
    assert saved.damage
    with SessionReader(saved.path) as part, SessionReader(session) as whole:
        assert part.info.metadata() == whole.info.metadata()
        some, every = list(part.messages([ImuSample])), list(whole.messages([ImuSample]))
    assert 0 < len(some) < len(every)
    for a, b in zip(some, every, strict=False):
        assert np.array_equal(a.accel, b.accel, equal_nan=True)


@pytest.mark.long
def test_every_truncated_file_is_read_or_rejected(session: Path) -> None:
    data = session.read_bytes()
    cut = session.with_name("cut.mcap")
    for end in range(0, len(data), len(data) // 60):
        cut.write_bytes(data[:end])
        try:
            verdict = verify(cut)
        except GlovetrackError:
            continue
        assert not is_ok(verdict)


@pytest.mark.long
def test_flipped_bits_are_reported(session: Path) -> None:
    data, rng = session.read_bytes(), np.random.default_rng(8)
    bad = session.with_name("bad.mcap")
    refused = 0
    for _ in range(60):
        spoilt = bytearray(data)
        for at in rng.integers(0, len(data), 3):
            spoilt[at] ^= 1 << int(rng.integers(8))
        bad.write_bytes(spoilt)
        started = time.process_time()
        try:
            with SessionReader(bad) as reader:
                list(reader.messages())
        except GlovetrackError:
            refused += 1
        assert time.process_time() - started < 2
    assert refused > 12


def test_a_decompression_bomb_is_rejected(tmp_path: Path, session: Path) -> None:
    bomb = lz4.frame.compress(bytes(2**26))
    head = struct.pack("<QQQII", 0, 1, 2**20, 0, 3) + b"lz4" + struct.pack("<Q", len(bomb))
    body = head + bomb
    header = b"\x01" + struct.pack("<Q", 8) + bytes(8)
    path = tmp_path / "bomb.mcap"
    path.write_bytes(b"\x89MCAP0\r\n" + header + b"\x06" + struct.pack("<Q", len(body)) + body)
    source = McapInput(path)
    assert shows(str(source.contents.damage[0].what), "data.size")
    source.close()


@pytest.mark.parametrize("kind", ["lz4", "zstd"])
def test_a_chunk_that_declares_a_huge_size_is_not_decompressed(
    tmp_path: Path, kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    size, zeros = 2**27, bytes(2**20)
    if kind == "lz4":
        packed = lz4.frame.compress(zeros)
    else:
        packed = zstandard.ZstdCompressor().compress(zeros)
    monkeypatch.setattr(
        "tracker.session.mcap.chunks.decompress", lambda *_: pytest.fail("unpacked")
    )
    body = struct.pack("<QQQII", 0, 1, size, 0, len(kind)) + kind.encode()
    body += struct.pack("<Q", len(packed)) + packed
    path = tmp_path / "bomb.mcap"
    header = b"\x01" + struct.pack("<Q", 8) + bytes(8)
    path.write_bytes(b"\x89MCAP0\r\n" + header + b"\x06" + struct.pack("<Q", len(body)) + body)
    found = verify(path)
    assert any(
        shows(str(f.what), "data.declared_size", size_bytes=size) for f in found
    ) and not is_ok(found)


def test_attachment_names_cannot_escape_the_folder(tmp_path: Path, session_info) -> None:
    out = McapOutput(tmp_path / "a.mcap", sync=False)
    for name in ("../hand.toml", "/etc/glove.toml", "..\\colours.toml", "C:\\hand.toml"):
        out.attach(name, "x = 1", 0)
    out.attach("glove.toml", session_info.glove_text, 0)
    out.finish()
    with SessionReader(tmp_path / "a.mcap") as reader:
        assert list(reader.attachments) == ["glove.toml"]
        with raises(FileError, "session.part_missing"):
            reader.attachment("hand.toml")
    assert sorted(p.name for p in tmp_path.rglob("*")) == ["a.mcap"]


@pytest.mark.parametrize("content", [b"", b"\x89MCAP0\r\n", b"not a session", bytes(5000)])
def test_other_files_are_rejected(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "x.mcap"
    path.write_bytes(content)
    codes = ("session.not_mcap", "session.part_missing")
    with raises(FileError, *codes), SessionReader(path) as reader:
        list(reader.messages())


def test_a_recording_never_overwrites(session: Path, session_info) -> None:
    before = session.read_bytes()
    with raises(FileError, "recording.exists"):
        SessionRecorder(session, session_info)
    assert session.read_bytes() == before
    for _ in range(2):
        SessionRecorder(session.parent, session_info).close()
    names = sorted(p.name for p in session.parent.glob("2025-10-09*"))
    assert names == ["2025-10-09_08-53-20_P-07.mcap", "2025-10-09_08-53-20_P-07_2.mcap"]


def test_a_missing_folder_is_reported(tmp_path: Path, session_info) -> None:
    with raises(FileError, "file.not_writable"):
        SessionRecorder(tmp_path / "no" / "a.mcap", session_info)


def test_low_disk_space_warns_and_then_stops(tmp_path: Path, session_info, maker) -> None:
    bytes_left = iter([9e9, 4e9, 0.5e9])
    path = tmp_path / "a.mcap"
    recorder = SessionRecorder(path, session_info, free=lambda _: int(next(bytes_left)))
    assert "GB" in recorder.status.warning
    with raises(FileError, "recording.disk_full_stopped"):
        for k in range(1000):
            recorder.write(maker.imu(10.0 * k, k))
    assert recorder.closed
    assert is_ok(verify(path))


def test_a_tracked_file_may_be_written_with_too_little_space_to_record(
    tmp_path: Path, session_info, maker, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A recording needs a reserve; a tracked file is small, and can be computed again."""
    left = SimpleNamespace(total=10**12, used=10**12, free=50 * 10**6)
    monkeypatch.setattr("tracker.base.files.shutil.disk_usage", lambda folder: left)
    with pytest.raises(FileError) as caught:
        SessionRecorder(tmp_path / "recorded.mcap", session_info)
    assert caught.value.notice.code == "recording.disk_full"
    with new_session(tmp_path / "made.mcap", session_info) as recorder:
        for m in maker.stream(500, images=False):
            recorder.write(m)
    assert is_ok(verify(tmp_path / "made.mcap"))
    assert sorted(p.name for p in tmp_path.iterdir()) == ["made.mcap"]


def test_a_full_disk_leaves_complete_chunks(
    tmp_path: Path, session_info, maker, monkeypatch
) -> None:
    path = tmp_path / "a.mcap"
    recorder = SessionRecorder(path, session_info)
    write, left = os.write, [200_000]

    def limited(fd: int, data: bytes) -> int:
        if left[0] < len(data):
            write(fd, bytes(data)[: left[0]])
            raise OSError(28, "No space left on device")
        left[0] -= len(data)
        return write(fd, data)

    monkeypatch.setattr(disk.os, "write", limited)
    with raises(FileError, "file.not_writable"):
        for k in range(5000):
            recorder.write(maker.imu(10.0 * k, k))
    monkeypatch.undo()
    assert recorder.closed
    saved = recover(path)
    assert saved.messages > 500
    assert all(d.what.code == "check.breaks_off" for d in saved.damage)
    with raises(FileError, "recording.has_ended"):
        recorder.write(maker.imu(0))


def test_overload_loses_only_images(tmp_path: Path, session_info, maker) -> None:
    path = tmp_path / "a.mcap"
    with SessionRecorder(path, session_info) as recorder:
        for k in range(20):
            recorder.write(maker.imu(10.0 * k, k), overloaded=True)
            recorder.write(maker.image(10.0 * k, k), overloaded=k % 2 == 0)
        assert (recorder.status.frames, recorder.status.frames_thinned) == (10, 10)
    with SessionReader(path) as reader:
        kinds = [type(m).__name__ for m in reader.messages()]
    assert (kinds.count("ImuSample"), kinds.count("StereoFrame")) == (20, 10)


def test_verify_finds_gaps_jumps_and_missing_topics(tmp_path: Path, record: Record, maker) -> None:
    messages = [maker.imu(10.0 * k + (800 if k > 60 else 0), k, missing=1) for k in range(120)]
    found = verify(record(tmp_path / "a.mcap", messages))
    codes = {f.what.code: f.what.values for f in found}
    assert codes["check.gaps"]["longest_s"] == pytest.approx(0.81, abs=1e-3)
    assert {"check.no_imu", "check.no_camera"} <= codes.keys()
    assert is_ok(found)


def test_an_intact_session_has_no_findings(session: Path) -> None:
    assert verify(session) == []


def test_compare_measures_the_changes(tmp_path: Path, record: Record, maker) -> None:
    from dataclasses import replace

    estimates = [maker.estimate(10.0 * k) for k in range(30)]
    moved = [replace(e, keypoints=e.keypoints + [0.003, 0.0, 0.004]) for e in estimates]
    a, b = record(tmp_path / "a.mcap", estimates), record(tmp_path / "b.mcap", moved)
    found = compare(a, b, tmp_path / "f.png")
    assert found["mean_mm"] == pytest.approx(5.0)
    assert found["rms_deg"] == 0
    assert not found["identical"]
    assert compare(a, a)["identical"]
    assert (tmp_path / "f.png").read_bytes()[:4] == b"\x89PNG"


def test_commands_have_json_output(session: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", str(session), "--json", "-"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["topics"]["/hand/right/keypoints"]["count"] == 150
    assert found["topics"]["/glove/right/imu/dorsum"]["type"] == "sensor_msgs/msg/Imu"
    assert found["integrity"] == "ok"
    assert found["simulated"] is True
    assert main(["verify", str(session), "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out) == {"ok": True, "findings": []}
    assert main(["info", str(session.parent / "none.mcap")]) == 1
    assert shows(capsys.readouterr().err, "file.missing")


def test_estimates_of_an_unfinished_file_are_read(session: Path) -> None:
    data = session.read_bytes()
    cut = session.with_name("cut.mcap")
    cut.write_bytes(data[: len(data) * 2 // 3])
    with SessionReader(cut) as reader:
        assert len(list(reader.messages([Estimate]))) > 20


def test_a_channel_may_be_defined_at_the_end_of_a_chunk_before_its_messages(tmp_path: Path) -> None:
    """In an unfinished file: all left images of one were not found."""
    path = tmp_path / "unfinished.mcap"
    with path.open("wb") as stream:
        writer = Writer(stream, chunk_size=200)
        writer.start("ros2", "test")
        schema = writer.register_schema("a", "ros2msg", b"")
        early = writer.register_channel("/early", "cdr", schema)
        writer.add_message(early, 1, bytes(100), 1)
        late = writer.register_channel("/late", "cdr", schema)
        writer.add_message(early, 2, bytes(300), 2)  # ends the chunk
        writer.add_message(late, 3, bytes(300), 3)
    source = McapInput(path)
    try:
        assert not source.contents.finished
        assert [m.topic for m in ordered(source)] == ["/early", "/early", "/late"]
    finally:
        source.close()


def test_a_disk_that_is_removed_is_reported(
    tmp_path: Path, session_info, maker, monkeypatch
) -> None:
    recorder = SessionRecorder(tmp_path / "a.mcap", session_info)

    def gone(*_: object) -> int:
        raise OSError(5, "Input/output error")

    monkeypatch.setattr(disk.os, "write", gone)
    monkeypatch.setattr(disk.os, "ftruncate", gone)
    with raises(FileError, "file.not_writable"):
        for k in range(200):
            recorder.write(maker.imu(10.0 * k, k))
    monkeypatch.undo()
    recorder.close()
    assert recorder.closed


def test_chunks_are_limited_in_time_and_size(session: Path) -> None:
    source = McapInput(session)
    spans = [source.contents.spans[i] for i in range(len(source.contents.spans))]
    source.close()
    assert len(spans) > 3
    assert all(s.end - s.start <= 0.5e9 for s in spans)
    assert all(s.length < 80_000 for s in spans)


def test_chunks_are_limited_in_time_with_late_packets(tmp_path: Path, session_info, maker) -> None:
    """Packets up to 2.5 s behind the images; none is lost or out of order for a reader."""
    path, rng = tmp_path / "a.mcap", np.random.default_rng(2)
    wrote = []
    with SessionRecorder(path, session_info) as recorder:
        for k in range(400):
            frame = maker.blob_frame(10.0 * k, k)
            late_s = rng.uniform(0, 2.5) if k % 3 == 0 else 0.0
            packet = maker.imu(10.0 * k, k)
            packet = replace(packet, t_arrival=max(packet.t_arrival - late_s, START))
            recorder.write(frame)
            recorder.write(packet)
            wrote.append(packet.t_arrival)
    source = McapInput(path)
    spans = [source.contents.spans[i] for i in range(len(source.contents.spans))]
    times = [m.log_time for m in ordered(source)]
    for span in spans:
        inside = [m.log_time for m in source.messages_in(span)]
        assert max(inside) - min(inside) <= 0.5e9
        assert (min(inside), max(inside)) == (span.start, span.end)
    source.close()
    assert times == sorted(times) and len(spans) < 400
    with SessionReader(path) as reader:
        assert len(list(reader.messages((ImuSample,)))) == 400
    assert is_ok(verify(path))


@pytest.mark.long
def test_damaged_messages_in_intact_chunks_affect_no_others(session: Path, maker) -> None:
    """Checksums are correct here, so the damage reaches the decoders."""
    rng = np.random.default_rng(12)
    spoilt = 0
    with SessionReader(session) as reader:
        everything = list(ordered(reader.source))
        attachments, metadata = dict(reader.attachments), dict(reader.metadata)
    for n in range(40):
        path = session.with_name(f"spoilt{n}.mcap")
        out = McapOutput(path, "none", sync=False)
        out.metadata("glovetrack", metadata)
        for name, text in attachments.items():
            out.attach(name, text, 0)
        for m in everything[:200] + everything[-10:]:
            data = bytearray(m.data)
            if rng.uniform() < 0.03:
                data[int(rng.integers(len(data)))] ^= 1 << int(rng.integers(8))
            out.write(out.channel(m.topic, m.type), m.log_time, m.publish_time, bytes(data), 0)
        out.finish()
        with SessionReader(path) as reader:
            list(reader.messages())
            left_out = reader.source.left_out.by_topic()
        found = [f for f in verify(path) if f.what.code == "check.damaged_messages"]
        assert {f.where: f.what.values["count"] for f in found} == left_out
        spoilt += sum(left_out.values())
    assert spoilt > 10
