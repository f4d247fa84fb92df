"""The user guide that travels along: its pages in Markdown."""

from __future__ import annotations

import re
from pathlib import Path

from resources import folder

FIRST = "README.md"
LINK = re.compile(r"\[[^\]]*\]\(([\w.-]+\.md)\)")


def place() -> Path:
    """The folder of an installation, or of the tree that this runs from."""
    installed = Path(str(folder("guide")))
    return installed if installed.is_dir() else Path(__file__).parents[2] / "docs" / "guide"


def site() -> Path | None:
    """The whole documentation's first page, of an installation or as ``make docs`` built it; None
    where it is not there."""
    built = Path(__file__).parents[2] / "build" / "site"
    pages = (Path(str(folder("site"))) / "index.html", built / "index.html")
    return next((page for page in pages if page.is_file()), None)


def pages() -> dict[str, str]:
    """The Markdown of each page by its file's name, in the order of the first page's list.

    Raises FileNotFoundError where the guide did not travel along.
    """
    first = (place() / FIRST).read_text("utf-8")
    names = [FIRST, *dict.fromkeys(LINK.findall(first))]
    return {name: (place() / name).read_text("utf-8") for name in names}


def title_of(page: str) -> str:
    """Its first heading."""
    found = re.search(r"^# (.+)$", page, re.MULTILINE)
    return found[1].strip() if found else ""


def matches(found: dict[str, str], words: str) -> list[str]:
    """Names of the pages that hold all of ``words``, whatever their case."""
    wanted = words.casefold().split()
    return [name for name, text in found.items() if all(w in text.casefold() for w in wanted)]
