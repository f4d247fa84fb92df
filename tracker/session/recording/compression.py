"""Images compressed in threads beside the writer: OpenCV holds no lock of Python's meanwhile."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor

from tracker.session.images import PackedFrame, encode_image
from tracker.session.recording.image_slots import Image, ImageInSlot, SlotReader
from tracker.session.ros.sensors import ImageMessage

THREADS = 2


class ImageCompression:
    """``done`` is called, in one of the threads, whenever a pair is ready to be taken."""

    def __init__(self, kind: str, quality: int, done: Callable[[], None]) -> None:
        self._kind, self._quality, self._done = kind, quality, done
        self._pool = ThreadPoolExecutor(THREADS, "glovetrack-images")
        self._waiting: deque[Future[PackedFrame]] = deque()

    def put(self, reader: SlotReader, image: ImageInSlot) -> None:
        """Begin with a pair; its place is free again once it is compressed."""
        future = self._pool.submit(self._compressed, reader, image)
        self._waiting.append(future)
        future.add_done_callback(lambda _: self._done())

    def _compressed(self, reader: SlotReader, image: ImageInSlot) -> PackedFrame:
        try:
            parts = {
                camera: ImageMessage(0, "", self._kind, self._encoded(pixels))
                for camera, pixels in reader.images(image).items()
            }
        finally:
            reader.free(image)
        return PackedFrame(image.t, image.t_arrival, parts, image.pose, image.exposure)

    def _encoded(self, image: Image) -> bytes:
        return encode_image(image, self._kind, self._quality)

    def take(self) -> Iterator[PackedFrame]:
        """Pairs that are ready, in the order in which they came."""
        while self._waiting and self._waiting[0].done():
            yield self._waiting.popleft().result()

    def take_all(self) -> Iterator[PackedFrame]:
        """The same, and those that are not ready yet."""
        while self._waiting:
            yield self._waiting.popleft().result()

    def close(self) -> None:
        """What was not begun is given up."""
        self._pool.shutdown(cancel_futures=True)
