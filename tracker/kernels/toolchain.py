"""Calls to the C++ compiler, through setuptools."""

from __future__ import annotations

import os
import sys
import sysconfig
import tempfile
from pathlib import Path
from typing import Any

import numba
import numpy as np
from numba import _helperlib
from setuptools import Distribution, Extension

from tracker.kernels.parts import HERE

OBJECT = ".obj" if sys.platform == "win32" else ".o"
NUMBA = Path(numba.__file__).parent
RUNTIME = "kernel_runtime"
COMPACT = [] if sys.platform == "win32" else ["-ffunction-sections", "-fdata-sections"]
"""Options with which the linker can leave out functions that nothing calls, and its own."""
ONLY_CALLED = {"linux": ["-Wl,--gc-sections", "-pthread"], "darwin": ["-Wl,-dead_strip", "-Wl,-S"]}


def build_dispatch(name: str, folder: Path) -> None:
    """Compile ``dispatch.c`` as the extension module ``name``."""
    _build(Extension(name, [_source("dispatch.c")], include_dirs=[np.get_include()]), folder)


def build_runtime(folder: Path) -> None:
    """Compile numba's helper functions, which each module contains, as a static library."""
    headers = [NUMBA, NUMBA / "core" / "runtime", sysconfig.get_path("include"), np.get_include()]
    contents = {
        "sources": [_source("runtime.c"), str(NUMBA / "core" / "runtime" / "nrt.cpp")],
        "include_dirs": [str(header) for header in headers],
        "macros": [("NUMBA_LAPACK_BUILD_ILP64", _width_of_lapack())],
        "cflags": COMPACT,
    }
    command: Any = Distribution({"libraries": [(RUNTIME, contents)]}).get_command_obj("build_clib")
    command.build_clib = command.build_temp = str(folder)
    command.ensure_finalized()
    command.run()


def link_module(name: str, functions: Path, runtime: Path, folder: Path) -> None:
    """Make the extension module ``name`` of an object file of `tracker.kernels.aot`; ``runtime``
    is the folder of `build_runtime`."""
    system = [] if sys.platform == "win32" else ["m"]
    extension = Extension(
        name,
        [_source("module.c")],
        define_macros=[("MODULE", name)],
        extra_objects=[str(functions)],
        depends=[str(functions)],  # or an older library of this name is kept
        extra_link_args=ONLY_CALLED.get(sys.platform, []),
        libraries=[RUNTIME, *system],
        library_dirs=[str(runtime)],
        language="c++",
    )
    _build(extension, folder)


def _source(name: str) -> str:
    """setuptools wants relative paths."""
    return os.path.relpath(HERE / name)


def _width_of_lapack() -> int:
    """1 if this numba calls LAPACK with integers of 64 bits."""
    return int(getattr(_helperlib, "LAPACK_BUILD_ILP64", 0))


def _build(extension: Extension, folder: Path) -> None:
    with tempfile.TemporaryDirectory() as work:
        command: Any = Distribution({"ext_modules": [extension]}).get_command_obj("build_ext")
        command.build_lib, command.build_temp = str(folder), work
        command.ensure_finalized()
        command.run()
