"""Sources of the hand for applications without a window: a session, the simulator, a stream."""

from __future__ import annotations

import json
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tracker.base.clock import ClockAnchor
from tracker.base.errors import ConfigError, FileError, GlovetrackError
from tracker.base.notices import notice
from tracker.engine.pipeline import Pipeline
from tracker.glove import library
from tracker.messages import Array, Estimate, ImuSample, Message, Tracking, Validity
from tracker.offline.simulate import SimulateOptions, truth_message
from tracker.offline.simulate import build as build_simulation
from tracker.session.decode import Decoded
from tracker.session.description import SessionInfo, describe
from tracker.session.reader import SessionReader
from tracker.streaming.payload import SCHEMAS
from tracker.streaming.publisher import LOOPBACK, Names, StreamError
from tracker.streaming.udp import DEFAULT_PORT

SILENCE = 3.0  # s without data after which a stream has ended
TIMEOUT = 30.0  # s, timeout for the first hand of a stream


class HandSource(NamedTuple):
    """Information about a session, and its messages including estimates."""

    info: SessionInfo
    messages: Iterator[Message | Decoded]


@contextmanager
def recorded(path: Path, side: str = "") -> Iterator[HandSource]:
    """The messages of a session with the estimates of one hand; ``side`` selects one of two, the
    default is the main hand. Raises FileError if the session does not contain that hand."""
    with SessionReader(path, side=side if sides_of(path) else "") as reader:
        if side and reader.info.side != side:
            raise FileError(notice("applications.no_side", path=path, side=side))
        yield HandSource(reader.info, reader.packed_messages())


def sides_of(path: Path) -> tuple[str, ...]:
    """The hands of a session with both; empty for a single hand. Raises FileError."""
    with SessionReader(path) as reader:
        return reader.sides


def simulated(options: SimulateOptions, on_truth: bool) -> HandSource:
    """A simulated wearer, tracked or, with ``on_truth``, with the true hand."""
    simulation, info = build_simulation(options)

    def messages() -> Iterator[Message]:
        pipeline = Pipeline(simulation.hand, simulation.glove, simulation.rig)
        for message in simulation.feed():
            if message.t > options.duration:
                return
            yield message
            if not isinstance(message, ImuSample):
                pipeline.feed_frame(message)  # type: ignore[arg-type]
            elif on_truth:
                yield truth_message(message.t, simulation.truth(message.t), info)
            else:
                yield pipeline.feed_imu(message)

    return HandSource(info, messages())


def streamed(address: str, glove_name: str = "") -> HandSource:
    """Estimates of a live stream: ``udp:PORT``, or ``ws://host:port``.

    Raises ConfigError for an invalid address; iterating raises StreamError if none arrives.
    """
    texts = library.texts(glove_name or library.DEFAULT_GLOVE, None)
    info = describe(*texts, ClockAnchor(0, 0))
    names = Names.of(info.hand, info.glove)
    texts_of = _websocket(address) if address.startswith("ws://") else _udp(address)

    def messages() -> Iterator[Estimate]:
        for text in texts_of:
            yield from_json(text, names, len(info.hand.segments))

    return HandSource(info, messages())


def _udp(address: str) -> Iterator[bytes]:
    kind, _, port = address.partition(":")
    if kind != "udp" or (port and not port.isdecimal()):
        raise ConfigError(notice("applications.address", address=address))
    return _datagrams(int(port or DEFAULT_PORT))


def _datagrams(port: int) -> Iterator[bytes]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listener:
        listener.bind((LOOPBACK, port))
        timeout = TIMEOUT
        try:
            while True:
                listener.settimeout(timeout)
                data, timeout = listener.recv(65536), SILENCE
                yield data
        except TimeoutError as error:
            _need_some(timeout, f"port {port}", error)


def _need_some(timeout: float, where: str, error: Exception) -> None:
    """Raises StreamError if a stream ends before its first estimate."""
    if timeout == TIMEOUT:
        raise StreamError(notice("applications.no_hand", where=where, wait_s=TIMEOUT)) from error


def _websocket(address: str) -> Iterator[str | bytes]:
    try:
        from websockets.exceptions import ConnectionClosed  # deferred: an extra
        from websockets.sync.client import connect
    except ImportError as error:
        raise ConfigError(notice("option.packages", option="ws://", extra="streams")) from error
    try:
        connection = connect(address)
    except OSError as error:
        raise ConfigError(notice("applications.no_server", address=address, why=error)) from error
    with connection:
        timeout = TIMEOUT
        try:
            while True:
                data, timeout = connection.recv(timeout), SILENCE
                yield data
        except (TimeoutError, ConnectionClosed) as error:
            _need_some(timeout, address, error)


def from_json(text: str | bytes, names: Names, segments: int) -> Estimate:
    """The estimate in a message of our keypoints; ``segments`` is how many the hand has, whose
    poses are not sent (NaN). Raises GlovetrackError for anything else."""
    try:
        data = json.loads(text)
        if data["schema"] not in SCHEMAS or data["side"] != names.side:
            raise GlovetrackError(notice("stream.other_hand"))
        points = [data["keypoints"].get(n, {}) for n in names.keypoints]
        angles = [data["angles"].get(n, {}) for n in names.angles]
        return Estimate(
            t=float(data["t"]),
            tracking=Tracking[data["tracking"].upper()],
            keypoints=np.array([_numbers(p.get("position"), 3) for p in points]),
            keypoint_q=np.array([_numbers(p.get("orientation_xyzw"), 4) for p in points]),
            keypoint_state=np.array([_state(p) for p in points], np.int64),
            keypoint_sd=np.array([_numbers(p.get("sd"), 1) for p in points])[:, 0],
            angles=np.array([_numbers(a.get("value"), 1) for a in angles])[:, 0],
            angle_state=np.array([_state(a) for a in angles], np.int64),
            segment_R=np.full((segments, 3, 3), np.nan),
            segment_p=np.full((segments, 3), np.nan),
        )
    except (ValueError, KeyError, TypeError, AttributeError, IndexError) as error:
        raise GlovetrackError(notice("stream.not_ours", why=repr(error))) from error


def _numbers(value: Any, many: int) -> Array:
    """(many,); NaN where there is null."""
    if value is None:
        return np.full(many, np.nan)
    out = np.atleast_1d(np.array(value, float))
    if out.shape != (many,):
        raise ValueError(f"{many} numbers were expected")
    return out


def _state(entry: dict[str, Any]) -> int:
    return int(Validity[str(entry.get("state", "lost")).upper()])
