"""What the vision thread does: detection in the newest image, where markers are expected."""

from __future__ import annotations

import math
from collections.abc import Callable

from tracker.base.channels import Latest
from tracker.live.inbox import DetectedFrame, Inbox
from tracker.live.loop import LiveLoop
from tracker.messages import Shed, StereoFrame
from tracker.online.flicker_watch import FlickerWatch
from tracker.sensors.image_watch import StallWatch
from tracker.vision.colours import ColourProfile
from tracker.vision.detector import Detector, detect_frame
from tracker.vision.hints import DetectionHints
from tracker.vision.region_prediction import SearchPlan

WAIT = 0.05  # s that a step waits for an image


class Vision:
    """Detects blobs in ``images`` and passes them to ``inbox``.

    ``profile`` may be set by any thread; the detector for it, which is slow to create, is created
    for the next image.
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
        self._stalls, self._lamps = StallWatch(), FlickerWatch()
        self._last = -math.inf  # stamp of the last image that was searched
        self._shed = self._missed = 0

    def step(self) -> None:
        """Searches the newest image, if one arrives within `WAIT`. Raises Closed at the end."""
        loop = self._loop
        frame = self.images.get(WAIT)
        self._report_stall(frame)
        if frame is None:
            return
        self._notice_flicker(frame)
        if self._is_shed(frame):
            return
        if self._detector.profile is not self.profile:
            self._detector = self._make_detector(self.profile)
        started = loop.clock()
        blobs = detect_frame(self._detector, frame, self._hints(frame))
        loop.telemetry.took("detect", loop.clock() - started)
        before, self._missed = self._missed, self.images.dropped + self._inbox.skipped
        self._inbox.put_frame(DetectedFrame(frame, blobs, self._missed - before))

    def _is_shed(self, frame: StereoFrame) -> bool:
        """Whether this image is left out because the computer is too slow."""
        if 0 <= frame.t - self._last < self._loop.load.image_interval:
            self._shed += 1
            return True
        self._last = frame.t
        return False

    def figures(self) -> dict[str, float]:
        """Returns the number of images that were not searched, or whose blobs were too late."""
        return {"frames_dropped": self.images.dropped + self._inbox.skipped + self._shed}

    def _hints(self, frame: StereoFrame) -> tuple[DetectionHints, DetectionHints] | None:
        """Where to look for markers; None for the whole image."""
        loop, names = self._loop, self.profile.hue_names
        sparing = loop.load.level >= Shed.WHOLE_SEARCHES
        predicted, rig = loop.predicted, loop.rig
        return self._plan.hints(predicted, rig, frame.t, frame.pose, names, sparing)

    def _notice_flicker(self, frame: StereoFrame) -> None:
        """Report lamps that flicker."""
        image = frame.left if frame.left is not None else frame.right
        if image is not None:
            self._lamps.look(image, frame.t, frame.index)
            self._loop.journal.report_all("device", self._lamps)

    def _report_stall(self, frame: StereoFrame | None) -> None:
        """Report a device that hangs in a call that never returns."""
        watch, now = self._stalls, self._loop.clock()
        what = watch.look(now) if frame is None else watch.received(now)
        if what is not None:
            self._loop.journal.report("device", what)
