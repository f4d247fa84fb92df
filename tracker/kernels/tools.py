"""Requirements for compiling the kernels ahead of time: numba, a C++ compiler, Python's headers.

python -m tracker.kernels.tools     # exit status 0 if all are installed
"""

from __future__ import annotations

import os
import re
import shutil
import sys
import sysconfig
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

from tracker.kernels import parts
from tracker.kernels.signature import INSTALLED_IN

ROOT = Path(__file__).parents[2]
SOURCES = ("app", "extensions", "tracker")
COMPILERS = ("g++", "clang++", "cl")


def are_here() -> bool:
    """Whether this computer can compile the library; the bundled program never can."""
    headers = Path(sysconfig.get_path("include"), "Python.h")
    has_compiler = any(shutil.which(name) for name in COMPILERS)
    return has_compiler and headers.exists() and find_spec("numba") is not None


def are_wanted() -> bool:
    """Whether the library is missing or older than its source, and can be compiled."""
    if parts.MODE in os.environ or not (os.access(parts.HERE, os.W_OK) and are_here()):
        return False
    return not parts.built() or are_outdated()


def are_outdated(root: Path = ROOT) -> bool:
    """Whether a source file with kernels is newer than the library, as after an update of a
    checkout. Parts that the demo does not need do not count. In an installed package, always False.

    Takes about 20 ms. `tracker.kernels.build` sets the time of parts that are still current.
    """
    counted = [part for part in parts.built() if not parts.is_for_later(part)]
    if INSTALLED_IN or not counted:
        return False
    oldest = min(parts.table_of(part).stat().st_mtime for part in counted)
    return any(_is_newer_source(path, oldest) for path in _sources(root))


def _sources(root: Path) -> Iterator[os.DirEntry[str]]:
    folders = [str(root / name) for name in SOURCES if (root / name).is_dir()]
    while folders:
        with os.scandir(folders.pop()) as entries:
            for entry in entries:
                if entry.is_dir(follow_symlinks=False):
                    folders.append(entry.path)
                elif entry.name.endswith(".py"):
                    yield entry


def _is_newer_source(entry: os.DirEntry[str], t: float) -> bool:
    return entry.stat().st_mtime > t and b"\n@kernel" in Path(entry.path).read_bytes()


def command(*words: str) -> list[str]:
    """The command that compiles the library in a subprocess; see `tracker.kernels.build`."""
    return [sys.executable, "-m", f"{__package__}.build", *words]


def progress_line(part: str, number: int, count: int) -> str:
    """The line that the compiler prints after each part."""
    return f"compiled {number} of {count}: {part}"


def progress(line: str) -> tuple[int, int] | None:
    """Number of compiled parts and of all parts, from a line that the compiler prints."""
    found = re.match(r"compiled (\d+) of (\d+):", line)
    return (int(found[1]), int(found[2])) if found else None


if __name__ == "__main__":
    sys.exit(not are_here())
