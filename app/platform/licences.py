"""Packages contained in Glovetrack and their licences."""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path

from resources import folder

OWN = "glovetrack"
NAME = re.compile(r"[A-Za-z0-9._-]+")


@dataclass(frozen=True)
class LicensedPackage:
    """A package that the program contains."""

    name: str
    version: str
    licence: str


def bundled_text() -> str:
    """The list generated with the bundle, with all texts; empty when run from source."""
    path = Path(sys.executable).parent / "LICENCES.txt"
    if getattr(sys, "frozen", False) and path.is_file():
        return path.read_text("utf-8")
    return ""


def own_text() -> str:
    """Glovetrack's own licence; empty if the file is not installed."""
    path = Path(__file__).resolve().parents[2] / "LICENSE"
    return path.read_text("utf-8") if path.is_file() else ""


def parts() -> list[LicensedPackage]:
    """The packages that this installation needs to run, by name."""
    found: dict[str, LicensedPackage] = {}
    waiting = [OWN]
    while waiting:
        name = waiting.pop()
        key = name.lower().replace("_", "-")
        if key in found:
            continue
        try:
            package = distribution(name)
        except PackageNotFoundError:
            continue  # a requirement for another system
        data = package.metadata
        found[key] = LicensedPackage(data["Name"], package.version, licence_of(package))
        waiting += [m[0] for r in package.requires or () if (m := _needed(r))]
    return sorted(
        (p for k, p in found.items() if k != OWN), key=lambda part: (part.name.lower(), part.name)
    )


def _needed(requirement: str) -> re.Match[str] | None:
    """The name in a requirement; None if it belongs to an extra."""
    return None if "extra ==" in requirement else NAME.match(requirement)


def licence_of(package: Distribution) -> str:
    """The expression, else the old field's first line, else the classifiers."""
    data = package.metadata
    field = _first(data.get_all("License")).strip().partition("\n")[0]
    classifiers = [
        c.rpartition(" :: ")[2]
        for c in data.get_all("Classifier") or []
        if c.startswith("License :: ") and not c.endswith("OSI Approved")
    ]
    expression = _first(data.get_all("License-Expression"))
    return expression or ", ".join(classifiers) or field or "see its package"


def _first(values: list[str] | None) -> str:
    return values[0] if values else ""


def icons_text() -> str:
    """The licence of the icons, which come from another project."""
    words = (folder("icons") / "lucide" / "LICENSE").read_text("utf-8")
    return f"The icons are of the Lucide set, under this licence:\n\n{words}"


def page_text() -> str:
    """The licences of the parts of the headset page."""
    found = {"three.js 0.170.0": "LICENSE-three", "IWER 2.5.0": "LICENSE-iwer"}
    texts = [(n, (folder("webxr") / file).read_text("utf-8")) for n, file in found.items()]
    return "\n\n".join(f"{name} is under this licence:\n\n{words}" for name, words in texts)


def as_text() -> str:
    """The text of the About box."""
    made = bundled_text()
    if made:
        return made
    found = parts()
    width = max((len(f"{p.name} {p.version}") for p in found), default=0)
    lines = [f"{f'{p.name} {p.version}':{width}}  {p.licence}" for p in found]
    heading = "Glovetrack runs with these packages under these licences."
    return "\n".join([heading, "", *lines, "", icons_text(), "", page_text()])
