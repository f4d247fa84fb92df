"""The documentation's site: every page is in its menu, every link and anchor leads somewhere."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = sorted(DOCS.rglob("*.md"))
LINK = re.compile(r"\]\((?!https?:)([^)#\s]*)(?:#([^)\s]+))?\)")
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)


def anchors(page: Path) -> set[str]:
    """Names of a page's headings, as Markdown's ``toc`` makes them."""
    titles = HEADING.findall(FENCE.sub("", page.read_text("utf-8")))
    words = (re.sub(r"[^\w\s-]", "", t.replace("`", "")).strip().lower() for t in titles)
    return {re.sub(r"[\s-]+", "-", w) for w in words}


def test_the_menu_has_every_page() -> None:
    nav = re.findall(r":\s+(\S+\.md)$", (ROOT / "mkdocs.yml").read_text("utf-8"), re.MULTILINE)
    assert len(nav) == len(set(nav))
    assert set(nav) == {str(p.relative_to(DOCS)) for p in PAGES}


@pytest.mark.parametrize("page", PAGES, ids=lambda p: str(p.relative_to(DOCS)))
def test_links_lead_to_pages_and_headings(page: Path) -> None:
    dead = []
    for target, heading in LINK.findall(FENCE.sub("", page.read_text("utf-8"))):
        path = (page.parent / target).resolve() if target else page
        known = path.exists() and path.is_relative_to(DOCS)  # the site has nothing else
        if not known or (heading and heading not in anchors(path)):
            dead.append(f"{target}#{heading}")
    assert dead == []
