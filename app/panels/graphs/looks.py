"""Colours and line styles that distinguish the curves of a graph."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt

from app.viewmodels.states import BLUISH_GREEN, ORANGE, PURPLE, SKY, VERMILION, YELLOW
from app.widgets.curve_plot import CurveLook

COLOURS = (ORANGE, SKY, BLUISH_GREEN, PURPLE, VERMILION, YELLOW)
STYLES = (Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine, Qt.PenStyle.DotLine)


def curve_looks(names: Sequence[str]) -> list[CurveLook]:
    """A look for each curve: first different colours, then different line styles."""
    return [
        CurveLook(COLOURS[k % len(COLOURS)], STYLES[k // len(COLOURS) % len(STYLES)], name)
        for k, name in enumerate(names)
    ]
