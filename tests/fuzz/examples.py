"""Valid inputs as a starting point for a fuzzer."""

from __future__ import annotations

import json
import struct
import tempfile
from pathlib import Path

import numpy as np

from tracker.base.config import to_toml
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove import library
from tracker.messages import BlobFrame, Event, ImuSample, Message, Status, Tracking
from tracker.sensors.protocol import GloveStatus, Hello, Samples, cobs_decode, encode
from tracker.session.description import SessionInfo
from tracker.session.mcap.container import McapOutput
from tracker.session.mcap.input import McapInput
from tracker.session.writer import RecorderParams, SessionRecorder
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

ZED = """[LEFT_CAM_HD]
fx = 700.8
fy = 700.8
cx = 665.4
cy = 371.9
k1 = -0.174
[RIGHT_CAM_HD]
fx=698.7
fy=698.7
cx=640.1
cy=375.1
k2=0.025
[STEREO]
Baseline=62.8
TY=-0.08
CV_HD=0.0099
"""
TABLE = """Timestamp (us),Gyroscope X (deg/s),Accelerometer Z (g),packet,sampled [ns],arrived [ns]
1000,1.5,0.9,1,2000000000000000000,2000000000000000100
11000,,1.0,,3,4
"""
STAMP = 1_760_000_000 * 10**9  # ns, of messages
MAGIC, DATA_END = b"\x89MCAP0\r\n", 0x0F
MATRIX = """{0}: !!opencv-matrix
   rows: {1}
   cols: {2}
   dt: d
   data: [ {3} ]
"""


def session(info: SessionInfo, path: Path, duration: float = 0.3) -> Path:
    """A short recording with its estimates, at ``path``."""
    motion = RandomPostures(info.hand, 1, duration=duration)
    sim = Simulation(info.hand, info.glove, motion, 1, fps=30)
    pipeline, found = Pipeline(info.hand, info.glove, sim.rig), list[Message]()
    for m in sim.feed():
        found.append(m)
        if isinstance(m, ImuSample):
            found.append(pipeline.feed_imu(m))
        elif isinstance(m, BlobFrame):
            pipeline.feed_frame(m)
    t = found[-1].t
    found += [pipeline.calibration(), Event(t, "note", "x"), Status(t, Tracking.LOST, {"a": 1.0})]
    with SessionRecorder(path, info, RecorderParams(sync=False)) as recorder:
        for m in found:
            recorder.write(m)
    return path


def topics_of(info: SessionInfo) -> list[tuple[str, str, bytes]]:
    """Name, type and a message of every topic of a recording."""
    with tempfile.TemporaryDirectory() as folder:
        source = McapInput(session(info, Path(folder) / "a.mcap"))
        first: dict[str, tuple[str, str, bytes]] = {}
        for i in range(len(source.contents.spans)):
            for m in source.messages_in(source.contents.spans[i]):
                first.setdefault(m.topic, (m.topic, m.type, bytes(m.data)))
        source.close()
    return [first[name] for name in sorted(first)]


def begun(info: SessionInfo) -> bytes:
    """A file with its description, and no messages yet."""
    whole = _plain(info, [])
    at = len(MAGIC)
    while whole[at] != DATA_END:
        at += 9 + int.from_bytes(whole[at + 1 : at + 9], "little")
    return whole[:at]


def _plain(info: SessionInfo, topics: list[tuple[str, str, bytes]]) -> bytes:
    """A file without compression, in which every byte matters."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.mcap"
        out = McapOutput(path, sync=False)
        out.metadata("glovetrack", info.metadata())
        for name, text in info.attachments().items():
            out.attach(name, text, 0)
        for topic, kind, data in topics:
            stamp = info.anchor.wall_ns
            out.write(out.channel(topic, kind), stamp, stamp, data, 0)
        out.finish()
        return path.read_bytes()


def _records(topics: list[tuple[str, str, bytes]]) -> bytes:
    """Schemas, channels and messages, as in a chunk."""
    out = b""
    for k, (topic, kind, data) in enumerate(topics):
        name, schema = topic.encode(), kind.encode()
        body = struct.pack("<HI", k + 1, len(schema)) + schema + struct.pack("<I", 7) + b"ros2msg"
        out += _record(3, body + struct.pack("<I", 0))
        body = struct.pack("<HHI", k + 1, k + 1, len(name)) + name + struct.pack("<I", 3) + b"cdr"
        out += _record(4, body + struct.pack("<I", 0))
        out += _record(5, struct.pack("<HIQQ", k + 1, 0, STAMP, STAMP) + data)
    return out


def _record(kind: int, body: bytes) -> bytes:
    return bytes([kind]) + struct.pack("<Q", len(body)) + body


def _state() -> bytes:
    header = {
        "engine": "chain",
        "arrays": [["float64", [3]], ["bool", [2, 2]]],
        "state": {
            "record": "camera_tilt",
            "has": {
                "bias": {"array": 0},
                "last": None,
                "rotations": [{"tuple": [1, {"number": 1.0, "type": "float64"}]}],
            },
        },
    }
    text = json.dumps(header).encode()
    return struct.pack("<I", len(text)) + text + np.arange(3.0).tobytes() + bytes(4)


def _frames(imus: int) -> list[bytes]:
    raw = np.full((imus, 6), 2048, np.int16)
    frames = [encode(Hello(1, imus)), encode(GloveStatus(1, 3700, 0, 127))]
    return frames + [encode(Samples(k, 10_000 * k, raw + k)) for k in range(20)]


def _opencv() -> str:
    eye = "1., 0., 0., 0., 1., 0., 0., 0., 1."
    out = "%YAML:1.0\n---\n"
    for name in ("K1", "K2"):
        out += MATRIX.format(name, 3, 3, "700., 0., 320., 0., 700., 240., 0., 0., 1.")
    for name in ("D1", "D2"):
        out += MATRIX.format(name, 1, 5, "0.1, 0., 0., 0., 0.")
    return out + MATRIX.format("R", 3, 3, eye) + MATRIX.format("T", 3, 1, "-0.12, 0., 0.")


def examples(name: str, info: SessionInfo, topics: list[tuple[str, str, bytes]]) -> list[bytes]:
    """Inputs that the named target reads without an error."""
    if name == "container":
        return [_plain(info, topics)]
    if name == "records":
        return [_records(topics)]
    if name == "messages":
        return [
            b"".join(bytes([k]) + struct.pack("<H", len(t[2])) + t[2] for k, t in enumerate(topics))
        ]
    if name == "state":
        return [_state()]
    if name in ("decoder", "link"):
        frames = _frames(len(info.glove.imus))
        bodies = [cobs_decode(f[:-1])[:-2] for f in frames]
        return [b"".join(frames if name == "decoder" else [bytes([len(b)]) + b for b in bodies])]
    if name == "colours":
        return [library.text("colours", library.DEFAULT_COLOURS).encode()]
    texts = {
        "hand": info.hand_text,
        "glove": info.glove_text,
        "settings": to_toml(Settings()),
        "zed": ZED,
        "opencv": _opencv(),
        "table": TABLE,
    }
    return [texts[name].encode()]
