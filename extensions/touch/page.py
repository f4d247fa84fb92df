"""The printed pages: the sheet, and the strip that is folded into a ridge."""

from __future__ import annotations

from extensions.sheets.page import FAINT, INK, PAPERS_MM, Page
from extensions.touch import sheet
from extensions.touch.sheet import CROSSES, SheetCross, TouchSheet
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel

MM = 1000.0
LABEL_MM = 4.0  # of a cross's number from its middle


def touch_pages(paper: str = "a4") -> list[Page]:
    """The sheet and the strip, landscape."""
    high_mm, wide_mm = PAPERS_MM[paper]
    return [_sheet_page(wide_mm, high_mm), _strip_page(wide_mm, high_mm)]


def _sheet_page(wide_mm: float, high_mm: float) -> Page:
    page = Page(wide_mm, high_mm)
    frame_wide, frame_high = TouchSheet.width * MM, TouchSheet.height * MM
    left, foot = (wide_mm - frame_wide) / 2, (high_mm - frame_high) / 2 + 2.0
    page.axes.imshow(
        TouchSheet().image(),
        cmap="gray",
        extent=(left, left + frame_wide, foot, foot + frame_high),
        interpolation="none",
        aspect="auto",
        vmin=0,
        vmax=255,
    )
    page.axes.set_xlim(0.0, wide_mm)
    page.axes.set_ylim(0.0, high_mm)
    top = foot + frame_high
    for cross in CROSSES:
        if cross.height == 0:
            _draw_cross(page, cross, left + cross.x * MM, top - cross.y * MM)
    _ridge_outline(page, left + TouchSheet.width * MM / 2, top - sheet.RIDGE_Y * MM)
    _scale_line(page, left, foot - 5.0)
    return page


def _draw_cross(page: Page, cross: SheetCross, x_mm: float, y_mm: float) -> None:
    half = sheet.CROSS * MM / 2
    page.axes.plot([x_mm - half, x_mm + half], [y_mm, y_mm], color=INK, linewidth=0.6)
    page.axes.plot([x_mm, x_mm], [y_mm - half, y_mm + half], color=INK, linewidth=0.6)
    page.text(x_mm + LABEL_MM, y_mm + LABEL_MM, cross.name, 11)


def _ridge_outline(page: Page, x_mm: float, y_mm: float) -> None:
    """Where the ridge stands: its corners, and a word."""
    half_wide, half_high = sheet.RIDGE_LENGTH * MM / 2, sheet.RIDGE_TOP * MM / 2
    xs = [x_mm - half_wide, x_mm + half_wide, x_mm + half_wide, x_mm - half_wide]
    ys = [y_mm - half_high, y_mm - half_high, y_mm + half_high, y_mm + half_high]
    page.axes.plot([*xs, xs[0]], [*ys, ys[0]], color=FAINT, linewidth=0.5, linestyle="--")
    page.text(x_mm - 22, y_mm, "ridge (folded strip)", 8, FAINT)


def _scale_line(page: Page, x_mm: float, y_mm: float) -> None:
    length = sheet.RULER * MM
    page.axes.plot([x_mm, x_mm + length], [y_mm, y_mm], color=INK, linewidth=0.6)
    for end in (x_mm, x_mm + length):
        page.axes.plot([end, end], [y_mm - 2, y_mm + 2], color=INK, linewidth=0.6)
    page.text(
        x_mm + length / 2 - 25, y_mm - 3, "260 mm: measure this line; print at 100 %", 8, FAINT
    )


def _strip_page(wide_mm: float, high_mm: float) -> Page:
    """The unfolded strip: tab, side, top with crosses, side, tab."""
    page = Page(wide_mm, high_mm)
    page.heading(
        "Ridge of the touch test",
        "Cut out, fold along the dashed lines, tape the tabs to the sheet around the outline; "
        f"height {sheet.RIDGE_HEIGHT * MM:g} mm",
    )
    parts = (sheet.TAB, sheet.RIDGE_HEIGHT, sheet.RIDGE_TOP, sheet.RIDGE_HEIGHT, sheet.TAB)
    length = sheet.RIDGE_LENGTH * MM
    left, y = (wide_mm - length) / 2, high_mm - 40.0
    page.axes.plot([left, left + length], [y, y], color=INK, linewidth=0.8)
    top = y
    for k, part in enumerate(parts):
        y -= part * MM
        style = "-" if k == len(parts) - 1 else "--"
        page.axes.plot([left, left + length], [y, y], color=INK, linewidth=0.8, linestyle=style)
    for x in (left, left + length):
        page.axes.plot([x, x], [y, top], color=INK, linewidth=0.8)
    middle = (top + y) / 2
    frame_left = left - (TouchSheet.width * MM - length) / 2
    for cross in CROSSES:
        if cross.height > 0:
            _draw_cross(page, cross, frame_left + cross.x * MM, middle)
    return page


def printed_pages(hand: HandModel, glove: GloveModel, paper: str) -> tuple[list[Page], str]:
    """The pages and their title for ``glovetrack print``."""
    return touch_pages(paper), "Sheet of the touch test"
