"""Runs one application on successive estimates, without threads and clocks.

The start and each change of a setting are events, so that a recorded session contains everything
needed to run the application again: the same estimates give the same events.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from extensions.applications.drawing import Drawing
from extensions.applications.hand import HandReader, HandSample, predicted
from extensions.applications.interface import Command, Happening, Step
from extensions.applications.registry import changed, make
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Estimate, Event

KIND = "application"
BEGINS, ENDS, SETTING, FAILED = "begins", "ends", "setting", "failed"
PACKET = 0.01  # s between two estimates of a glove


@dataclass(frozen=True, eq=False)
class Outcome:
    """Result of one sample at ``t`` (s); the next one of this estimate is ``next_after`` s
    later."""

    t: float
    next_after: float
    hand: HandSample
    drawing: Drawing
    events: tuple[Event, ...]
    commands: Sequence[Command]


class ApplicationRunner:
    """Feeds an application. Raises ConfigError if it cannot be created."""

    def __init__(
        self,
        name: str,
        hand: HandModel,
        glove: GloveModel,
        settings: Mapping[str, Any] | None = None,
    ) -> None:
        self.name, self.side = name, hand.side
        self._hand, self._glove = hand, glove
        self._settings = dict(settings or {})
        self.restart()

    def restart(self) -> None:
        """Start over with the current settings."""
        self.application = make(self.name, self._settings)
        self._reader = HandReader(self._hand, self._glove)
        self._last: HandSample | None = None
        self._begun = False
        self._changes: list[tuple[str, Any]] = []

    @property
    def settings(self) -> Any:
        return self.application.settings

    def set(self, key: str, value: Any) -> None:
        """Change a setting from the next sample on. Raises ConfigError."""
        settings = changed(self.application.settings, key, value, self.name)
        prepare = getattr(self.application, "prepare", None)
        if prepare is not None:
            try:
                prepare(settings)
            except GlovetrackError as error:
                raise ConfigError(error.notice) from error
        self._settings[key] = value
        self._changes.append((key, value))

    def feed(self, estimate: Estimate) -> Iterator[Outcome]:
        """Yields the results of an estimate: of its own sample, then of the predicted ones."""
        before, now = self._last, self._reader.read(estimate)
        self._last = now
        many = self.application.between if before is not None else 0
        pause = PACKET / (many + 1)
        yield self._step(now, self._openings(now), pause if many else 0.0)
        for k in range(1, many + 1):
            assert before is not None
            hand = predicted(before, now, pause * k)
            yield self._step(hand, [], pause if k < many else 0.0)

    def _openings(self, hand: HandSample) -> list[Event]:
        """Events of the start and of changed settings that take effect with this sample."""
        out = []
        if not self._begun:
            self._begun = True
            # as read back from JSON: tuples are lists in a session
            settings = json.loads(json.dumps(asdict(self.application.settings)))
            out.append(self._event(hand, Happening(BEGINS, {"settings": settings})))
        changes, self._changes = self._changes, []  # another thread may add meanwhile
        for key, value in changes:
            settings = changed(self.application.settings, key, value, self.name)
            self.application.settings = settings
            out.append(self._event(hand, Happening(SETTING, {"key": key, "value": value})))
        return out

    def _step(self, hand: HandSample, events: list[Event], next_after: float) -> Outcome:
        step: Step = self.application.step(hand)
        events = events + [self._event(hand, happening) for happening in step.events]
        return Outcome(hand.t, next_after, hand, step.drawing, tuple(events), step.commands)

    def _event(self, hand: HandSample, happening: Happening) -> Event:
        data = {"application": self.name, "hand": self.side, "what": happening.what}
        return Event(hand.t, KIND, "", {**data, **happening.data})

    @property
    def has_begun(self) -> bool:
        """Whether the application has received a sample."""
        return self._begun

    def ended(self, t: float) -> Event:
        """The event that the application has ended."""
        data: dict[str, object] = {"application": self.name, "hand": self.side, "what": ENDS}
        return Event(t, KIND, "", data)
