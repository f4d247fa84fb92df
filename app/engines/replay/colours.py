"""The colours that a session was searched with, which follow its light, and those tried on it."""

from __future__ import annotations

import logging
from bisect import bisect_right
from collections.abc import Sequence

from tracker.base.errors import GlovetrackError
from tracker.live.colours import KIND
from tracker.messages import Event
from tracker.vision.colours import ColourProfile, parse_profile

_log = logging.getLogger(__name__)


class ColoursOfFile:
    """By positions in s from the file's start, from which on they were looked for."""

    def __init__(self, first: ColourProfile, events: Sequence[tuple[float, Event]]) -> None:
        """``first``: those that the session began with."""
        told = sorted(
            (
                (t, str(e.data["colours"]))
                for t, e in events
                if e.kind == KIND and "colours" in e.data
            ),
            key=lambda of: of[0],
        )
        self._first, self._tried = first, first
        self._starts = [t for t, _ in told]
        self._texts = [text for _, text in told]
        self._read: dict[int, ColourProfile] = {}  # only what was looked at: reading takes a while

    def tried(self, profile: ColourProfile) -> None:
        """These are shown everywhere from now on; those of the file end that."""
        self._tried = profile

    def at(self, position: float) -> ColourProfile:
        """Those to be shown there."""
        if self._tried is not self._first and self._tried not in self._read.values():
            return self._tried
        return self._of(bisect_right(self._starts, position) - 1)

    def _of(self, index: int) -> ColourProfile:
        """Of a change; what cannot be read, or is of another glove, changes nothing."""
        if index < 0:
            return self._first
        if index not in self._read:
            before = self._of(index - 1)
            try:
                new = parse_profile(self._texts[index])
            except GlovetrackError as error:
                _log.warning("Colours in the session were not taken: %s", error)
                new = before
            self._read[index] = new if new.hue_names == before.hue_names else before
        return self._read[index]
