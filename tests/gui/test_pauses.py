"""Garbage collection does not block all threads while a hand is tracked."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QObject

from app.engines.engine_host import EngineHost
from app.platform.process_tuning import freeze_permanent_objects
from app.platform.tasks import TaskOwner
from app.window import pauses


@pytest.fixture(autouse=True)
def _thawed() -> Iterator[None]:
    """Nothing is frozen before: a run of all tests does it too, with its objects."""
    gc.unfreeze()
    yield
    gc.unfreeze()


class Loop:
    def __init__(self) -> None:
        self.itself = self


def test_permanent_objects_are_frozen_soon_after_a_start(
    qtbot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pauses, "SETTLED_MS", 1)
    owner = QObject()
    host = EngineHost(TaskOwner(owner), owner)
    pauses.keep_pauses_short(host)
    assert gc.get_freeze_count() == 0
    host.running_changed.emit(True)
    qtbot.waitUntil(lambda: gc.get_freeze_count() > 0)


def test_garbage_among_frozen_objects_is_freed_at_the_next_start() -> None:
    loop = Loop()
    watched = weakref.ref(loop)
    freeze_permanent_objects()
    del loop
    gc.collect()
    assert watched() is not None  # otherwise nothing is frozen at all
    freeze_permanent_objects()
    assert watched() is None
