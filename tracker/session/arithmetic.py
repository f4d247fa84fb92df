"""What determines the last bits of results: processor, BLAS kernel and its threads.

Tracking a session again gives identical bits on computers with the same ones. On others, sums are
taken in another order and multiplications may be fused; results differ by far less than a
micrometre.
"""

from __future__ import annotations

import ctypes
import platform
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib import introspect

from tracker.kernels import compiler

BLAS_PREFIXES = ("scipy_openblas_", "openblas_")
BLAS_SUFFIXES = ("64_", "")


@cache
def arithmetic() -> str:
    """Returns this computer's arithmetic as a text, the same on every computer of its kind."""
    return "; ".join(
        (
            f"processor {platform.machine()} {_instructions()}",
            f"BLAS {_blas()}",
            f"numpy {np.__version__}",
            compiler(),
        )
    )


def _instructions() -> str:
    """The vector instructions that both NumPy and this processor support."""
    chosen = introspect.opt_func_info(func_name="^sin$", signature="float64")
    return str(next(iter(chosen["sin"].values()))["current"])


def _blas() -> str:
    """The kernel that was chosen for this processor, or by the user, and its number of threads."""
    for path in _libraries():
        library = ctypes.CDLL(str(path))
        name, threads = (
            _openblas_function(library, "get_corename"),
            _openblas_function(library, "get_num_threads"),
        )
        if name is None or threads is None:
            continue
        name.restype, threads.restype = ctypes.c_char_p, ctypes.c_int
        kernel: bytes = name() or b"unknown"
        return f"OpenBLAS {kernel.decode('ascii', 'replace')}, {threads()} threads"
    built: Any = np.__config__.CONFIG
    return str(built["Build Dependencies"]["blas"].get("name", "unknown"))


def _libraries() -> list[Path]:
    """Shared BLAS libraries in NumPy's wheel."""
    root = Path(np.__file__).parent
    folders = (root.parent / "numpy.libs", root / ".libs", root / ".dylibs")
    return [path for folder in folders for path in sorted(folder.glob("*openblas*"))]


def _openblas_function(library: ctypes.CDLL, what: str) -> Any:
    """Returns a function of OpenBLAS, whatever its prefix and suffix; None if it is missing."""
    for prefix in BLAS_PREFIXES:
        for suffix in BLAS_SUFFIXES:
            found = getattr(library, f"{prefix}{what}{suffix}", None)
            if found is not None:
                return found
    return None
