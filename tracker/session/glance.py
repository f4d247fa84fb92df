"""How good a session is and what it looks like, from a few places of the file."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.errors import GlovetrackError
from tracker.messages import Tracking
from tracker.session.decode_estimate import tracking_of
from tracker.session.images import decode_image
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import last_before, ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, sensors, topics

PLACES = 20


@dataclass(frozen=True)
class Quality:
    """``tracked``: share of the places looked at where the hand was tracked; None: not tracked at
    all yet. ``packets_lost`` by the last status; None where there is none.
    """

    tracked: float | None
    packets_lost: int | None


def quality(reader: SessionReader, places: int = PLACES) -> Quality:
    """Looks at ``places`` instants, evenly spread: an hour takes no longer than a minute."""
    status_there = topics.STATUS in reader.topic_names
    topic = topics.STATUS if status_there else topics.hand(reader.info.side, "states")
    if topic not in reader.topic_names:
        return Quality(None, None)
    words, lost = [], None
    for raw in _spread(reader, topic, places):
        for said in motion.unpack_diagnostics(raw.data)[1]:
            if said.name in ("tracker", "tracking"):
                words.append(tracking_of(said.message))
            if "imu_lost" in said.values:
                lost = round(float(said.values["imu_lost"]))
    if not words:
        return Quality(None, lost)
    return Quality(sum(w == Tracking.TRACKING for w in words) / len(words), lost)


def _spread(reader: SessionReader, topic: str, places: int) -> Iterator[RawMessage]:
    """The message of ``topic`` that holds at each of the places."""
    first, last = reader.span_ns
    for time in np.linspace(first, last, places + 1)[1:].astype(np.int64):
        raw = last_before(reader.source, topic, int(time) + 1)
        if raw is not None:
            yield raw


def thumbnail(reader: SessionReader, width: int) -> NDArray[np.uint8] | None:
    """(h, width, 3) BGR from the middle of the left images; None where there are none."""
    wanted = frozenset([topics.image("left")])
    middle = sum(reader.span_ns) // 2
    for start in (middle, 0):
        for raw in ordered(reader.source, wanted, start):
            encoded = sensors.unpack_image(raw.data)
            try:
                image = decode_image(encoded.data, encoded.frame)
            except GlovetrackError:
                continue  # a damaged image; the next one may be whole
            height = max(1, round(image.shape[0] * width / image.shape[1]))
            small = cv2.resize(image, (width, height), interpolation=cv2.INTER_AREA)
            return np.asarray(small, np.uint8)
    return None
