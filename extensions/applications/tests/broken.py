"""An application that fails at its third sample."""

from __future__ import annotations

from extensions.applications.hand import HandSample
from extensions.applications.interface import NoSettings, Step


class Broken:
    name, title, between = "broken", "Broken", 0

    def __init__(self, settings: NoSettings) -> None:
        self.settings = settings
        self._left = 2

    def step(self, hand: HandSample) -> Step:
        self._left -= 1
        1 / (self._left + 1)
        return Step()
