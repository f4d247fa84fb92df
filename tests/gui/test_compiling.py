"""The first start from source: the compilation of kernels is shown to the user."""

import os
import sys

import pytest
from PySide6.QtCore import QTimer

from app.window import start
from app.window.start import CompilingWindow, compile_before_start
from tracker.kernels import parts, tools


def words(*lines: str, status: int = 0) -> list[str]:
    """A process that prints these lines, like the compiler."""
    progress_line = "; ".join(f"print({line!r}, flush=True)" for line in lines)
    return [sys.executable, "-c", f"{progress_line}; raise SystemExit({status})"]


@pytest.fixture
def window(qtbot):
    made = CompilingWindow()
    qtbot.addWidget(made)
    return made


def test_the_number_of_compiled_parts_is_shown(window):
    lines = [
        tools.progress_line(part, i + 1, 12) for i, part in enumerate(["vision", "hand", "fusion"])
    ]
    assert window.run(words("Compiling", *lines))
    assert (window.bar.value(), window.bar.maximum()) == (3, 12)
    assert not window.isVisible()


def test_a_failing_compiler_is_quoted_and_does_not_block(window, capsys):
    assert not window.run(words("no such header", status=1))
    assert "no such header" in capsys.readouterr().err


def test_a_missing_program_does_not_block(window):
    assert not window.run(["/no/such/python"])


def test_cancelling_stops_the_compiler(window, qtbot):
    QTimer.singleShot(200, window.later.click)
    assert not window.run([sys.executable, "-c", "import sys; sys.stdin.read()"])  # it waits for us
    assert window._process.state() == window._process.ProcessState.NotRunning


@pytest.fixture
def started(qapp, monkeypatch, tmp_path):
    """What `compile_before_start` starts, where the library is in ``tmp_path``."""
    processes = []
    monkeypatch.setattr(start.os, "execv", lambda *_: processes.append("this program"))
    monkeypatch.setattr(
        start.subprocess, "Popen", lambda *_a, **_k: processes.append("other parts")
    )
    monkeypatch.setattr(tools, "command", lambda *_: words("compiled 1 of 1: all"))
    monkeypatch.setattr(tools, "are_here", lambda: True)
    monkeypatch.setattr(parts, "HERE", tmp_path)
    monkeypatch.delenv(parts.MODE)
    return processes


def test_a_checkout_without_a_library_is_compiled(qapp, started):
    compile_before_start(qapp)
    assert started == ["other parts", "this program"]
    compile_before_start(qapp)
    assert len(started) == 2, "the restarted program does not compile again"


def test_only_an_outdated_library_is_compiled_again(qapp, started, monkeypatch, tmp_path):
    for part in ("tracker_vision", "tracker_inertial"):  # the demo does not need the second one
        (tmp_path / f"_compiled_{part}.txt").write_text("a table")
    os.utime(tmp_path / "_compiled_tracker_inertial.txt", (0, 0))
    source = tmp_path / "tracker" / "vision" / "kernels.py"
    source.parent.mkdir(parents=True)
    monkeypatch.setattr(tools.are_outdated, "__defaults__", (tmp_path,))
    now = (tmp_path / "_compiled_tracker_vision.txt").stat().st_mtime
    for text, t, outdated in (
        ("@kernel\n", now - 1, False),
        ("", now + 1, False),
        ("@kernel\n", now + 1, True),
    ):
        source.write_text(f"from tracker.kernels import kernel\n\n{text}")
        os.utime(source, (t, t))
        compile_before_start(qapp)
        assert started == (["other parts", "this program"] if outdated else [])


def test_tests_use_the_library_as_it_is(qapp, started, monkeypatch):
    monkeypatch.setenv(parts.MODE, "kept")
    compile_before_start(qapp)
    assert not started
