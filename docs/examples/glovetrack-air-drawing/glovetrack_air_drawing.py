"""Drawing in the air: a pinch draws a line, a fist wipes everything away."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from glovetrack.applications import Drawing, HandSample, Happening, Line, Points, Step


@dataclass(frozen=True)
class AirDrawingSettings:
    """What the panel and ``glovetrack apps --set`` may change."""

    colour: str = "#E69F00"
    width: float = 3.0  # px
    spacing: float = 0.003  # m between two points of a line


class AirDrawing:
    name, title, between = "air-drawing", "Drawing in the air", 0

    def __init__(self, settings: AirDrawingSettings) -> None:
        self.settings = settings
        self._lines: list[list[np.ndarray]] = []

    def step(self, hand: HandSample) -> Step:
        events, pen = [], hand.pinch_point("index")
        if hand.begins("fist") and self._lines:
            events.append(Happening("wiped", {"lines": len(self._lines)}))
            self._lines = []
        if hand.begins("pinch_index"):
            self._lines.append([])
            events.append(Happening("line", {"number": len(self._lines)}))
        if hand.shows("pinch_index") and pen is not None and self._lines:
            self._extend(self._lines[-1], pen)
        return Step(self._drawing(pen), events)

    def _extend(self, line: list[np.ndarray], pen: np.ndarray) -> None:
        if not line or np.linalg.norm(pen - line[-1]) > self.settings.spacing:
            line.append(pen)

    def _drawing(self, pen: np.ndarray | None) -> Drawing:
        s = self.settings
        lines = [Line(f"line{i}", np.array(line), s.colour, s.width)
                 for i, line in enumerate(self._lines) if len(line) > 1]  # fmt: skip
        tip = [] if pen is None else [Points("pen", pen[None], 0.003, s.colour)]
        return (*lines, *tip)
