"""What a replay shows where it stands: the latest of every stream."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from app.engines.replay.tell_markers import MarkerTeller
from tracker.live.history import History, SearchedImage
from tracker.messages import (
    BlobFrame,
    Calibration,
    Estimate,
    FrameResult,
    ImuSample,
    Message,
    Status,
    StereoFrame,
    Tracking,
    Validity,
)

IMAGES_WAITING = 30
HANDS = 60  # estimates that are kept: an image is some 40 ms older than the newest
LATE = 0.3  # s after which an image is shown without its blobs, and blobs without their image


class ReplayMoment:
    """One hand of a replay. Taken by the replay's thread, read by the window's.

    ``markers``: how many the glove has. ``has_images``: whether the file holds any, so that blobs
    wait for theirs. At one arrival time either may come first: images are packed by another process
    than the one that writes. ``teller`` tells which blob is which marker; None where no camera is
    known. ``position``: where the replay is, s of the file's monotonic clock.
    """

    def __init__(self, markers: int, has_images: bool, teller: MarkerTeller | None = None) -> None:
        self._markers, self._has_images, self._teller = markers, has_images, teller
        self._hands: deque[Estimate] = deque(maxlen=HANDS)
        self._estimate: Estimate | None = None
        self._in_hole: Estimate | None = None  # what is shown after it; None where no hole follows
        self._hole = np.inf  # s, where that begins
        self._is_fresh = False  # whether an estimate was read since the last `forget`
        self.position: Callable[[], float] = lambda: -np.inf
        self._frame: tuple[StereoFrame, BlobFrame, FrameResult] | None = None
        self._calibration: Calibration | None = None
        self._status = Status(0.0, Tracking.SEARCHING, {})
        self.forget()

    def forget(self) -> None:
        """What belongs to the position that is left; the hand stands until another one comes."""
        self._images: dict[float, StereoFrame] = {}
        self._hands.clear()
        self._is_fresh = False
        self._imu: History[ImuSample] = History()
        self._estimates: History[Estimate] = History()
        self._searched: float | None = None  # t of the last blobs, or of the first image
        self._pictured: float | None = None  # t of the last image, or of the first blobs
        self._waiting: BlobFrame | None = None  # the last blobs, whose image has not come yet

    def take(self, message: Message) -> None:
        """The next message of the file; an image waits for its blobs.

        Events of the file are on the timeline: they did not happen now.
        """
        if isinstance(message, ImuSample):
            self._imu.add(message)
        elif isinstance(message, Estimate):
            self._estimate, self._is_fresh = message, True
            self._hole, self._in_hole = np.inf, None
            self._hands.append(message)
            self._estimates.add(message)
        elif isinstance(message, StereoFrame):
            self._take_image(message)
        elif isinstance(message, BlobFrame):
            self._take_blobs(message)
        elif isinstance(message, Calibration):
            self._calibration = message
        elif isinstance(message, Status):
            self._status = message

    def _take_image(self, image: StereoFrame) -> None:
        self._pictured = image.t
        if self._waiting is not None and self._waiting.t == image.t:
            blobs, self._waiting = self._waiting, None
            self._show(image, blobs)
            return
        self._images[image.t] = image
        while len(self._images) > IMAGES_WAITING:
            self._images.pop(next(iter(self._images)))
        if self._searched is None:
            self._searched = image.t
        if image.t - self._searched > LATE:
            self._show(image, BlobFrame(image.t, image.t_arrival, (), None, None, image.pose))

    def _take_blobs(self, blobs: BlobFrame) -> None:
        self._searched = blobs.t
        if self._pictured is None:
            self._pictured = blobs.t
        image = self._images.pop(blobs.t, None)
        if image is not None:
            self._show(image, blobs)
        elif self._has_images and blobs.t - self._pictured <= LATE:
            self._waiting = blobs  # the image before stands until then
        else:
            empty = StereoFrame(blobs.t, blobs.t_arrival, None, None, blobs.pose, blobs.index)
            self._show(empty, blobs)

    def _show(self, image: StereoFrame, blobs: BlobFrame) -> None:
        if self._teller is not None:
            result = self._teller.tell(blobs, self._hands)
        else:
            tracking = self._estimate.tracking if self._estimate else Tracking.SEARCHING
            result = FrameResult.nothing(blobs.t, tracking, self._markers)
        self._frame = (image, blobs, result)

    def begin_hole(self, at: float) -> None:
        """The hand is lost from ``at`` (s) to the next estimate, as the file has none."""
        if self._estimate is not None:
            self._hole, self._in_hole = at, lost(self._estimate)

    def arrive(self) -> None:
        """Where a replay was sent to: what was shown before is not of here."""
        if not self._is_fresh:
            self.begin_hole(-np.inf)

    @property
    def is_in_hole(self) -> bool:
        """Whether the file has no estimates around the position."""
        return self._in_hole is not None and self.position() >= self._hole

    def latest_estimate(self) -> Estimate | None:
        hole = self._in_hole
        return hole if hole is not None and self.position() >= self._hole else self._estimate

    def latest_frame(
        self, t: float | None = None
    ) -> tuple[StereoFrame, BlobFrame, FrameResult] | None:
        """``t`` (s): only if it is the one of that exposure."""
        frame = self._frame
        return frame if t is None or (frame is not None and frame[0].t == t) else None

    def calibration(self) -> Calibration | None:
        return self._calibration

    def status(self) -> Status:
        """The latest one, with the state of tracking of the estimate: a status is written once a
        second, and says nothing of a gap that was interpolated later."""
        hand = self.latest_estimate()
        if hand is None or not (self._is_fresh or self.is_in_hole):
            return self._status
        return replace(self._status, tracking=hand.tracking)

    def recent_imu(self) -> Sequence[ImuSample]:
        """The samples of the last seconds."""
        return self._imu.recent()

    def recent_estimates(self) -> Sequence[Estimate]:
        """The estimates of the last seconds."""
        return self._estimates.recent()

    def recent_images(self) -> Sequence[SearchedImage]:
        """None: what the filter made of each image is not in a file."""
        return ()


def lost(estimate: Estimate) -> Estimate:
    """What is known in a hole after this estimate: nothing."""
    known = ("keypoints", "keypoint_q", "keypoint_sd", "angles", "segment_R", "segment_p")
    nothing = {name: np.full_like(getattr(estimate, name), np.nan) for name in known}
    states = {
        name: np.full_like(getattr(estimate, name), int(Validity.LOST))
        for name in ("keypoint_state", "angle_state")
    }
    return replace(estimate, tracking=Tracking.LOST, **nothing, **states)
