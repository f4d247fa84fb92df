"""When the log blames the colours, and when it takes that back."""

import numpy as np

from tracker.base.notices import Notice, warning
from tracker.messages import BlobFrame, Blobs, Tracking
from tracker.online.colour_watch import PATIENCE, ColourWatch

MARKERS = 37


def blobs(t: float, count: int) -> BlobFrame:
    uv = np.zeros((count, 2))
    one = Blobs.empty()
    fields = {n: getattr(one, n) for n in ("uv", "size", "hue", "score")}
    many = {n: np.zeros((count, *a.shape[1:]), a.dtype) for n, a in fields.items()}
    assert many["uv"].shape == uv.shape
    return BlobFrame(t, t, ("red",), Blobs(**many), None)


def reported(
    count: int, tracking: Tracking, seconds: float = 3.0, fps: float = 30.0
) -> list[Notice]:
    watch = ColourWatch(MARKERS)
    for k in range(round(seconds * fps)):
        watch.look(blobs(10 + k / fps, count), tracking)
    return watch.notices.drain()


def test_many_patches_without_a_hand_are_said_once() -> None:
    unfit = warning("colours.unfit", patches=400)
    assert reported(400, Tracking.SEARCHING) == [unfit]
    assert reported(400, Tracking.LOST) == [unfit]


def test_nothing_is_said_of_a_tracked_hand_a_clean_room_or_a_moment() -> None:
    assert reported(400, Tracking.TRACKING) == []
    assert reported(MARKERS, Tracking.SEARCHING) == []
    assert reported(400, Tracking.SEARCHING, PATIENCE - 0.2) == []


def test_it_is_taken_back_when_the_hand_is_found() -> None:
    watch = ColourWatch(MARKERS)
    for k in range(90):
        watch.look(blobs(10 + k / 30, 400), Tracking.LOST)
    assert watch.figures() == {"colours_unfit": 1.0}
    watch.look(blobs(13.1, 400), Tracking.TRACKING)
    assert watch.figures() == {"colours_unfit": 0.0}
    assert len(watch.notices.drain()) == 2
    watch.look(blobs(13.2, 400), Tracking.TRACKING)
    assert watch.notices.drain() == []


def test_seconds_without_images_do_not_count() -> None:
    watch = ColourWatch(MARKERS)
    watch.look(blobs(10.0, 400), Tracking.LOST)
    watch.look(blobs(14.0, 400), Tracking.LOST)
    assert watch.notices.drain() == []
