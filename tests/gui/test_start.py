"""What a start of the window waits for, and what it does not."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from tracker.kernels import are_compiled

ROOT = Path(__file__).parents[2]
LATER = {
    *("scipy", "superqt", "qtpy", "vtkmodules", "pyvista", "matplotlib", "h5py", "mujoco"),
    *("tracker.engine.pipeline", "tracker.live.runner", "tracker.simulation.scenario"),
    "app.engines.demo",
}
"""Loaded when they are used: each takes a tenth of a second, or several."""


def test_the_window_is_imported_without_what_only_devices_and_dialogs_need() -> None:
    code = "import sys, app.window.start, app.window.main_window; print(*sys.modules)"
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": "offscreen"}
    result = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT,
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    loaded = set(result.stdout.split())
    assert "app.window.main_window" in loaded
    assert loaded & (LATER if are_compiled() else LATER - {"scipy"}) == set()  # numba loads it


def test_commands_are_listed_without_numpy_and_qt() -> None:
    code = "import sys; from tracker.cli import build_parser as b; b(['-h']); print(*sys.modules)"
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert {"numpy", "PySide6", "cv2"} & set(result.stdout.split()) == set()
