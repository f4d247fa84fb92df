"""Images in shared memory: slots are allocated and freed, within the system's limits."""

from __future__ import annotations

import errno
import os

import numpy as np
import pytest

from tests.notices import raises
from tests.session.recording.conftest import left_since, shared_names
from tracker.base import shared_memory
from tracker.messages import StereoFrame
from tracker.session.recording.image_slots import ImageSlots, SlotReader, bytes_of


def frame(seed: int) -> StereoFrame:
    left, right = np.random.default_rng(seed).integers(0, 256, (2, 6, 8, 3), dtype=np.uint8)
    return StereoFrame(1.0, 2.0, left, right, index=seed)


@pytest.fixture
def slots():
    before = shared_names()
    made = ImageSlots(0, bytes_of(frame(0)))
    yield made
    made.close()
    assert not left_since(before)


def test_every_slot_can_be_allocated_again_after_it_is_freed(slots) -> None:
    reader, sent = SlotReader(slots.opened), [frame(k) for k in range(slots.opened.slots)]
    put = [slots.put(f) for f in sent]
    assert slots.put(frame(99)) is None
    for image, f in zip(put, sent, strict=True):
        images = reader.images(image)
        assert np.array_equal(images["left"], f.left)
        assert np.array_equal(images["right"], f.right)
    del images
    reader.free(put[3])
    again = slots.put(frame(99))
    assert again.slot == put[3].slot and again.exposure == 99
    reader.close()


def test_the_name_is_removed_once_both_sides_are_attached(slots) -> None:
    name = slots.opened.name
    assert not shared_names() or name in shared_names()
    reader = SlotReader(slots.opened)
    assert name not in shared_names()
    reader.close()


def test_memory_that_was_never_attached_is_freed(slots) -> None:
    """Checked by the fixture: the other side never attached."""


@pytest.mark.skipif(not hasattr(os, "posix_fallocate"), reason="the system's own way to say no")
def test_a_system_with_little_memory_gives_fewer_slots_and_reports_none(monkeypatch) -> None:
    before, take, left = shared_names(), os.posix_fallocate, [3 * bytes_of(frame(0)) + 100]

    def little(handle: int, start: int, size: int) -> None:
        if size > left[0]:
            raise OSError(errno.ENOSPC, "No space left on device")
        left[0] -= size
        take(handle, start, size)

    monkeypatch.setattr(shared_memory.os, "posix_fallocate", little)
    few = ImageSlots(0, bytes_of(frame(0)))
    put = [few.put(frame(k)) for k in range(5)]
    assert [p is not None for p in put] == [True, True, True, False, False]
    reader = SlotReader(few.opened)
    reader.free(put[1])
    assert few.put(frame(9)) is not None
    reader.close()
    few.close()
    left[0] = 100
    with raises(shared_memory.NoSharedMemory, "system.shared_memory_full"):
        ImageSlots(0, bytes_of(frame(0)))
    assert not left_since(before)
