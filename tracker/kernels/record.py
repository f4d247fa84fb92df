"""Notes the types of every call of a kernel out of Python, for the list of what to compile.

    GLOVETRACK_KERNELS=record GLOVETRACK_KERNEL_CALLS=calls.txt python -m app --demo
    python -m tracker.kernels.record calls.txt       # writes signatures.txt anew

`make signatures` does so with all that the tests do.
"""

from __future__ import annotations

import functools
import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

from tracker.kernels.fingerprint import OURS
from tracker.kernels.kinds import UnknownKindError, kinds_of

CALLS = "GLOVETRACK_KERNEL_CALLS"
"""Environment variable: the file that calls are added to, by as many processes as there are."""

SIGNATURES = Path(__file__).with_name("signatures.txt")


class Recorded:
    """A kernel whose calls are noted."""

    def __init__(self, compiled: Any) -> None:
        functools.update_wrapper(self, compiled.py_func)
        self._compiled = compiled
        self._numba_type_ = compiled._numba_type_  # other kernels see numba's function
        self._name = f"{compiled.py_func.__module__}.{compiled.py_func.__qualname__}"
        self._seen: set[str] = set()
        self.py_func, self.options = compiled.py_func, compiled.options

    def __call__(self, *args: object) -> object:
        with suppress(UnknownKindError):  # numba may know what to do with it
            self._note(kinds_of(args))
        return self._compiled(*args)

    def _note(self, kinds: str) -> None:
        if kinds not in self._seen:
            self._seen.add(kinds)
            with Path(os.environ[CALLS]).open("a", encoding="utf-8") as calls:
                calls.write(f"{self._name} {kinds}\n")


def merge(*files: str) -> list[str]:
    """All lines of the files, each once, in order; no kernels that tests made."""
    lines = {line for f in files for line in Path(f).read_text("utf-8").splitlines()}
    return sorted(line for line in lines if line.partition(".")[0] in OURS)


def main(argv: list[str]) -> None:
    """Write signatures.txt anew from the given files of calls."""
    lines = merge(*argv)
    SIGNATURES.write_text("".join(f"{line}\n" for line in lines), "utf-8")
    print(f"{len(lines)} signatures")


if __name__ == "__main__":
    main(sys.argv[1:])
