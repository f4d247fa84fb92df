"""What the threads of the glove and of the camera do: hand on what the devices give."""

from __future__ import annotations

from dataclasses import replace

from tracker.base.channels import Latest
from tracker.base.notices import notice, plain
from tracker.engine.hands import Sided
from tracker.live.inbox import Inbox
from tracker.live.journal import Journal
from tracker.live.telemetry import Telemetry
from tracker.messages import Event, StereoFrame
from tracker.sensors.sources import CameraSource, GloveSource, ReportingGlove

WAIT = 0.05  # s that a step waits for its device


class GloveReader:
    """Packets go to the engine's inbox, events into the journal.

    ``named``: events say which glove they are of, where there is another one.
    """

    def __init__(
        self, glove: GloveSource, side: str, inbox: Inbox, journal: Journal, named: bool = False
    ) -> None:
        self._glove, self._side, self._named = glove, side, named
        self._inbox, self._journal = inbox, journal

    def step(self) -> None:
        """Take what has come."""
        for item in self._glove.poll(WAIT):
            if isinstance(item, Event):
                self._journal.add(self._of_side(item) if self._named else item)
            else:
                self._inbox.put(Sided(item, self._side))

    def _of_side(self, event: Event) -> Event:
        what = event.notice or plain(event.text)
        named = replace(notice("glove.of_side", side=self._side, what=what), severity=what.severity)
        return replace(event, text=str(named), notice=named)

    def figures(self) -> dict[str, float]:
        """Battery, counters and clock, of a glove that reports them."""
        return self._glove.figures.values() if isinstance(self._glove, ReportingGlove) else {}


class CameraReader:
    """Images go to the vision thread, which may miss some, and onto the disk, which does not."""

    def __init__(
        self,
        camera: CameraSource,
        images: Latest[StereoFrame],
        journal: Journal,
        telemetry: Telemetry,
    ) -> None:
        self._camera, self._images = camera, images
        self._journal, self._telemetry = journal, telemetry

    def step(self) -> None:
        """Take the next image pair."""
        frame = self._camera.read(WAIT)
        for event in self._camera.take_events():
            self._journal.add(event)
        if frame is not None:
            self._telemetry.tick("frame", frame.t_arrival)
            self._journal.record(frame)
            self._images.put(frame)
