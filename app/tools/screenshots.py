"""``python -m app.tools.screenshots``: all panels of the running demo, light and dark, as PNG."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TypeVar

from PySide6.QtWidgets import QDialog, QWidget

from app.viewmodels.glove_setup import SetUpPhase
from app.window.headless_report import wait_until
from app.window.main_window import MainWindow
from app.wizards.camera import CameraSetup
from app.wizards.glove.wizard import GloveSetup
from app.wizards.stereo.wizard import StereoWizard

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import cv2
import numpy as np
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication, QTreeWidget

from app.engines.demo_camera import FPS, DemoChoice
from app.engines.protocols import RecordingRequest
from app.engines.snapshot import Snapshot
from app.storage.settings import SettingsStore
from app.widgets.curve_plot import CurvePlot
from app.window.headless_report import START_TIMEOUT
from app.window.sources import demo_factory
from tracker.messages import Tracking

SETTLE = 6.0  # s of tracking before the first image
SIZE = (1366, 768)
IDLE_MS = 150.0
TIMEOUT = 40.0  # s for a good moment
OPEN = 0.126  # m from the wrist to the nearest fingertip
SHOW_A_HAND = ("hand", "cameras")
STILL = 1.5  # s for which the hand must remain open
LAID_OUT = 1.0  # s for which a panel must have contents: it makes its plots when first shown
COVERED = 0.9  # share of a plot's time axis that its curves must cover
FLOATING = {"graphs": (820, 520), "devices": (640, 480), "openxr": (560, 330)}
"""Panels that show too little of their contents in their dock, and the size that shows enough."""

Part = CurvePlot | QTreeWidget  # of a panel, which waits for its contents


def main(argv: Sequence[str] | None = None) -> int:
    """Run the demo and take the images; returns the exit status."""
    parser = argparse.ArgumentParser(prog="app.tools.screenshots")
    parser.add_argument(
        "--out",
        type=Path,
        default=Path("docs/screenshots"),
        help="folder for the images (default: docs/screenshots)",
    )
    parser.add_argument(
        "--panels",
        default="",
        help="names of panels, separated by commas, to take no other images (default: all)",
    )
    parser.add_argument(
        "--fps",
        type=float,
        default=FPS,
        help="images per second of the demo's camera; fewer for a slow computer",
    )
    options = parser.parse_args(argv)
    out, panels = options.out, [name for name in options.panels.split(",") if name]
    out.mkdir(parents=True, exist_ok=True)
    app = QApplication.instance() or QApplication(["glovetrack"])
    app.setApplicationName("glovetrack")
    with tempfile.TemporaryDirectory() as folder:
        store = SettingsStore(Path(folder) / "window.json")
        store.update(sessions_folder=folder, job="all")
        window = MainWindow(store)
        try:
            return _take_all(window, out, Path(folder), panels, options.fps)
        finally:
            window.close()


def _take_all(
    window: MainWindow, out: Path, folder: Path, panels: Sequence[str], fps: float
) -> int:
    window.resize(*SIZE)
    window.show()
    for name in () if panels else ("light", "dark"):
        window.set_theme(name)
        wait_until(lambda: False, 0.3)
        save(window, out / f"start-{name}.png")
    window.host.open("demo", demo_factory(DemoChoice(fps=fps)))
    if not wait_until(lambda: window.host.running, START_TIMEOUT):
        print("The demo did not start.")
        return 1
    window.host.recording.begin(RecordingRequest(folder / "P01_pinch.mcap", "P01", "pinch"))
    wait_until(lambda: False, SETTLE)
    for name in ("light", "dark"):
        window.set_theme(name)
        _take_panels(window, out, name, panels)
    window.host.shut_down()
    if not panels and not take_set_up(window, out, save):
        print("A set-up page did not finish loading.")
        return 1
    return 0


def _take_panels(window: MainWindow, out: Path, name: str, panels: Sequence[str]) -> None:
    """The whole window and each dock, while the hand is tracked; or only ``panels``."""
    window.layouts.reset()
    if not panels:
        _wait_for_hand(window, spread=True)
        save(window, out / f"window-{name}.png")
    for panel in panels or window.docks:
        dock = window.docks[panel]
        dock.raise_()
        if panel in FLOATING:
            dock.setFloating(True)
            dock.resize(*FLOATING[panel])
        if not _wait_until_it_lasts(partial(has_contents, window.panels[panel]), LAID_OUT):
            print(f"The panel {panel} has empty plots or lists.")
        _wait_for_hand(window, spread=panel in SHOW_A_HAND)
        save(dock, out / f"{panel}-{name}.png")
        dock.setFloating(False)


def has_contents(panel: QWidget) -> bool:
    """Whether curves fill the visible plots, and the visible trees have items.

    A panel begins to collect data when it is first shown, and lays out its plots after that.
    """
    found: list[Part] = [*panel.findChildren(CurvePlot), *panel.findChildren(QTreeWidget)]
    parts = [part for part in found if part.isVisibleTo(panel)]
    seen = [part for part in parts if _is_visible(part)]
    return (
        not panel.visibleRegion().isEmpty()
        and bool(seen) == bool(parts)
        and all(map(_is_filled, seen))
    )


def _is_visible(part: Part) -> bool:
    """Whether any of it is visible: neither hidden nor scrolled out of view."""
    view = part.plot if isinstance(part, CurvePlot) else part
    return not view.viewport().visibleRegion().isEmpty()


def _is_filled(part: Part) -> bool:
    """Whether a tree has items, or each curve of a plot covers `COVERED` of its time axis."""
    if isinstance(part, QTreeWidget):
        return part.topLevelItemCount() > 0
    begin, end = part.plot.viewRange()[0]
    covered = [
        float(np.ptp(t)) if (t := curve.xData) is not None and len(t) else 0.0
        for curve in part.curves
        if curve.isVisible()
    ]
    return bool(covered) and min(covered) > COVERED * (end - begin)


def _wait_until_it_lasts(done: Callable[[], bool], duration: float) -> bool:
    """Wait until ``done()`` has held for ``duration`` s, at most `TIMEOUT`; returns whether it
    did."""
    since = time.monotonic()

    def lasted() -> bool:
        nonlocal since
        if not done():
            since = time.monotonic()
        return time.monotonic() - since > duration

    return wait_until(lasted, TIMEOUT)


def _wait_for_hand(window: MainWindow, spread: bool) -> None:
    """Let the panels refresh, then wait for a tracked hand, spread or not (`TIMEOUT` at most)."""
    wait_until(lambda: False, 0.7)
    _wait_until_it_lasts(lambda: _is_good(window.host.snapshot(), spread), STILL if spread else 0.0)
    window.hand.look_from("back")
    wait_until(lambda: False, 0.2)


def _is_good(view: Snapshot | None, spread: bool) -> bool:
    if view is None or view.status is None or view.estimate is None:
        return False
    if view.status.values.get("latency_total_ms", 0.0) > IDLE_MS:
        return False  # the last image taken held everything up
    return view.estimate.tracking == Tracking.TRACKING and (not spread or _is_open(view))


def _is_open(view: Snapshot) -> bool:
    """Whether all fingertips are far from the wrist: a fist hides most keypoints."""
    names = view.setup.glove.keypoint_names(view.setup.hand)
    tips = [i for i, name in enumerate(names) if name.endswith("_tip")]
    assert view.estimate is not None
    reach = np.linalg.norm(view.estimate.keypoints[tips] - view.estimate.segment_p[0], axis=1)
    return bool(reach.min() > OPEN)


def save(widget: QWidget, path: Path) -> None:
    """Write a small PNG, without the noise of the simulated images: Git stores every version."""
    image = widget.grab().toImage().convertToFormat(QImage.Format.Format_BGR888)
    width, height = image.width(), image.height()
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(height, image.bytesPerLine())
    pixels = rows[:, : 3 * width].reshape(height, width, 3)
    # The two lowest bits are mostly noise of the simulated camera, which PNG cannot compress.
    cv2.imwrite(str(path), pixels & 0xFC, [cv2.IMWRITE_PNG_COMPRESSION, 9])


if __name__ == "__main__":
    sys.exit(main())


D = TypeVar("D", bound=QDialog)
PAGE_TIMEOUT = 90.0  # s for a page to be ready on a busy machine
VIEWS = 15
Save = Callable[[QWidget, Path], None]


def take_set_up(window: MainWindow, out: Path, save: Save) -> bool:
    """All pages in both themes; False where one did not get ready."""

    def both(dialog: QDialog, name: str) -> None:
        for theme in ("light", "dark"):
            window.set_theme(theme)
            wait_until(lambda: False, 0.3)
            save(dialog, out / f"{name}-{theme}.png")

    return _stereo(window, both) and _glove(window, both) and _camera(window, both)


Both = Callable[[QDialog, str], None]


def _opened(window: MainWindow, command: str, name: str, kind: type[D]) -> D:
    window.run_command(command)
    wait_until(lambda: name in window.set_up.dialogs, PAGE_TIMEOUT)
    dialog = window.set_up.dialogs[name]
    assert isinstance(dialog, kind)
    return dialog


def _stereo(window: MainWindow, both: Both) -> bool:
    wizard = _opened(window, "stereo", "stereo", StereoWizard)
    wizard.resize(980, 680)  # whatever the off-screen screen is
    both(wizard, "stereo-board")
    wizard.go_on()
    ready = wait_until(lambda: wizard.collect.list.count() >= VIEWS, PAGE_TIMEOUT)
    both(wizard, "stereo-views")
    wizard.go_on()
    ready = ready and wait_until(wizard.next.isEnabled, PAGE_TIMEOUT)
    both(wizard, "stereo-result")
    wizard.go_on()
    ready = ready and wait_until(wizard.next.isEnabled, PAGE_TIMEOUT)
    both(wizard, "stereo-check")
    wizard.close()
    return ready


def _glove(window: MainWindow, both: Both) -> bool:
    dialog = _opened(window, "glove_setup", "glove", GloveSetup)
    wait_until(lambda: not window.tasks.tasks, PAGE_TIMEOUT)
    both(dialog, "glove-choice")
    dialog.tabs.setCurrentWidget(dialog.still)
    ready = wait_until(dialog.still.start.isEnabled, PAGE_TIMEOUT)
    dialog.still.begin()
    ready = ready and wait_until(lambda: dialog.still.table.rowCount() > 0, PAGE_TIMEOUT)
    both(dialog, "glove-still")
    dialog.tabs.setCurrentWidget(dialog.wiggle)
    dialog.wiggle.begin()
    ready = ready and wait_until(lambda: dialog.wiggle.phase == SetUpPhase.DONE, PAGE_TIMEOUT)
    both(dialog, "glove-wiggle")
    dialog.close()
    return ready


def _camera(window: MainWindow, both: Both) -> bool:
    dialog = _opened(window, "camera_setup", "camera", CameraSetup)
    wait_until(lambda: not window.tasks.tasks, PAGE_TIMEOUT)
    both(dialog, "camera-setup")
    dialog.close()
    return True
