"""The command ``teleop``: a robot hand that follows a session, a live stream or a script."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Iterable
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from extensions.robot.library import SHADOW, need_mujoco
from tracker.base.command import Command
from tracker.base.errors import ConfigError
from tracker.base.files import check_target
from tracker.base.notices import notice
from tracker.base.terminal import add_json, check_json, finish, progress_line

if TYPE_CHECKING:
    from extensions.robot.driver import RobotDriver
    from extensions.robot.settings import RobotSettings
    from extensions.robot.teleop_run import DriveFigures
    from tracker.messages import RobotState


def add_teleop(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument("source", type=Path, nargs="?", metavar="IN", help="a session to follow")
    parser.add_argument("-o", "--out", type=Path, help="copy of the session with the robot added")
    parser.add_argument(
        "--check", action="store_true", help="drive the recorded robot again and compare"
    )
    parser.add_argument(
        "--listen",
        metavar="PORT|ws://HOST:PORT",
        help="follow a live stream over UDP or WebSocket until interrupted",
    )
    parser.add_argument(
        "--seconds",
        type=float,
        default=0.0,
        help="maximum duration of a live stream (0: unlimited)",
    )
    parser.add_argument(
        "--simulate",
        type=int,
        metavar="SEED",
        help="follow a simulated wearer who picks and places a cube",
    )
    parser.add_argument(
        "--send", default="", metavar="HOST:PORT", help="send robot states as JSON over UDP"
    )
    parser.add_argument(
        "--model",
        "--hand-model",
        default=SHADOW,
        help="robot hand: a name, or the path of an MJCF or URDF file",
    )
    add_fingers(parser)
    parser.add_argument(
        "--side",
        choices=("right", "left"),
        default="",
        help="side of the robot hand (default: the session's hand)",
    )
    parser.add_argument("--objects", default="cube,cylinder,ball", help="objects on the table")
    parser.add_argument(
        "--motion-scale", type=float, default=1.0, help="scale factor of the palm's motion"
    )
    parser.add_argument(
        "--reach-scale", type=float, default=1.0, help="scale factor of the fingers' reach"
    )
    parser.add_argument(
        "--clutch",
        choices=("none", "thumb_up", "point", "fist"),
        default="none",
        help="gesture that couples and uncouples the palm",
    )
    add_json(parser)


def add_fingers(parser: argparse.ArgumentParser) -> None:
    """The option for links of fingertips."""
    parser.add_argument(
        "--fingers",
        default="",
        metavar="FINGER=LINK,…|FILE.toml",
        help="links of the robot's fingertips (default: found automatically)",
    )


def teleoperate(args: argparse.Namespace) -> int:
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
    if args.check:
        return _check(args)
    if args.source is not None:
        return _session(args)
    return _live(args) if args.listen is not None else _script(args)


def _settings(args: argparse.Namespace, side: str) -> RobotSettings:
    from extensions.robot.finger_map import map_given
    from extensions.robot.settings import RobotSettings

    return RobotSettings(
        model=args.model,
        fingers=map_given(args.fingers).text,
        side=args.side or side,
        objects=args.objects,
        motion_scale=args.motion_scale,
        reach_scale=args.reach_scale,
        clutch=args.clutch,
    )


def _check(args: argparse.Namespace) -> int:
    from extensions.robot.teleop_run import drive_again

    again = drive_again(args.source)
    same = again.different == 0 and again.compared > 0
    lines = [f"{again.robot}: {again.compared} states recomputed, {again.different} differ"]
    finish(args, asdict(again), lines, [args.source])
    return 0 if same else 1


def _session(args: argparse.Namespace) -> int:
    from extensions.robot.teleop_run import DriveFigures, drive, driver_of, write_driven
    from tracker.session.reader import SessionReader

    if args.out:
        check_target(args.out, args.force, [args.source])
    figures = DriveFigures()
    with SessionReader(args.source, watch=progress_line("driving")) as reader:
        driver = driver_of(reader, _settings(args, reader.info.side))
        with _StateSender(args.send, driver) as send:
            outputs = drive(reader, driver, figures, send)
            if args.out:
                write_driven(reader, args.out, outputs, args.force)
            else:
                for _ in outputs:
                    continue
    return _finish(args, driver, figures)


def _live(args: argparse.Namespace) -> int:
    from extensions.robot.driver import RobotDriver
    from extensions.robot.teleop import Teleop
    from extensions.robot.teleop_live import follow_stream
    from extensions.robot.teleop_run import DriveFigures

    driver = RobotDriver(Teleop(_settings(args, "right")))
    figures = DriveFigures()
    with _StateSender(args.send, driver) as send:
        follow_stream(driver, args.listen, args.seconds, figures, send)
    return _finish(args, driver, figures)


def _script(args: argparse.Namespace) -> int:
    from extensions.robot.driver import RobotDriver
    from extensions.robot.pick_and_place import pick_and_place
    from extensions.robot.teleop import Teleop
    from extensions.robot.teleop_run import DriveFigures

    driver = RobotDriver(Teleop(_settings(args, "right")))
    figures = DriveFigures()
    with _StateSender(args.send, driver) as send:
        result = pick_and_place(driver.teleop, args.simulate, figures.count, send)
    outcome = "Cube placed" if result.placed else "Cube not placed"
    return _finish(args, driver, figures, [f"{outcome}, {result.off_mm:.0f} mm from its target."])


def _finish(
    args: argparse.Namespace,
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
        from tracker.streaming.datagram import DatagramSocket

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
        from extensions.robot.payload import state_payload

        if self._socket is not None:
            model = self._driver.model
            payload = state_payload(state, model.joint_names, model.objects)
            self._socket.send(json.dumps(payload, separators=(",", ":")).encode())


TELEOP = Command(
    "teleop",
    "drive a robot hand from a session or a live stream",
    teleoperate,
    add=add_teleop,
    extra="robot",
)
