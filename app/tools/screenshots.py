"""``python -m app.tools.screenshots``: all panels of the running demo, light and dark, as PNG."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import cv2
import numpy as np
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication, QWidget

from app.engines.protocols import RecordingRequest
from app.engines.snapshot import Snapshot
from app.storage.settings import SettingsStore
from app.tools.screenshots_set_up import take_set_up
from app.window.headless_report import START_TIMEOUT, wait_until
from app.window.main_window import MainWindow
from app.window.sources import demo_factory
from tracker.messages import Tracking

SETTLE = 6.0  # s of tracking before the first image
SIZE = (1366, 768)
CALM_MS = 150.0
PATIENCE = 40.0  # s for a good moment
OPEN = 0.126  # m from the wrist to the nearest fingertip
SHOW_A_HAND = ("hand", "cameras")
STILL = 1.5  # s for which it stays so, lest it be caught on its way


def main(argv: Sequence[str] | None = None) -> int:
    """Run the demo and take the images; returns the exit status."""
    parser = argparse.ArgumentParser(prog="app.tools.screenshots")
    parser.add_argument(
        "--out",
        type=Path,
        default=Path("docs/screenshots"),
        help="folder for the images (default: docs/screenshots)",
    )
    out = parser.parse_args(argv).out
    out.mkdir(parents=True, exist_ok=True)
    app = QApplication.instance() or QApplication(["glovetrack"])
    app.setApplicationName("glovetrack")
    with tempfile.TemporaryDirectory() as folder:
        store = SettingsStore(Path(folder) / "window.json")
        store.update(sessions_folder=folder, job="all")
        window = MainWindow(store)
        try:
            return _take_all(window, out, Path(folder))
        finally:
            window.close()


def _take_all(window: MainWindow, out: Path, folder: Path) -> int:
    window.resize(*SIZE)
    window.show()
    for name in ("light", "dark"):
        window.set_theme(name)
        wait_until(lambda: False, 0.3)
        save(window, out / f"start-{name}.png")
    window.host.open("demo", demo_factory())
    if not wait_until(lambda: window.host.running, START_TIMEOUT):
        print("The demo did not start.")
        return 1
    window.host.recording.begin(RecordingRequest(folder / "P01_pinch.mcap", "P01", "pinch"))
    wait_until(lambda: False, SETTLE)
    for name in ("light", "dark"):
        window.set_theme(name)
        _take_panels(window, out, name)
    window.host.shut_down()
    if not take_set_up(window, out, save):
        print("A set-up page did not finish loading.")
        return 1
    return 0


def _take_panels(window: MainWindow, out: Path, name: str) -> None:
    """The whole window and each dock, while the hand is tracked."""
    window.layouts.reset()
    _wait_for_hand(window, spread=True)
    save(window, out / f"window-{name}.png")
    for panel, dock in window.docks.items():
        dock.raise_()
        _wait_for_hand(window, spread=panel in SHOW_A_HAND)
        save(dock, out / f"{panel}-{name}.png")


def _wait_for_hand(window: MainWindow, spread: bool) -> None:
    """Let the panels refresh, then wait for a tracked hand, spread or not (`PATIENCE` at most)."""
    wait_until(lambda: False, 0.7)
    since = time.monotonic()

    def ready() -> bool:
        nonlocal since
        if not _is_good(window.host.snapshot(), spread):
            since = time.monotonic()
        return time.monotonic() - since > (STILL if spread else 0.0)

    wait_until(ready, PATIENCE)
    window.hand.look_from("back")
    wait_until(lambda: False, 0.2)


def _is_good(view: Snapshot | None, spread: bool) -> bool:
    if view is None or view.status is None or view.estimate is None:
        return False
    if view.status.values.get("latency_total_ms", 0.0) > CALM_MS:
        return False  # the last image taken held everything up
    return view.estimate.tracking == Tracking.TRACKING and (not spread or _is_open(view))


def _is_open(view: Snapshot) -> bool:
    """Whether all fingertips are far from the wrist: a fist shows little of what is tracked."""
    names = view.setup.glove.keypoint_names(view.setup.hand)
    tips = [i for i, name in enumerate(names) if name.endswith("_tip")]
    assert view.estimate is not None
    reach = np.linalg.norm(view.estimate.keypoints[tips] - view.estimate.segment_p[0], axis=1)
    return bool(reach.min() > OPEN)


def save(widget: QWidget, path: Path) -> None:
    """A PNG of 256 colours' worth of bytes: the repository holds these files."""
    image = widget.grab().toImage().convertToFormat(QImage.Format.Format_BGR888)
    width, height = image.width(), image.height()
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(height, image.bytesPerLine())
    pixels = rows[:, : 3 * width].reshape(height, width, 3)
    # The two lowest bits hold the simulated camera's noise, which no PNG can pack.
    cv2.imwrite(str(path), pixels & 0xFC, [cv2.IMWRITE_PNG_COMPRESSION, 9])


if __name__ == "__main__":
    sys.exit(main())
