"""Images of the sheets that a glove's builder prints, for the guide."""

from __future__ import annotations

from pathlib import Path

from extensions.sheets.markers import marker_pages
from extensions.sheets.wiring import wiring_page
from tracker.glove import library

DPI = 72


def take_sheets(out: Path) -> None:
    """Patches, the hand and the wiring, as PNG."""
    hand, glove = library.load()
    patches, above = marker_pages(hand, glove)[:2]
    for name, page in (("markers", patches), ("hand", above), ("wiring", wiring_page(glove))):
        page.figure.savefig(out / f"sheet-{name}.png", dpi=DPI, facecolor="white")
