"""What the Applications panel says: which there are, their settings, what they have told."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass, fields
from typing import Any

from app.engines.engine import EngineSetup
from app.words import error_text, local, tr
from extensions.applications.drawing import Drawing
from extensions.applications.live import stage_of
from extensions.applications.registry import titles
from extensions.applications.runner import BEGINS, ENDS, KIND
from extensions.applications.stage import ApplicationStage
from extensions.applications.window.words import Progress, instruction, is_known, results
from tracker.base.errors import GlovetrackError
from tracker.streaming.publisher import StreamError

PAGE_PORT = 9752
NO_EVENTS = frozenset({BEGINS, ENDS})


@dataclass(frozen=True)
class SettingRow:
    """One setting: its value is a number, a text, a boolean or a tuple of numbers."""

    key: str
    value: Any


class ApplicationsModel:
    """Of one open engine."""

    def __init__(self, setup: EngineSetup) -> None:
        self._setup = setup
        self.stage = stage_of(setup.listeners)
        self.titles = titles()

    @property
    def expected(self) -> tuple[str, dict[str, Any]]:
        """Name and settings of the application of this hand that a session holds, or that a
        simulated wearer uses; empty where there is none."""
        player, side = self._setup.player, self._setup.hand.side
        for _, event in player.events if player is not None else ():
            begins = event.kind == KIND and event.data.get("what") == BEGINS
            if begins and event.data.get("hand") == side:
                settings: Any = event.data.get("settings", {})
                return str(event.data["application"]), dict(settings)
        name, settings = self._setup.application
        return name, dict(settings)

    def show(self, name: str, settings: dict[str, Any] | None = None) -> str:
        """Run it; why it cannot be, in words, or empty."""
        if self.stage is None:
            return tr("Applications run on a tracked hand: open the demo, devices or a session.")
        try:
            self.stage.show(name, settings)
        except (GlovetrackError, ImportError) as error:
            return error_text(error)
        return ""

    @property
    def runs(self) -> bool:
        """Whether there is an application."""
        return self.stage is not None and bool(self.stage.name)

    def rows(self) -> list[SettingRow]:
        """The settings of what runs."""
        settings = self.stage.settings if self.stage is not None else None
        if settings is None:
            return []
        return [SettingRow(f.name, getattr(settings, f.name)) for f in fields(settings)]

    def set(self, key: str, value: Any) -> str:
        """Change one; why it cannot be, or empty."""
        try:
            if self.stage is not None:
                self.stage.set(key, value)
        except GlovetrackError as error:
            return error_text(error)
        return ""

    def leave(self) -> tuple[str, dict[str, Any]]:
        """End what runs, for another hand to take it over: its name and settings."""
        stage = self.stage
        if stage is None or not stage.name:
            return "", {}
        left = stage.name, json.loads(json.dumps(asdict(stage.settings)))  # rows as lists
        self.show_page(False)
        stage.show("")
        return left

    def show_page(self, on: bool) -> str:
        """Serve the page on this machine, or end it: where it is, or why it cannot be, in words."""
        stage = self.stage
        if stage is None:
            return ""
        for viewer in stage.viewers:
            viewer.close()
        stage.viewers.clear()
        if not on:
            return ""
        try:
            from extensions.applications.page import PageServer

            page = PageServer(PAGE_PORT)
        except ImportError:
            return tr('The page needs a package that is not installed: pip install "{}"').format(
                "glovetrack[streams]"
            )
        except StreamError as error:
            return error_text(error)
        stage.viewers.append(page)
        return tr("For browsers of this machine, a headset's too: {}").format(page.url)

    @property
    def drawing(self) -> Drawing:
        """The newest; empty before the first."""
        outcome = self.stage.outcome if self.stage is not None else None
        return outcome.drawing if outcome is not None else ()

    def instruction(self) -> str:
        """What the wearer is to do now; empty where that is not known."""
        stage = self.stage
        if stage is None or not stage.name or stage.problem:
            return ""
        located = stage.outcome is not None and stage.outcome.hand.located
        return instruction(stage.name, self._made(stage), located)

    @staticmethod
    def _made(stage: ApplicationStage) -> Progress:
        last = {what: event.data for what, event in stage.latest.items()}
        return Progress(Counter(dict(stage.counts)), last)

    def line(self) -> str:
        """What has happened, in one line."""
        stage = self.stage
        if stage is None or not stage.name:
            return ""
        if stage.problem:
            return tr("It failed and rests: {}").format(stage.problem)
        found = results(stage.name, self._made(stage))
        if found:
            return found
        if is_known(stage.name):
            return tr("Nothing has happened yet.")
        counts = [(what, n) for what, n in stage.counts.items() if what not in NO_EVENTS]
        return ", ".join(f"{what} {n}" for what, n in counts) or tr("Nothing has happened yet.")


def parsed(text: str, like: Any) -> Any:
    """What a user has written, as a value like ``like``. Raises ValueError."""
    if isinstance(like, tuple):
        return [float(part) for part in text.replace(";", ",").split(",") if part.strip()]
    return text


def written(value: Any) -> str:
    """A text or a tuple of numbers as a user writes it."""
    if isinstance(value, Sequence) and not isinstance(value, str):
        return ", ".join(f"{local(float(v)):g}" for v in value)
    return str(value)
