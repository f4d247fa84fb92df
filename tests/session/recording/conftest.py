"""Recorders in processes of their own, and a look at what they leave behind."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tracker.session.recording.process import RecorderProcesses

SHARED = Path("/dev/shm")
NAME = "glovetrack-recorder"


def shared_names() -> set[str]:
    return {p.name for p in SHARED.iterdir()} if SHARED.is_dir() else set()


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
    assert shared_names() <= before
