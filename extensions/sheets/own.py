"""Descriptors of the sheets for building a glove and calibrating a camera."""

from __future__ import annotations

from typing import TYPE_CHECKING

from extensions.sheets.kinds import SheetKind

if TYPE_CHECKING:
    from extensions.sheets.page import Page
    from tracker.glove.model import GloveModel
    from tracker.hand.model import HandModel


def _markers(hand: HandModel, glove: GloveModel, paper: str) -> tuple[list[Page], str]:
    from extensions.sheets.markers import marker_pages

    return marker_pages(hand, glove, paper), f"Markers of the glove {glove.name}"


def _wiring(hand: HandModel, glove: GloveModel, paper: str) -> tuple[list[Page], str]:
    from extensions.sheets.wiring import wiring_page

    return [wiring_page(glove, paper)], f"Wiring of the glove {glove.name}"


def _board(hand: HandModel, glove: GloveModel, paper: str) -> tuple[list[Page], str]:
    from extensions.sheets.board import board_page

    return [board_page(paper)], "Calibration board"


MARKERS = SheetKind("markers", "marker patches and their positions", _markers)
WIRING = SheetKind("wiring", "the wiring", _wiring)
BOARD = SheetKind("board", "the calibration board of a camera", _board)
