"""Streams that the command line turns on."""

import contextlib
import json
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from app.__main__ import main
from tests.gui.environments import without_screen
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tests.notices import shows
from tracker.base.errors import GlovetrackError
from tracker.streaming.registry import StreamSettings, with_streams
from tracker.streaming.remote.client import ask
from tracker.streaming.remote.request import is_reply

ROOT = Path(__file__).resolve().parents[2]


def test_a_stream_of_the_command_line_sends_once_an_engine_runs(window, qtbot):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listener:
        listener.bind(("127.0.0.1", 0))
        listener.setblocking(False)
        port = listener.getsockname()[1]
        window.outputs.use(with_streams(StreamSettings(), f"udp:{port}?schema=1"))
        assert window.store.value.streams == {}, "the next start is as it was"
        window.host.adopt(scripted_setup(ScriptedEngine()))

        def has_arrived() -> bool:
            try:
                return json.loads(listener.recv(65536))["schema"] == 1
            except BlockingIOError:
                return False

        qtbot.waitUntil(has_arrived)
        assert window.panels["streams"].boxes["udp"].isChecked()


@pytest.mark.timeout(180)
def test_a_report_without_a_screen_sends_too_and_leaves_its_files(tmp_path):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listener:
        listener.bind(("127.0.0.1", 0))
        words = ["--scene", "plain", "--headless-report", "5", "--out", str(tmp_path)]
        stream = ["--stream", f"udp:{listener.getsockname()[1]}"]
        done = subprocess.run(
            [sys.executable, "-m", "app", "--demo", *words, *stream],
            cwd=ROOT,
            env=without_screen(),
            capture_output=True,
            text=True,
        )
        listener.settimeout(1.0)
        assert "keypoints" in json.loads(listener.recv(65536))
    assert done.returncode == 0, done.stderr
    assert {"session.mcap", "session.csv"} <= {p.name for p in tmp_path.iterdir()}
    assert "tracking " in done.stdout
    assert shows(done.stderr, "tracking.tracked")


@pytest.mark.timeout(240)
def test_a_report_without_a_screen_answers_by_remote_control(tmp_path):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    words = ["--headless-report", "20", "--out", str(tmp_path), "--lenses", "none"]
    running = subprocess.Popen(
        [sys.executable, "-m", "app", "--demo", *words, "--remote", f"udp:{port}"],
        cwd=ROOT,
        env=without_screen(),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        answer = ""
        while not is_reply(answer) and running.poll() is None:  # a free port may answer itself
            with contextlib.suppress(GlovetrackError):
                answer = ask({"do": "status"}, "127.0.0.1", port, 2.0)
        assert is_reply(answer) and json.loads(answer)["ok"] is True
    finally:
        running.terminate()
        running.wait(60)


@pytest.mark.parametrize(
    "words", [["x.mcap", "--headless-report", "5"], ["--demo", "--headless-report", "0"]]
)
def test_a_report_of_a_session_or_without_a_duration_is_wrong_usage(words, capsys):
    with pytest.raises(SystemExit) as ended:
        main(words)
    assert ended.value.code == 2
    assert "--headless-report" in capsys.readouterr().err


def test_an_unknown_stream_is_a_usage_error(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["--demo", "--stream", "ros"])
    assert ended.value.code == 2
    assert shows(capsys.readouterr().err, "part.unknown", kind="stream", name="ros")


@pytest.mark.parametrize("word", ["--remote", "--stream", "--wearer", "--headless-report"])
def test_an_option_of_the_window_opens_it_without_another_word(monkeypatch, word):
    """As the guide to remote control writes it; ``--help`` and ``--version`` are the commands'."""
    opened = []
    monkeypatch.setattr("app.window.start.open_window", lambda options: opened.append(options) or 0)
    assert main([word, "7"]) == 0
    assert str(getattr(opened[0], word.strip("-").replace("-", "_"))) in ("7", "7.0")
    with pytest.raises(SystemExit):
        main(["--version"])
    assert len(opened) == 1
