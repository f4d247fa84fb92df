"""``glovetrack print``."""

from __future__ import annotations

from extensions.sheets.command import PrintArguments
from extensions.sheets.kinds import SHEETS
from extensions.sheets.page import save_pages
from tracker.base.files import check_target, whole_file
from tracker.glove import library


def print_sheets(args: PrintArguments) -> int:
    """Write the PDF file."""
    check_target(args.out, args.force)
    hand, glove = library.load(args.glove or library.DEFAULT_GLOVE)
    pages, title = SHEETS.get(args.what).pages(hand, glove, args.paper)
    with whole_file(args.out, args.force) as part:
        save_pages(pages, part, title)
    print(f"{args.out}: {len(pages)} page{'s' if len(pages) > 1 else ''}; print at 100 % scale")
    return 0
