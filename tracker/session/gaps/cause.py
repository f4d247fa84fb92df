"""Finds out why a keypoint was not measured, from the sensor messages of that time."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from tracker.messages import EYES, IntArray
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import topics

OCCLUDED, NOT_SEARCHED, NO_IMAGES = "occluded", "not searched", "no images"
NO_PACKETS, NO_IMU, NO_SENSOR = "packets missing", "IMU missing", "no sensor"
PAUSED, NOT_COMPUTED, UNKNOWN = "paused", "not computed", "unknown"
CAUSES = (
    OCCLUDED, NOT_SEARCHED, NO_IMAGES, NO_PACKETS, NO_IMU, NO_SENSOR, PAUSED, NOT_COMPUTED, UNKNOWN,
)  # fmt: skip
"""The camera saw too few of the markers; images arrived that nothing searched; no images arrived;
the glove sent no packets; an IMU of the part did not answer; nothing measures the part; nothing was
recorded at all; sensors and images are there but no estimate; the session has no sensors."""
_SHARE = 0.5
"""For the messages that a topic has on average, below which it counts as missing."""


class CauseFinder:
    """Finds causes; reads the arrival times of the sensors' messages once, for the first cause."""

    def __init__(self, reader: SessionReader) -> None:
        self._reader = reader
        info = reader.info
        self._packets = topics.packets(info.side)
        self._imus = {
            topics.imu(info.side, imu.name): imu.segment.split("_")[0] for imu in info.glove.imus
        }
        self._images = [topics.image(c) for c in EYES]
        self._blobs = [topics.blobs(c) for c in EYES]

    def of(
        self, keypoints: Sequence[str], kind: str, span_ns: tuple[int, int], unsensed: bool
    ) -> str:
        """One of `CAUSES`; ``unsensed``: the keypoints are never measured in the session."""
        if unsensed and kind == "inferred":
            return NO_SENSOR
        start, stop = span_ns
        there = {name: self._is_there(name, start, stop) for name in self._times}
        if not there:
            return UNKNOWN
        if not any(there.values()):
            return PAUSED
        if there.get(self._packets) is False:
            return NO_PACKETS
        parts = {name.split("_")[0] for name in keypoints}
        own = [topic for topic, part in self._imus.items() if part in parts]
        if kind == "inferred" and any(there.get(topic) is False for topic in own):
            return NO_IMU
        return self._of_camera(there, kind)

    def _of_camera(self, there: dict[str, bool], kind: str) -> str:
        images = [there[name] for name in self._images if name in there]
        blobs = [there[name] for name in self._blobs if name in there]
        if images and not any(images):
            return NO_IMAGES
        if images and blobs and not any(blobs):
            return NOT_SEARCHED
        if blobs and not any(blobs):
            return NO_IMAGES
        if kind == "hole":
            return NOT_COMPUTED
        return OCCLUDED if images or blobs else UNKNOWN

    def _is_there(self, topic: str, start: int, stop: int) -> bool:
        """Whether a topic has its usual number of messages in an interval (ns)."""
        times = self._times[topic]
        span = times[-1] - times[0]
        usual = (len(times) - 1) / span if span > 0 else 0.0
        inside = np.searchsorted(times, stop) - np.searchsorted(times, start, side="right")
        expected = usual * (stop - start)
        return bool(expected < 1 or inside >= _SHARE * expected)

    @cached_property
    def _times(self) -> dict[str, IntArray]:
        """Log times (ns) of the session's topics."""
        wanted = {self._packets, *self._imus, *self._images, *self._blobs}
        found: dict[str, list[int]] = {}
        for raw in ordered(self._reader.source, frozenset(wanted & self._reader.topic_names)):
            found.setdefault(raw.topic, []).append(raw.log_time)
        return {name: np.array(times, np.int64) for name, times in found.items()}
