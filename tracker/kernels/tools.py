"""Requirements for compiling the kernels ahead of time: numba, a C++ compiler, Python's headers.

python -m tracker.kernels.tools     # exit status 0 if all are installed
"""

from __future__ import annotations

import os
import re
import shutil
import sys
import sysconfig
from importlib.util import find_spec
from pathlib import Path

from tracker.kernels import parts

COMPILERS = ("g++", "clang++", "cl")


def are_here() -> bool:
    """Whether this computer can compile the library; the bundled program never can."""
    headers = Path(sysconfig.get_path("include"), "Python.h")
    has_compiler = any(shutil.which(name) for name in COMPILERS)
    return has_compiler and headers.exists() and find_spec("numba") is not None


def are_wanted() -> bool:
    """Whether there is no library, but it can be compiled."""
    return not parts.built() and os.access(parts.HERE, os.W_OK) and are_here()


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
