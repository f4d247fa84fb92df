"""Finds the recorded image nearest in time to each frame."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence

import numpy as np

from extensions.lerobot.layout import DatasetCamera
from tracker.base.clock import NS
from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice
from tracker.messages import IntArray
from tracker.session.images import image_size
from tracker.session.mcap.ordering import ordered
from tracker.session.message_check import sound
from tracker.session.reader import SessionReader
from tracker.session.ros import sensors, topics

LATE = 2 * NS
"""Largest delay in ns between the exposure and the arrival of an image."""


class NearestImages:
    """Iterates once over the images of ``cameras``; ``gap`` is the largest time between a frame and
    its image so far, s."""

    def __init__(
        self, reader: SessionReader, cameras: Sequence[DatasetCamera], at: IntArray
    ) -> None:
        self._reader, self._at = reader, at
        self._queues = {topics.image(c.name): _Queue(c, at) for c in cameras}

    @property
    def gap(self) -> float:
        return max(q.gap for q in self._queues.values()) / NS

    def __iter__(self) -> Iterator[tuple[bytes, ...]]:
        """One image per camera for each of N frames. Raises FileError if a camera has none,
        ConfigError if its images change their size."""
        queues = list(self._queues.values())
        first, last = int(self._at[0]) - LATE, int(self._at[-1]) + LATE
        wanted = frozenset(self._queues)
        source = self._reader.source
        stored = ordered(source, wanted, max(first, 0), last)
        for raw in sound(stored, source.left_out):
            self._queues[raw.topic].feed(raw.publish_time, raw.data)
            while all(q.decided for q in queues):
                yield tuple(q.decided.popleft() for q in queues)
        for q in queues:
            q.finish(str(self._reader.path))
        while queues[0].decided:
            yield tuple(q.decided.popleft() for q in queues)


class _Queue:
    """Images of one camera that are already known to be the nearest ones of their frames."""

    def __init__(self, camera: DatasetCamera, at: IntArray) -> None:
        self._camera, self._at = camera, at
        self._before: tuple[int, bytes] | None = None
        self._next = 0
        self.decided: deque[bytes] = deque()
        self.gap = 0

    def feed(self, stamp: int, message: bytes) -> None:
        data = sensors.unpack_image(message).data
        if image_size(data) != (self._camera.width, self._camera.height):
            raise ConfigError(notice("lerobot.image_sizes", camera=self._camera.name))
        if self._before is not None:
            middle = (self._before[0] + stamp) // 2
            self._give(int(np.searchsorted(self._at, middle, side="right")))
        self._before = (stamp, data)

    def finish(self, path: str) -> None:
        if self._before is None:
            raise FileError(notice("lerobot.no_images", path=path, camera=self._camera.name))
        self._give(len(self._at))

    def _give(self, end: int) -> None:
        """Assign the previous image to all frames up to ``end``."""
        if self._before is None:
            return
        stamp, data = self._before
        for k in range(self._next, end):
            self.gap = max(self.gap, abs(int(self._at[k]) - stamp))
            self.decided.append(data)
        self._next = max(self._next, end)
