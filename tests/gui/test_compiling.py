"""The first start from source: the compilation of kernels is shown to the user."""

import sys

import pytest
from PySide6.QtCore import QTimer

from app.platform import compiling
from app.platform.compiling import CompilingWindow, compile_before_start
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


def test_only_a_checkout_without_a_library_is_compiled(qapp, monkeypatch, tmp_path):
    started = []
    monkeypatch.setattr(compiling.os, "execv", lambda *_: started.append("anew"))
    monkeypatch.setattr(compiling.subprocess, "Popen", lambda *_a, **_k: started.append("the rest"))
    monkeypatch.setattr(tools, "command", lambda *_: words("compiled 1 of 1: all"))
    monkeypatch.setattr(tools, "are_here", lambda: True)
    monkeypatch.setattr(parts, "HERE", tmp_path)
    (tmp_path / "_compiled_vision.txt").write_text("a table")
    compile_before_start(qapp)
    assert not started
    (tmp_path / "_compiled_vision.txt").unlink()
    compile_before_start(qapp)
    assert started == ["the rest", "anew"]
