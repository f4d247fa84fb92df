"""Fuzz targets: each accepts any bytes, and reads or rejects them.

Some are whole files; others are inserted where a fuzzer would not get by chance, behind checksums
and lengths, which are corrected around the bytes.
"""

from __future__ import annotations

import contextlib
import functools
import struct
import tempfile
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import zstandard

from tests.fuzz.examples import STAMP, begun, topics_of
from tracker.base.clock import ClockAnchor
from tracker.base.config import from_toml
from tracker.base.errors import GlovetrackError
from tracker.engine.settings import Settings
from tracker.fusion.chain.engine import ChainEngine  # registers what it keeps  # noqa: F401
from tracker.glove import library
from tracker.glove.files import parse_glove
from tracker.hand.files import parse_hand
from tracker.messages import ImuSample
from tracker.offline.imports.table import read_table
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.protocol import Hello, cobs_encode, crc16, encode
from tracker.sensors.rig_files import load_opencv_stereo, load_zed
from tracker.session import engine_state
from tracker.session.description import SessionInfo
from tracker.session.mcap.container import McapOutput
from tracker.session.reader import SessionReader
from tracker.session.recover import recover
from tracker.session.verify import verify
from tracker.vision.colours import parse_profile
from tracker.vision.rig import ideal_rig

ANCHOR = ClockAnchor(wall_ns=STAMP, monotonic_ns=5_000_000_000)
HAND, GLOVE = library.load(library.DEFAULT_GLOVE, "")
INFO = SessionInfo(
    HAND, GLOVE, *library.texts(library.DEFAULT_GLOVE, ""), ANCHOR, ideal_rig(64, 48)
)
BEGUN = begun(INFO)
_folder = tempfile.TemporaryDirectory(prefix="glovetrack-fuzz-")


@functools.cache
def topics() -> list[tuple[str, str, bytes]]:
    """For a recording, which takes seconds to create: not during test collection."""
    return topics_of(INFO)


def _file(data: bytes, name: str = "a.mcap") -> Path:
    path = Path(_folder.name) / name
    path.write_bytes(data)
    return path


def _read(path: Path) -> None:
    """Everything a command would read of a session."""
    try:
        verify(path)
        with SessionReader(path) as reader:
            reader.engine_states()
            reader.rig_changes()
            list(reader.truth())
            list(reader.messages())
    except GlovetrackError:
        pass  # refused with an error
    saved = path.with_name("saved.mcap")
    saved.unlink(missing_ok=True)
    with contextlib.suppress(GlovetrackError):
        recover(path, saved)


# ---- sessions


def container(data: bytes) -> None:
    """A whole file."""
    _read(_file(data))


def records(data: bytes) -> None:
    """The content of a chunk, with correct sizes and no checksum, in an unfinished file."""
    body = (
        struct.pack("<QQQII", STAMP, STAMP + 10**9, len(data), 0, 0)
        + struct.pack("<Q", len(data))
        + data
    )
    _read(_file(BEGUN + b"\x06" + struct.pack("<Q", len(body)) + body))


def messages(data: bytes) -> None:
    """Messages of our own topics in a valid session: number of the topic, u16 length, the bytes."""
    path = Path(_folder.name) / "b.mcap"
    path.unlink(missing_ok=True)
    out = McapOutput(path, sync=False)
    out.metadata("glovetrack", INFO.metadata())
    for name, text in INFO.attachments().items():
        out.attach(name, text, 0)
    at, stamp = 0, ANCHOR.wall_ns
    while at + 3 <= len(data) and stamp < ANCHOR.wall_ns + 50 * 10**7:
        topic, kind, _ = topics()[data[at] % len(topics())]
        (length,) = struct.unpack_from("<H", data, at + 1)
        stamp += 10**7
        out.write(out.channel(topic, kind), stamp, stamp, data[at + 3 : at + 3 + length], 0)
        at += 3 + length
    out.finish()
    _read(path)


def state(data: bytes) -> None:
    """The unpacked content of an attachment ``engine_state``, with correct checksum and size."""
    packed = struct.pack("<Q", len(data)) + zstandard.ZstdCompressor(level=1).compress(data)
    whole = b"GTES" + struct.pack("<HI", engine_state.VERSION, zlib.crc32(packed)) + packed
    try:
        engine_state.unpack(whole)
        engine_state.unpack(data)
    except GlovetrackError:
        pass


# ---- the glove


def decoder(data: bytes) -> None:
    """Bytes from a port, in pieces; the result must not depend on the division."""
    whole = FrameDecoder()
    frames = whole.feed(data)
    pieces, parts = FrameDecoder(), []
    for at in range(0, len(data), 7):
        parts += pieces.feed(data[at : at + 7])
    assert len(frames) == len(parts) == whole.counters.frames


def link(data: bytes) -> None:
    """Frames with correct checksums, u8 length each, through the whole link on a simulated
    clock."""
    port, before = _Port(data), -np.inf
    found = GloveLink(lambda: port, len(GLOVE.imus), clock=lambda: port.t)
    while port.left or port.in_waiting:
        for item in found.poll(0.0):
            if isinstance(item, ImuSample):
                assert item.t > before  # time is monotonic
                before = item.t
    found.close()


class _Port:
    """Returns one frame per read, 10 ms apart, and ignores commands."""

    def __init__(self, data: bytes) -> None:
        self.t, self.left = 20.0, [encode(Hello(1, len(GLOVE.imus)))]
        self.timeout: float | None = None
        self._rest, at = b"", 0
        while at < len(data) and len(self.left) < 400:
            body = data[at + 1 : at + 1 + data[at]]
            body += crc16(body).to_bytes(2, "little")
            self.left.append(cobs_encode(body) + b"\0")
            at += 1 + data[at]

    @property
    def in_waiting(self) -> int:
        return len(self._rest)

    def read(self, size: int) -> bytes:
        if not self._rest:
            self.t += 0.01
            self._rest = self.left.pop(0) if self.left else b""
        out, self._rest = self._rest[:size], self._rest[size:]
        return out

    def write(self, data: bytes) -> int | None:
        return len(data)

    def close(self) -> None:
        self.left = []


# ---- texts


def _text(parse: Callable[[str], object]) -> Callable[[bytes], None]:
    def target(data: bytes) -> None:
        try:
            parse(data.decode("utf-8", "replace"))
        except GlovetrackError as error:
            assert len(str(error)) < 2000

    return target


def _path(load: Callable[[Path], object], name: str) -> Callable[[bytes], None]:
    def target(data: bytes) -> None:
        with contextlib.suppress(GlovetrackError):
            load(_file(data, name))

    return target


TARGETS: dict[str, Callable[[bytes], None]] = {
    "container": container,
    "records": records,
    "messages": messages,
    "state": state,
    "decoder": decoder,
    "link": link,
    "hand": _text(parse_hand),
    "glove": _text(lambda text: parse_glove(text, HAND)),
    "colours": _text(parse_profile),
    "settings": _text(lambda text: from_toml(Settings, text)),
    "zed": _path(load_zed, "SN1.conf"),
    "table": _path(lambda path: read_table(path, "a"), "imu.csv"),
    "opencv": _path(lambda path: load_opencv_stereo([path], 640, 480), "stereo.yaml"),
}
