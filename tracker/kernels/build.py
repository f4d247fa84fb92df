"""Compiles the kernels ahead of time, for the types in signatures.txt.

    python -m tracker.kernels.build

It takes a C++ compiler and a minute or two, and leaves the library beside this file
(`tracker.kernels.library`).
"""

from __future__ import annotations

import importlib
import os
import sys
import tempfile
import warnings
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

from tracker.kernels.mode import MODE

os.environ[MODE] = "build"  # before any kernel is made

import numpy as np
from setuptools import Distribution, Extension

from tracker.kernels.fingerprint import fingerprint
from tracker.kernels.library import TABLE
from tracker.kernels.numba_types import arguments
from tracker.kernels.record import SIGNATURES

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # numba has said since 2023 that this may move elsewhere
    from numba.core.registry import cpu_target
    from numba.pycc import CC
    from numba.pycc import compiler as pycc_compiler

HERE = Path(__file__).parent
PROCESSOR = ""  # what every processor of the kind understands
LIBRARY, DISPATCH = "_compiled", "_dispatch"


class Entry(NamedTuple):
    """One function of the library."""

    symbol: str
    name: str
    kinds: str
    kernel: Any

    def line(self) -> str:
        made_of = fingerprint(self.kernel.py_func, self.kernel.options)
        return f"{self.symbol} {made_of} {self.name} {self.kinds}\n"


def main() -> None:
    TABLE.unlink(missing_ok=True)  # the old library is not to be used with half of a new one
    lines = SIGNATURES.read_text("utf-8").splitlines()
    entries = [_entry(i, line) for i, line in enumerate(lines) if _is_there(line)]
    _build_dispatch()
    _build_library(entries)
    TABLE.write_text("".join(entry.line() for entry in entries), "utf-8")
    print(f"{len(entries)} kernels compiled")


def _is_there(line: str) -> bool:
    """Whether a line of the list still names a kernel; after an edit it may not."""
    module, _, function = line.partition(" ")[0].rpartition(".")
    there = hasattr(importlib.import_module(module), function)
    if not there:
        print(f"There is no {module}.{function} any more: make signatures")
    return there


def _entry(number: int, line: str) -> Entry:
    name, _, kinds = line.partition(" ")
    module, _, function = name.rpartition(".")
    return Entry(f"k{number}", name, kinds, getattr(importlib.import_module(module), function))


def _build_library(entries: list[Entry]) -> None:
    compiler = CC(LIBRARY, source_module=sys.modules[__name__])
    compiler.target_cpu = PROCESSOR
    compiler.output_dir = str(HERE)
    for entry in entries:
        compiler.export(entry.symbol, arguments(entry.kinds))(entry.kernel.py_func)
    options = {entry.kernel.py_func: entry.kernel.targetoptions for entry in entries}
    with mock.patch.object(pycc_compiler, "compile_extra", _with_options(options)):
        compiler.compile()


def _with_options(options: dict[Any, dict[str, Any]]) -> Any:
    """numba's ahead-of-time compiler, made to heed what the decorator was told."""
    plain = pycc_compiler.compile_extra

    def compile_extra(  # type: ignore[no-untyped-def]
        typing, target, function, args, result, flags, **rest
    ):
        own = flags.copy()  # those given are for all functions: fast-math of one would stay on
        cpu_target.options.parse_as_flags(own, options[function])
        own.no_cpython_wrapper, own.no_cfunc_wrapper = False, True
        return plain(typing, target, function, args, result, own, **rest)

    return compile_extra


def _build_dispatch() -> None:
    with tempfile.TemporaryDirectory() as work:
        source = os.path.relpath(HERE / "dispatch.c")
        extension = Extension(DISPATCH, [source], include_dirs=[np.get_include()])
        command: Any = Distribution({"ext_modules": [extension]}).get_command_obj("build_ext")
        command.build_lib, command.build_temp = str(HERE), work
        command.ensure_finalized()
        command.run()


if __name__ == "__main__":
    main()
