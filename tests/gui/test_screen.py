"""A machine without a screen."""

import subprocess
import sys
from pathlib import Path

import pytest
from environments import without_screen

from app.window.start import has_screen

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize(
    ("environment", "system", "there"),
    [
        ({"DISPLAY": ":0"}, "linux", True),
        ({"WAYLAND_DISPLAY": "wayland-0"}, "linux", True),
        ({"QT_QPA_PLATFORM": "vnc"}, "linux", True),
        ({"DISPLAY": ""}, "linux", False),
        ({}, "linux", False),
        ({}, "win32", True),
        ({}, "darwin", True),
    ],
)
def test_a_screen_is_what_the_environment_names(environment, system, there):
    assert has_screen(environment, system) is there


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="others always have one")
def test_the_window_says_that_there_is_no_screen():
    done = subprocess.run(
        [sys.executable, "-m", "app"],
        cwd=ROOT,
        env=without_screen(),
        capture_output=True,
        text=True,
    )
    assert done.returncode == 1
    assert done.stderr.startswith("There is no screen to open the window on")
    assert "Traceback" not in done.stderr
