"""Garbage collection does not block all threads while a hand is tracked."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QObject

from app.engines.engine_host import EngineHost
from app.platform.process_tuning import collection_postponed, freeze_permanent_objects
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


@pytest.fixture
def host(qtbot, monkeypatch: pytest.MonkeyPatch) -> Iterator[EngineHost]:
    monkeypatch.setattr(pauses, "SETTLED_MS", 1)
    owner = QObject()
    made = EngineHost(TaskOwner(owner), owner)
    pauses.keep_pauses_short(made)
    assert gc.get_freeze_count() == 0
    yield made
    assert owner is not None


def test_the_window_is_frozen_when_it_has_been_made(qtbot, host: EngineHost) -> None:
    qtbot.waitUntil(lambda: gc.get_freeze_count() > 0)


def test_what_a_start_adds_is_frozen_soon_after_it(qtbot, host: EngineHost) -> None:
    qtbot.waitUntil(lambda: gc.get_freeze_count() > 0)
    before = gc.get_freeze_count()
    added: list[list[int]] = [[] for _ in range(10_000)]
    host.running_changed.emit(True)
    qtbot.waitUntil(lambda: gc.get_freeze_count() > before + 5000)
    assert len(added) == 10_000


def test_garbage_among_frozen_objects_is_freed_when_tracking_has_ended(
    qtbot, host: EngineHost
) -> None:
    loop = Loop()
    watched = weakref.ref(loop)
    host.running_changed.emit(True)
    kept = [loop]
    del loop
    qtbot.waitUntil(lambda: not any(other is kept[0] for other in gc.get_objects()))  # frozen
    kept.clear()
    gc.collect()
    assert watched() is not None
    host.running_changed.emit(False)
    qtbot.waitUntil(lambda: watched() is None)


def test_no_garbage_is_collected_during_a_start() -> None:
    with collection_postponed():
        assert not gc.isenabled()
        freeze_permanent_objects()
        assert gc.isenabled()
    with pytest.raises(ValueError), collection_postponed():
        raise ValueError
    assert gc.isenabled()


def test_garbage_among_frozen_objects_is_freed_at_the_next_start() -> None:
    loop = Loop()
    watched = weakref.ref(loop)
    freeze_permanent_objects()
    print(
        "FROZEN",
        gc.get_freeze_count(),
        gc.is_tracked(loop),
        any(o is loop for o in gc.get_objects()),
    )
    del loop
    gc.collect()
    assert watched() is not None  # otherwise nothing is frozen at all
    freeze_permanent_objects()
    assert watched() is None
