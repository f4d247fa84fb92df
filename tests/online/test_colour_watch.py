"""When the log reports unsuitable colours, and when it withdraws that."""

import numpy as np

from tracker.base.notices import Notice, warning
from tracker.messages import BlobFrame, Blobs, Tracking
from tracker.online.colour_watch import DELAY, ColourWatch

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


def test_many_patches_without_a_hand_are_reported_once() -> None:
    unfit = warning("colours.unfit", patches=400)
    assert reported(400, Tracking.SEARCHING) == [unfit]
    assert reported(400, Tracking.LOST) == [unfit]


def test_a_tracked_hand_an_empty_scene_or_a_moment_are_not_reported() -> None:
    assert reported(400, Tracking.TRACKING) == []
    assert reported(MARKERS, Tracking.SEARCHING) == []
    assert reported(400, Tracking.SEARCHING, DELAY - 0.2) == []


def test_it_is_withdrawn_when_the_hand_is_found() -> None:
    watch = ColourWatch(MARKERS)
    for k in range(90):
        watch.look(blobs(10 + k / 30, 400), Tracking.LOST)
    assert watch.figures() == {"colours_unfit": 1.0}
    watch.look(blobs(13.1, 400), Tracking.TRACKING)
    assert watch.figures() == {"colours_unfit": 0.0}
    assert len(watch.notices.drain()) == 2
    watch.look(blobs(13.2, 400), Tracking.TRACKING)
    assert watch.notices.drain() == []


def test_time_without_images_does_not_count() -> None:
    watch = ColourWatch(MARKERS)
    watch.look(blobs(10.0, 400), Tracking.LOST)
    watch.look(blobs(14.0, 400), Tracking.LOST)
    assert watch.notices.drain() == []
