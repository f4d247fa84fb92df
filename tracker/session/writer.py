"""Records a session. Called from one thread; callers that must not block queue their messages."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from types import TracebackType

from tracker.base.clock import seconds
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import DiskError, free_bytes, whole_file
from tracker.base.notices import notice, warning
from tracker.messages import CameraPose, EngineState, Estimate, Message, StereoFrame
from tracker.session import engine_state
from tracker.session.description import METADATA, SessionInfo
from tracker.session.encode import Arrivals, Encoder, ImageCoding, Out, status_name
from tracker.session.images import PackedFrame
from tracker.session.mcap.container import COMPRESSION, McapOutput
from tracker.session.mcap.disk import automatic_path
from tracker.session.mcap.input import RawMessage
from tracker.session.rigs import CAMERA, shutter_record
from tracker.session.ros import motion, topics
from tracker.vision.rig import StereoRig

IMAGES = ("jpeg", "png", "none")
GB = 1e9


@dataclass(frozen=True)
class RecorderParams:
    """``images``: jpeg, png (lossless) or none (only blobs)."""

    images: str = "jpeg"
    jpeg_quality: int = 90
    compression: str = "lz4"  # or zstd, none
    chunk_bytes: int = 64 * 1024
    chunk_s: float = 0.4  # at most this and the chunk being written is lost by a kill
    warn_free_gb: float = 5.0
    stop_free_gb: float = 1.0
    check_disk_s: float = 2.0
    sync: bool = True  # synchronise with the disk, against loss of power
    sync_in_thread: bool = False  # in a thread of its own: writing does not wait for the disk


@dataclass(frozen=True)
class RecorderStatus:
    """The status for display. ``warning`` is a sentence or empty."""

    path: Path
    size_bytes: int
    messages: int
    frames: int
    frames_thinned: int
    free_bytes: int
    warning: str


def load_describer() -> Callable[[SessionInfo], str]:
    """Imports the description of the hand, with scipy, which takes a second. A process that waits
    for a recording calls this in advance, so that the first second is not lost."""
    from tracker.session.export.urdf import robot_description  # deferred: loads SciPy

    return robot_description


class SessionRecorder:
    """Writes one session to ``path``, a new file, or a new name in it if it is a folder.

    Raises FileError if the file exists or cannot be written, and from `write` if the disk fills up
    or is disconnected; the file is then closed and whole.
    """

    def __init__(
        self,
        path: Path,
        info: SessionInfo,
        params: RecorderParams | None = None,
        free: Callable[[Path], int] = free_bytes,
    ) -> None:
        self.params = _checked(params or RecorderParams())
        path = Path(path)
        if path.is_dir():
            path = automatic_path(path, info.anchor.wall_ns, info.participant)
        self.path, self.info, self._measure_free = path, info, free
        self._free = free(path.parent)
        self._messages = self._frames = self._omitting_images = 0
        if path.parent.is_dir():
            _check_room(self._free, self.params, self.path.parent, started=False)
        self._out: McapOutput | None = self._open()
        coding = ImageCoding(self.params.images, self.params.jpeg_quality)
        self._arrivals = Arrivals()
        self._encoders = {
            hand.side: Encoder(hand, coding, status_name(info, hand.side), self._arrivals)
            for hand in info.hands
        }
        self._encoder = self._encoders[""] = self._encoders[info.side]
        self._next_check = info.anchor.wall_ns
        self._guarded(self._write_start)

    def _open(self) -> McapOutput:
        p = self.params
        chunk_ns = round(p.chunk_s * 1e9)
        sync = (p.sync, p.sync_in_thread)
        return McapOutput(self.path, p.compression, p.chunk_bytes, chunk_ns, *sync)

    def _write_start(self, out: McapOutput) -> None:
        now = self.info.anchor.wall_ns
        out.metadata(METADATA, self.info.metadata())
        for name, text in self.info.attachments().items():
            out.attach(name, text, now)
        if self.info.rig is not None and self.info.rig.line_time:
            out.metadata(CAMERA, shutter_record(self.info.rig))
        if self.info.rig is not None:
            self._put(out, self._encoder.rig(self.info.rig, seconds(self.info.anchor.monotonic_ns)))
        self._put(out, _descriptions(self.info, now))
        out.close_chunk()

    @property
    def status(self) -> RecorderStatus:
        problem = ""
        if self._free < self.params.warn_free_gb * GB:
            low = {"free_gb": self._free / GB, "folder": self.path.parent}
            problem = str(warning("recording.disk_low", **low))
        size = self._out.size if self._out else _size_on_disk(self.path)
        return RecorderStatus(
            self.path,
            size,
            self._messages,
            self._frames,
            self._omitting_images,
            self._free,
            problem,
        )

    @property
    def closed(self) -> bool:
        return self._out is None

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool:
        """Writes one message. While ``overloaded``, images are left out and counted: returns False.

        ``side``: the hand of the message, in a session of both.

        FrameResult is not written: it can be computed from the others.
        """
        if isinstance(message, StereoFrame):
            self._omitting_images += overloaded
            self._frames += not overloaded
            if overloaded:
                return False
        if isinstance(message, EngineState):
            self.write_state(message.t, engine_state.pack(message.engine, message.state))
        else:
            self._guarded(lambda out: self._put(out, self._encoders[side].encoded(message)))
        return True

    def arrived(self, t: float) -> None:
        """The measurement from which the next estimates follow arrived at ``t`` s, in a session
        that does not contain it."""
        self._arrivals.add(self.info.anchor.wall(t))

    def write_state(self, t: float, data: bytes) -> None:
        """An EngineState, packed by `tracker.session.engine_state`."""
        name, kind, when = engine_state.NAME, engine_state.MEDIA_TYPE, self.info.anchor.wall(t)
        self._guarded(lambda out: out.attach_bytes(name, kind, data, when))

    def flush(self) -> None:
        """Does nothing: messages are in the file or the current chunk."""

    def write_packed(self, frame: PackedFrame) -> None:
        """Images that are compressed already, byte for byte."""
        self._frames += 1
        self._guarded(lambda out: self._put(out, self._encoder.packed_images(frame)))

    def write_camera(
        self, t: float, t_arrival: float, pose: CameraPose, exact: bool = True
    ) -> None:
        """Writes the camera's pose at an exposure, once; ``exact``: also without rounding."""
        self._guarded(
            lambda out: self._put(out, self._encoder.camera_pose(t, t_arrival, pose, exact))
        )

    def write_truth(self, truth: Estimate, side: str = "") -> None:
        """Writes the true pose of a simulated hand."""
        self._guarded(lambda out: self._put(out, self._encoders[side].truth(truth)))

    def copy(self, message: RawMessage, kind: str) -> None:
        """Writes a message of another session, of the ROS type ``kind``, byte for byte."""
        out = Out(message.topic, kind, message.log_time, message.publish_time, message.data)
        self._guarded(lambda output: self._put(output, iter([out])))

    def attach(self, name: str, media_type: str, data: bytes, when: int) -> None:
        """Writes an attachment that is not in ``info``; ``when``: ns since 1970."""
        self._guarded(lambda out: out.attach_bytes(name, media_type, data, when))

    def write_rig(self, rig: StereoRig, t: float) -> None:
        """Writes a calibration that is valid from ``t`` on."""
        before = 0.0 if self.info.rig is None else self.info.rig.line_time
        self.info = replace(self.info, rig=rig)
        if rig.line_time != before:
            record = shutter_record(rig, self.info.anchor.wall(t))
            self._guarded(lambda out: out.metadata(CAMERA, record))
        self._guarded(lambda out: self._put(out, self._encoder.rig(rig, t)))

    def _put(self, out: McapOutput, messages: Iterator[Out]) -> None:
        for m in messages:
            channel = out.channel(m.topic, m.type)
            out.write(channel, m.log_time, m.stamp, m.data, m.sequence)
            self._messages += 1
            if m.log_time >= self._next_check:
                self._next_check = m.log_time + round(self.params.check_disk_s * 1e9)
                self._free = self._measure_free(self.path.parent)
                _check_room(self._free, self.params, self.path.parent, bool(self._messages))

    def _guarded(self, work: Callable[[McapOutput], None]) -> None:
        """Calls ``work``; if the disk fails, closes the file and raises."""
        if self._out is None:
            raise FileError(notice("recording.has_ended", path=self.path))
        try:
            work(self._out)
        except DiskError:
            out, self._out = self._out, None
            out.abandon()  # every chunk in it is whole; `recover` writes the index elsewhere
            raise
        except FileError:
            self.close()
            raise

    def close(self) -> None:
        """Finish the file. Calling it again does nothing."""
        if self._out is None:
            return
        out, self._out = self._out, None
        out.finish()

    def __enter__(self) -> SessionRecorder:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


@contextmanager
def new_session(
    path: Path,
    info: SessionInfo,
    force: bool = False,
    inputs: Sequence[Path] = (),
    params: RecorderParams | None = None,
) -> Iterator[SessionRecorder]:
    """A recorder for a file that is generated, not recorded: whole or absent at the end.

    Nothing is lost if the disk fills up, so no space is reserved. Raises FileError
    as `tracker.base.files.whole_file` does.
    """
    params = replace(params or RecorderParams(), sync=False, stop_free_gb=0.0)
    with whole_file(path, force, inputs) as part, SessionRecorder(part, info, params) as recorder:
        yield recorder


def _size_on_disk(path: Path) -> int:
    return path.stat().st_size if path.exists() else 0


def _checked(p: RecorderParams) -> RecorderParams:
    if p.images not in IMAGES:
        raise ConfigError(notice("recording.images", known=IMAGES, value=p.images))
    if p.compression not in COMPRESSION:
        raise ConfigError(notice("recording.compression", known=COMPRESSION, value=p.compression))
    if not 1 <= p.jpeg_quality <= 100:
        raise ConfigError(notice("recording.jpeg_quality", quality=p.jpeg_quality))
    return p


def _descriptions(info: SessionInfo, now: int) -> Iterator[Out]:
    """The hands as robots' models, for programs that draw the joints of the session."""
    robot_description = load_describer()
    for hand in info.hands:
        topic = topics.description(hand.side, not info.others)
        data = motion.pack_string(robot_description(hand))
        yield Out(topic, motion.STRING, now, now, data)


def _check_room(free: float, params: RecorderParams, folder: Path, started: bool) -> None:
    """Raises FileError if fewer than the necessary bytes are ``free`` in the folder."""
    if free >= params.stop_free_gb * GB:
        return
    left = f"{free / 1e6:.0f} MB"
    if started:
        raise FileError(notice("recording.disk_full_stopped", folder=folder, left=left))
    raise FileError(notice("recording.disk_full", folder=folder, left=left))
