"""The times of a session's images that have detected blobs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from itertools import islice

from tracker.base.errors import FileError
from tracker.messages import BlobFrame, StereoFrame
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader

MOST_BEFORE_SIGHT = 500  # messages; a session without a pair among them has no pairs
APART = 60  # the most images or blobs between the two of a pair


def first_sight(reader: SessionReader) -> float | None:
    """The arrival (s) of the first blobs whose image is in the file too; None without any. The
    image of earlier blobs may have been taken before the recording began."""
    messages = reader.packed_messages((StereoFrame, BlobFrame))
    with suppress(FileError):  # damage was reported at the first reading
        return next(pairs(islice(messages, MOST_BEFORE_SIGHT)), None)
    return None


def sights(reader: SessionReader, begin: float, end: float) -> list[float]:
    """The arrivals (s) of images with blobs in a span; of either, where the file contains only
    one of them. Images are not decompressed."""
    found = list(reader.packed_messages((StereoFrame, BlobFrame), start=begin, end=end))
    either = [m.t_arrival for m in found if isinstance(m, PackedFrame | BlobFrame)]
    return list(pairs(found)) or either


def pairs(messages: Iterable[object]) -> Iterator[float]:
    """Arrival (s) of each image or blobs whose other half arrived before, in either order."""
    waiting: dict[float, type] = {}
    for message in messages:
        if not isinstance(message, PackedFrame | BlobFrame):
            continue
        if waiting.get(message.t, type(message)) is not type(message):
            del waiting[message.t]
            yield message.t_arrival
        else:
            waiting[message.t] = type(message)
            if len(waiting) > APART:
                waiting.pop(next(iter(waiting)))
