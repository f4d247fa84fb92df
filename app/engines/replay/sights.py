"""When there is something to see in a session: an image with what was found in it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from itertools import islice

from tracker.base.errors import FileError
from tracker.messages import BlobFrame, StereoFrame
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader

MOST_BEFORE_SIGHT = 500  # messages; what has none of its images by then has none
APART = 60  # images or blobs that come between the two of a pair, at most


def first_sight(reader: SessionReader) -> float | None:
    """When (s) the first blobs come whose image is in the file, too: blobs may come first whose
    image was taken before the recording began. None where there are none."""
    messages = reader.packed_messages((StereoFrame, BlobFrame))
    with suppress(FileError):  # what is damaged has been told by who read it first
        return next(pairs(islice(messages, MOST_BEFORE_SIGHT)), None)
    return None


def sights(reader: SessionReader, begin: float, end: float) -> list[float]:
    """When (s) something is seen in a span: images with their blobs; where only one of the two is
    in the file, that by itself. Images are not unpacked."""
    found = list(reader.packed_messages((StereoFrame, BlobFrame), start=begin, end=end))
    either = [m.t_arrival for m in found if isinstance(m, PackedFrame | BlobFrame)]
    return list(pairs(found)) or either


def pairs(messages: Iterable[object]) -> Iterator[float]:
    """Arrival (s) of each image or blobs whose other half came before, in whichever order."""
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
