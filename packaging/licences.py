"""Writes the licences of everything in a bundle; fails if one is GPL, AGPL or unknown.

    python packaging/licences.py WORK BUNDLE

``WORK`` contains PyInstaller's lists of contents (``.toc`` files), ``BUNDLE`` is the folder built
from them. Licences of Python packages are read from their metadata, those of the system's libraries
from ``system_licences.toml``.
"""

from __future__ import annotations

import ast
import re
import sys
import tomllib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from importlib.metadata import Distribution, distributions
from pathlib import Path

TABLE = Path(__file__).with_name("system_licences.toml")
ICONS_LICENCE = TABLE.parents[1] / "resources" / "icons" / "lucide" / "LICENSE"
LISTS = ("COLLECT-00.toc", "PYZ-00.toc")
TEXT_NAME = re.compile(r"^(licen[cs]e|copying|notice)", re.IGNORECASE)
COPYLEFT = re.compile(r"(?<!L)(?<!Lesser )\bA?GPL|Affero|(?<!Lesser )General Public", re.IGNORECASE)
# GCC's run-time libraries, and PyInstaller's boot loader.
FFMPEG = re.compile(rb"lib(?:av|sw)[a-z]+ license: ([ -~]+)")
"""Build options that FFmpeg's libraries report; the GPL is one."""
EXCEPTION = re.compile(
    r"\bWITH GCC-exception"
    r"|special exception which allows to use PyInstaller to build and distribute non-free programs"
)


@dataclass(frozen=True)
class Part:
    """Something in the bundle with a licence of its own. ``texts`` are files with the licence's
    text."""

    name: str
    version: str
    licence: str
    texts: tuple[Path, ...] = ()


def is_allowed(licence: str) -> bool:
    """Whether an SPDX expression or a classifier permits a choice that is neither GPL nor AGPL."""
    choices = re.split(r"\s+OR\s+", licence.strip())
    return bool(licence.strip()) and any(_is_free_of_copyleft(c) for c in choices)


def _is_free_of_copyleft(choice: str) -> bool:
    terms = re.split(r"\s+AND\s+", choice)
    return all(EXCEPTION.search(t) or not COPYLEFT.search(t) for t in terms)


def licence_of(distribution: Distribution, known: dict[str, str]) -> str:
    """The licence expression, else the old licence field, else the classifiers, else our table.

    If the old field contains a whole licence, its first line is not sufficient.
    """
    data = distribution.metadata
    field = (data.get("License") or "").strip()
    classifiers = [
        c.rpartition(" :: ")[2]
        for c in data.get_all("Classifier") or []
        if c.startswith("License :: ") and not c.endswith("OSI Approved")
    ]
    short = "" if "\n" in field else field
    found = data.get("License-Expression") or short or " AND ".join(classifiers)
    return found or known.get(data["Name"], "")


def sources(work: Path) -> set[Path]:
    """The source paths of the bundle's files."""
    found: set[Path] = set()
    for name in LISTS:
        listed = ast.literal_eval((work / name).read_text("utf-8"))
        found |= {Path(e[1]) for e in _entries(listed) if e[1].startswith("/")}
    return found


def _entries(node: object) -> Iterator[tuple[str, str, str]]:
    """(destination, source, kind) at any depth of PyInstaller's nested lists."""
    if isinstance(node, tuple) and len(node) == 3 and all(isinstance(x, str) for x in node):
        yield node
    elif isinstance(node, list | tuple):
        for child in node:
            yield from _entries(child)


def packages(files: set[Path], known: dict[str, str]) -> Iterator[Part]:
    """The installed distributions that own any of ``files``, which are taken out of the set."""
    for distribution in distributions():
        own = {Path(str(distribution.locate_file(f))): f.name for f in distribution.files or ()}
        if files.isdisjoint(own):
            continue
        files -= own.keys()
        texts = sorted(p for p, name in own.items() if TEXT_NAME.match(name) and p.is_file())
        data = distribution.metadata
        licence = licence_of(distribution, known)
        yield Part(data["Name"], distribution.version, licence, tuple(texts))


def libraries(bundle: Path, known: dict[str, str]) -> Iterator[Part]:
    """The system's libraries, directly in the bundle's folder, and those included in wheels."""
    for path in sorted([*bundle.glob("lib*.so*"), *bundle.glob("*.libs/lib*.so*")]):
        if path.is_symlink():  # to a file in a package's folder, where it was listed
            continue
        keys = [k for k in known if path.name.startswith(k)]
        licence = known[max(keys, key=len)] if keys else ""
        found = FFMPEG.search(path.read_bytes())
        yield Part(path.name, "", found[1].decode() if found else licence)


def refused(parts: Iterable[Part]) -> list[str]:
    """One sentence for each part that is not allowed in the bundle."""
    return [
        f"{p.name}: {p.licence or 'its licence is not known'}"
        for p in parts
        if not is_allowed(p.licence)
    ]


def as_text(parts: list[Part]) -> str:
    """The list, followed by the text of each licence."""
    width = max(len(p.name) + len(p.version) for p in parts) + 1
    lines = ["Glovetrack contains these parts under these licences.", ""]
    lines += [f"{f'{p.name} {p.version}'.rstrip():{width}}  {p.licence}" for p in parts]
    for part in parts:
        for path in part.texts:
            words = path.read_text("utf-8", "replace").strip()
            lines += ["", "-" * 80, f"{part.name}: {path.name}", "-" * 80, words]
    return "\n".join(lines) + "\n"


def main(work: Path, bundle: Path) -> int:
    """Print the list; returns 1 if a part is not allowed."""
    known = tomllib.loads(TABLE.read_text("utf-8"))
    files = sources(work)
    python = Part("Python", sys.version.partition(" ")[0], "PSF-2.0", _python_texts())
    found = sorted(packages(files, known["packages"]), key=lambda p: p.name.lower())
    icons = Part("Lucide icons", "", "ISC AND MIT", (ICONS_LICENCE,))
    parts = [python, icons, *_page(), *found, *libraries(bundle, known["licences"])]
    problems = refused(parts)
    for problem in problems:
        print(f"may not be in the bundle: {problem}", file=sys.stderr)
    print(as_text(parts), end="")
    return 1 if problems else 0


def _page() -> list[Part]:
    """The components of the page for headsets."""
    folder = ICONS_LICENCE.parents[2] / "webxr"
    return [
        Part("three.js", "0.170.0", "MIT", (folder / "LICENSE-three",)),
        Part("IWER", "2.5.0", "MIT", (folder / "LICENSE-iwer",)),
    ]


def _python_texts() -> tuple[Path, ...]:
    text = Path(ast.__file__).parent / "LICENSE.txt"
    return (text,) if text.is_file() else ()


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), Path(sys.argv[2])))
