"""The files of the library: one part per package, so that parts are compiled in parallel and an
edit does not affect the others. Kernels that process images have a second, wide part (`WIDE`).

A part is an extension module with a function for each kernel that Python calls, and a table with
the source fingerprint and types of each. Its first line contains the compiler's version.
"""

from __future__ import annotations

import platform
import re
from collections.abc import Iterable
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

from tracker.kernels.signature import INSTALLED_IN

HERE = Path(__file__).parent
MODE = "GLOVETRACK_KERNELS"
"""Environment variable. ``numba``: ignore the compiled library. ``build``: kernels as required by
the library's compiler, without numba's cache. ``kept``: use the library as it is, even if it is
older than its source."""
PREFIX = "_compiled_"
WIDE = "_wide"
"""Suffix of a part's second module, in which kernels that process images (`decorator.kernel`) are
compiled for processors with `WIDE_FEATURES`: those of the last ten years. Without fused
multiply-add, which rounds once where others round twice: results are the same on all processors."""
WIDE_FEATURES = "+avx2"
DIVIDED = ("tracker_fusion", "tracker_simulation")
NOT_FOR_THE_DEMO = (
    "extensions_applications",
    "tracker_fusion_vist",
    "tracker_inertial",
    "tracker_simulation_desk",
    "tracker_simulation_recorded",
)
"""Parts that the demo does not need; they are compiled after the others."""


def part_of(kernel: str) -> str:
    """A kernel's part: ``tracker_vision`` for ``tracker.vision.cpd.parallax_em``; for the large
    packages in `DIVIDED` one for each subpackage, such as ``tracker_fusion_chain``."""
    names = kernel.removeprefix(INSTALLED_IN).split(".")
    depth = 3 if "_".join(names[:2]) in DIVIDED and len(names) > 4 else 2
    return "_".join(names[:depth])


def module_of(part: str) -> str:
    """Name of the extension module, in this package."""
    return PREFIX + part


def is_wide(part: str) -> bool:
    """Whether a part is only for processors with `WIDE_FEATURES`."""
    return part.endswith(WIDE)


def is_for_later(part: str) -> bool:
    """Whether the demo does not need a part."""
    return part.removesuffix(WIDE) in NOT_FOR_THE_DEMO


def can_be_wide() -> bool:
    """Whether this architecture has processors that run wide parts."""
    return platform.machine().lower() in ("x86_64", "amd64")


def table_of(part: str) -> Path:
    return HERE / f"{PREFIX}{part}.txt"


def built() -> list[str]:
    """All parts that have a table."""
    return sorted(path.stem.removeprefix(PREFIX) for path in HERE.glob(f"{PREFIX}*.txt"))


def compiler() -> str | None:
    """The compiler in the first line of the library's tables, "numba 0.68.1"; None without a
    library.

    The bundle of the program includes that library but not numba.
    """
    for part in built():
        with table_of(part).open(encoding="utf-8") as table:
            found = re.search(r"numba \S+", table.readline())
        if found:
            return found[0]
    return None


def is_built(part: str, table: str) -> bool:
    """Whether the part exists and was compiled from the source described in ``table``."""
    there = any((HERE / (module_of(part) + suffix)).exists() for suffix in EXTENSION_SUFFIXES)
    return there and table_of(part).exists() and table_of(part).read_text("utf-8") == table


def remove_others(parts: Iterable[str]) -> None:
    """Delete files of the library that do not belong to any of these."""
    names = {module_of(part) for part in parts}
    for path in HERE.glob(f"{PREFIX.rstrip('_')}*"):
        if path.name.partition(".")[0] not in names:
            path.unlink()
