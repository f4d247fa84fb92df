"""Colours that follow the light while the hand is tracked live, in a thread of their own."""

from __future__ import annotations

from dataclasses import replace

from tracker.base.channels import Latest
from tracker.base.notices import Notice
from tracker.calibration.colours_follow import FOLLOWED, ColourFollower
from tracker.live.frame_results import ShownFrame
from tracker.live.journal import Journal
from tracker.live.vision import Vision
from tracker.messages import Event
from tracker.vision.colours import ColourProfile, profile_to_toml

WAIT = 0.05  # s that a step waits for an image
KIND = "colours"  # of events with the colours that are detected from then on
STAND = 0.5  # s after which colours that someone has set are recorded: a slider moves through many


class FollowedColours:
    """Adapts the colours of ``vision`` to the present light; learning them takes up to a second.

    Colours that are set meanwhile take precedence and are adapted from then on. Both changes are
    recorded.
    """

    def __init__(self, follower: ColourFollower, vision: Vision, journal: Journal) -> None:
        self.used: Latest[ShownFrame] = Latest()  # images that the filter has used
        self._follower, self._vision, self._journal = follower, vision, journal
        self._set_at: float | None = None  # t of the first image since someone has set colours

    def step(self) -> None:
        """Evaluates the newest image, if one arrives within `WAIT`. Raises Closed at the end."""
        used = self.used.get(WAIT)
        if used is None:
            return
        now = self._vision.profile
        frame = used[0]
        if now is not self._follower.profile:
            self._follower.take(now)
            self._set_at = frame.t
        elif self._set_at is not None and frame.t - self._set_at >= STAND:
            self._journal.record(_event(self._set_at, None, now))
            self._set_at = None
        if not self._follower.is_due(frame.t):
            return
        new = self._follower.look(*used)
        if new is None or self._vision.profile is not now:
            return
        self._vision.profile = new
        self._set_at = None
        self._journal.add(_event(frame.t, FOLLOWED, replace(new, name="followed")))


def _event(t: float, what: Notice | None, profile: ColourProfile) -> Event:
    data = {"colours": profile_to_toml(profile)}
    return Event(t, KIND, "", data) if what is None else Event.of(t, KIND, what, data)
