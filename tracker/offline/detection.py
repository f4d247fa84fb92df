"""Images of a session searched ahead of the engine, on a few threads."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor

from tracker.messages import BlobFrame, CameraImuSample, Event, ImuSample, WristPose
from tracker.session.decode import Decoded
from tracker.session.images import PackedFrame
from tracker.vision.detector import Detector, detect_frame

_Packet = ImuSample | CameraImuSample | WristPose | Event
AHEAD = 12  # pairs of images unpacked before the engine asks for them: 65 MB at 720p


def detected(
    messages: Iterable[Decoded],
    detector: Callable[[], Detector],
    threads: int,
    keep: bool = False,
) -> Iterator[_Packet | PackedFrame | BlobFrame]:
    """Yields packets and events unchanged and the blobs of images, in the order of ``messages``.

    With ``keep``, also each pair of images, before its blobs.

    ``detector`` is called once for each pair, a fixed number of images ahead of those that are
    returned. Unpacking and detection release the interpreter lock and depend only on their image,
    so the result is the same with any number of ``threads``.
    """
    waiting: deque[_Packet | PackedFrame | Future[BlobFrame | None]] = deque()
    images = 0
    pool = ThreadPoolExecutor(threads, "glovetrack-detect")
    try:
        for message in messages:
            if isinstance(message, PackedFrame):
                if keep:
                    waiting.append(message)
                waiting.append(pool.submit(_find, detector(), message))
                images += 1
            elif isinstance(message, _Packet):
                waiting.append(message)
            while images > AHEAD or (waiting and not isinstance(waiting[0], Future)):
                first = waiting.popleft()
                images -= isinstance(first, Future)
                yield from _ready(first)
        for item in waiting:
            yield from _ready(item)
    finally:
        pool.shutdown(cancel_futures=True)


def _find(detector: Detector, frame: PackedFrame) -> BlobFrame | None:
    """None where all images of the frame are damaged."""
    images = frame.unpack()
    return detect_frame(detector, images) if images is not None else None


def _ready(
    item: _Packet | PackedFrame | Future[BlobFrame | None],
) -> Iterator[_Packet | PackedFrame | BlobFrame]:
    found = item.result() if isinstance(item, Future) else item
    if found is not None:
        yield found
