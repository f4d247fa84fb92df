"""A machine without a screen."""

import socket
import subprocess
import sys
from pathlib import Path

import pytest
from environments import without_screen

from app.platform.screens import answers, has_screen

ROOT = Path(__file__).resolve().parents[2]


LISTENING = {"/tmp/.X11-unix/X0", ("there", 6010), "/run/user/1/wayland-0"}


@pytest.mark.parametrize(
    ("environment", "system", "there"),
    [
        ({"DISPLAY": ":0"}, "linux", True),
        ({"DISPLAY": "unix:0.1"}, "linux", True),
        ({"DISPLAY": "there:10.0"}, "linux", True),
        ({"DISPLAY": ":1"}, "linux", False),  # named, but dead
        ({"DISPLAY": ":1", "QT_QPA_PLATFORM": "xcb"}, "linux", False),
        ({"DISPLAY": "no display"}, "linux", False),
        ({"WAYLAND_DISPLAY": "wayland-0", "XDG_RUNTIME_DIR": "/run/user/1"}, "linux", True),
        ({"WAYLAND_DISPLAY": "/run/user/1/wayland-0"}, "linux", True),
        ({"WAYLAND_DISPLAY": "wayland-1", "XDG_RUNTIME_DIR": "/run/user/1"}, "linux", False),
        ({"QT_QPA_PLATFORM": "vnc"}, "linux", True),
        ({"DISPLAY": ""}, "linux", False),
        ({}, "linux", False),
        ({}, "win32", True),
        ({}, "darwin", True),
    ],
)
def test_a_screen_is_what_the_environment_names_and_answers(environment, system, there):
    assert has_screen(environment, system, LISTENING.__contains__) is there


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="local sockets of X")
def test_a_local_socket_answers_while_somebody_listens(tmp_path):
    path = str(tmp_path / "X7")
    assert not answers(path)
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(path)
        server.listen()
        assert answers(path)
    assert not answers(path)


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
