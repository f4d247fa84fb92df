"""Compiles the kernels ahead of time, for the types that their annotations say.

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
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

from tracker.kernels.decorator import MODE

os.environ[MODE] = "build"  # before any kernel is made

import numba
import numpy as np
from setuptools import Distribution, Extension

from tracker.kernels import aot, exported, numba_types, parts
from tracker.kernels.fingerprint import fingerprint
from tracker.kernels.parts import HERE
from tracker.kernels.signature import SignatureError, signature

DISPATCH = "_dispatch"


class Entry(NamedTuple):
    """One function of the library."""

    symbol: str
    name: str
    kernel: Any

    def line(self) -> str:
        function = self.kernel.py_func
        made_of = fingerprint(function, self.kernel.options)
        return f"{self.symbol} {made_of} {self.name} {signature(function)}\n"


def main(wanted: list[str]) -> None:
    entries = _entries()
    if wanted:
        for part in wanted:
            _build_part(part, entries[part])
        return
    parts.remove_others(entries)
    tables = {part: _table(its) for part, its in entries.items()}
    old = [part for part, table in tables.items() if not parts.is_built(part, table)]
    for part in old:
        parts.table_of(part).unlink(missing_ok=True)  # it is not to speak for a new module
    _build_dispatch()
    _build_side_by_side(sorted(old, key=lambda part: -len(entries[part])))
    print(f"{sum(map(len, entries.values()))} kernels compiled, {len(old)} parts of them now")


def _entries() -> dict[str, list[Entry]]:
    """What each part is to hold. SystemExit if a kernel does not say its types."""
    untyped = [str(error) for error in map(_error_of, exported.kernels()) if error is not None]
    if untyped:
        raise SystemExit("\n".join(untyped))
    entries: dict[str, list[Entry]] = defaultdict(list)
    for name in exported.exported():
        its = entries[parts.part_of(name)]
        its.append(Entry(f"k{len(its)}", name, _kernel(name)))
    return dict(entries)


def _kernel(name: str) -> Any:
    module, _, function = name.rpartition(".")
    return getattr(importlib.import_module(module), function)


def _error_of(name: str) -> SignatureError | None:
    try:
        signature(_kernel(name).py_func)
    except SignatureError as error:
        return error
    return None


def _table(entries: list[Entry]) -> str:
    return f"{_compiled_by()}\n" + "".join(entry.line() for entry in entries)


def _compiled_by() -> str:
    """Versions of all that decides what a kernel's source becomes."""
    here = hashlib.sha256()
    for source in (__file__, aot.__file__, numba_types.__file__):
        here.update(Path(source).read_bytes())
    python = ".".join(map(str, sys.version_info[:3]))
    versions = f"python {python} numba {numba.__version__} numpy {np.__version__}"
    return f"# {versions} build {here.hexdigest()[:16]}"


def _build_side_by_side(names: list[str]) -> None:
    """One process for each part, as many at a time as there are cores."""
    command = [sys.executable, "-m", f"{__package__}.build"]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        codes = list(pool.map(lambda part: subprocess.run([*command, part]).returncode, names))
    failed = [part for part, code in zip(names, codes, strict=True) if code]
    if failed:
        raise SystemExit(f"Not compiled: {', '.join(failed)}")


def _build_part(part: str, entries: list[Entry]) -> None:
    module = aot.ExtensionModule(parts.module_of(part), HERE)
    for entry in entries:
        function = entry.kernel.py_func
        types = numba_types.arguments(function)
        module.add(entry.symbol, types, function, entry.kernel.targetoptions)
    module.compile()
    parts.table_of(part).write_text(_table(entries), "utf-8")
    print(f"{part}: {len(entries)} kernels", flush=True)


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
