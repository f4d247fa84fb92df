"""``python -m extensions.sheets.pictures`` writes images of the printed sheets for the guide."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from extensions.sheets.markers import marker_pages
from extensions.sheets.wiring import wiring_page
from tracker.glove import library

DPI = 72


def main(argv: Sequence[str] | None = None) -> None:
    """Write the images."""
    parser = argparse.ArgumentParser(prog="pictures")
    parser.add_argument(
        "--out",
        type=Path,
        default=Path("docs/screenshots"),
        help="folder for the images (default: docs/screenshots)",
    )
    take_sheets(parser.parse_args(argv).out)


def take_sheets(out: Path) -> None:
    """Write patches, hand and wiring as PNG."""
    hand, glove = library.load()
    patches, above = marker_pages(hand, glove)[:2]
    for name, page in (("markers", patches), ("hand", above), ("wiring", wiring_page(glove))):
        page.figure.savefig(out / f"sheet-{name}.png", dpi=DPI, facecolor="white")


if __name__ == "__main__":
    main()
