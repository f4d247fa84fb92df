"""Tells numba where a bundled program's compiled kernels are, by its NUMBA_CACHE_LOCATOR_CLASSES.

numba's own locators know a kernel by the folder in which the program is installed and by the
program file's content; here it is the folder within the bundle, and its build's number is in the
cache's path (`start.lay_out`). So kernels stay valid wherever the bundle is unpacked.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path

from numba.core.caching import _CacheLocator


class KernelLocator(_CacheLocator):
    """One function's place in the cache."""

    def __init__(self, line: int, folder: Path) -> None:
        self._line = line
        self._folder = folder

    @classmethod
    def from_function(cls, py_func: Callable[..., object], py_file: str) -> KernelLocator:
        bundle = Path(sys._MEIPASS)  # type: ignore[attr-defined]
        within = Path(py_file).resolve().relative_to(bundle.resolve()).with_suffix("")
        folder = Path(os.environ["GLOVETRACK_KERNELS"]) / within
        self = cls(py_func.__code__.co_firstlineno, folder)
        self.ensure_cache_path()
        return self

    def get_cache_path(self) -> str:
        return str(self._folder)

    def get_source_stamp(self) -> str:
        return "bundled"  # the sources never change within a build

    def get_disambiguator(self) -> str:
        return str(self._line)
