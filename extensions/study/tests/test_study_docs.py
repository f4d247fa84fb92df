"""The page about studies: its commands run, in order, with a shorter protocol."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from extensions.study.protocol import parse_protocol
from tracker.cli import main

PAGE = Path(__file__).parents[1] / "docs" / "study.md"
TOML = re.compile(r"^```toml\n(.*?)^```", re.MULTILINE | re.DOTALL)
SHELL = re.compile(r"^```sh\n(.*?)^```", re.MULTILINE | re.DOTALL)
KEY = re.compile(r"`([a-z_]+)`")


@pytest.mark.long
@pytest.mark.usefixtures("workers_here")
@pytest.mark.timeout(900)  # it simulates and tracks eight trials
def test_every_command_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = PAGE.read_text("utf-8")
    (protocol,) = TOML.findall(text)
    assert len(parse_protocol(protocol).participants) == 10
    shorter = re.sub(r"trials = 2 ", "trials = 1 ", protocol).replace("trials = 2\n", "")
    for long, short in (
        *(("duration = 30.0", "duration = 2.5"), ("longest = 60.0", "longest = 4.0")),
        *(("practice = 1 ", "practice = 0 "), ("countdown = 3.0", "countdown = 0.5")),
        ("tracked = 0.9", "tracked = 0.1"),
    ):
        assert long in shorter
        shorter = shorter.replace(long, short)
    (tmp_path / "grasp.toml").write_text(shorter, "utf-8")
    monkeypatch.chdir(tmp_path)
    commands = [line for block in SHELL.findall(text) for line in block.splitlines()]
    assert len(commands) >= 7
    for line in commands:
        assert main(shlex.split(line)[1:]) == 0, line
    assert Path("trial/report/report.html").is_file() and Path("trial/tables.csv").is_file()
    assert len(list(Path("bids").rglob("*tracksys-hand*_motion.tsv"))) == 4


def test_the_table_has_every_key() -> None:
    from dataclasses import fields

    from extensions.study.protocol import Condition, Protocol, Task, TrialLimits

    text = PAGE.read_text("utf-8")
    described = set(KEY.findall(text[text.index("## Keys of the protocol") :]))
    for kind in (Protocol, Condition, TrialLimits, Task):
        names = {f.name for f in fields(kind)} - {"conditions", "tasks", "limits"}
        assert names <= described, kind
