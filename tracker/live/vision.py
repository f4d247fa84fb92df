"""What the vision thread does: detection in the newest image, where markers are expected."""

from __future__ import annotations

from collections.abc import Callable

from tracker.channels import Latest
from tracker.live.inbox import DetectedFrame, Inbox
from tracker.live.loop import LiveLoop
from tracker.messages import StereoFrame
from tracker.sensors.image_watch import SilenceWatch
from tracker.vision.colours import ColourProfile
from tracker.vision.detector import DetectionHints, Detector, detect_frame
from tracker.vision.region_prediction import SearchPlan

WAIT = 0.05  # s that a step waits for an image


class Vision:
    """Takes images out of ``images``, puts what it found in them into ``inbox``.

    ``profile`` may be set by any thread; the detector for it, which takes a while to make, is made
    when the next image comes.
    """

    def __init__(
        self,
        profile: ColourProfile,
        make_detector: Callable[[ColourProfile], Detector],
        inbox: Inbox,
        loop: LiveLoop,
    ) -> None:
        self.profile = profile
        self.images: Latest[StereoFrame] = Latest()
        self._make_detector, self._detector = make_detector, make_detector(profile)
        self._inbox, self._loop = inbox, loop
        self._plan = SearchPlan()
        self._silence = SilenceWatch("camera")

    def step(self) -> None:
        """Detect in the newest image, if one comes within `WAIT`. Raises Closed at the end."""
        loop = self._loop
        frame = self.images.get(WAIT)
        self._notice_silence(frame)
        if frame is None:
            return
        if self._detector.profile is not self.profile:
            self._detector = self._make_detector(self.profile)
        started = loop.clock()
        blobs = detect_frame(self._detector, frame, self._hints(frame))
        loop.telemetry.took("detect", loop.clock() - started)
        self._inbox.put_frame(DetectedFrame(frame, blobs))

    def figures(self) -> dict[str, float]:
        """Images that were never looked at, or whose blobs came too late."""
        return {"frames_dropped": self.images.dropped + self._inbox.skipped}

    def _hints(self, frame: StereoFrame) -> tuple[DetectionHints, DetectionHints] | None:
        """Where to look for markers; None for the whole image."""
        loop, names = self._loop, self.profile.hue_names
        return self._plan.hints(loop.predicted, loop.pipeline.rig, frame.t, frame.pose, names)

    def _notice_silence(self, frame: StereoFrame | None) -> None:
        """A device may hang in a call that never returns: here it is noticed all the same."""
        watch, now = self._silence, self._loop.clock()
        text = watch.look(now) if frame is None else watch.heard(now)
        if text:
            self._loop.journal.say("device", text)
