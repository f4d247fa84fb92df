"""The window off-screen for some seconds: a session, an export, a screenshot and a short report."""

from __future__ import annotations

import os
import sys
import time
from collections import defaultdict, deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QBuffer, QByteArray, QEventLoop, QIODevice, QTimer

from app.engines.engine_host import SetupFactory
from app.engines.protocols import RecordingRequest
from app.engines.snapshot import Snapshot
from app.jobs.export import ExportRequest, export_job
from app.platform.tasks import JobProgress
from app.storage.settings import SettingsStore
from app.viewmodels.log import words_of
from app.window.main_window import MainWindow
from app.window.pauses import keep_pauses_short
from app.window.report_files import make_room
from tracker.base.errors import FileError, GlovetrackError
from tracker.base.files import write_whole
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Array, Event, Tracking
from tracker.session.recover import needs_recovery
from tracker.streaming.registry import StreamSettings

START_TIMEOUT = 600.0  # s; the first start compiles the kernels, slowly on a loaded machine
SAMPLE_MS = 50
NOT_PRINTED = ("pulse", "gesture")  # kinds of events that come many times a second
SCREENSHOT_AFTER = 0.6
"""Share of the time after which an image of a tracked hand is taken as soon as there is one."""


@dataclass
class Figures:
    """Samples collected while the window runs."""

    error: list[Array] = field(default_factory=list)  # (4,) m
    states: deque[int] = field(default_factory=deque)


class Watched(NamedTuple):
    """The source that the window shows: its name, and the factory of its engine."""

    name: str
    make: SetupFactory


class Connected(NamedTuple):
    """Interfaces for other programs: streams, and the names and address of remote control."""

    streams: StreamSettings
    remote: str = ""
    remote_host: str = ""


def headless_report(
    duration: float,
    out: Path,
    watched: Watched,
    connected: Connected,
    wearer: Path | None = None,
) -> int:
    """Run what is ``watched`` for ``duration`` s of tracking and write its results to ``out``,
    where those of an earlier report are deleted. ``wearer`` is the profile to begin with.

    Raises DiskError.
    """
    make_room(out)
    with TemporaryDirectory(prefix="glovetrack-") as folder:
        window = MainWindow(SettingsStore(Path(folder) / "window.json"))
        window.resize(1440, 900)
        window.set_theme("dark")
        keep_pauses_short(window.host)
        window.outputs.use(connected.streams)
        window.remote.use(connected.remote, connected.remote_host)
        if wearer is not None:
            window.calibration.profiles.begin_with(wearer)
        window.show()
        try:
            return _run(window, duration, out, watched)
        finally:
            window.close()


def _run(window: MainWindow, duration: float, out: Path, watched: Watched) -> int:
    problems: list[str] = []
    window.tasks.failed.connect(problems.append)
    window.host.error.connect(problems.append)
    window.host.happened.connect(_EventPrinter())
    window.host.open(watched.name, watched.make)
    wait_until(lambda: window.host.running or bool(problems), START_TIMEOUT)
    if not window.host.running:
        print(f"The {watched.name} did not start: {' '.join(problems) or 'it took too long.'}")
        return 1
    path, table = out / "session.mcap", out / "session.csv"
    window.host.recording.begin(RecordingRequest(path, watched.name, "as they come"))
    began, ticks = time.monotonic(), window.ticker.ticks
    gathered = _gather(window, duration, out / "window.png", problems)
    rate = (window.ticker.ticks - ticks) / (time.monotonic() - began)
    view = window.host.snapshot()
    window.host.stop()
    window.host.recording.wait()
    problems += _ended_early(window.host.recording.ended_by, path)
    if path.exists():
        try:
            export_job(ExportRequest(path, "csv", table))(JobProgress(lambda _f, _t: None))
        except GlovetrackError as error:  # devices that sent nothing
            problems.append(str(error))
    print(_report(gathered, view, rate, path))
    print("\n".join(problems), end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


def _ended_early(why: str, path: Path) -> list[str]:
    """The problem to report for a recording that ended because of ``why``; empty: none."""
    if not why:
        return []
    again = f"`glovetrack recover {path}` recovers what was recorded."
    return [f"{why} {again}" if path.exists() and needs_recovery(path) else why]


class _EventPrinter:
    """Prints events as they happen, with the time since the start in s: by the end of the report it
    is too late to change the files of the wrong glove."""

    def __init__(self) -> None:
        self._began = time.monotonic()

    def __call__(self, event: Event) -> None:
        text = words_of(event)
        if text and event.kind not in NOT_PRINTED:
            late = time.monotonic() - self._began
            print(f"{late:6.1f} s  {text}", file=sys.stderr, flush=True)


def wait_until(done: Callable[[], bool], timeout: float) -> bool:
    """Run the event loop until ``done()``, at most ``timeout`` s; returns whether it was done.

    ``done`` is called once per turn, because a tracked hand may be lost again.
    """
    loop, poll = QEventLoop(), QTimer()
    end = time.monotonic() + timeout
    was_done = False

    def look() -> None:
        nonlocal was_done
        was_done = done()
        if was_done or time.monotonic() > end:
            loop.quit()

    poll.timeout.connect(look)
    poll.start(20)
    loop.exec()
    poll.stop()
    return was_done


def _gather(
    window: MainWindow, duration: float, image: Path, problems: list[str]
) -> dict[str, Figures]:
    """Sample the engine for ``duration`` s; returns the figures of each hand by its side."""
    began = time.monotonic()
    sampler = QTimer()
    gathered: dict[str, Figures] = defaultdict(Figures)
    taken = False

    def sample() -> None:
        nonlocal taken
        view = window.host.snapshot()
        if view is None:
            return
        for hand in view.hands:
            _take(hand, gathered[hand.setup.side])
        late = time.monotonic() - began > SCREENSHOT_AFTER * duration
        if late and not taken and all(_is_tracked(hand) for hand in view.hands):
            taken = True
            _save(window, image, problems)

    sampler.timeout.connect(sample)
    sampler.start(SAMPLE_MS)
    wait_until(lambda: False, duration)
    sampler.stop()
    if not taken:
        _save(window, image, problems)
    return gathered


def _save(window: MainWindow, image: Path, problems: list[str]) -> None:
    """Save an image of the window as a PNG, in one step."""
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    window.grab().save(buffer, "PNG")
    try:
        write_whole(image, bytes(data.data()))
    except FileError as error:
        problems.append(str(error))


def _is_tracked(view: Snapshot) -> bool:
    return view.estimate is not None and view.estimate.tracking == Tracking.TRACKING


def _take(view: Snapshot, figures: Figures) -> None:
    estimate = view.estimate
    if estimate is None:
        return
    figures.states.append(int(estimate.tracking))
    truth = view.truth()
    if truth is not None:
        names = view.setup.glove.keypoint_names(view.setup.hand)
        rows = [names.index(k) for k in MARKED_KEYPOINTS if k in names]
        delta = estimate.keypoints[rows] - truth.keypoints[rows]
        if np.isfinite(delta).all():
            figures.error.append(np.linalg.norm(delta, axis=1))


def _report(gathered: Mapping[str, Figures], view: Snapshot | None, rate: float, path: Path) -> str:
    values = view.status.values if view is not None and view.status is not None else {}
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")

    def figure(key: str, pattern: str = "{:.1f}") -> str:
        return pattern.format(values[key]) if key in values else "–"

    stages = ["detect", "filter", "imu", "total"]
    stages += [s for s in ("screen", "stream") if f"latency_{s}_ms" in values]
    latency = [
        f"{s} {figure(f'latency_{s}_ms')} (99 %: {figure(f'latency_{s}_p99_ms')})" for s in stages
    ]
    lines = [
        f"rates        glove {figure('imu_rate_hz')} Hz, camera {figure('frame_rate_hz')} Hz, "
        f"estimates {figure('estimate_rate_hz')} Hz, window {rate:.1f} Hz",
        f"latency ms   {', '.join(latency)}",
        f"losses       {figure('imu_lost', '{:.0f}')} packets, "
        f"{figure('frames_dropped', '{:.0f}')} images not searched, "
        f"{figure('pictures_thinned', '{:.0f}')} images not recorded",
        *_lines_of_hands(gathered, view),
        f"session      {_session_text(path)}",
        f"machine      {os.cpu_count()} cores, load {load:.1f}",
    ]
    return "\n".join(lines)


def _session_text(path: Path) -> str:
    if not path.exists():
        return "not recorded"
    tables = sorted(table.name for table in path.parent.glob(f"{path.stem}*.csv"))
    return ", ".join([f"{path} ({path.stat().st_size / 1e6:.1f} MB)", *(tables or ["no table"])])


def _lines_of_hands(gathered: Mapping[str, Figures], view: Snapshot | None) -> list[str]:
    """How well each hand was tracked; two are named, with the packets that they lost."""
    lost = {}
    for hand in view.hands if view is not None and len(view.hands) > 1 else ():
        values = hand.status.values if hand.status is not None else {}
        lost[hand.setup.side] = f", {values.get('imu_lost', 0):.0f} packets lost"
    lines = []
    for side, figures in sorted(gathered.items()):
        tracked = _share(figures, Tracking.TRACKING)
        located = _share(figures, Tracking.TRACKING, Tracking.COASTING)
        name = f"{side} hand: " if side in lost else ""
        lines += [
            f"tracking     {name}{100 * tracked:.0f} % of the time, position known "
            f"{100 * located:.0f} %{lost.get(side, '')}",
            f"error        {name}{_error_text(figures)}",
        ]
    return lines


def _share(figures: Figures, *states: Tracking) -> float:
    """Share of the time spent in one of ``states``."""
    return sum(s in states for s in figures.states) / max(1, len(figures.states))


def _error_text(figures: Figures) -> str:
    if not figures.error:
        return "no estimate with a position"
    errors = 1000 * np.array(figures.error)
    each = ", ".join(
        f"{k} {m:.1f}" for k, m in zip(MARKED_KEYPOINTS, errors.mean(axis=0), strict=True)
    )
    return f"{errors.mean():.1f} mm on average ({each}), median {np.median(errors):.1f} mm"
