"""The times of a session's images that have detected blobs."""

from __future__ import annotations

import threading
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import islice
from pathlib import Path

from app.engines.protocols import ReferenceHand
from app.engines.replay.references import References
from tracker.base.errors import FileError
from tracker.messages import BlobFrame, Event, StereoFrame
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


# ---- the transport of a replay: position, play, seek, step, range, loop, speed


class Transport:
    """Set by the window's thread, read by the replay's; times are s from the file's start.

    The threads share plain attributes, each assigned in one step.
    """

    def __init__(self, duration: float) -> None:
        self.duration = duration
        self.playing, self.looping = True, False
        self.position, self.speed = 0.0, 1.0
        self.range = (0.0, duration)  # the in and the out point
        self.seek_to: float | None = 0.0
        self.images_due = 0  # images that a paused replay is still to show
        self.steps_back = 0
        self.stopping = threading.Event()

    def seek(self, position: float) -> None:
        self.seek_to = self.clamped(position)

    def pause_at(self, position: float) -> None:
        """Show this instant."""
        self.playing = False
        self.seek(position)

    def play(self, on: bool) -> None:
        start, stop = self.range
        if on and not start <= self.position < stop - 1e-3:
            self.seek(start)
        self.playing = on

    def set_speed(self, speed: float) -> None:
        self.speed = speed

    def set_loop(self, on: bool) -> None:
        self.looping = on

    def set_range(self, start: float, stop: float) -> None:
        """Play from ``start`` to ``stop`` s only."""
        start, stop = sorted((self.clamped(start), self.clamped(stop)))
        self.range = (start, stop)

    def clamped(self, position: float) -> float:
        return min(max(position, 0.0), self.duration)

    def step(self, images: int) -> None:
        """Pause, and go that many images forward, or (negative) back."""
        self.playing = False
        if images > 0:
            self.images_due += images
        else:
            self.steps_back -= images

    @property
    def sent_elsewhere(self) -> bool:
        """Whether the present playback is to end."""
        return self.stopping.is_set() or self.steps_back > 0 or self.seek_to is not None

    def end(self, position: float) -> None:
        """At the out point or the end of the file: loop, or stop."""
        self.position = position
        if self.looping and self.playing:
            self.seek(self.range[0])
        else:
            self.playing = False


class ReplayPlayer(Transport):
    """The `Player` of a replay: its transport, the events of the file, and the reference hands by
    side."""

    def __init__(
        self,
        path: Path,
        duration: float,
        references: Mapping[str, References],
        tracked: bool,
        cut_off: bool,
    ) -> None:
        super().__init__(duration)
        self.path, self.tracked, self.cut_off = path, tracked, cut_off
        self.events: Sequence[tuple[float, Event]] = ()  # with their positions in s
        self._references = references
        self.is_compared = False

    def set_reference(self, path: Path | None, shift: float = 0.0) -> None:
        """Compare with the tracking in ``path``. Raises FileError.

        ``shift``: s that its clock is ahead of this one's.
        """
        for references in self._references.values():
            references.want(path, shift)
        self.is_compared = path is not None
        self.seek(self.position)

    def reference(self, side: str) -> ReferenceHand | None:
        """The hand of that side in the other tracking."""
        return self._references[side].other_hand
