"""Which shared libraries of a bundle nothing reaches, so that they may stay out of it.

PyInstaller takes whole packages along, most of them for file formats and plug-ins that the window
never calls. What is kept is what follows from roots: the libraries that
ELF's NEEDED entries of the roots name, and so on.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable, Iterable, Mapping
from fnmatch import fnmatchcase
from pathlib import Path, PurePosixPath

Needs = Callable[[str], Iterable[str]]
Entry = tuple[str, str, str]
"""PyInstaller's (place in the bundle, file, kind)."""

LINK = "SYMLINK"
"""The kind whose "file" is where the link points to, seen from its own folder."""

LOADED_BY_START = "libpython"
"""What the program's start opens by its name."""

PLAIN = re.compile(r"lib(?!.*\.(cpython-|abi3)).*\.so(\.\d+)*$")
"""Not pyarrow's module ``lib.cpython-311-x86_64-linux-gnu.so``, which Python opens by its name."""

NEEDED = re.compile(r"\(NEEDED\).*\[(.+)\]")


def needed_by(file: str) -> list[str]:
    """Names of the libraries that an ELF file asks for."""
    shown = subprocess.run(["readelf", "-d", file], capture_output=True, text=True, check=True)
    return NEEDED.findall(shown.stdout)


def reachable(roots: Iterable[str], files: Mapping[str, str], needs: Needs = needed_by) -> set[str]:
    """Names in ``files`` (name to path) that ``roots`` need, directly or not; roots included."""
    found: set[str] = set()
    waiting = list(roots)
    while waiting:
        name = waiting.pop()
        if name in found or name not in files:
            continue
        found.add(name)
        waiting.extend(needs(files[name]))
    return found


def prune(
    entries: Iterable[Entry],
    folders: Iterable[str],
    unwanted: Iterable[str],
    needs: Needs = needed_by,
) -> list[Entry]:
    """``entries`` without what matches ``unwanted`` and what then only unwanted files needed.

    ``unwanted`` are patterns of places, whose * takes slashes too; only shared libraries right in
    ``folders`` may fall for not being needed.
    """
    patterns, folders = list(unwanted), list(folders)
    wanted = [e for e in entries if not any(fnmatchcase(e[0], p) for p in patterns)]
    links = [e for e in wanted if e[2] == LINK]
    real = [e for e in wanted if e[2] != LINK]
    files = {PurePosixPath(e[0]).name: e[1] for e in real if is_elf(Path(e[1]))}
    roots = [PurePosixPath(e[0]).name for e in real if not _is_library(e, folders)]
    kept = reachable(roots, files, needs)
    left = [e for e in real if not _is_library(e, folders) or PurePosixPath(e[0]).name in kept]
    places = {e[0] for e in left}
    return left + [e for e in links if str(PurePosixPath(e[0]).parent / e[1]) in places]


def _is_library(entry: Entry, folders: Iterable[str]) -> bool:
    """A plain shared library right in one of ``folders``; extension modules are not."""
    place = PurePosixPath(entry[0])
    plain = PLAIN.match(place.name) and not place.name.startswith(LOADED_BY_START)
    return bool(plain) and str(place.parent) in folders


def is_elf(path: Path) -> bool:
    """Whether a file is a library or a program, by how it begins."""
    with path.open("rb") as file:
        return file.read(4) == b"\x7fELF"
