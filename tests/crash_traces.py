"""Where a hard crash of a test process happened, reported at the end of the run.

A crashed worker of pytest-xdist is replaced and only its last test is named. Python's fault handler
writes the stacks of all threads into a file per process; a summary shows those that are not empty.
"""

from __future__ import annotations

import faulthandler
import os
from collections.abc import Iterator
from pathlib import Path
from typing import TextIO

import pytest
from _pytest.terminal import TerminalReporter

FOLDER = "GLOVETRACK_CRASH_TRACES"


class CrashTraces:
    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._file: TextIO = (folder / f"crash-{os.getpid()}.txt").open("w", encoding="utf-8")

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        """Enabled again for each test: some of them, and pytest, enable it themselves."""
        faulthandler.enable(self._file)
        return (yield)

    def pytest_terminal_summary(self, terminalreporter: TerminalReporter) -> None:
        for path in sorted(self._folder.glob("crash-*.txt")):
            text = path.read_text("utf-8", "replace")
            if text.strip():
                terminalreporter.section(f"process {path.stem.partition('-')[2]} crashed")
                terminalreporter.write_line(text)


def register(config: pytest.Config, folder: Path) -> None:
    """Workers write where the process that has started them looks."""
    if not hasattr(config, "workerinput"):
        os.environ[FOLDER] = str(folder)
    config.pluginmanager.register(CrashTraces(Path(os.environ[FOLDER])), "crash_traces")
