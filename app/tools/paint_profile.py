"""``python -m app.tools.paint_profile``: the processor time that a refresh of the window takes.

The demo runs off-screen with all panels visible. Once the hand is tracked, the window's timer is
stopped and panels are refreshed and painted one at a time, so that each has its own row: time of
its refresh, of its painting, and how much of both was spent in compiled code that does not hold
Python's lock. What remains is when the engine may have to wait. Its sum counts panels with a longer
period as rarely as they are refreshed in a window of `RATE`. Times are processor times of the
window's thread and barely depend on other load; the quotient with a fixed loop of Python hardly
depends on the computer. Printed as a table, and as JSON with ``--json``.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QApplication

from app.engines.demo_camera import HANDS, DemoChoice, start_camera
from app.platform.process_tuning import tune_process
from app.storage.settings import SettingsStore
from app.tools.soak import SIZE, START_TIMEOUT, is_tracked
from app.viewmodels import hand_skin
from app.widgets import curve_canvas, image_canvas
from app.widgets.view3d.raster import scene
from app.window.headless_report import wait_until
from app.window.main_window import MainWindow
from app.window.sources import demo_factory
from tracker.base.files import check_target, write_whole
from tracker.base.terminal import add_force

if TYPE_CHECKING:
    from app.engines.snapshot import Snapshot
    from app.panels.panel import Panel
    from app.window.main_window import MainWindow

REFRESHES = 60
RATE = 30.0  # Hz, refreshes of the window in a second; panels with a longer period omit some
TURN_S = 0.1  # s that new data are waited for at most
LOOPS = 100_000
REST = "other"
"""Painting that belongs to no panel, the status bar's and the frame's."""


@dataclass(frozen=True)
class PanelCost:
    """Processor time of one panel, ms each time it is refreshed, in ``share`` of the window's
    refreshes."""

    panel: str
    refresh_ms: float
    paint_ms: float
    unlocked_ms: float  # of both, in compiled code without the lock
    share: float = 1.0

    @property
    def locked_ms(self) -> float:
        return self.refresh_ms + self.paint_ms - self.unlocked_ms


@dataclass(frozen=True)
class PaintProfile:
    """``loop_ms``: processor time of the fixed loop; ``ratio``: time with the lock over it."""

    hands: str
    refreshes: int
    loop_ms: float
    panels: tuple[PanelCost, ...]

    @property
    def locked_ms(self) -> float:
        """Per refresh of the window."""
        return sum(cost.share * cost.locked_ms for cost in self.panels)

    @property
    def ratio(self) -> float:
        return self.locked_ms / self.loop_ms


def main(argv: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="app.tools.paint_profile", description=__doc__)
    parser.add_argument("--hands", choices=HANDS, default=HANDS[0], help="hands of the demo")
    parser.add_argument("--fps", type=float, default=60.0, help="frame rate, Hz")
    parser.add_argument("--refreshes", type=int, default=REFRESHES, help="refreshes to average")
    parser.add_argument("--json", type=Path, help="file for the results")
    add_force(parser)
    args = parser.parse_args(argv)
    if args.json is not None:
        check_target(args.json, args.force)
    app = QApplication.instance() or QApplication([])
    tune_process()
    with tempfile.TemporaryDirectory() as folder:
        found = paint_profile(DemoChoice(fps=args.fps, hands=args.hands), args.refreshes, folder)
    print(_table(found))
    if args.json is not None:
        data = asdict(found) | {"locked_ms": found.locked_ms, "ratio": found.ratio}
        write_whole(args.json, json.dumps(data, indent=2).encode())
    del app
    return 0


def paint_profile(choice: DemoChoice, refreshes: int, folder: str | Path) -> PaintProfile:
    """The demo's window, in the layout that shows the most panels."""
    camera = start_camera(choice=choice)
    store = SettingsStore(Path(folder) / "window.json")
    store.update(job="all")
    window = MainWindow(store)
    window.resize(*SIZE)
    window.show()
    try:
        window.host.open("demo", demo_factory(choice, camera=camera))
        if not wait_until(lambda: is_tracked(window), START_TIMEOUT):
            raise SystemExit("The demo did not find the hand.")
        return measure_panels(window, choice.hands, refreshes)
    finally:
        window.close()


def measure_panels(window: MainWindow, hands: str, refreshes: int) -> PaintProfile:
    """Refresh and paint each visible panel of a window, ``refreshes`` times."""
    window.ticker.stop()
    spent, view = dict[str, list[float]](), None
    with _unlocked() as unlocked:
        for _ in range(refreshes):
            wait_until(partial(_has_changed, window, view), TURN_S)
            begun = time.thread_time()
            QCoreApplication.processEvents()
            _add(spent, REST, 0.0, time.thread_time() - begun, 0.0)
            view = _unspared(window.host.snapshot())
            for panel in window.panels.values():
                if view is not None and not panel.visibleRegion().isEmpty():
                    _add(spent, panel.name, *_one(panel, view, unlocked))
    window.ticker.start()
    periods = {panel.name: panel.period for panel in window.panels.values()}
    costs = []
    for name, sums in spent.items():
        refresh, paint, free = (1e3 * s / refreshes for s in sums)
        costs.append(PanelCost(name, refresh, paint, free, share_of(periods.get(name, 0.0))))
    panels = tuple(sorted(costs, key=lambda cost: -cost.share * cost.locked_ms))
    return PaintProfile(hands, refreshes, 1e3 * _loop_s(), panels)


def share_of(period: float) -> float:
    """Share of the window's refreshes in which a panel with a ``period`` (s) is refreshed."""
    return 1.0 / max(1.0, RATE * period)


def _has_changed(window: MainWindow, seen: Snapshot | None) -> bool:
    """Whether there is another image than in the view that was ``seen``."""
    now = window.host.snapshot()
    return seen is None or now is None or now.frame is not seen.frame


def _unspared(view: Snapshot | None) -> Snapshot | None:
    """As on a computer that is fast enough: nothing is left out."""
    if view is None or view.status is None:
        return view
    values = {**view.status.values, "load_shed": 0.0}
    others = tuple(seen for other in view.others if (seen := _unspared(other)) is not None)
    return replace(view, status=replace(view.status, values=values), others=others)


def _one(panel: Panel, view: Any, unlocked: list[float]) -> tuple[float, float, float]:
    """Refresh and paint a panel: s of both, and of them without the lock."""
    free, begun = unlocked[0], time.thread_time()
    panel.refresh(view)
    refreshed = time.thread_time()
    QCoreApplication.processEvents()
    return refreshed - begun, time.thread_time() - refreshed, unlocked[0] - free


def _add(spent: dict[str, list[float]], name: str, *parts: float) -> None:
    sums = spent.setdefault(name, [0.0] * len(parts))
    for i, part in enumerate(parts):
        sums[i] += part


@contextmanager
def _unlocked() -> Iterator[list[float]]:
    """Counts the processor time (s) of the window's kernels, which release the lock."""
    total = [0.0]

    def counted(function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*args: Any) -> Any:
            begun = time.thread_time()
            made = function(*args)
            total[0] += time.thread_time() - begun
            return made

        return call

    kernels = [(image_canvas, "show_pixels"), (image_canvas, "draw_strokes")]
    kernels += [(curve_canvas, "visible_spans"), (curve_canvas, "draw_curves")]
    kernels += [(scene, "draw"), (scene, "draw_outline"), (hand_skin, "posed")]
    before = [getattr(module, name) for module, name in kernels]
    for (module, name), function in zip(kernels, before, strict=True):
        setattr(module, name, counted(function))
    try:
        yield total
    finally:
        for (module, name), function in zip(kernels, before, strict=True):
            setattr(module, name, function)


def _loop_s() -> float:
    """Processor time of a fixed loop of Python, the least of five."""

    def once() -> float:
        begun, total = time.thread_time(), 0
        for i in range(LOOPS):
            total += i & 7
        return time.thread_time() - begun

    return min(once() for _ in range(5))


def _table(found: PaintProfile) -> str:
    lines = [
        f"{'panel':<14}{'refresh':>10}{'paint':>10}{'unlocked':>10}{'locked':>10}  ms, of refreshes"
    ]
    for cost in found.panels:
        times = (cost.refresh_ms, cost.paint_ms, cost.unlocked_ms, cost.locked_ms)
        lines.append(
            f"{cost.panel:<14}"
            + "".join(f"{value:>10.2f}" for value in times)
            + f"{100 * cost.share:>12.0f} %"
        )
    lines.append(
        f"with the lock: {found.locked_ms:.2f} ms per refresh of the window at {RATE:g} Hz"
    )
    lines.append(f"fixed loop: {found.loop_ms:.2f} ms; ratio {found.ratio:.2f}")
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
