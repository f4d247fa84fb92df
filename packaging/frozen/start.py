"""Runs before everything else in a bundled program: lays out the cache of compiled kernels.

A bundle brings its kernels compiled (`packaging/kernels.sh`). They are copied into the user's cache
once, because the program's own folder may be read-only and numba adds what it compiles later.
Whatever is missing, numba compiles as usual.

`kernel_locator` tells numba the place; this file must not import numba, since most commands never
need it.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from pathlib import Path

PLACE = "GLOVETRACK_KERNELS"
"""Names the folder to `kernel_locator`, here and in the processes started from here."""

PROCESSOR = "x86-64-v3"
FEATURES = {"avx", "avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe"}
"""What that level promises beside older ones, in the words of /proc/cpuinfo."""


def has_level(cpuinfo: str) -> bool:
    """Whether each of `FEATURES` is among the first processor's flags."""
    flags = next((line for line in cpuinfo.splitlines() if line.startswith("flags")), "")
    return set(flags.partition(":")[2].split()) >= FEATURES


def user_cache() -> Path:
    """As the XDG base directories say; elsewhere the local application data."""
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def lay_out(shipped: Path, build: str, cache: Path) -> Path:
    """The folder of this build's kernels within ``cache``; those of other builds go."""
    target = cache / "glovetrack" / f"kernels-{build}"
    if target.is_dir():
        return target
    target.parent.mkdir(parents=True, exist_ok=True)
    for old in target.parent.glob("kernels-*"):
        shutil.rmtree(old, ignore_errors=True)
    # Another process may do the same: whoever renames first wins.
    fresh = Path(tempfile.mkdtemp(prefix="new-", dir=target.parent))
    fill(fresh, shipped)
    try:
        fresh.rename(target)
    except OSError:
        shutil.rmtree(fresh, ignore_errors=True)
    return target


def fill(fresh: Path, shipped: Path) -> None:
    """Copy what is shipped; half a copy, on a full disk say, is worse than none."""
    try:
        shutil.copytree(shipped, fresh, dirs_exist_ok=True)
    except OSError:
        shutil.rmtree(fresh, ignore_errors=True)
        fresh.mkdir(exist_ok=True)


def choose(bundle: Path) -> Path:
    """The kernels' folder: in the user's cache, or for this run alone where that is read-only."""
    shipped, build = bundle / "kernels", (bundle / "BUILD").read_text("utf-8").strip()
    try:
        return lay_out(shipped, build, user_cache())
    except OSError:
        return lay_out(shipped, build, Path(tempfile.mkdtemp(prefix="glovetrack-")))


def prepare(bundle: Path) -> None:
    """Tell numba where kernels are and for which processor they are made."""
    os.environ.setdefault("NUMBA_CACHE_LOCATOR_CLASSES", "kernel_locator.KernelLocator")
    cpuinfo = Path("/proc/cpuinfo")
    if "NUMBA_CPU_NAME" not in os.environ and cpuinfo.exists() and has_level(cpuinfo.read_text()):
        os.environ["NUMBA_CPU_NAME"], os.environ["NUMBA_CPU_FEATURES"] = PROCESSOR, ""
    if PLACE not in os.environ:
        os.environ[PLACE] = str(choose(bundle))


if getattr(sys, "frozen", False):
    prepare(Path(sys._MEIPASS))  # type: ignore[attr-defined]
