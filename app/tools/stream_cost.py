"""``python -m app.tools.stream_cost``: how much later poses are with all streams on.

The demo runs in the window, off-screen, with all panels visible; another process reads every
stream. Streams are switched on and off in turns, so that other load on the computer meets both.
Reported are sample to pose (from the arrival of a packet to its estimate), median and 99 %, without
and with streams, and the quotients: the median over the pairs of turns, and their range. The
program writes them as JSON.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import socket
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from PySide6.QtWidgets import QApplication

from app.engines.demo_camera import DemoChoice
from app.platform.process_tuning import tune_process
from app.storage.settings import SettingsStore
from app.tools import stream_readers
from app.tools.soak import SIZE, START_TIMEOUT, demo_job, is_tracked
from app.window.headless_report import wait_until
from app.window.main_window import MainWindow
from app.window.pauses import keep_pauses_short
from tracker.base.files import check_target, write_whole
from tracker.base.terminal import add_force

if TYPE_CHECKING:
    from app.window.main_window import MainWindow

NOT_HERE = ("opengloves",)  # a pipe of Windows
FIRST_PORT = 20_000
SETTLE_S = 2.0  # after switching, before a turn counts
SWITCH_WAIT = 120.0  # s for all streams to open or close, on a loaded computer
MEDIAN_SPAN = 4.0  # the latencies that the engine stores are those of so many seconds
MEDIAN, HIGH = "latency_imu_ms", "latency_imu_p99_ms"


class Processes(NamedTuple):
    """Whether each has a process of its own."""

    streams: bool
    tracking: bool


@dataclass
class StreamTurn:
    """ms, each the median over the turn; ``sent`` by stream."""

    median_ms: float
    p99_ms: float
    sent: dict[str, int] = field(default_factory=dict)


@dataclass
class Cost:
    """``off`` and ``on`` alternate. Quotients of on and off, and their least and largest."""

    streams: list[str]
    apart: Processes
    off: list[StreamTurn] = field(default_factory=list)
    on: list[StreamTurn] = field(default_factory=list)
    received: dict[str, int] = field(default_factory=dict)
    loads: list[float] = field(default_factory=list)
    median_ratio: float = float("nan")
    p99_ratio: float = float("nan")
    p99_ratio_range: tuple[float, float] = (float("nan"), float("nan"))

    def conclude(self) -> None:
        """Compute the quotients."""
        pairs = list(zip(self.off, self.on, strict=True))
        medians = [on.median_ms / off.median_ms for off, on in pairs]
        highs = [on.p99_ms / off.p99_ms for off, on in pairs]
        self.median_ratio = round(float(np.median(medians)), 3)
        self.p99_ratio = round(float(np.median(highs)), 3)
        self.p99_ratio_range = (round(min(highs), 3), round(max(highs), 3))


def main(argv: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="app.tools.stream_cost", description=__doc__)
    parser.add_argument("--turns", type=int, default=6, help="pairs of turns (default: 6)")
    parser.add_argument("--seconds", type=float, default=12.0, help="length of a turn, s")
    parser.add_argument("--fps", type=float, default=30.0, help="frame rate, Hz (default: 30)")
    parser.add_argument(
        "--together", action="store_true", help="streams in the window's process, not in their own"
    )
    parser.add_argument("--apart", action="store_true", help="track in a process of its own")
    parser.add_argument("--streams", default="", help="names with commas (default: all)")
    parser.add_argument("--json", type=Path, default=None, help="file for the results")
    add_force(parser)
    args = parser.parse_args(argv)
    if args.json is not None:
        check_target(args.json, args.force)
    tune_process()
    app = QApplication.instance() or QApplication(["glovetrack"])
    assert isinstance(app, QApplication)
    with tempfile.TemporaryDirectory() as folder:
        names = [name for name in args.streams.split(",") if name]
        turns = args.turns, args.seconds
        processes = Processes(not args.together, args.apart)
        cost = measure(turns, args.fps, names, processes, Path(folder))
    text = json.dumps(asdict(cost), indent=2)
    print(text)
    if args.json is not None:
        write_whole(args.json, text + "\n", args.force)
    return 0


def measure(
    turns: tuple[int, float], fps: float, names: Sequence[str], apart: Processes, folder: Path
) -> Cost:
    """Opens the demo in the window; ``turns``: their number and length (s); ``names``: the streams,
    all of them if it is empty."""
    factory = demo_job(DemoChoice(fps), apart.tracking)

    store = SettingsStore(folder / "window.json")
    store.update(job="all", sessions_folder=str(folder))
    window = MainWindow(store)
    window.resize(*SIZE)
    keep_pauses_short(window.host)
    window.show()
    known = [name for name in window.outputs.kinds if name not in NOT_HERE]
    try:
        window.host.open("demo", factory)
        window.outputs.apart = apart.streams
        return _alternate(window, Cost(list(names) or known, apart), *turns)
    finally:
        window.close()


def _alternate(window: MainWindow, cost: Cost, turns: int, seconds: float) -> Cost:
    if not wait_until(lambda: is_tracked(window), START_TIMEOUT):
        raise SystemExit("The demo did not find the hand.")
    ported = [name for name in cost.streams if window.outputs.kinds[name].has("port")]
    for name, port in zip(ported, _free_ports(len(ported)), strict=True):
        window.outputs.set_port(name, port)
    readers = _start_readers(window, cost.streams)
    wait_until(lambda: False, SETTLE_S)
    for k in range(turns):
        for on in (False, True) if k % 2 == 0 else (True, False):
            _switch(window, cost.streams, on)
            wait_until(lambda: False, SETTLE_S)
            (cost.on if on else cost.off).append(_turn(window, cost.streams, seconds))
            cost.loads.append(round(os.getloadavg()[0], 1))
    output, _ = readers.communicate("")
    cost.received = json.loads(output)
    _switch(window, cost.streams, False)
    cost.conclude()
    return cost


def _free_ports(count: int) -> list[int]:
    """Ports that no other program uses, by TCP, and below those from which the system connects: a
    reader that tries again and again would at some time connect to itself."""
    found: list[int] = []
    for port in range(FIRST_PORT + os.getpid() % 1000 * 10, 32768):
        with socket.socket() as sock, contextlib.suppress(OSError):
            sock.bind(("127.0.0.1", port))
            found.append(port)
        if len(found) == count:
            break
    return found


def _start_readers(window: MainWindow, names: Sequence[str]) -> subprocess.Popen[str]:
    ports = [f"{name}={window.outputs.port(name) or 0}" for name in names]
    command = [sys.executable, "-m", stream_readers.__name__, *ports]
    return subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )


def _switch(window: MainWindow, names: Sequence[str], on: bool) -> None:
    """Switch all streams, and wait until they are open or closed. Raises SystemExit."""
    outputs = window.outputs
    for name in names:
        outputs.switch(name, on)
    if not wait_until(
        lambda: all((outputs.counts(n) is not None) == on for n in names), SWITCH_WAIT
    ):
        raise SystemExit(f"The streams could not be switched: {outputs.problems}.")


def _turn(window: MainWindow, names: Sequence[str], seconds: float) -> StreamTurn:
    readings: list[tuple[float, float]] = []
    for _ in range(max(round(seconds / MEDIAN_SPAN), 1)):
        wait_until(lambda: False, MEDIAN_SPAN)
        setup = window.host.setup
        assert setup is not None
        values = setup.tracked.status().values
        readings.append((values[MEDIAN], values[HIGH]))
    median, high = np.median(readings, axis=0)
    counts = {name: window.outputs.counts(name) for name in names}
    sent = {name: found.sent for name, found in counts.items() if found is not None}
    return StreamTurn(round(float(median), 3), round(float(high), 3), sent)


if __name__ == "__main__":
    sys.exit(main())
