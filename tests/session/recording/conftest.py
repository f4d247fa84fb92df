"""Recorders in processes of their own, and a look at what they leave behind."""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tracker.session.recording.process import RecorderProcesses

SHARED = Path("/dev/shm")
NAME = "glovetrack-recorder"


def shared_names() -> set[str]:
    """Of blocks of memory that anyone has made here and not given up yet."""
    return {p.name for p in SHARED.glob("psm_*")} if SHARED.is_dir() else set()


def left_since(before: set[str]) -> set[str]:
    """Names that stay; those of tests beside this one are gone in a moment."""
    deadline = time.monotonic() + 10
    while (left := shared_names() - before) and time.monotonic() < deadline:
        time.sleep(0.05)
    return left


@pytest.fixture
def recorders() -> Iterator[Callable[..., RecorderProcesses]]:
    """``recorders(prepare)``; in the end no process and no shared memory of them is left."""
    before, made = shared_names(), []

    def make(prepare: Callable[[], None] | None = None) -> RecorderProcesses:
        made.append(RecorderProcesses(prepare))
        return made[-1]

    yield make
    for processes in made:
        processes.close()
    assert not [p for p in multiprocessing.active_children() if p.name == NAME]
    assert not left_since(before)
