"""One application fed with one estimate after another; no thread, no clock.

It begins, and each change of a setting, with an event, so that a recorded session tells all that it
takes to run the application again: from the same estimates it gives the same events.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from extensions.applications.drawing import Drawing
from extensions.applications.hand import HandReader, HandSample, foretold
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
    """Of one sample at ``t`` (s); another of the same estimate follows ``next_after`` s later."""

    t: float
    next_after: float
    hand: HandSample
    drawing: Drawing
    events: tuple[Event, ...]
    commands: Sequence[Command]


class ApplicationRunner:
    """Feeds an application. Raises ConfigError where it cannot be made."""

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
        self.begin_anew()

    def begin_anew(self) -> None:
        """As in the beginning, with the settings as they are now."""
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
                raise ConfigError(str(error)) from error
        self._settings[key] = value
        self._changes.append((key, value))

    def feed(self, estimate: Estimate) -> Iterator[Outcome]:
        """What an estimate brings, to be gone through: its own sample, then those foretold."""
        before, now = self._last, self._reader.read(estimate)
        self._last = now
        many = self.application.between if before is not None else 0
        pause = PACKET / (many + 1)
        yield self._step(now, self._openings(now), pause if many else 0.0)
        for k in range(1, many + 1):
            assert before is not None
            hand = foretold(before, now, pause * k)
            yield self._step(hand, [], pause if k < many else 0.0)

    def _openings(self, hand: HandSample) -> list[Event]:
        """That it begins, and changes that stand from this sample on."""
        out = []
        if not self._begun:
            self._begun = True
            # as JSON gives them back: tuples are lists in a session
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
        """Whether a sample has reached it."""
        return self._begun

    def ended(self, t: float) -> Event:
        """That it is over."""
        data: dict[str, object] = {"application": self.name, "hand": self.side, "what": ENDS}
        return Event(t, KIND, "", data)
