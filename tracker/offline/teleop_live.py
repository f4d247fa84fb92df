"""A robot hand that follows a live stream by UDP."""

from __future__ import annotations

import json
import socket

from tracker.clock import monotonic
from tracker.messages import RobotState
from tracker.offline.teleop import DriveFigures, Watch
from tracker.robot.driver import RobotDriver
from tracker.robot.worn import WornHand, from_payload
from tracker.streaming.publisher import LOOPBACK, StreamError

MOST_BYTES = 65536
LOOK_EVERY = 0.25  # s, whether it is over


def follow_stream(
    driver: RobotDriver, port: int, seconds: float, figures: DriveFigures, watch: Watch
) -> None:
    """Until ``seconds`` have passed since the first hand, 0: until it is stopped.

    Of hands that wait the latest counts. Raises StreamError where the port cannot be had.
    """
    try:
        receiving = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        receiving.bind((LOOPBACK, port))
    except (OSError, OverflowError) as error:
        raise StreamError(f"Nothing can be received at port {port}: {error}.") from error
    began: float | None = None
    with receiving:
        while began is None or not seconds or monotonic() - began < seconds:
            receiving.settimeout(LOOK_EVERY)
            worn = _latest(receiving)
            if worn is None:
                continue
            start = monotonic()
            began = start if began is None else began
            for message in driver.feed_worn(worn):
                if isinstance(message, RobotState):
                    figures.count(message, driver.teleop.fingers.error, monotonic() - start)
                    watch(message)


def _latest(receiving: socket.socket) -> WornHand | None:
    """The newest hand of what waits; None where none comes or it is no hand of ours."""
    data: bytes | None = None
    try:
        while True:
            data = receiving.recv(MOST_BYTES)
            receiving.settimeout(0.0)
    except (TimeoutError, BlockingIOError):
        if data is None:
            return None
    try:
        said = json.loads(data)
        return from_payload(said) if isinstance(said, dict) else None
    except (ValueError, RecursionError):
        return None  # somebody else's datagram
