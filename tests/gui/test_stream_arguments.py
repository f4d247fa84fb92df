"""Streams that the command line turns on."""

import contextlib
import json
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from app.__main__ import main
from app.window.report_files import report_paths
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


@pytest.mark.timeout(240)
def test_a_report_without_a_screen_sends_and_answers_and_leaves_its_files(tmp_path):
    """It replaces those of an earlier report, with --force, and no others."""
    own = b"the user's own\n"
    others = [tmp_path / name for name in ("notes.txt", "window.json")]
    for path in (*others, *report_paths(tmp_path)):
        path.write_bytes(own)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listener:
        listener.bind(("127.0.0.1", 0))
        words = ["--scene", "plain", "--fps", "15", "--headless-report", "3"]
        words += ["--out", str(tmp_path), "--force"]
        words += [
            "--stream",
            f"udp:{listener.getsockname()[1]}",
            "--remote",
            f"udp:{(port := free_port())}",
        ]
        running = subprocess.Popen(
            [sys.executable, "-m", "app", "--demo", *words],
            cwd=ROOT,
            env=without_screen(),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        try:
            answer = ""
            while not is_reply(answer) and running.poll() is None:  # a free port may answer itself
                with contextlib.suppress(GlovetrackError):
                    answer = ask({"do": "status"}, "127.0.0.1", port, 2.0)
            printed, errors = running.communicate()
        finally:
            running.kill()
        assert is_reply(answer) and json.loads(answer)["ok"] is True
        listener.settimeout(1.0)
        assert "keypoints" in json.loads(listener.recv(65536))
    assert running.returncode == 0, errors
    made = {path: path.read_bytes() for path in tmp_path.iterdir()}
    assert [made.pop(path) for path in others] == [own, own]
    assert {"session.mcap", "session.csv", "window.png"} <= {path.name for path in made}
    assert own not in made.values()
    assert "tracking " in printed
    assert shows(errors, "tracking.tracked")


def free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
        asking.bind(("127.0.0.1", 0))
        return asking.getsockname()[1]


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
