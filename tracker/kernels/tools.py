"""What it takes to compile the kernels ahead of time: numba, a C++ compiler and Python's headers.

python -m tracker.kernels.tools     # exit status 0 where they are all there
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
    """Whether this computer can compile the library; the packed program never can."""
    headers = Path(sysconfig.get_path("include"), "Python.h")
    has_compiler = any(shutil.which(name) for name in COMPILERS)
    return has_compiler and headers.exists() and find_spec("numba") is not None


def are_wanted() -> bool:
    """Whether there is no library at all, and there can be one."""
    return not parts.built() and os.access(parts.HERE, os.W_OK) and are_here()


def command(*words: str) -> list[str]:
    """What compiles the library in a process of its own; see `tracker.kernels.build`."""
    return [sys.executable, "-m", f"{__package__}.build", *words]


def said(part: str, number: int, count: int) -> str:
    """What the compiler prints after each part."""
    return f"compiled {number} of {count}: {part}"


def progress(line: str) -> tuple[int, int] | None:
    """How many parts of how many are compiled, out of a line that the compiler prints."""
    found = re.match(r"compiled (\d+) of (\d+):", line)
    return (int(found[1]), int(found[2])) if found else None


if __name__ == "__main__":
    sys.exit(not are_here())
