"""The documentation's site: every page is in its menu, every link and anchor is valid."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
EXTENSIONS = sorted(ROOT.glob("extensions/*/docs/*.md"))
PAGES = [*sorted(DOCS.rglob("*.md")), *EXTENSIONS]
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
    names = [p.name if p in EXTENSIONS else str(p.relative_to(DOCS)) for p in PAGES]
    assert sorted(nav) == sorted(names)


@pytest.mark.parametrize("page", PAGES, ids=lambda p: str(p.relative_to(ROOT)))
def test_links_lead_to_pages_and_headings(page: Path) -> None:
    dead = []
    for target, heading in LINK.findall(FENCE.sub("", page.read_text("utf-8"))):
        path = (page.parent / target).resolve() if target else page
        on_site = path.is_relative_to(DOCS) or path in EXTENSIONS
        known = path.exists() and on_site
        if not known or (heading and heading not in anchors(path)):
            dead.append(f"{target}#{heading}")
    assert dead == []
