"""The command ``teleop``: a robot hand that follows a session, a live stream or a script."""

from __future__ import annotations

import json
import socket
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

from extensions.robot.commands import TeleopArguments
from extensions.robot.driver import RobotDriver
from extensions.robot.finger_map import map_given
from extensions.robot.library import need_mujoco
from extensions.robot.payload import state_payload
from extensions.robot.pick_and_place import pick_and_place
from extensions.robot.settings import RobotSettings
from extensions.robot.teleop import Teleop
from extensions.robot.teleop_run import (
    DriveFigures,
    Watch,
    drive,
    drive_again,
    driver_of,
    write_driven,
)
from extensions.robot.wearer_hand import WearerHand, hand_from_message
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.base.files import check_target
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.messages import RobotState
from tracker.session.reader import SessionReader
from tracker.streaming.datagram import DatagramSocket
from tracker.streaming.publisher import LOOPBACK, StreamError


def teleoperate(args: TeleopArguments) -> int:
    """Drive the robot hand, or check a recorded drive."""
    given = [args.source is not None, args.listen is not None, args.simulate is not None]
    if sum(given) != 1:
        raise ConfigError(
            notice("option.exactly_one", options=("SESSION", "--listen", "--simulate"))
        )
    if args.source is None and (args.out or args.check):
        raise ConfigError(notice("option.requires", option="-o, --check", needed="SESSION"))
    check_json(args, [args.source] if args.source else [])
    need_mujoco()
    if args.source is not None:
        return (_check if args.check else _session)(args, args.source)
    if args.simulate is not None:
        return _script(args, args.simulate)
    return _live(args, args.listen or "")


def _settings(args: TeleopArguments, side: str) -> RobotSettings:
    return RobotSettings(
        model=args.model,
        fingers=map_given(args.fingers).text,
        side=args.side or side,
        objects=args.objects,
        motion_scale=args.motion_scale,
        reach_scale=args.reach_scale,
        clutch=args.clutch,
    )


def _check(args: TeleopArguments, source: Path) -> int:
    again = drive_again(source)
    same = again.different == 0 and again.compared > 0
    lines = [f"{again.robot}: {again.compared} states recomputed, {again.different} differ"]
    finish(args, asdict(again), lines, [source])
    return 0 if same else 1


def _session(args: TeleopArguments, source: Path) -> int:
    if args.out:
        check_target(args.out, args.force, [source])
    figures = DriveFigures()
    with SessionReader(source, watch=progress_line("driving")) as reader:
        driver = driver_of(reader, _settings(args, reader.info.side))
        with _StateSender(args.send, driver) as send:
            outputs = drive(reader, driver, figures, send)
            if args.out:
                write_driven(reader, args.out, outputs, args.force)
            else:
                for _ in outputs:
                    continue
    return _finish(args, driver, figures)


def _live(args: TeleopArguments, listen: str) -> int:
    driver = RobotDriver(Teleop(_settings(args, "right")))
    figures = DriveFigures()
    with _StateSender(args.send, driver) as send:
        follow_stream(driver, listen, args.seconds, figures, send)
    return _finish(args, driver, figures)


def _script(args: TeleopArguments, seed: int) -> int:
    driver = RobotDriver(Teleop(_settings(args, "right")))
    figures = DriveFigures()
    with _StateSender(args.send, driver) as send:
        result = pick_and_place(driver.teleop, seed, figures.count, send)
    outcome = "Cube placed" if result.placed else "Cube not placed"
    return _finish(args, driver, figures, [f"{outcome}, {result.off_mm:.0f} mm from its target."])


def _finish(
    args: TeleopArguments,
    driver: RobotDriver,
    figures: DriveFigures,
    more: Iterable[str] = (),
) -> int:
    report: dict[str, Any] = {"robot": driver.model.name, **figures.report()}
    lines = [f"{key.replace('_', ' '):<24}{_shown(value)}" for key, value in report.items()]
    finish(args, report, [*lines, *more], [args.source] if args.source else [])
    return 0


def _shown(value: Any) -> str:
    return f"{value:.2f}" if isinstance(value, float) else str(value)


class _StateSender:
    """Sends each state to the address given by --send, if any."""

    def __init__(self, target: str, driver: RobotDriver) -> None:
        self._driver = driver
        self._socket: DatagramSocket | None = None
        if target:
            host, colon, port = target.rpartition(":")
            if not colon or not port.isdecimal():
                raise ConfigError(notice("teleop.target", target=target))
            self._socket = DatagramSocket("robot", host, int(port))

    def __enter__(self) -> Callable[[RobotState], None]:
        return self.send

    def __exit__(self, *error: object) -> None:
        if self._socket is not None:
            self._socket.close()

    def send(self, state: RobotState) -> None:
        """Send one datagram; a receiver is not required."""
        if self._socket is not None:
            model = self._driver.model
            payload = state_payload(state, model.joint_names, model.objects)
            self._socket.send(json.dumps(payload, separators=(",", ":")).encode())


MOST_BYTES = 65536
POLL_EVERY = 0.25  # s between checks whether to stop

Latest = Callable[[], str | bytes | None]
"""Returns the newest of the waiting messages, or None after `POLL_EVERY` without one."""


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
        receiving.settimeout(POLL_EVERY)
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
        timeout = POLL_EVERY
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
