"""Drives a robot hand from a live stream (UDP or WebSocket)."""

from __future__ import annotations

import json
import socket
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from extensions.robot.driver import RobotDriver
from extensions.robot.teleop_run import DriveFigures, Watch
from extensions.robot.wearer_hand import WearerHand, hand_from_message
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import RobotState
from tracker.streaming.publisher import LOOPBACK, StreamError

MOST_BYTES = 65536
LOOK_EVERY = 0.25  # s between checks whether to stop

Latest = Callable[[], str | bytes | None]
"""Returns the newest of the waiting messages, or None after `LOOK_EVERY` without one."""


class StreamEnded(Exception):
    """The sender has closed the stream."""


def follow_stream(
    driver: RobotDriver, address: str, seconds: float, figures: DriveFigures, watch: Watch
) -> None:
    """Drive the robot for ``seconds`` after the first hand (0: until the stream ends).

    ``address``: the port of a UDP stream, or ws://HOST:PORT. Only the latest of several waiting
    hands is used. Raises StreamError if nothing can be received there, ConfigError for an invalid
    address.
    """
    began: float | None = None
    try:
        with _listening(address) as latest:
            while began is None or not seconds or monotonic() - began < seconds:
                wearer = _hand(latest())
                if wearer is None:
                    continue
                start = monotonic()
                began = start if began is None else began
                for message in driver.feed_hand(wearer):
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
        raise ConfigError(notice("teleop.address", address=address))


@contextmanager
def _datagrams(port: int) -> Iterator[Latest]:
    try:
        receiving = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        receiving.bind((LOOPBACK, port))
    except (OSError, OverflowError) as error:
        raise StreamError(notice("teleop.port", port=port, why=error)) from error

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
        from websockets.exceptions import ConnectionClosed  # deferred: an extra
        from websockets.sync.client import connect
    except ImportError as error:
        raise ConfigError(notice("option.packages", option="ws://", extra="streams")) from error
    try:
        connection = connect(url)
    except (OSError, ValueError) as error:
        raise StreamError(notice("stream.no_connection", stream=url, why=error)) from error

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


def _hand(data: str | bytes | None) -> WearerHand | None:
    """The hand in a message; None without a message or if it is not one of the live streams."""
    if data is None:
        return None
    try:
        message = json.loads(data)
        return hand_from_message(message) if isinstance(message, dict) else None
    except (ValueError, RecursionError):
        return None  # another program's message
