"""Compiles the kernels ahead of time, for the types in signatures.txt.

    python -m tracker.kernels.build                 # all parts that are not as they would become
    python -m tracker.kernels.build tracker_vision  # one part

It takes a C++ compiler and some minutes, two parts at a time on two cores, and leaves the library
beside this file (`tracker.kernels.parts`).
"""

from __future__ import annotations

import hashlib
import importlib
import os
import subprocess
import sys
import tempfile
import warnings
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

from tracker.kernels.mode import MODE

os.environ[MODE] = "build"  # before any kernel is made

import numba
import numpy as np
from setuptools import Distribution, Extension

from tracker.kernels import numba_types, parts
from tracker.kernels.fingerprint import fingerprint
from tracker.kernels.parts import HERE
from tracker.kernels.record import SIGNATURES

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # numba has said since 2023 that this may move elsewhere
    from numba.core.registry import cpu_target
    from numba.pycc import CC
    from numba.pycc import compiler as pycc_compiler

PROCESSOR = ""  # what every processor of the kind understands
DISPATCH = "_dispatch"


class Entry(NamedTuple):
    """One function of the library."""

    symbol: str
    name: str
    kinds: str
    kernel: Any

    def line(self) -> str:
        made_of = fingerprint(self.kernel.py_func, self.kernel.options)
        return f"{self.symbol} {made_of} {self.name} {self.kinds}\n"


def main(wanted: list[str]) -> None:
    entries = _entries()
    if wanted:
        for part in wanted:
            _build_part(part, entries[part])
        return
    parts.remove_others(entries)
    _build_dispatch()
    old = [part for part, its in entries.items() if not parts.is_built(part, _table(its))]
    _build_side_by_side(sorted(old, key=lambda part: -len(entries[part])))
    print(f"{sum(map(len, entries.values()))} kernels compiled, {len(old)} parts of them now")


def _entries() -> dict[str, list[Entry]]:
    """What each part is to hold."""
    entries: dict[str, list[Entry]] = defaultdict(list)
    for i, line in enumerate(SIGNATURES.read_text("utf-8").splitlines()):
        name, _, kinds = line.partition(" ")
        module, _, function = name.rpartition(".")
        kernel = getattr(importlib.import_module(module), function, None)
        if kernel is None:
            print(f"There is no {name} any more: make signatures")
        else:
            entries[parts.part_of(name)].append(Entry(f"k{i}", name, kinds, kernel))
    return dict(entries)


def _table(entries: list[Entry]) -> str:
    return f"{_compiled_by()}\n" + "".join(entry.line() for entry in entries)


def _compiled_by() -> str:
    """Versions of all that decides what a kernel's source becomes."""
    here = hashlib.sha256()
    for source in (__file__, numba_types.__file__):
        here.update(Path(source).read_bytes())
    python = ".".join(map(str, sys.version_info[:3]))
    versions = f"python {python} numba {numba.__version__} numpy {np.__version__}"
    return f"# {versions} build {here.hexdigest()[:16]}"


def _build_side_by_side(names: list[str]) -> None:
    """One process for each part, as many at a time as there are cores."""
    command = [sys.executable, "-m", "tracker.kernels.build"]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        codes = list(pool.map(lambda part: subprocess.run([*command, part]).returncode, names))
    failed = [part for part, code in zip(names, codes, strict=True) if code]
    if failed:
        raise SystemExit(f"Not compiled: {', '.join(failed)}")


def _build_part(part: str, entries: list[Entry]) -> None:
    parts.table_of(part).unlink(missing_ok=True)  # an old one is not to speak for a new module
    compiler = CC(parts.module_of(part), source_module=sys.modules[__name__])
    compiler.target_cpu = PROCESSOR
    compiler.output_dir = str(HERE)
    for entry in entries:
        compiler.export(entry.symbol, numba_types.arguments(entry.kinds))(entry.kernel.py_func)
    options = {entry.kernel.py_func: entry.kernel.targetoptions for entry in entries}
    with mock.patch.object(pycc_compiler, "compile_extra", _with_options(options)):
        compiler.compile()
    parts.table_of(part).write_text(_table(entries), "utf-8")
    print(f"{part}: {len(entries)} kernels", flush=True)


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
    main(sys.argv[1:])
