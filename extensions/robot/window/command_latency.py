"""``python -m extensions.robot.window.command_latency``: latency of motors and a robot.

Runs the demo (with ``--devices``: the configured devices) off-screen with a virtual object to touch
and a robot hand that follows, both visible, and records it. The latencies are computed from the
session (`tracker.session.latency`). Devices simulated by ``glovetrack rig`` run in another process
and do not load the window.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from app.storage.settings import SettingsStore
from app.window.headless_report import wait_until
from app.window.main_window import MainWindow
from app.window.pauses import keep_pauses_short
from app.window.sources import demo_factory, hardware_factory
from tracker.session.latency import latencies_of

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtWidgets import QApplication

from app.engines.demo_camera import DemoChoice, start_camera
from app.engines.protocols import RecordingRequest
from app.platform.process_tuning import tune_process
from app.window.contributions import panel_of
from extensions.applications.window.panel import ApplicationsPanel
from extensions.robot.window.panel import RobotPanel
from tracker.base.files import check_target
from tracker.base.terminal import add_force

if TYPE_CHECKING:
    from app.window.main_window import MainWindow

SIZE = (1440, 900)
START_TIMEOUT = 300.0
SETTLE_S = 5.0  # after the start: a process that has just begun takes the machine
THING = {"size": 0.2}  # m: so large that fingers which move at random are at its surface often
PARTS = ("touch", "robot")
SESSION, SETTINGS = "latency.mcap", "window.json"


def main(argv: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="command_latency", description=__doc__)
    parser.add_argument(
        "--seconds", type=float, default=60.0, help="duration of the recording (default: 60)"
    )
    parser.add_argument(
        "--fps",
        type=float,
        default=30.0,
        help="frame rate of the simulated camera, Hz (default: 30)",
    )
    parser.add_argument(
        "--devices", action="store_true", help="use the configured devices instead of the demo"
    )
    parser.add_argument("--motion", default="", help="hand motion, as for the demo")
    parser.add_argument("--only", choices=PARTS, default="", help="run only this part")
    parser.add_argument("--hidden", action="store_true", help="hide the panels of both parts")
    parser.add_argument("-o", "--output", type=Path, default=None, help="folder for the session")
    add_force(parser)
    args = parser.parse_args(argv)
    if args.output is not None:
        for name in (SESSION, SETTINGS):
            check_target(args.output / name, args.force)
    tune_process()
    app = QApplication.instance() or QApplication(["glovetrack"])
    app.setApplicationName("glovetrack")
    with tempfile.TemporaryDirectory() as folder:
        print(json.dumps(measure(args, args.output or Path(folder)), indent=2))
    return 0


def measure(args: argparse.Namespace, folder: Path) -> dict[str, Any]:
    """The latencies in the session, and statistics of the window."""

    choice = DemoChoice(args.fps, motion=args.motion)
    camera = None if args.devices else start_camera(choice=choice)

    folder.mkdir(parents=True, exist_ok=True)
    window = MainWindow(SettingsStore(folder / SETTINGS))
    window.resize(*SIZE)
    keep_pauses_short(window.host)
    window.show()
    path = folder / SESSION
    try:
        made = (
            hardware_factory(SettingsStore().value)
            if args.devices
            else demo_factory(choice, camera=camera)
        )
        window.host.open("devices" if args.devices else "demo", made)
        if not wait_until(lambda: window.host.running, START_TIMEOUT):
            raise SystemExit("The engine did not start.")
        _begin(window, [args.only] if args.only else PARTS, not args.hidden)
        wait_until(lambda: False, SETTLE_S)
        path.unlink(missing_ok=True)
        window.host.recording.begin(RecordingRequest(path, "", ""))
        ticks = window.ticker.ticks
        wait_until(lambda: False, args.seconds)
        drawn = (window.ticker.ticks - ticks) / args.seconds
        setup = window.host.setup
        values = dict(setup.tracked.status().values) if setup is not None else {}
        missed = panel_of(window.panels, RobotPanel).link.figures.tip
        window.host.stop()
        window.host.recording.wait()
    finally:
        window.close()
    shown = {k: round(v, 2) for k, v in values.items() if k.startswith("latency")}
    return {
        **latencies_of(path),
        "window_hz": round(drawn, 1),
        "stages_ms": shown,
        "application_missed": values.get("application_missed", 0.0),
        "robot": missed,
        "load": round(os.getloadavg()[0], 1) if hasattr(os, "getloadavg") else None,
    }


def _begin(window: MainWindow, parts: Sequence[str], shown: bool) -> None:
    """Let applications and robot run."""
    if "touch" in parts:
        if shown:
            window.show_panel("applications")
        panel_of(window.panels, ApplicationsPanel).choose("touch", THING)
    if "robot" in parts:
        if shown:
            window.show_panel("robot")
        link = panel_of(window.panels, RobotPanel).link
        problems: list[str] = []
        link.failed.connect(problems.append)
        link.switch(True)
        if not wait_until(lambda: link.view is not None or bool(problems), START_TIMEOUT):
            problems.append("The robot did not start.")
        if problems:
            raise SystemExit(" ".join(problems))


if __name__ == "__main__":
    sys.exit(main())
