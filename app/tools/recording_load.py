"""``python -m app.tools.recording_load``: the cost of recording, and whether anything is left out.

Runs the demo off-screen with everything visible, without and with a recording, at each of
``--fps``, and writes what it measured as JSON: images left out, refreshes of the window, latency,
and the processor's time of each process and thread, which means something on a busy machine too.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import psutil
from PySide6.QtWidgets import QApplication

from app.engines.demo_camera import DemoChoice, start_camera
from app.engines.protocols import RecordingRequest
from app.platform.process_tuning import tune_process
from app.storage.settings import SettingsStore
from app.window.headless_report import wait_until
from app.window.main_window import MainWindow
from app.window.sources import demo_factory
from tracker.base.files import check_target, write_whole
from tracker.base.terminal import add_force

if TYPE_CHECKING:
    from app.window.main_window import MainWindow

SIZE = (1440, 900)
START_TIMEOUT = 300.0
SETTLE_S = 3.0  # after the start, and after the recording has begun


@dataclass
class Load:
    """For one stretch. Processor's time in s per second, of processes and of the window's threads.

    ``left_out``: images of the stretch that are not in the file.
    """

    fps: float
    recorded: bool
    refreshes_hz: float = float("nan")
    images_hz: float = float("nan")
    left_out: float = float("nan")
    imu_lost: float = float("nan")
    latency_ms: dict[str, float] = field(default_factory=dict)
    processes: dict[str, float] = field(default_factory=dict)
    threads: dict[str, float] = field(default_factory=dict)
    machine_load: float = float("nan")


def main(argv: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="app.tools.recording_load", description=__doc__)
    parser.add_argument(
        "--seconds", type=float, default=60.0, help="duration of each measurement (default: 60)"
    )
    parser.add_argument(
        "--fps",
        type=float,
        nargs="+",
        default=[30.0, 60.0],
        help="camera frame rates to measure, Hz (default: 30 60)",
    )
    parser.add_argument("--json", type=Path, default=None, help="file for the results")
    add_force(parser)
    args = parser.parse_args(argv)
    if args.json is not None:
        check_target(args.json, args.force)
    tune_process()
    app = QApplication.instance() or QApplication(["glovetrack"])
    app.setApplicationName("glovetrack")
    with tempfile.TemporaryDirectory() as folder:
        loads = [x for fps in args.fps for x in measure(fps, args.seconds, Path(folder))]
    text = json.dumps([asdict(load) for load in loads], indent=2)
    print(text)
    if args.json is not None:
        write_whole(args.json, text + "\n", args.force)
    return 0


def measure(fps: float, seconds: float, folder: Path) -> list[Load]:
    """The demo, first without a recording, then while it records."""
    camera = start_camera(choice=DemoChoice(fps))

    store = SettingsStore(folder / "window.json")
    store.update(job="all")  # the layout that shows the most panels
    window = MainWindow(store)
    window.resize(*SIZE)
    window.show()
    try:
        window.host.open("demo", demo_factory(DemoChoice(fps), camera=camera))
        if not wait_until(lambda: window.host.running, START_TIMEOUT):
            raise SystemExit("The demo did not start.")
        wait_until(lambda: False, SETTLE_S)
        out = [_stretch(window, Load(fps, False), seconds)]
        window.host.recording.begin(RecordingRequest(folder / f"{fps:g}.mcap", "", ""))
        wait_until(lambda: False, SETTLE_S)
        return [*out, _stretch(window, Load(fps, True), seconds)]
    finally:
        window.close()


def _stretch(window: MainWindow, out: Load, seconds: float) -> Load:
    before, began, ticks = _times(), time.monotonic(), window.ticker.ticks
    values = _status(window)
    wait_until(lambda: False, seconds)
    passed = time.monotonic() - began
    out.refreshes_hz = round((window.ticker.ticks - ticks) / passed, 1)
    for mine, now, then in zip((out.processes, out.threads), _times(), before, strict=True):
        mine |= {k: round((v - then.get(k, 0.0)) / passed, 3) for k, v in now.items()}
    now = _status(window)
    out.images_hz = round(now.get("frame_rate_hz", float("nan")), 1)
    out.left_out = now.get("pictures_thinned", 0.0) - values.get("pictures_thinned", 0.0)
    out.imu_lost = now.get("imu_lost", 0.0) - values.get("imu_lost", 0.0)
    out.latency_ms = {k: round(v, 2) for k, v in now.items() if k.startswith("latency")}
    out.machine_load = round(os.getloadavg()[0], 1) if hasattr(os, "getloadavg") else float("nan")
    return out


def _status(window: MainWindow) -> dict[str, float]:
    setup = window.host.setup
    return dict(setup.tracked.status().values) if setup is not None else {}


def _times() -> tuple[dict[str, float], dict[str, float]]:
    """s of the processor so far: of the program's processes, of this one's threads."""
    me = psutil.Process()
    processes = {"window": _cpu(me)}
    for child in multiprocessing.active_children():
        processes[child.name.removeprefix("glovetrack-")] = _cpu(psutil.Process(child.pid))
    names = {t.native_id: t.name for t in threading.enumerate()}
    threads: dict[str, float] = {}
    for t in me.threads():
        name = names.get(t.id, "others")
        threads[name] = threads.get(name, 0.0) + t.user_time + t.system_time
    return processes, threads


def _cpu(process: psutil.Process) -> float:
    times = process.cpu_times()
    return float(times.user + times.system)


if __name__ == "__main__":
    sys.exit(main())
