"""Shell completion and logging: what every command has."""

from __future__ import annotations

import logging
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.notices import shows
from tracker.cli import main
from tracker.completion import SCRIPTS, candidates

PROGRAM = Path(sys.executable).with_name("glovetrack")


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ("tra", ["track"]),
        ("evaluate in", ["inertial"]),
        ("colours check --js", ["--json"]),
        ("simulate -o x.mcap --scene p", ["plain", "painted", "photo"]),
        ("remote vib", ["vibrate"]),
        ("print w", ["wiring"]),
        ("--dem", ["--demo"]),
        ("a.mcap --wea", ["--wearer"]),
        ("track x -", None),
        ("track --engine ", []),
        ("track a.mc", []),
        ("nothing of --ours", []),
    ],
)
def test_words_are_completed(words: str, found: list[str] | None) -> None:
    offered = candidates(words.split(" "))
    if found is None:
        assert {"-o", "--smooth", "--log-level"} <= set(offered)
    else:
        assert offered == found


def test_an_option_is_completed_before_other_positions() -> None:
    assert candidates(["demo", "--lenses", ""]) == ["both", "one", "none"]
    assert candidates(["demo", "--hands", "l"]) == ["left"]


@pytest.mark.parametrize("shell", SCRIPTS)
def test_a_shell_accepts_its_script(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    assert "glovetrack completion words" in script
    if shutil.which(shell):
        subprocess.run([shell, "-n"], input=script, text=True, check=True)


@pytest.mark.skipif(not PROGRAM.exists() or shutil.which("bash") is None, reason="needs both")
def test_bash_completes_a_command() -> None:
    script = SCRIPTS["bash"] + (
        "COMP_WORDS=(glovetrack evaluate i); COMP_CWORD=2; _glovetrack; "
        'printf "%s\\n" "${COMPREPLY[@]}"\n'
    )
    path = f"{PROGRAM.parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["bash", "-c", script], env={**os.environ, "PATH": path}, capture_output=True, text=True
    )
    assert done.stdout.split() == ["inertial"], done.stderr


# ---- logging


@pytest.fixture
def logging_command(monkeypatch: pytest.MonkeyPatch) -> logging.Logger:
    """``glovetrack verify`` that logs three messages."""
    log = logging.getLogger("tracker.test")

    def verify(path: Path) -> list[object]:
        for level in (logging.DEBUG, logging.INFO, logging.WARNING):
            log.log(level, "message %s", logging.getLevelName(level).lower())
        return []

    monkeypatch.setattr("tracker.session.command_runs.verify", verify)
    return log


def logged(text: str) -> list[str]:
    return [line.split()[-1] for line in text.splitlines() if "message" in line]


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ([], ["warning"]),
        (["--log-level", "debug"], ["debug", "info", "warning"]),
        (["--log-level", "error"], []),
    ],
)
def test_the_level_is_that_of_standard_error(
    words: list[str],
    found: list[str],
    tmp_path: Path,
    logging_command: logging.Logger,
    capsys: pytest.CaptureFixture[str],
) -> None:
    session = tmp_path / "a.mcap"
    session.touch()
    assert main(["verify", str(session), *words]) == 0
    assert logged(capsys.readouterr().err) == found


def test_a_log_file_has_messages_from_info_on_and_replaces_nothing(
    tmp_path: Path, logging_command: logging.Logger, capsys: pytest.CaptureFixture[str]
) -> None:
    session, log = tmp_path / "a.mcap", tmp_path / "run.log"
    session.touch()
    before = logging.getLogger().handlers[:], logging.getLogger().level
    assert main(["verify", str(session), "--log-file", str(log)]) == 0
    assert logged(log.read_text()) == ["info", "warning"]
    assert "INFO MainThread tracker.test" in log.read_text()
    assert logged(capsys.readouterr().err) == ["warning"]
    assert main(["verify", str(session), "--log-file", str(log)]) == 1
    assert logged(log.read_text()) == ["info", "warning"]
    assert shows(capsys.readouterr().err, "file.exists_force")
    assert before == (logging.getLogger().handlers, logging.getLogger().level)
