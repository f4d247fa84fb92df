"""The user guide that is shipped with the program: its pages in Markdown."""

from __future__ import annotations

import re
from pathlib import Path

from resources import folder

FIRST = "README.md"
LINK = re.compile(r"\[[^\]]*\]\(([\w.-]+\.md)\)")


def guide_folder() -> Path:
    """The folder in an installation, or in the source tree."""
    installed = Path(str(folder("guide")))
    return installed if installed.is_dir() else Path(__file__).parents[2] / "docs" / "guide"


def site() -> Path | None:
    """First page of the documentation site, in an installation or as built by ``make docs``; None
    if there is none."""
    built = Path(__file__).parents[2] / "build" / "site"
    pages = (Path(str(folder("site"))) / "index.html", built / "index.html")
    return next((page for page in pages if page.is_file()), None)


def pages() -> dict[str, str]:
    """The Markdown of each page by file name, in the order of the first page's list.

    Raises FileNotFoundError if the guide is not installed.
    """
    first = (guide_folder() / FIRST).read_text("utf-8")
    names = [FIRST, *dict.fromkeys(LINK.findall(first))]
    return {name: (guide_folder() / name).read_text("utf-8") for name in names}


def title_of(page: str) -> str:
    """The first heading of a page."""
    found = re.search(r"^# (.+)$", page, re.MULTILINE)
    return found[1].strip() if found else ""


def matches(found: dict[str, str], words: str) -> list[str]:
    """Names of the pages that contain all of ``words``, ignoring case."""
    wanted = words.casefold().split()
    return [name for name, text in found.items() if all(w in text.casefold() for w in wanted)]
