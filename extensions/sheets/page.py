"""Pages at true scale, with coordinates in millimetres from the lower left corner."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.figure import Figure

PAPERS_MM = {"a4": (210.0, 297.0), "letter": (215.9, 279.4)}
MM_PER_INCH = 25.4
MARGIN_MM = 15.0
INK, FAINT = "#1f2937", "#6b7280"


class Page:
    """One page of ``wide_mm`` by ``high_mm``; draw on ``axes`` in millimetres."""

    def __init__(self, wide_mm: float, high_mm: float) -> None:
        self.wide_mm, self.high_mm = wide_mm, high_mm
        self.figure = Figure(figsize=(wide_mm / MM_PER_INCH, high_mm / MM_PER_INCH))
        self.axes: Axes = self.figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self.axes.set_xlim(0.0, wide_mm)
        self.axes.set_ylim(0.0, high_mm)
        self.axes.axis("off")

    def text(
        self, x_mm: float, y_mm: float, text: str, points: float = 9.0, ink: str = INK
    ) -> None:
        """Draw text that starts at a position."""
        self.axes.text(x_mm, y_mm, text, fontsize=points, color=ink, va="center")

    def heading(self, title: str, note: str) -> None:
        """Draw a title and a note at the top of the page."""
        top = self.high_mm - MARGIN_MM
        self.text(MARGIN_MM, top, title, 14)
        self.text(MARGIN_MM, top - 7, note, 9, FAINT)

    def ruler(self) -> None:
        """Draw a scale of 100 mm at the bottom to check the printer's scale."""
        y, x = MARGIN_MM - 3, MARGIN_MM
        for mm in range(0, 101, 5):
            tall = 4.0 if mm % 10 == 0 else 2.5
            self.axes.plot([x + mm, x + mm], [y, y + tall], color=INK, linewidth=0.5)
        self.axes.plot([x, x + 100], [y, y], color=INK, linewidth=0.5)
        self.text(x + 103, y + 2, "100 mm: print at 100 %, not fitted to the page", 8, FAINT)


def save_pages(pages: Iterable[Page], path: Path, title: str) -> None:
    """Write all pages as one PDF; deterministic."""
    with PdfPages(path, metadata={"Title": title, "CreationDate": None}) as pdf:
        for page in pages:
            pdf.savefig(page.figure)
