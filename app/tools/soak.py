"""``python -m app.tools.soak``: checks for leaks of the window, and whether the demo keeps its
rate.

``--cycles 200`` opens and closes the window that often on an engine and looks for threads, timers
and memory left behind. ``--minutes 10`` runs the demo off-screen at full rate with everything
visible, then a while with the 3D view hidden; ``--hands both`` and ``--lenses one`` are the demo's.
``--drawn`` draws all images first, which then take no more of a processor than a real camera's, but
300 MB for each second. Both write what they measured as JSON.
"""

from __future__ import annotations

import argparse
import gc
import json
import os
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from multiprocessing import active_children
from pathlib import Path
from typing import TYPE_CHECKING

from app.window.sources import demo_factory

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
import psutil
from PySide6.QtCore import QCoreApplication, QEvent, Qt, QTimer
from PySide6.QtWidgets import QApplication

from app.engines.apart.demo import DemoSource
from app.engines.apart.process import EngineProcess
from app.engines.apart.setup import apart_factory
from app.engines.demo_camera import HANDS, LENSES, DemoChoice, start_camera
from app.engines.replay.engine import open_replay
from app.platform.process_tuning import collection_postponed, tune_process
from app.platform.tasks import JobProgress
from app.storage.settings import SettingsStore
from app.window.headless_report import wait_until
from app.window.main_window import MainWindow
from app.window.pauses import keep_pauses_short
from tracker.base.files import check_target, write_whole
from tracker.base.terminal import add_force
from tracker.messages import Tracking
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track

if TYPE_CHECKING:
    from app.window.main_window import MainWindow
    from app.window.sources import SetupFactory

STARTED = psutil.Process().create_time()
MB = 1e6
SIZE = (1440, 900)
FPS = 60.0
HIDDEN_S = 10.0  # with the 3D view hidden
STARTS_WITHIN = 10.0  # s of images more, for the search for the hand
SETTLE_CYCLES = 20  # after which memory should be constant
START_TIMEOUT = 300.0


@dataclass(frozen=True)
class Cycles:
    """Results of opening and closing: memory of this process in MB, and objects that remain after
    the last close."""

    cycles: int
    memory_mb: list[float]
    growth_mb_per_100: float
    threads_left: int
    timers_left: int
    windows_left: int


@dataclass
class Soak:
    """For the demo. ``memory_mb``: this process, at the start, each minute and the end."""

    minutes: float
    fps: float
    start_to_tracked_s: float = float("nan")
    memory_mb: list[float] = field(default_factory=list)
    camera_memory_mb: float = float("nan")  # the simulated camera's own process
    recorder_memory_mb: float = float("nan")  # its process, which waits
    refreshes_hz: float = float("nan")
    refreshes_hidden_3d_hz: float = float("nan")
    loop_gap_p99_ms: float = float("nan")  # between turns of the window's event loop
    loop_gap_most_ms: float = float("nan")
    imu_lost: float = float("nan")  # of all gloves
    frames_dropped: float = float("nan")
    images_hz: float = float("nan")  # that the camera gave, and of them those searched
    searched_hz: float = float("nan")
    tracked: dict[str, float] = field(default_factory=dict)  # share of the time, by side
    most_shed: int = 0  # of `tracker.messages.Shed`
    cores: dict[str, float] = field(default_factory=dict)  # processor time a second, by process
    latency_ms: dict[str, float] = field(default_factory=dict)
    load: float = float("nan")


def main(argv: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="app.tools.soak", description=__doc__)
    parser.add_argument(
        "--cycles", type=int, default=0, help="number of times to open and close the window"
    )
    parser.add_argument("--minutes", type=float, default=0.0, help="duration of the demo")
    parser.add_argument(
        "--fps", type=float, default=FPS, help="frame rate of the demo's camera, Hz (default: 60)"
    )
    parser.add_argument("--hands", choices=HANDS, default="right", help="hands in the demo")
    parser.add_argument(
        "--lenses", choices=LENSES, default="both", help="lenses of the demo's camera"
    )
    parser.add_argument(
        "--motion", default="", help="motion of the demo, such as show:touch, with its application"
    )
    parser.add_argument(
        "--drawn", action="store_true", help="render all images before the demo starts"
    )
    parser.add_argument("--apart", action="store_true", help="track in a process of its own")
    parser.add_argument("--json", type=Path, default=None, help="file for the results")
    add_force(parser)
    args = parser.parse_args(argv)
    if args.json is not None:
        check_target(args.json, args.force)
    tune_process()
    app = QApplication.instance() or QApplication(["glovetrack"])
    assert isinstance(app, QApplication)
    app.setApplicationName("glovetrack")
    figures: dict[str, object] = {}
    with tempfile.TemporaryDirectory() as folder, collection_postponed():
        if args.cycles:
            figures["cycles"] = asdict(cycle(app, args.cycles, Path(folder)))
        if args.minutes:
            choice = DemoChoice(args.fps, args.hands, lenses=args.lenses, motion=args.motion)
            found = soak(args.minutes, choice, Path(folder), args.drawn, args.apart)
            figures["soak"] = asdict(found)
    text = json.dumps(figures, indent=2)
    print(text)
    if args.json is not None:
        write_whole(args.json, text + "\n", args.force)
    return 0


def memory_mb() -> float:
    """Memory of this process, MB."""
    return round(psutil.Process().memory_info().rss / MB, 1)


# --- opening and closing


def cycle(app: QApplication, cycles: int, folder: Path) -> Cycles:
    """Open the window on a replayed session, let it draw, close it; again and again."""
    session = _session(folder)
    threads = threading.active_count()
    timers = _timers()
    memory = []
    for i in range(cycles):
        _open_and_close(app, folder, session)
        if i % 10 == 9 or i == cycles - 1:
            gc.collect()
            memory.append(memory_mb())
    settled = memory[SETTLE_CYCLES // 10 :] or memory
    return Cycles(
        cycles,
        memory,
        _slope(settled) * 10,
        threading.active_count() - threads,
        _timers() - timers,
        sum(w.isVisible() for w in app.topLevelWidgets()),
    )


def _slope(values: Sequence[float]) -> float:
    """Growth per value by the median of all pairs' slopes (Theil and Sen)."""
    n = len(values)
    slopes = [(values[j] - values[i]) / (j - i) for i in range(n) for j in range(i + 1, n)]
    return round(float(np.median(slopes)), 3) if slopes else 0.0


def _timers() -> int:
    gc.collect()
    return sum(issubclass(type(o), QTimer) for o in gc.get_objects())  # not of weak proxies


def _session(folder: Path) -> Path:
    """Two seconds of blobs and samples."""
    simulated, path = folder / "simulated.mcap", folder / "session.mcap"
    simulate(simulated, SimulateOptions(duration=2.0, fps=30.0, images=False))
    track(simulated, path, TrackOptions(with_sensors=True))
    return path


def _open_and_close(app: QApplication, folder: Path, session: Path) -> None:
    window = MainWindow(SettingsStore(folder / "window.json"))
    window.resize(*SIZE)
    window.show()
    window.host.adopt(open_replay(session, JobProgress(lambda *_: None)))
    end = time.monotonic() + 0.1
    while time.monotonic() < end:
        app.processEvents()
        time.sleep(0.005)
    window.close()
    window.deleteLater()
    # Outside an event loop, Qt deletes objects only on request.
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    app.processEvents()


# --- the demo


class LoopGaps:
    """How long the window's event loop let a timer of 5 ms wait. Starts when it is made."""

    PERIOD_MS = 5

    def __init__(self) -> None:
        self._gaps: list[float] = []
        self._last = time.monotonic()
        self._timer = QTimer()
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._note)
        self._timer.start(self.PERIOD_MS)

    def _note(self) -> None:
        now = time.monotonic()
        self._gaps.append(1e3 * (now - self._last))
        self._last = now

    def stop(self) -> tuple[float, float]:
        """The gap that 99 % are under, and the longest, ms. Not a number if it never turned."""
        self._timer.stop()
        if not self._gaps:
            return float("nan"), float("nan")
        gaps = np.array(self._gaps)
        return round(float(np.percentile(gaps, 99)), 1), round(float(gaps.max()), 1)


def soak(
    minutes: float, choice: DemoChoice, folder: Path, drawn: bool = False, apart: bool = False
) -> Soak:
    """The demo with everything visible for ``minutes``, then a while without the 3D view.
    ``apart``: tracked in a process of its own."""
    seconds = 60.0 * minutes + HIDDEN_S + STARTS_WITHIN
    images = round(choice.fps * seconds) if drawn else 0
    factory = demo_job(choice, apart, images)

    store = SettingsStore(folder / "window.json")
    store.update(job="all")  # the layout that shows the most panels
    window = MainWindow(store)
    window.resize(*SIZE)
    keep_pauses_short(window.host)
    window.show()
    try:
        window.host.open("demo", factory)
        return _watch(window, Soak(minutes, choice.fps))
    finally:
        window.close()


def demo_job(choice: DemoChoice, apart: bool, images: int = 0) -> SetupFactory:
    """Starts the demo's camera, or (``apart``) the process that tracks; returns the job that opens
    the demo. ``images`` are rendered before."""
    if not apart:
        camera = start_camera(choice=choice, drawn=images)

        return demo_factory(choice, camera=camera)

    source = DemoSource(choice, drawn=images)
    return apart_factory(source, EngineProcess(source))


def _watch(window: MainWindow, out: Soak) -> Soak:
    if not wait_until(lambda: is_tracked(window), START_TIMEOUT):
        raise SystemExit("The demo did not find the hand.")
    out.start_to_tracked_s = round(time.time() - STARTED, 2)
    out.memory_mb.append(memory_mb())
    before, began, gaps = window.ticker.ticks, time.monotonic(), LoopGaps()
    pace, cores = _Pace(window), _core_seconds()
    left = 60.0 * out.minutes
    while left > 0:
        wait_until(lambda: False, min(60.0, left))
        left -= 60.0
        out.memory_mb.append(memory_mb())
    lasted = time.monotonic() - began
    out.refreshes_hz = round((window.ticker.ticks - before) / lasted, 1)
    out.loop_gap_p99_ms, out.loop_gap_most_ms = gaps.stop()
    out.cores = {k: round((v - cores.get(k, 0.0)) / lasted, 2) for k, v in _core_seconds().items()}
    pace.tell(out)
    _take_status(window, out)
    window.docks["hand"].hide()
    before, began = window.ticker.ticks, time.monotonic()
    wait_until(lambda: False, HIDDEN_S)
    hidden = (window.ticker.ticks - before) / (time.monotonic() - began)
    out.refreshes_hidden_3d_hz = round(hidden, 1)
    return out


def is_tracked(window: MainWindow) -> bool:
    view = window.host.snapshot()
    if view is None or view.estimate is None:
        return False
    return bool(view.estimate.tracking == Tracking.TRACKING)


class _Pace:
    """Asks both hands how they are, twice a second from when it is made."""

    PERIOD_MS = 500

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._tracked: dict[str, list[bool]] = {}
        self._images: list[float] = []
        self._shed = 0
        self._dropped, self._began = self._now("frames_dropped"), time.monotonic()
        self._timer = QTimer()
        self._timer.timeout.connect(self._poll)
        self._timer.start(self.PERIOD_MS)

    def tell(self, out: Soak) -> None:
        """Report the results so far, and stop measuring."""
        self._timer.stop()
        lost = self._now("frames_dropped") - self._dropped
        out.images_hz = round(sum(self._images) / max(len(self._images), 1), 1)
        out.searched_hz = round(out.images_hz - lost / (time.monotonic() - self._began), 1)
        out.tracked = {k: round(sum(v) / len(v), 3) for k, v in self._tracked.items()}
        out.most_shed = self._shed

    def _now(self, name: str) -> float:
        view = self._window.host.snapshot()
        status = view.status if view is not None else None
        return status.values.get(name, 0.0) if status is not None else 0.0

    def _poll(self) -> None:
        setup = self._window.host.setup
        for hand in setup.hands if setup is not None else ():
            status = hand.tracked.status()
            known = status.tracking == Tracking.TRACKING
            self._tracked.setdefault(hand.side, []).append(known)
        self._images.append(self._now("frame_rate_hz"))
        self._shed = max(self._shed, int(self._now("load_shed")))


def _core_seconds() -> dict[str, float]:
    """Processor time (s) so far of this process and of each that it has started, by name."""
    held = {"window": time.process_time()}
    for child in active_children():
        process = psutil.Process(child.pid)
        held[child.name] = _seconds_of(process)
        for k, other in enumerate(process.children(recursive=True)):
            held[f"{child.name} {k}"] = _seconds_of(other)
    return held


def _seconds_of(process: psutil.Process) -> float:
    times = process.cpu_times()
    return float(times.user + times.system)


def _lost(window: MainWindow) -> float:
    """Packets of all gloves that are missing."""
    setup = window.host.setup
    hands = setup.hands if setup is not None else ()
    return sum(hand.tracked.status().values.get("imu_lost", float("nan")) for hand in hands)


def _take_status(window: MainWindow, out: Soak) -> None:
    view = window.host.snapshot()
    values = view.status.values if view is not None and view.status is not None else {}
    out.imu_lost = _lost(window)
    out.frames_dropped = values.get("frames_dropped", float("nan"))
    out.latency_ms = {k: round(v, 2) for k, v in values.items() if k.startswith("latency")}
    held = {c.name: psutil.Process(c.pid).memory_info().rss / MB for c in active_children()}
    out.camera_memory_mb = round(held.get("glovetrack-camera", float("nan")), 1)
    out.recorder_memory_mb = round(held.get("glovetrack-recorder", float("nan")), 1)
    out.load = round(os.getloadavg()[0], 1) if hasattr(os, "getloadavg") else float("nan")


if __name__ == "__main__":
    sys.exit(main())
