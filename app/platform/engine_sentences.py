"""Sentences of the engine in the user's language.

The engine knows no window and speaks English, with values in its sentences: "The glove is back, at
/dev/ttyUSB0." A translation holds such a sentence as a template with ``{}`` for each value. What
comes is compared with the templates; the one that says most of it in its own words tells the
values, which are put into its translation.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from functools import lru_cache
from pathlib import Path

from app.words import decimal, mark, tr

LEAST = 6  # letters of its own that a template needs: ": ." fits everything
HUES = "red|green|blue|yellow"
"""Words of colour files that the engine enumerates: "red, green and blue"."""
FIGURE = r"[-+]?\d+\.\d+( ?(mm|px|s|ms|°|°/s|%|Hz|V))?"
"""A value with decimals; a version has more points."""
SIDES = {"left": mark("Left"), "right": mark("Right")}


def is_engines(file: str) -> bool:
    """Whether a source file is the engine's or an extension's engine side."""
    return file.startswith(("tracker/", "extensions/")) and "/window/" not in file


def templates_in(ts: Path) -> Iterator[tuple[str, str]]:
    """The engine's sentences in a ``.ts`` file, each with its translation."""
    for message in ET.parse(ts).getroot().iter("message"):
        location, target = message.find("location"), message.find("translation")
        if location is None or target is None or not target.text:
            continue
        if is_engines(location.get("filename", "")) and target.get("type") is None:
            yield message.findtext("source") or "", target.text


class EngineSentences:
    """Translates by the templates of a ``.ts`` file, read when the first sentence comes."""

    def __init__(self, ts: Path) -> None:
        self._ts = ts
        self._templates: list[tuple[re.Pattern[str], str]] | None = None
        self.translate: Callable[[str], str] = lru_cache(500)(self._translate)

    def _known(self) -> list[tuple[re.Pattern[str], str]]:
        if self._templates is None:
            found = [(own(source), source, target) for source, target in templates_in(self._ts)]
            found.sort(key=lambda entry: -entry[0])
            self._templates = [(_pattern(s), t) for letters, s, t in found if letters >= LEAST]
        return self._templates

    def _translate(self, text: str) -> str:
        """As a whole, or sentence by sentence; as it stands where no template fits."""
        whole = self._fit(text)
        if whole is not None:
            return whole
        parts = re.split(r"(?<=[.?!])\s+", text)
        return " ".join(self._fit(part) or part for part in parts) if len(parts) > 1 else text

    def _fit(self, text: str) -> str | None:
        for pattern, target in self._known():
            fits = pattern.fullmatch(text)
            if fits is not None:
                return target.format(*(self._value(value) for value in fits.groups()))
        return None

    def _value(self, text: str) -> str:
        """A value is a name or a figure; or a word of ours, or another sentence."""
        if text in SIDES:
            return tr(SIDES[text]).lower()
        if re.fullmatch(FIGURE, text):
            return text.replace(".", decimal())
        return self._fit(text) or _listed(text) or tr(text)


def _listed(text: str) -> str | None:
    """An enumeration of hues, word by word; None where it is none."""
    if not re.fullmatch(rf"({HUES})(, ({HUES}))*( and ({HUES}))?", text):
        return None
    first, _, last = text.partition(" and ")
    names = ", ".join(tr(name) for name in first.split(", "))
    return tr("{} and {}").format(names, tr(last)) if last else names


def own(template: str) -> int:
    """How many letters of its own a template has."""
    return len(re.sub(r"\{\}|[^A-Za-z]", "", template))


def _pattern(template: str) -> re.Pattern[str]:
    return re.compile("(.*?)".join(re.escape(part) for part in template.split("{}")), re.DOTALL)
