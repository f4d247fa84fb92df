"""Matches an image with the result that the filter, which lags behind, produces later."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, NamedTuple

from tracker.live.history import History, SearchedImage
from tracker.messages import BlobFrame, FrameResult, StereoFrame, Tracking

if TYPE_CHECKING:  # the window, which shows frames, does not load the engine
    from tracker.live.inbox import DetectedFrame

MOST_WAITING = 30  # images; they have no results while searching
MOST_SHOWN = 4  # images that are stored with their results


class ShownFrame(NamedTuple):
    """An image, the blobs found in it and the result of the filter."""

    image: StereoFrame
    blobs: BlobFrame
    result: FrameResult


class FrameResults:
    """Written by one thread; ``latest`` and ``history`` may be read by any."""

    def __init__(self) -> None:
        self._waiting: deque[DetectedFrame] = deque()
        self._shown: tuple[ShownFrame, ...] = ()
        self.history: History[SearchedImage] = History()

    @property
    def latest(self) -> ShownFrame | None:
        """The newest image with a result; None before the first."""
        return self._shown[-1] if self._shown else None

    def of(self, t: float) -> ShownFrame | None:
        """Returns the image of ``t`` (s); None if it is not stored any more."""
        return next((shown for shown in self._shown if shown.image.t == t), None)

    def _show(self, found: DetectedFrame, result: FrameResult) -> None:
        self._shown = (*self._shown[1 - MOST_SHOWN :], ShownFrame(found.frame, found.blobs, result))
        left, right = (len(blobs or ()) for blobs in (found.blobs.left, found.blobs.right))
        self.history.add(SearchedImage(result.t, left, right, result))

    def wait_for(self, found: DetectedFrame) -> None:
        """Stores an image that was just fed to the filter."""
        self._waiting.append(found)

    def match(self, result: FrameResult) -> DetectedFrame | None:
        """Returns the image of ``result``, now the latest; None if it is not stored any more."""
        while self._waiting and self._waiting[0].blobs.t < result.t:
            self._waiting.popleft()
        if not self._waiting:
            return None
        found = self._waiting.popleft()
        self._show(found, result)
        return found

    def forget_old(self) -> None:
        """Discards all but the newest `MOST_WAITING` images."""
        while len(self._waiting) > MOST_WAITING:
            self._waiting.popleft()

    def show_unmatched(self, markers: int) -> None:
        """Makes the newest image the latest, with none of the ``markers`` matched in it."""
        if self._waiting:
            found = self._waiting[-1]
            nothing = FrameResult.nothing(found.blobs.t, Tracking.SEARCHING, markers)
            if self.latest is None or self.latest.blobs is not found.blobs:
                self._show(found, nothing)
