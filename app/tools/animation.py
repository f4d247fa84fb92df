"""``python -m app.tools.animation``: the replay of a simulated session as an animated picture.

A replay advances image by image, so the picture does not depend on the computer's load.
"""

from __future__ import annotations

import argparse
import heapq
import os
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PIL import Image
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication, QWidget

from app.engines.protocols import Player
from app.storage.settings import SettingsStore
from app.window.headless_report import START_TIMEOUT, wait_until
from app.window.main_window import MainWindow
from tracker.messages import StereoFrame
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder

SIZE = (1366, 768)
WIDTH = 800  # px of the picture
FRAMES, WARM_UP, IMAGES, MS = (
    22,
    8,
    5,
    170,
)  # frames, and steps before them; images a step; ms a frame
BEGIN, SECONDS, FPS = 2.0, 7.5, 30.0  # s at the first frame, and of the session; its images per s
TIMEOUT = 10.0  # s until an image is shown
COLOURS = 96


def main(argv: Sequence[str] | None = None) -> int:
    """Run the demo and write the picture; returns the exit status."""
    parser = argparse.ArgumentParser(prog="app.tools.animation")
    parser.add_argument("--out", type=Path, default=Path("docs/screenshots/tracking.gif"))
    out = parser.parse_args(argv).out
    app = QApplication.instance() or QApplication(["glovetrack"])
    app.setApplicationName("glovetrack")
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder) / "work"
        work.mkdir()
        session = work / "session.mcap"
        simulate(session, SimulateOptions(duration=SECONDS, fps=FPS, seed=3))
        track(session, tracked := work / "estimates.mcap")
        whole = _with_images(session, tracked, Path(folder) / "P01_pinch.mcap")
        store = SettingsStore(Path(folder) / "window.json")
        store.update(sessions_folder=folder)
        window = MainWindow(store)
        try:
            return _take(window, whole, out)
        finally:
            window.close()


def _with_images(session: Path, tracked: Path, out: Path) -> Path:
    """Estimates of ``tracked`` and images of ``session`` in one file."""
    with SessionReader(session) as images, SessionReader(tracked) as estimates:
        merged = heapq.merge(
            images.messages((StereoFrame,)), estimates.messages(), key=lambda m: m.t
        )
        with SessionRecorder(out, estimates.info, RecorderParams(sync=False)) as recorder:
            for message in merged:
                recorder.write(message)
    return out


def _take(window: MainWindow, session: Path, out: Path) -> int:
    window.resize(*SIZE)
    window.show()
    window.set_theme("dark")
    window.sources.open_session(session, BEGIN)
    if not wait_until(lambda: window.host.running, START_TIMEOUT):
        print("The session was not opened.")
        return 1
    window.layouts.reset()
    setup = window.host.setup
    assert setup is not None and setup.player is not None
    player = setup.player
    for _ in range(WARM_UP):  # until the camera panel has an image and the library is read
        _advance(player)
    frames: list[Image.Image] = []
    for _ in range(FRAMES):
        _advance(player)
        frames.append(_grab(window))
    window.host.shut_down()
    # One palette for all frames: unchanged pixels then cost nothing.
    palette = frames[0].quantize(COLOURS)
    first, *rest = [f.quantize(palette=palette, dither=Image.Dither.NONE) for f in frames]
    first.save(out, save_all=True, append_images=rest, duration=MS, loop=0, optimize=True)
    return 0


def _advance(player: Player) -> None:
    """Steps forward and lets all panels refresh."""
    before = player.position
    player.step(IMAGES)
    wait_until(lambda: player.position > before, TIMEOUT)
    wait_until(lambda: False, 0.3)


def _grab(widget: QWidget) -> Image.Image:
    smooth = Qt.TransformationMode.SmoothTransformation
    image = widget.grab().toImage().scaledToWidth(WIDTH, smooth)
    image = image.convertToFormat(QImage.Format.Format_RGB888)
    size = (image.width(), image.height())
    data = bytes(image.constBits())
    return Image.frombuffer("RGB", size, data, "raw", "RGB", image.bytesPerLine(), 1)


if __name__ == "__main__":
    sys.exit(main())
