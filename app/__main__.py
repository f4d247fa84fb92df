"""``python -m app``: the window; with ``--headless-report`` the same window off-screen."""

from __future__ import annotations

import argparse
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QApplication

from app.engines.demo_camera import start_camera
from app.platform.process import prepare_process
from app.platform.screen import NO_SCREEN, do_without, has_screen
from resources import folder
from tracker import __version__
from tracker.errors import GlovetrackError
from tracker.streaming.params import STREAMS, StreamParams, with_streams

if TYPE_CHECKING:
    from app.platform.crash import CrashWatch
    from app.platform.single_instance import Instance


def main(argv: Sequence[str] | None = None) -> int:
    """Open the window; returns the exit status."""
    parser = _parser()
    args = parser.parse_args(sys.argv[1:] if argv is None else list(argv))
    try:
        args.streams = with_streams(StreamParams(), args.stream, args.stream_host)
    except GlovetrackError as error:
        parser.error(str(error))
    if not has_screen():
        if args.headless_report is None:
            print(NO_SCREEN, file=sys.stderr)
            return 1
        do_without()
    prepare_process()
    app = QApplication.instance() or QApplication(["glovetrack"])
    assert isinstance(app, QApplication)
    app.setApplicationName("glovetrack")
    app.setApplicationDisplayName("Glovetrack")
    app.setApplicationVersion(__version__)
    app.setDesktopFileName("glovetrack")
    app.setWindowIcon(QIcon(str(folder("icons") / "glovetrack.svg")))
    if args.headless_report is not None:
        camera = start_camera(fps=args.fps)  # before the window is even imported
        from app.tools.report import headless_report

        return headless_report(app, args.headless_report, args.out, args.fps, camera, args.streams)
    return _run(app, args)


def _run(app: QApplication, args: argparse.Namespace) -> int:
    from app.platform.crash import CrashWatch, log_folder, log_to_file
    from app.platform.single_instance import Instance, hand_over

    if not args.demo and hand_over(args.session):
        return 0  # the window that is open has it now
    log_to_file(log_folder())
    crashes, instance = CrashWatch(log_folder()), Instance()
    try:
        return _show(app, args, crashes, instance)
    finally:
        instance.close()
        crashes.end()


def _show(
    app: QApplication, args: argparse.Namespace, crashes: CrashWatch, instance: Instance
) -> int:
    camera = start_camera(fps=args.fps) if args.demo else None
    from app.window.main_window import MainWindow

    window = MainWindow(crashes=crashes)
    instance.asked.connect(window.take_over)
    # Ctrl+C closes the window as a click does: the file is finished, the devices are freed. The
    # window's own timer gives Python the chance to see the signal.
    signal.signal(signal.SIGINT, lambda *_: window.close())
    window.outputs.use(args.streams)
    window.show()
    if args.demo:
        window.start_demo(args.fps, camera)
    elif args.session is not None:
        window.open_session(args.session)
    return app.exec()


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="glovetrack", description="The Glovetrack window.")
    parser.add_argument("session", nargs="?", type=Path, help="a session file to replay")
    parser.add_argument("--demo", action="store_true", help="start the simulated glove and camera")
    parser.add_argument(
        "--stream",
        default="",
        metavar="NAME[:PORT],…",
        help=f"outputs to turn on for this run: {', '.join(STREAMS)}",
    )
    parser.add_argument("--stream-host", default="", metavar="HOST", help="to or at which address")
    parser.add_argument("--fps", type=float, default=30.0, help="of the simulated camera")
    parser.add_argument(
        "--headless-report",
        type=float,
        metavar="SECONDS",
        default=None,
        help="run so long by itself, with or without a screen, and leave a report in --out",
    )
    parser.add_argument("--out", type=Path, default=Path("demo"), help="folder of the report")
    return parser


if __name__ == "__main__":
    sys.exit(main())
