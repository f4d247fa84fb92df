"""Recorders in separate processes, and checks of what they leave behind."""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tracker.base.callbacks import ignore
from tracker.session.recording.process import RecorderProcesses

SHARED = Path("/dev/shm")
NAME = "glovetrack-recorder"


def shared_names() -> set[str]:
    """Names of shared memory blocks created here and not freed yet."""
    return {p.name for p in SHARED.glob("psm_*")} if SHARED.is_dir() else set()


def left_since(before: set[str]) -> set[str]:
    """Names that persist; those of parallel tests disappear soon."""
    deadline = time.monotonic() + 10
    while (left := shared_names() - before) and time.monotonic() < deadline:
        time.sleep(0.05)
    return left


@pytest.fixture
def recorders() -> Iterator[Callable[..., RecorderProcesses]]:
    """``recorders(prepare)``; afterwards no process and no shared memory of them is left."""
    before, made = shared_names(), []

    def make(prepare: Callable[[], object] = ignore) -> RecorderProcesses:
        made.append(RecorderProcesses(prepare))
        return made[-1]

    yield make
    for processes in made:
        processes.close()
    assert not [p for p in multiprocessing.active_children() if p.name == NAME]
    assert not left_since(before)
