"""The camera's calibration board on a page, at true scale."""

from __future__ import annotations

from extensions.sheets.kinds import SheetKind
from extensions.sheets.page import PAPERS_MM, Page
from tracker.calibration.stereo.board import BoardSpec, page_size, print_image
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel


def board_page(paper: str = "a4", spec: BoardSpec | None = None) -> Page:
    """A landscape page with the board and a ruler."""
    high_mm, wide_mm = PAPERS_MM[paper]
    page = Page(wide_mm, high_mm)
    board, _ = print_image(spec or BoardSpec(), dpi=300)
    board_wide_mm, board_high_mm = (1000 * side for side in page_size(spec or BoardSpec()))
    left, foot = (wide_mm - board_wide_mm) / 2, (high_mm - board_high_mm) / 2
    page.axes.imshow(
        board,
        cmap="gray",
        extent=(left, left + board_wide_mm, foot, foot + board_high_mm),
        interpolation="none",
        aspect="auto",
        vmin=0,
        vmax=255,
    )
    page.axes.set_xlim(0.0, wide_mm)
    page.axes.set_ylim(0.0, high_mm)
    return page


def _sheet(_hand: HandModel, _glove: GloveModel, paper: str) -> tuple[list[Page], str]:
    return [board_page(paper)], "Calibration board"


BOARD = SheetKind("board", "the calibration board of a camera", _sheet)
