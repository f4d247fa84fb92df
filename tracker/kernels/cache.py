"""A cache of compiled parts of the library, shared between checkouts, indexed by their source.

It is in the user's cache folder, or in GLOVETRACK_KERNEL_CACHE, with one folder for each content of
a part's table: versions of compiler and Python, and each kernel's fingerprint. A folder is created
under a temporary name and renamed, so it is always complete.
"""

from __future__ import annotations

import hashlib
import logging
import os
import platform
import shutil
import sysconfig
import tempfile
from pathlib import Path

import platformdirs

from tracker.kernels.parts import HERE

FOLDER = "GLOVETRACK_KERNEL_CACHE"
"""Environment variable: the folder; empty disables the cache."""
AT_MOST = 60
"""Number of folders, about 1 MB each; the most recently used are retained."""

_log = logging.getLogger(__name__)


def fetch(made_of: str, module: str) -> bool:
    """Copy the extension ``module`` that was compiled from ``made_of`` to this folder.

    Returns False where there is none.
    """
    folder = _folder()
    source = folder / _key(made_of) / _file(module) if folder else None
    if source is None or not source.is_file():
        return False
    if not all(_is_trusted(path) for path in (source, source.parent, source.parent.parent)):
        _log.warning("%s is not used: other users can write to it", source)
        return False
    target = HERE / source.name
    partial = target.with_suffix(".new")
    shutil.copy(source, partial)
    partial.replace(target)  # the old one may be in use
    os.utime(source.parent)
    return True


def store(made_of: str, module: str) -> None:
    """Store the extension ``module`` of this folder; an unwritable cache is ignored."""
    folder = _folder()
    if folder is None or (folder / _key(made_of)).exists():
        return
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        partial = Path(tempfile.mkdtemp(dir=folder, prefix="new-"))
        shutil.copy(HERE / _file(module), partial)
        partial.rename(folder / _key(made_of))
        _evict(folder)
    except OSError as error:
        _log.info("compiled kernels are not cached: %s", error)


def _is_trusted(path: Path) -> bool:
    """Whether only this user or the administrator can modify it: it is code."""
    if not hasattr(os, "getuid"):
        return True  # Windows: the cache folder belongs to the user
    found = path.stat()
    return found.st_uid in (0, os.getuid()) and not found.st_mode & 0o022


def _folder() -> Path | None:
    named = os.environ.get(FOLDER)
    if named is None:
        return platformdirs.user_cache_path("glovetrack", appauthor=False) / "kernels"
    return Path(named) if named else None


def _key(made_of: str) -> str:
    words = f"{platform.machine()} {sysconfig.get_config_var('EXT_SUFFIX')}\n{made_of}"
    return hashlib.sha256(words.encode()).hexdigest()[:32]


def _file(module: str) -> str:
    return f"{module}{sysconfig.get_config_var('EXT_SUFFIX')}"


def _evict(folder: Path) -> None:
    """Remove the least recently used folders."""
    by_use = sorted(folder.iterdir(), key=lambda path: path.stat().st_mtime, reverse=True)
    for path in by_use[AT_MOST:]:
        shutil.rmtree(path, ignore_errors=True)
