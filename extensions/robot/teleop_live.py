"""A robot hand that follows a live stream, by UDP or from a WebSocket."""

from __future__ import annotations

import json
import socket
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from extensions.robot.driver import RobotDriver
from extensions.robot.teleop_run import DriveFigures, Watch
from extensions.robot.worn import WornHand, from_payload
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.messages import RobotState
from tracker.streaming.publisher import LOOPBACK, StreamError

MOST_BYTES = 65536
LOOK_EVERY = 0.25  # s, whether it is over

Latest = Callable[[], str | bytes | None]
"""The newest message of what waits, after `LOOK_EVERY` at most; None where there is none."""


class StreamEnded(Exception):
    """Nothing more will come."""


def follow_stream(
    driver: RobotDriver, address: str, seconds: float, figures: DriveFigures, watch: Watch
) -> None:
    """Until ``seconds`` have passed since the first hand, 0: until it is stopped, or has ended.

    ``address``: a port that UDP comes to, or ws://HOST:PORT. Of hands that wait the latest counts.
    Raises StreamError where nothing can be heard there, ConfigError for another address.
    """
    began: float | None = None
    try:
        with _listening(address) as latest:
            while began is None or not seconds or monotonic() - began < seconds:
                worn = _hand(latest())
                if worn is None:
                    continue
                start = monotonic()
                began = start if began is None else began
                for message in driver.feed_worn(worn):
                    if isinstance(message, RobotState):
                        figures.count(message, driver.teleop.fingers.error, monotonic() - start)
                        watch(message)
    except StreamEnded:
        return


@contextmanager
def _listening(address: str) -> Iterator[Latest]:
    if address.startswith("ws://"):
        with _websocket(address) as latest:
            yield latest
    elif address.isdecimal():
        with _datagrams(int(address)) as latest:
            yield latest
    else:
        raise ConfigError(f"A robot listens to a port or to ws://HOST:PORT, not to {address!r}.")


@contextmanager
def _datagrams(port: int) -> Iterator[Latest]:
    try:
        receiving = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        receiving.bind((LOOPBACK, port))
    except (OSError, OverflowError) as error:
        raise StreamError(f"Nothing can be received at port {port}: {error}.") from error

    def latest() -> bytes | None:
        data: bytes | None = None
        receiving.settimeout(LOOK_EVERY)
        try:
            while True:
                data = receiving.recv(MOST_BYTES)
                receiving.settimeout(0.0)
        except (TimeoutError, BlockingIOError):
            return data

    with receiving:
        yield latest


@contextmanager
def _websocket(url: str) -> Iterator[Latest]:
    try:
        from websockets.exceptions import ConnectionClosed
        from websockets.sync.client import connect
    except ImportError as error:
        raise ConfigError('A WebSocket needs: pip install "glovetrack[streams]".') from error
    try:
        connection = connect(url)
    except (OSError, ValueError) as error:
        raise StreamError(f"Nothing answers at {url}: {error}.") from error

    def latest() -> str | bytes | None:
        data: str | bytes | None = None
        timeout = LOOK_EVERY
        try:
            while True:
                data, timeout = connection.recv(timeout), 0.0
        except TimeoutError:
            return data
        except ConnectionClosed as error:
            raise StreamEnded from error

    with connection:
        yield latest


def _hand(data: str | bytes | None) -> WornHand | None:
    """None where nothing came, or what came is no hand of ours."""
    if data is None:
        return None
    try:
        said = json.loads(data)
        return from_payload(said) if isinstance(said, dict) else None
    except (ValueError, RecursionError):
        return None  # somebody else's message
