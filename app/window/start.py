"""The start of the window; with ``--headless-report`` the same window off-screen."""

from __future__ import annotations

import argparse
import os
import signal
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QApplication, QWidget

from app.engines.demo_camera import HANDS, LENSES, SCENES, DemoChoice, start_camera
from app.platform.process_tuning import tune_process
from app.platform.screens import PLATFORM, has_screen
from resources import folder
from tracker import __version__
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.base.toml_reader import read_text
from tracker.sensors.protocol import BAUDS
from tracker.streaming.connection import ConnectionSettings
from tracker.streaming.publisher import JOINT_SETS
from tracker.streaming.registry import StreamSettings, stream_kinds, with_streams
from tracker.streaming.remote.registry import door_kinds, with_doors

if TYPE_CHECKING:
    from app.platform.crash import CrashWatch
    from app.platform.single_instance import Instance
    from app.storage.settings import SettingsStore

NO_SCREEN = (
    "The window cannot open because no display is available: neither DISPLAY nor WAYLAND_DISPLAY "
    "refers to a running display server.\n"
    "Without a display, use `glovetrack demo --headless-report 20` or another command "
    "(see the README)."
)

SingleShot = Qt.ConnectionType.SingleShotConnection

ENDS = ("SIGINT", "SIGTERM", "SIGHUP")
"""Of Ctrl+C, of a logout or a shutdown, and of a terminal that is closed."""


def open_window(argv: Sequence[str]) -> int:
    """Open the window with these words of the command line; returns the exit status."""
    parser = _parser()
    args = parser.parse_args(argv)
    try:
        args.streams = with_streams(
            StreamSettings(), args.stream, args.stream_host, args.stream_joints
        )
        with_doors(ConnectionSettings(), args.remote, args.remote_host)
        if args.wearer is not None:
            read_text(args.wearer)
        if args.headless_report is not None:
            _check_headless(args)
    except GlovetrackError as error:
        parser.error(str(error))
    if not has_screen():
        if args.headless_report is None:
            print(NO_SCREEN, file=sys.stderr)
            return 1
        do_without()
    tune_process()
    app = QApplication.instance() or QApplication(["glovetrack"])
    assert isinstance(app, QApplication)
    app.setApplicationName("glovetrack")
    app.setApplicationVersion(__version__)
    app.setDesktopFileName("glovetrack")
    app.setWindowIcon(QIcon(str(folder("icons") / "glovetrack.svg")))
    try:
        return _run(app, args) if args.headless_report is None else _report(args)
    except GlovetrackError as error:
        print(f"glovetrack: {error}", file=sys.stderr)
        return 1


def _check_headless(args: argparse.Namespace) -> None:
    """Raises ConfigError for options that such a run does not have."""
    if args.session is not None:
        raise ConfigError("--headless-report cannot be used with a session.")
    if not 0.0 < args.headless_report < float("inf"):
        raise ConfigError("--headless-report requires a number of seconds greater than 0.")


def _report(args: argparse.Namespace) -> int:
    from app.window.report_files import check_report

    check_report(args.out, args.force)
    # a camera to be simulated starts before the window is even imported
    camera = None if args.devices else start_camera(choice=_demo(args))
    from app.storage.settings import SettingsStore
    from app.window.headless_report import Connected, Watched, headless_report
    from app.window.sources import demo_factory, hardware_factory

    settings = SettingsStore().value
    if args.baud is not None:
        settings = replace(settings, baud=args.baud)
    watched = Watched("devices", hardware_factory(settings))
    if camera is not None:
        watched = Watched("demo", demo_factory(_demo(args), camera=camera))
    connected = Connected(args.streams, args.remote, args.remote_host)
    return headless_report(args.headless_report, args.out, watched, connected, args.wearer)


def _run(app: QApplication, args: argparse.Namespace) -> int:
    from app.platform.compiling import compile_before_start
    from app.platform.crash import CrashWatch, log_folder, log_to_file
    from app.platform.single_instance import Instance, hand_over
    from app.platform.translation import install
    from app.storage.settings import SettingsStore

    if not args.demo and hand_over(args.session):
        return 0  # the window that is open has it now
    store = SettingsStore()
    install(app, store.value.language)
    compile_before_start(app)
    log_to_file(log_folder())
    crashes, instance = CrashWatch(log_folder()), Instance()
    try:
        return _show(app, args, store, crashes, instance)
    finally:
        instance.close()
        crashes.end()


def _show(
    app: QApplication,
    args: argparse.Namespace,
    store: SettingsStore,
    crashes: CrashWatch,
    instance: Instance,
) -> int:
    camera = start_camera(choice=_demo(args)) if args.demo else None
    from app.window.main_window import MainWindow
    from app.window.pauses import keep_pauses_short

    window = MainWindow(store, crashes)
    instance.asked.connect(window.sources.take_over)
    close_when_told(window)
    keep_pauses_short(window.host)
    window.outputs.use(args.streams)
    window.remote.use(args.remote, args.remote_host)
    instance.answer = window.remote.answers.answer_line
    window.sources.baud = args.baud
    if args.wearer is not None:
        window.calibration.profiles.begin_with(args.wearer)
    window.show()
    if args.demo:
        if _demo(args).uses_application:  # once the layout of watching is there
            window.host.opened.connect(lambda _setup: window.show_panel("applications"), SingleShot)
        window.sources.open_demo(_demo(args), camera)
    elif args.session is not None:
        window.sources.open_session(args.session)
    elif args.devices:
        window.sources.open_devices()
    return app.exec()


def _demo(args: argparse.Namespace) -> DemoChoice:
    return DemoChoice(args.fps, args.hands, args.motion, args.lenses, args.scene)


def close_when_told(window: QWidget) -> None:
    """Let signals close the window as a click does: the file is finished, the devices are freed.

    A signal comes amid whatever Python does, which may hold a lock that closing needs: the window
    is closed in the next turn of its loop. Its own timer gives Python the chance to see signals.
    """
    for name in ENDS:
        if hasattr(signal, name):  # not every system has all of them
            number = getattr(signal, name)
            signal.signal(number, lambda *_: QTimer.singleShot(0, window, window.close))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="glovetrack", description="Open the Glovetrack window.")
    parser.add_argument("session", nargs="?", type=Path, help="session to replay")
    parser.add_argument("--demo", action="store_true", help="start a simulated glove and camera")
    parser.add_argument(
        "--devices", action="store_true", help="connect to the glove and the camera"
    )
    parser.add_argument(
        "--baud",
        type=int,
        choices=BAUDS,
        default=None,
        help="baud rate of the glove for this run (default: from the settings)",
    )
    parser.add_argument(
        "--stream",
        default="",
        metavar="NAME[:PORT],…",
        help=f"streams to enable for this run: {', '.join(stream_kinds())}",
    )
    parser.add_argument(
        "--stream-host",
        default="",
        metavar="HOST",
        help="destination or listening address of the streams",
    )
    parser.add_argument(
        "--stream-joints",
        default="",
        choices=("", *JOINT_SETS),
        metavar="|".join(JOINT_SETS),
        help="joints to stream: Glovetrack's keypoints, or OpenXR's 26 joints",
    )
    parser.add_argument(
        "--remote",
        default="",
        metavar="NAME[:PORT],…",
        help=f"enable remote control for this run: {', '.join(door_kinds())}",
    )
    parser.add_argument(
        "--remote-host", default="", metavar="HOST", help="listening address for remote control"
    )
    parser.add_argument(
        "--wearer",
        type=Path,
        metavar="FILE",
        help="import this wearer's profile and use it from the start",
    )
    parser.add_argument(
        "--fps",
        type=float,
        default=30.0,
        help="frame rate of the simulated camera, Hz (default: 30)",
    )
    parser.add_argument(
        "--hands", choices=HANDS, default="right", help="hands to simulate in the demo"
    )
    parser.add_argument(
        "--motion",
        default="",
        help="hand motion in the demo: a recording, or show:NAME for an application",
    )
    parser.add_argument(
        "--lenses",
        choices=LENSES,
        default="both",
        help="lenses of the simulated camera, or none for no camera",
    )
    parser.add_argument(
        "--scene",
        choices=SCENES,
        default="auto",
        help="background in the demo; auto: a desk if the computer can render it fast enough",
    )
    parser.add_argument(
        "--headless-report",
        type=float,
        metavar="SECONDS",
        default=None,
        help="run without a window for this long and write a report to --out",
    )
    parser.add_argument(
        "--out", type=Path, default=Path("demo"), help="folder for the report (default: demo)"
    )
    parser.add_argument("--force", action="store_true", help="overwrite an earlier report")
    return parser


def do_without() -> None:
    """Qt paints into memory."""
    os.environ[PLATFORM] = "offscreen"
