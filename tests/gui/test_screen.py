"""A computer without a screen."""

import signal
import socket
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from PySide6.QtWidgets import QWidget

from app.platform.screens import answers, has_screen
from app.window.start import ENDS, close_on_signals
from tests.gui.environments import without_screen

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
def test_a_screen_is_named_in_the_environment_and_answers(environment, system, there):
    assert has_screen(environment, system, LISTENING.__contains__) is there


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="local sockets of X")
def test_a_local_socket_answers_while_a_listener_exists(tmp_path):
    path = str(tmp_path / "X7")
    assert not answers(path)
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(path)
        server.listen()
        assert answers(path)
    assert not answers(path)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="others always have one")
def test_the_window_reports_a_missing_screen():
    done = subprocess.run(
        [sys.executable, "-m", "app"],
        cwd=ROOT,
        env=without_screen(),
        capture_output=True,
        text=True,
    )
    assert done.returncode == 1
    assert done.stderr.startswith("The window cannot open because no display is available")
    assert "Traceback" not in done.stderr


@pytest.fixture
def handlers():
    """Handlers of the signals that end a program, restored afterwards."""
    before = {name: signal.getsignal(getattr(signal, name)) for name in ENDS}
    yield
    for name, handler in before.items():
        signal.signal(getattr(signal, name), handler)


@pytest.mark.parametrize("name", ENDS)
def test_a_signal_closes_the_window_but_never_during_other_work(qtbot, handlers, name):
    """Closing takes locks that the interrupted work may hold."""
    busy, closed = threading.Lock(), []

    class Window(QWidget):
        def closeEvent(self, event) -> None:
            closed.append(busy.acquire(blocking=False))

    window = Window()
    qtbot.addWidget(window)
    window.show()
    close_on_signals(window)
    with busy:
        signal.raise_signal(getattr(signal, name))
        assert closed == []
    qtbot.waitUntil(lambda: closed == [True])
