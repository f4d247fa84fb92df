"""A second start passes its session to the first window: two processes, as from a file manager."""

import os
import subprocess
import sys
import time
import uuid
from pathlib import Path

import pytest
from PySide6.QtNetwork import QLocalSocket

from app.platform import single_instance
from app.platform.single_instance import Instance, addresses, ask, hand_over
from tests.notices import shows
from tracker.base.errors import GlovetrackError
from tracker.cli import main
from tracker.offline.simulate import SimulateOptions, simulate

ROOT = Path(__file__).resolve().parents[2]
START_S, END_S = 60.0, 60.0

FIRST = """
import sys
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from app.window.main_window import MainWindow

opened = MainWindow._opened

def tell(window, setup):
    opened(window, setup)
    player = setup.player
    print("opened", setup.name, "playing" if player.playing else player.seek_to, flush=True)
    QTimer.singleShot(200, window.close)

MainWindow._opened = tell
from app.__main__ import main
sys.exit(main(sys.argv[1:]))
"""


@pytest.fixture
def home(tmp_path, monkeypatch):
    """Private folders of settings and logs."""
    environment = {
        **os.environ,
        "QT_QPA_PLATFORM": "offscreen",
        "PYTHONPATH": str(ROOT),
        **{f"XDG_{k}_HOME": str(tmp_path / k) for k in ("CONFIG", "STATE", "DATA", "CACHE")},
    }
    for key in ("XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"):
        monkeypatch.setenv(key, environment[key])
    return environment


@pytest.fixture
def session_file(tmp_path):
    path = tmp_path / "P01.mcap"
    simulate(path, SimulateOptions(seed=1, duration=1.0, fps=10, images=False))
    return path


@pytest.mark.long
def test_a_second_start_opens_its_file_in_the_first_window(home, session_file, qapp):
    command = [sys.executable, "-c", FIRST]
    with subprocess.Popen(command, env=home, stdout=subprocess.PIPE, text=True) as first:
        try:
            deadline = time.monotonic() + START_S
            while not hand_over(None):  # until the first one listens
                assert first.poll() is None and time.monotonic() < deadline
                time.sleep(0.1)
            words = [sys.executable, "-m", "app", str(session_file), "--at", "0.5"]
            second = subprocess.run(words, env=home, timeout=START_S, check=False)
            assert second.returncode == 0
            output, _ = first.communicate(timeout=END_S)
        finally:
            first.kill()
    assert "opened P01.mcap 0.5" in output
    assert first.returncode == 0
    logs = Path(home["XDG_STATE_HOME"]) / "glovetrack" / "log"
    assert [p.name for p in logs.glob("*-*.log")] == []  # neither running nor crashed


@pytest.mark.long
def test_a_start_with_a_time_opens_its_file_paused_there(home, session_file, qapp):
    command = [sys.executable, "-c", FIRST, str(session_file), "--at", "0.25"]
    first = subprocess.run(
        command, env=home, capture_output=True, text=True, timeout=START_S, check=False
    )
    assert (first.returncode, first.stdout.strip()) == (0, "opened P01.mcap 0.25")


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (["--at", "1"], "option.requires"),
        (["a.mcap", "--at", "-1"], "option.least"),
        (["a.mcap", "--at=nan"], "option.least"),
    ],
)
def test_a_time_without_a_session_or_outside_it_is_refused(words, code, capsys):
    with pytest.raises(SystemExit) as end:
        main(words)
    assert end.value.code == 2 and shows(capsys.readouterr().err, code, option="--at")


def test_leftovers_of_a_crashed_window_do_not_stop_the_next(qtbot):
    name = f"glovetrack-test-{uuid.uuid4().hex}"
    stale = Path(addresses(name)[0])
    if sys.platform != "win32":
        stale.write_bytes(b"")
    assert not hand_over(None, name=name)
    instance = Instance(name)
    try:
        assert instance.listening
    finally:
        instance.close()
        stale.unlink(missing_ok=True)


def test_a_second_window_leaves_the_socket_to_the_first(qtbot):
    name = f"glovetrack-test-{uuid.uuid4().hex}"
    first, asked = Instance(name), []
    first.requested.connect(lambda *what: asked.append(what))
    second = Instance(name)
    try:
        assert (first.listening, second.listening) == (True, False)
    finally:
        second.close()
        first.close()


def test_invalid_data_on_the_socket_are_rejected(qtbot):
    name = f"glovetrack-test-{uuid.uuid4().hex}"
    instance, asked = Instance(name), []
    instance.requested.connect(lambda *what: asked.append(what))
    try:
        for nonsense in (
            b"[]\n",
            b"{}\n",
            b"\xff\n",
            b'{"open": 3}\n',
            b'{"open": "a", "at": "b"}\n',
        ):
            socket = QLocalSocket()
            socket.connectToServer(addresses(name)[0])
            assert socket.waitForConnected(2000)
            socket.write(nonsense)
            qtbot.waitUntil(
                lambda s=socket: (
                    s.state() == QLocalSocket.LocalSocketState.UnconnectedState
                    or s.bytesAvailable() > 0
                ),
            )
        assert asked == []
    finally:
        instance.close()


def test_a_window_that_does_not_answer_differs_from_none(qapp, monkeypatch):
    """A loaded computer carries out a request after the script has given up waiting."""
    monkeypatch.setattr(single_instance, "ASK_MS", 100)
    name = f"glovetrack-test-{uuid.uuid4().hex}"
    assert ask({"do": "start"}, name) is None
    window = Instance(name)  # whose event loop does not run
    try:
        with pytest.raises(GlovetrackError) as error:
            ask({"do": "start"}, name)
        assert error.value.notice.code == "window.no_answer"
    finally:
        window.close()
