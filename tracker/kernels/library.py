"""The library of kernels that were compiled ahead of time, and what runs in place of a missing one.

`tracker.kernels.build` leaves extension modules beside this one: those of the library's parts
(`tracker.kernels.parts`), with a function for each line of signatures.txt, and `_dispatch`, which
picks one by the types of a call.
"""

from __future__ import annotations

import functools
import importlib
import logging
import threading
from collections import defaultdict
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any

from tracker.kernels import parts
from tracker.kernels.fingerprint import fingerprint
from tracker.kernels.kinds import UnknownKindError, kinds_of

_log = logging.getLogger(__name__)

Function = Callable[..., Any]


class Library:
    """Makes kernels that run compiled functions wherever these were made from the same source.

    ``compiled`` has modules and their tables.
    """

    def __init__(self, kernel_type: type, compiled: Sequence[tuple[ModuleType, str]]) -> None:
        self._kernel_type = kernel_type
        self._filling = threading.Lock()
        self._lines: dict[str, list[tuple[Function, str, str]]] = defaultdict(list)
        for module, table in compiled:
            for line in table.splitlines()[1:]:
                symbol, print_, name, *kinds = line.split(" ")
                self._lines[name].append((getattr(module, symbol), print_, " ".join(kinds)))

    def kernel(self, function: Function, options: dict[str, Any]) -> Any:
        """A callable for ``function``; what it runs is decided when it is first called."""
        made = self._kernel_type(self)
        functools.update_wrapper(made, function)
        made.py_func, made.options, made.fallback = function, options, None
        return made

    # --- what a kernel asks

    def miss(self, kernel: Any, args: tuple[Any, ...], named: dict[str, Any]) -> Any:
        """A call that no function of the kernel fits: the first one, or one of other types."""
        if named:
            return kernel(*args, *_in_order(kernel.py_func, len(args), named))
        with self._filling:  # threads may call a kernel for the first time together
            if kernel.fallback is None:
                self._fill(kernel)
                kernel.fallback = self._fallback(kernel)
        return kernel(*args) if kernel.finds(*args) else kernel.fallback(*args)

    def numba_type(self, kernel: Any) -> Any:
        """numba compiles a kernel that calls this one: to it, this is a function of its own."""
        return self._by_numba(kernel)._numba_type_

    def _fill(self, kernel: Any) -> None:
        """Give a kernel its functions, those for the narrowest types first."""
        lines = self._lines[f"{kernel.__module__}.{kernel.__qualname__}"]
        wanted = fingerprint(kernel.py_func, kernel.options) if lines else ""
        for compiled, print_, kinds in sorted(lines, key=lambda line: _breadth(line[2])):
            if print_ == wanted:
                kernel.add(kinds, compiled)

    def _fallback(self, kernel: Any) -> Function:
        """What runs for types that are not in the library."""

        def run(*args: Any) -> Any:
            if not told:
                told.append(True)
                _log.debug("not in the library: %s %s", kernel.__qualname__, _told(args))
            return self._by_numba(kernel)(*args)

        told: list[bool] = []
        return run

    def _by_numba(self, kernel: Any) -> Any:
        if "jit" not in kernel.__dict__:
            try:
                from tracker.kernels.jit import compiled
            except ImportError:
                _log.warning("%s runs uncompiled, so slowly", kernel.__qualname__)
                kernel.jit = kernel.py_func
            else:
                kernel.jit = compiled(kernel.py_func, kernel.options)
        return kernel.jit


def load() -> Library | None:
    """The library, or None where it was not built or does not fit this Python."""
    try:
        from tracker.kernels import _dispatch  # type: ignore[attr-defined]

        compiled = [_part(name) for name in parts.built()]
    except (ImportError, OSError) as error:
        _log.debug("kernels are compiled as they are needed: %s", error)
        return None
    return Library(_dispatch.Kernel, compiled) if compiled else None


def _part(name: str) -> tuple[ModuleType, str]:
    module = importlib.import_module(f"tracker.kernels.{parts.module_of(name)}")
    return module, parts.table_of(name).read_text("utf-8")


def _told(args: tuple[Any, ...]) -> str:
    """The types of a call, for the log."""
    try:
        return kinds_of(args)
    except UnknownKindError as unknown:
        return f"with {unknown}"


def _breadth(kinds: str) -> int:
    """How many arrays may be of any order or read-only."""
    return kinds.count("A") + kinds.count("r")


def _in_order(function: Function, given: int, named: dict[str, Any]) -> list[Any]:
    """Named arguments in the order of the function's own."""
    code = function.__code__
    names = code.co_varnames[given : code.co_argcount]
    if set(named) != set(names):
        raise TypeError(f"{function.__qualname__}() wants {', '.join(names)}")
    return [named[name] for name in names]
