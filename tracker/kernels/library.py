"""The library of kernels compiled ahead of time, and the fallback for missing ones.

`tracker.kernels.build` writes extension modules to this folder: those of the library's parts
(`tracker.kernels.parts`), with a function for each kernel that Python calls, and `_dispatch`, which
runs it if a call's arguments have the types that it was compiled for.
"""

from __future__ import annotations

import functools
import importlib
import logging
import threading
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any

import numpy as np

from tracker.kernels import parts
from tracker.kernels.fingerprint import fingerprint

_log = logging.getLogger(__name__)

Function = Callable[..., Any]


class Library:
    """Creates kernels that run compiled functions wherever these were compiled from the same
    source.

    ``compiled`` contains modules and their tables.
    """

    def __init__(self, kernel_type: type, compiled: Sequence[tuple[ModuleType, str]]) -> None:
        self._kernel_type = kernel_type
        self._filling = threading.Lock()
        self._entries: dict[str, tuple[Function, str, str]] = {}
        self._made: dict[str, Any] = {}
        for module, table in compiled:
            for line in table.splitlines()[1:]:
                symbol, made_of, name, *words = line.split(" ")
                self._entries[name] = getattr(module, symbol), made_of, " ".join(words)

    def kernel(self, function: Function, options: dict[str, Any]) -> Any:
        """A callable for ``function``; its implementation is selected on the first call."""
        made = self._kernel_type(self)
        functools.update_wrapper(made, function)
        made.py_func, made.options, made.fallback = function, options, None
        self._made[_name(made)] = made
        return made

    def is_current(self) -> bool:
        """Whether all entries for the kernels created so far were compiled from their source."""
        held = [made for name, made in list(self._made.items()) if name in self._entries]
        return all(self._is_of_its_source(made) for made in held)

    # --- called by kernels

    def miss(self, kernel: Any, args: tuple[Any, ...], named: dict[str, Any]) -> Any:
        """Handles a call that does not match the compiled function: the first one, or other
        types."""
        if named:
            return kernel(*args, *_in_order(kernel.py_func, len(args), named))
        with self._filling:  # threads may call a kernel for the first time concurrently
            if kernel.fallback is None:
                self._fill(kernel)
                kernel.fallback = self._fallback(kernel)
        return kernel(*args) if kernel.finds(*args) else kernel.fallback(*args)

    def numba_type(self, kernel: Any) -> Any:
        """Used by numba to compile a kernel that calls this one, as a numba function."""
        return self._by_numba(kernel)._numba_type_

    def _fill(self, kernel: Any) -> None:
        """Assign the compiled function to a kernel, if it was compiled from the same source."""
        if _name(kernel) in self._entries and self._is_of_its_source(kernel):
            compiled, _, words = self._entries[_name(kernel)]
            kernel.add(words, compiled)

    def _is_of_its_source(self, kernel: Any) -> bool:
        _, made_of, _ = self._entries[_name(kernel)]
        return made_of == fingerprint(kernel.py_func, kernel.options)

    def _fallback(self, kernel: Any) -> Function:
        """The implementation for argument types that are not in the library."""

        def run(*args: Any) -> Any:
            function = self._by_numba(kernel)
            if not logged.is_set():
                logged.set()
                level = logging.WARNING if function is kernel.py_func else logging.DEBUG
                types = ", ".join(_described(arg) for arg in args)
                _log.log(level, "not in the library: %s(%s)", kernel.__qualname__, types)
            return function(*args)

        logged = threading.Event()
        return run

    def _by_numba(self, kernel: Any) -> Any:
        if "jit" not in kernel.__dict__:
            try:
                from tracker.kernels.jit import compiled  # deferred: loads numba
            except ImportError:
                _log.warning("%s runs uncompiled, so slowly", kernel.__qualname__)
                kernel.jit = kernel.py_func
            else:
                kernel.jit = compiled(kernel.py_func, kernel.options)
        return kernel.jit


def _name(kernel: Any) -> str:
    return f"{kernel.__module__}.{kernel.__qualname__}"


def load() -> Library | None:
    """The library, or None where it was not built, or does not match this Python or this source:
    after an update of a checkout the library is out of date until it is built again."""
    try:
        dispatch = importlib.import_module(f"{__package__}._dispatch")
        if not hasattr(dispatch, "runs_wide"):
            raise ImportError("it was built from an older source")
        compiled = [_part(name) for name in _for_this_processor(dispatch)]
    except (ImportError, OSError) as error:
        _log.debug("kernels are compiled as they are needed: %s", error)
        return None
    return Library(dispatch.Kernel, compiled) if compiled else None


def _for_this_processor(dispatch: ModuleType) -> list[str]:
    """Parts to be loaded, wide ones last: for a kernel in two parts the later one is used."""
    built, runs_wide = parts.built(), dispatch.runs_wide()
    return sorted((p for p in built if runs_wide or not parts.is_wide(p)), key=parts.is_wide)


def _part(name: str) -> tuple[ModuleType, str]:
    module = importlib.import_module(f"{__package__}.{parts.module_of(name)}")
    return module, parts.table_of(name).read_text("utf-8")


def _described(value: Any) -> str:
    """The type of an argument, for the log."""
    if isinstance(value, np.ndarray):
        order = "C" if value.flags.c_contiguous else "F" if value.flags.f_contiguous else "A"
        frozen = "" if value.flags.writeable else " read-only"
        return f"{value.dtype}[{value.ndim}{order}]{frozen}"
    if isinstance(value, tuple):
        return f"{type(value).__name__}({', '.join(_described(v) for v in value)})"
    return type(value).__name__


def _in_order(function: Function, given: int, named: dict[str, Any]) -> list[Any]:
    """Named arguments in the order of the function's parameters."""
    code = function.__code__
    names = code.co_varnames[given : code.co_argcount]
    if set(named) != set(names):
        raise TypeError(f"{function.__qualname__}() wants {', '.join(names)}")
    return [named[name] for name in names]
