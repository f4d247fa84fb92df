"""Compile the API layer: ``python -m extensions.openxr.build``.

It needs a C++17 compiler and OpenXR's headers (Debian: ``g++`` and ``libopenxr-dev``). As it is
loaded into other programs, the layer is linked so that it needs the C library alone.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from extensions.openxr.library import LIBRARY, SOURCES
from tracker.base.errors import ConfigError
from tracker.base.notices import notice

COMPILERS = ("c++", "g++", "clang++")
OPTIONS = (
    *("-std=c++17", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-pthread"),
    *("-Wall", "-Wextra", "-Werror", "-Wno-missing-field-initializers"),
    *("-static-libstdc++", "-static-libgcc", "-ffunction-sections", "-Wl,--gc-sections"),
    f"-Wl,--version-script={SOURCES / 'exports.map'}",  # nothing of ours meets the application's
)
HEADER = "#include <openxr/openxr.h>\n"


def compiler() -> str:
    """Path of a compiler that finds OpenXR's headers; CXX comes first. Raises ConfigError."""
    given = os.environ.get("CXX")
    found = next(filter(None, map(shutil.which, [given] if given else COMPILERS)), None)
    if found is None:
        raise ConfigError(notice("openxr.no_compiler"))
    asked = [found, "-fsyntax-only", "-x", "c++", "-"]
    if subprocess.run(asked, input=HEADER, text=True, capture_output=True).returncode:
        raise ConfigError(notice("openxr.no_headers"))
    return found


def compile_library(sources: Sequence[Path], target: Path) -> None:
    """A shared library of C++ sources. Raises ConfigError with what the compiler reports."""
    target.parent.mkdir(parents=True, exist_ok=True)
    made = target.with_name(f"{target.name}.{os.getpid()}")
    command = [compiler(), *OPTIONS, f"-I{SOURCES}", *map(str, sources), "-o", str(made)]
    run = subprocess.run(command, text=True, capture_output=True)
    if run.returncode:
        raise ConfigError(notice("openxr.not_compiled", file=target.name, why=run.stderr))
    made.replace(target)


def build(target: Path = LIBRARY) -> None:
    """Compile the layer."""
    compile_library(sorted(SOURCES.glob("*.cpp")), target)


def main() -> int:
    try:
        build()
    except ConfigError as error:
        print(error, file=sys.stderr)
        return 1
    print(f"{LIBRARY} ({LIBRARY.stat().st_size // 1024} kB)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
