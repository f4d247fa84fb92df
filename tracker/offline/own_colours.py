"""Colours of a session whose images are searched: they follow its light, and are fitted to it where
they show no hand.

What decides are the messages alone, in the order of feeding, and after how many of them: the same
session gives the same colours, whatever the computer.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, notice, warning
from tracker.calibration.colours_follow import FOLLOWED, ColourFollower
from tracker.messages import BlobFrame, Event, FrameResult, ImuSample, StereoFrame, Tracking
from tracker.offline.colours_fit import Sensed, WatchedGlove, fit_messages
from tracker.offline.detection import AHEAD, detected
from tracker.session.decode import Decoded
from tracker.session.description import SessionInfo
from tracker.session.images import PackedFrame
from tracker.vision.colours import ColourProfile, profile_to_toml
from tracker.vision.detector import Detector, DetectorParams

KIND = "colours"  # of events with learned colours
APART = 0.08  # s between two images that a fit looks at
IMAGES = 12  # of them
BEFORE = 0.5  # s of packets before the first of them
ATTEMPTS = 3  # fits in a session; each takes as long as a few seconds of tracking
WAITING = 60  # images that the engine has not used yet

Searched = ImuSample | PackedFrame | BlobFrame | Event


class OwnColours:
    """`drain_events` returns events with learned colours, for the new session."""

    def __init__(self, info: SessionInfo, profile: ColourProfile) -> None:
        assert info.rig is not None
        self._watched, self._profile = WatchedGlove(info.hand, info.glove, info.rig), profile
        size = float(info.glove.marker_size.mean()) if info.glove.markers else 0.012
        self._camera = size, info.rig.fx
        self.detector = Detector(profile, *self._camera, DetectorParams())
        self._follower = ColourFollower(profile, info.glove, *self._camera)
        self._packed: deque[PackedFrame] = deque(maxlen=WAITING)
        self._blobs: dict[float, BlobFrame] = {}
        self._handless: list[PackedFrame] = []
        self._packets: deque[ImuSample] = deque()
        self._left, self._stale = ATTEMPTS, 0  # images that were searched with colours before
        self._events: list[Event] = []

    def searched(self, messages: Iterable[Decoded], threads: int, keep: bool) -> Iterator[Searched]:
        """Yields ``messages`` with the blobs of their images; with ``keep``, also the images."""
        for message in detected(messages, lambda: self.detector, threads, keep=True):
            if isinstance(message, PackedFrame):
                self._packed.append(message)
                if not keep:
                    continue
            elif isinstance(message, BlobFrame):
                self._blobs[message.t] = message
            elif isinstance(message, ImuSample):
                self._packets.append(message)
            yield message  # type: ignore[misc]

    def used(self, results: Sequence[FrameResult]) -> None:
        """What the engine has made of images."""
        for result in results:
            frame = next((p for p in self._packed if p.t == result.t), None)
            blobs = self._blobs.pop(result.t, None)
            if frame is None or blobs is None or not self._follower.is_due(frame.t):
                continue
            images = frame.unpack()
            new = self._follower.look(images, blobs, result) if images is not None else None
            if new is not None:
                self._use(new, frame.t, FOLLOWED)

    def looked(self, frame: BlobFrame, tracking: Tracking) -> None:
        """Takes the state of tracking after an image."""
        if tracking not in (Tracking.SEARCHING, Tracking.LOST):
            self._handless.clear()
            self._forget(frame.t - BEFORE)
            return
        self._stale = max(self._stale - 1, 0)
        packed = self._packed[-1]
        if self._stale:
            return
        if not self._handless or packed.t - self._handless[-1].t >= APART:
            self._handless.append(packed)
        self._forget(self._handless[0].t - BEFORE)
        if len(self._handless) >= IMAGES and self._left:
            self._left -= 1
            self._fit()
            self._handless.clear()

    def _forget(self, before: float) -> None:
        while self._packets and self._packets[0].t < before:
            self._packets.popleft()
        for t in [t for t in self._blobs if t < before]:
            del self._blobs[t]

    def _fit(self) -> None:
        """Fits colours to images in which no hand was found; a refusal is reported once."""
        unpacked = (p.unpack() for p in self._handless)
        frames: list[StereoFrame] = [f for f in unpacked if f is not None]
        if not frames:
            return
        last = max(f.t_arrival for f in frames)
        messages: list[Sensed] = [p for p in self._packets if p.t_arrival <= last]
        messages += frames
        messages.sort(key=lambda m: m.t_arrival)
        try:
            fit = fit_messages(messages, self._watched, self._profile)
        except GlovetrackError as error:
            if self._left == ATTEMPTS - 1:
                refused = warning("colours.no_hand", why=error.notice)
                self._events.append(Event.of(frames[-1].t, "tracking", refused))
            return
        self._follower.take(fit.profile)
        self._stale = AHEAD + 2
        what = notice("colours.fitted_themselves")
        if fit.exchanged:
            what = notice("colours.exchanged_corrected", hues=fit.exchanged)
        self._use(fit.profile, frames[-1].t, what)

    def _use(self, profile: ColourProfile, t: float, what: Notice) -> None:
        """From the next image that is searched."""
        self.detector = Detector(profile, *self._camera, DetectorParams())
        text = profile_to_toml(replace(profile, name="followed"))
        self._events.append(Event.of(t, KIND, what, {"colours": text}))

    def drain_events(self) -> list[Event]:
        """The events since the last call, oldest first."""
        events, self._events = self._events, []
        return events
