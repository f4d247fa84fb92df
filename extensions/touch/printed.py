"""Descriptor of the touch test's sheet for ``glovetrack print``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from extensions.sheets.kinds import SheetKind

if TYPE_CHECKING:
    from extensions.sheets.page import Page
    from tracker.glove.model import GloveModel
    from tracker.hand.model import HandModel


def _pages(hand: HandModel, glove: GloveModel, paper: str) -> tuple[list[Page], str]:
    from extensions.touch.page import touch_pages

    return touch_pages(paper), "Sheet of the touch test"


TOUCH = SheetKind("touch", "the sheet of the touch test", _pages)
