"""Compiles the kernels ahead of time, for the types in their annotations.

    python -m tracker.kernels.build                 # all parts that are out of date
    python -m tracker.kernels.build --for-demo      # those of them that the demo needs
    python -m tracker.kernels.build tracker_vision  # one part

Requires a C++ compiler and a few minutes, compiles two parts at a time on two cores, and writes the
library to this folder (`tracker.kernels.parts`). Parts compiled earlier, in any checkout, are
copied from `tracker.kernels.cache`.
"""

from __future__ import annotations

import hashlib
import importlib
import multiprocessing
import os
import sys
import tempfile
from collections import Counter, defaultdict
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Any, NamedTuple

from tracker.kernels.parts import MODE

os.environ[MODE] = "build"  # before any kernel is created

import numba
import numpy as np

from tracker.kernels import aot, cache, exported, numba_types, parts, target, toolchain, tools
from tracker.kernels.fingerprint import fingerprint
from tracker.kernels.parts import HERE
from tracker.kernels.signature import SignatureError, check_result, signature

DISPATCH = "_dispatch"
FOR_DEMO = "--for-demo"


class LibraryEntry(NamedTuple):
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
    tables = {part: _table(part, its) for part, its in entries.items()}
    if not wanted:
        parts.remove_others(entries)
    elif wanted == [FOR_DEMO]:
        tables = {p: table for p, table in tables.items() if not parts.is_for_later(p)}
    else:
        tables = {part: tables[part] for part in wanted}
    old = [part for part, table in tables.items() if not parts.is_built(part, table)]
    for part in old:
        parts.table_of(part).unlink(missing_ok=True)  # it must not describe a new module
    _get_dispatch()
    new = [part for part in old if not _fetch_part(part, tables[part])]
    _build_side_by_side(new)
    for part in tables:
        os.utime(parts.table_of(part))  # current, even if its source file was touched
    print(f"{len(tables)} parts of kernels: {len(new)} compiled, {len(old) - len(new)} fetched")


def _fetch_part(part: str, table: str) -> bool:
    """Whether the part was compiled earlier from the same source, and is now in this folder."""
    if not cache.fetch(table, parts.module_of(part)):
        return False
    parts.table_of(part).write_text(table, "utf-8")
    return True


def _entries() -> dict[str, list[LibraryEntry]]:
    """The functions of each part. SystemExit if a kernel cannot be compiled for it."""
    called = exported.exported()
    errors = [_error_of(signature, name) for name in exported.kernels()]
    errors += [_error_of(check_result, name) for name in called]
    if wrong := [str(error) for error in errors if error is not None]:
        raise SystemExit("\n".join(wrong))
    entries: dict[str, list[LibraryEntry]] = defaultdict(list)
    for name in called:
        kernel, part = _kernel(name), parts.part_of(name)
        wide = kernel.options.get("wide") and parts.can_be_wide()
        for its in (entries[part], entries[part + parts.WIDE]) if wide else (entries[part],):
            its.append(LibraryEntry(f"k{len(its)}", name, kernel))
    return dict(entries)


def _kernel(name: str) -> Any:
    module, _, function = name.rpartition(".")
    return getattr(importlib.import_module(module), function)


def _error_of(check: Callable[[Any], object], name: str) -> SignatureError | None:
    try:
        check(_kernel(name).py_func)
    except SignatureError as error:
        return error
    return None


def _table(part: str, entries: list[LibraryEntry]) -> str:
    features = f" for {parts.WIDE_FEATURES}" if parts.is_wide(part) else ""
    return f"{_compiled_by()}{features}\n" + "".join(entry.line() for entry in entries)


def _compiled_by() -> str:
    """Versions of everything that affects a kernel's compiled code."""
    here = hashlib.sha256()
    for module in (aot, numba_types, target, toolchain):
        here.update(Path(str(module.__file__)).read_bytes())
    for source in (Path(__file__), HERE / "runtime.c", HERE / "module.c"):
        here.update(source.read_bytes())
    python = ".".join(map(str, sys.version_info[:3]))
    versions = f"python {python} numba {numba.__version__} numpy {np.__version__}"
    return f"# {versions} build {here.hexdigest()[:16]}"


def _build_side_by_side(wanted: list[str]) -> None:
    """As many parts at a time as there are cores, the longest first.

    A process compiles several parts, which share what they call; wide ones come last, in other
    processes. Where processes can be forked they start with everything imported, which takes 4 s.
    """
    if not wanted:
        return
    can_fork = "fork" in multiprocessing.get_all_start_methods() and sys.platform == "linux"
    context = multiprocessing.get_context("fork" if can_fork else "spawn")
    sizes = Counter(map(parts.part_of, exported.kernels()))
    longest_first = sorted(wanted, key=lambda part: -sizes[part.removesuffix(parts.WIDE)])
    failed: list[str] = []
    done = 0
    with tempfile.TemporaryDirectory() as runtime:
        toolchain.build_runtime(Path(runtime))
        for wide in (False, True):
            group = [part for part in longest_first if parts.is_wide(part) == wide]
            with ProcessPoolExecutor(os.cpu_count(), context) as pool:
                waiting = {pool.submit(_build_part, part, Path(runtime)): part for part in group}
                for future in as_completed(waiting):
                    done, part, error = done + 1, waiting[future], future.exception()
                    failed += [] if error is None else [f"{part} ({error})"]
                    print(tools.progress_line(part, done, len(wanted)), flush=True)
    if failed:
        raise SystemExit(f"Not compiled: {', '.join(failed)}")


def _build_part(part: str, runtime: Path) -> None:
    entries, module = _entries()[part], parts.module_of(part)
    features = parts.WIDE_FEATURES if parts.is_wide(part) else ""
    with tempfile.TemporaryDirectory() as work:
        code = Path(work, f"{module}{toolchain.OBJECT}")
        code.write_bytes(aot.object_code(module, [_function(e) for e in entries], features))
        toolchain.link_module(module, code, runtime, HERE)
    table = _table(part, entries)
    parts.table_of(part).write_text(table, "utf-8")
    cache.store(table, module)


def _function(entry: LibraryEntry) -> aot.Function:
    python = entry.kernel.py_func
    types = numba_types.arguments(python)
    return aot.Function(entry.symbol, types, python, entry.kernel.targetoptions)


def _get_dispatch() -> None:
    """Compile the dispatch module, unless that was done before."""
    made_of = f"{_compiled_by()}\n{(HERE / 'dispatch.c').read_text('utf-8')}"
    if cache.fetch(made_of, DISPATCH):
        return
    toolchain.build_dispatch(DISPATCH, HERE)
    cache.store(made_of, DISPATCH)


if __name__ == "__main__":
    main(sys.argv[1:])
