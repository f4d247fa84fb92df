"""A sheet for ``glovetrack print``: a label for the glove's box and one for each sensor.

``glovetrack print labels -o labels.pdf``
"""

from __future__ import annotations

from glovetrack.sheets import MARGIN_MM, PAPERS_MM, GloveModel, HandModel, Page, SheetKind

HEIGHT_MM, WIDTH_MM = 12.0, 60.0


def label_pages(hand: HandModel, glove: GloveModel, paper: str) -> tuple[list[Page], str]:
    """One page of labels, and the title of the file."""
    page = Page(*PAPERS_MM[paper])
    page.heading(glove.name, f"{glove.side} hand, {len(glove.markers)} markers")
    y_mm = page.high_mm - MARGIN_MM - 25.0
    for number, name in enumerate(glove.imu_names):
        left, right, top = MARGIN_MM, MARGIN_MM + WIDTH_MM, y_mm + HEIGHT_MM
        page.axes.plot([left, right, right, left, left], [y_mm, y_mm, top, top, y_mm], "k")
        page.text(left + 3.0, y_mm + HEIGHT_MM / 2, f"{number}  {name}")
        y_mm -= HEIGHT_MM + 3.0
    page.ruler()
    return [page], f"Labels of {glove.name}"


LABELS = SheetKind("labels", "labels for the glove's box and sensors", label_pages)
