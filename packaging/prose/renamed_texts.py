"""Table of the window's texts that were renamed since a commit, as Markdown.

    python packaging/prose/renamed_texts.py COMMIT > packaging/prose/renamed_texts.md

The English sources of the German translation are compared. A text that is gone is paired with the
new text that has the same German translation, otherwise with the most similar new one, preferably
of the same module. Texts without such a counterpart are listed as removed.
"""

from __future__ import annotations

import subprocess
import sys
import xml.etree.ElementTree as ET
from difflib import SequenceMatcher
from pathlib import Path, PurePosixPath
from typing import NamedTuple

TS = "resources/translations/glovetrack_de.ts"
IN_MODULE, ELSEWHERE = 0.5, 0.65
"""Least similarity of a pair from the same module, and from different ones."""
SHARED = 0.3
"""Least share of common words, which is checked first because it is fast."""


class Text(NamedTuple):
    english: str
    german: str
    module: str


def texts(data: str) -> dict[str, Text]:
    """By the English text."""
    found = {}
    for message in ET.fromstring(data).iter("message"):
        english = message.findtext("source") or ""
        location = message.find("location")
        path = PurePosixPath("" if location is None else location.get("filename", ""))
        found[english] = Text(english, message.findtext("translation") or "", path.stem)
    return found


def pairs(before: dict[str, Text], after: dict[str, Text]) -> list[tuple[Text, str]]:
    """Each text that is gone, with its successor; an empty one if it was removed."""
    gone = [text for english, text in before.items() if english not in after]
    new = [text for english, text in after.items() if english not in before]
    return [(text, _successor(text, new)) for text in gone]


def _successor(text: Text, new: list[Text]) -> str:
    groups = (
        ([t for t in new if text.german and t.german == text.german], 0.0),
        ([t for t in new if t.module == text.module], IN_MODULE),
        (new, ELSEWHERE),
    )
    for others, least in groups:
        rated = [(_likeness(text.english, other.english), other.english) for other in others]
        likeness, best = max(rated, default=(0.0, ""))
        if best and likeness >= least:
            return best
    return ""


def _likeness(a: str, b: str) -> float:
    first, second = set(a.lower().split()), set(b.lower().split())
    if len(first & second) < SHARED * max(len(first), len(second)):
        return 0.0
    return SequenceMatcher(None, a.lower(), b.lower(), autojunk=False).ratio()


def _cell(text: str) -> str:
    return " ".join(text.replace("|", "\\|").replace("<", "&lt;").split())


def main() -> None:
    since = sys.argv[1]
    old = subprocess.run(
        ["git", "show", f"{since}:{TS}"], capture_output=True, text=True, check=True
    ).stdout
    found = pairs(texts(old), texts(Path(TS).read_text("utf-8")))
    renamed = sorted((t.module, t.english, new) for t, new in found if new)
    removed = sorted(t.english for t, new in found if not new)
    print("# Renamed texts of the window\n")
    print(f"Texts of the window that changed since {since}: {len(renamed)} renamed,", end=" ")
    print(f"{len(removed)} removed. Use this table to update documents that quote the window.\n")
    print("| module | before | now |\n|---|---|---|")
    for module, before, new in renamed:
        print(f"| {module} | {_cell(before)} | {_cell(new)} |")
    print("\n## Removed\n")
    for english in removed:
        print(f"- {_cell(english)}")


if __name__ == "__main__":
    main()
