"""A hash of everything a kernel's compiled code depends on: signature, code, and globals.

Two kernels with the same fingerprint compile to the same code. Line numbers and file names are not
included, so comments, the installation folder and the package name have no effect.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from types import BuiltinFunctionType, CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

from tracker.kernels.signature import INSTALLED_IN, signature

OURS = tuple(f"{INSTALLED_IN}{name}" for name in ("app", "extensions", "tracker"))
Function = Callable[..., Any]


def is_kernel(value: Any) -> bool:
    """Whether it was created by `decorator.kernel`, in any form."""
    return hasattr(value, "py_func") and hasattr(value, "options")


def is_ours(name: str) -> bool:
    """Whether a module or function with this full name belongs to the product."""
    return name in OURS or name.startswith(tuple(f"{package}." for package in OURS))


def fingerprint(function: Function, options: dict[str, Any]) -> str:
    """16 hexadecimal digits for a kernel of `decorator`. Raises SignatureError as `signature`
    does."""
    digest = hashlib.sha256()
    for part in [signature(function), *_parts(function, options, set())]:
        digest.update(part.encode())
        digest.update(b"\0")
    return digest.hexdigest()[:16]


def _parts(function: Function, options: dict[str, Any], seen: set[Function]) -> list[str]:
    """Everything that is read, including the called kernels, each once."""
    if function in seen:
        return [function.__qualname__]
    seen.add(function)
    code = function.__code__
    parts = [function.__qualname__, repr(sorted(options.items())), *_code(code, function.__doc__)]
    names = _names(code)
    for name in names:
        if name in function.__globals__:
            parts += [name, *_value(function.__globals__[name], names, seen)]
    return parts


def _code(code: CodeType, doc: str | None = None) -> list[str]:
    constants = [c for c in code.co_consts if c != doc and not isinstance(c, CodeType)]
    inner = [c for c in code.co_consts if isinstance(c, CodeType)]
    own = [code.co_code.hex(), repr(constants), repr(code.co_names), repr(code.co_varnames)]
    return own + [part for c in inner for part in _code(c)]


def _names(code: CodeType) -> list[str]:
    inner = [c for c in code.co_consts if isinstance(c, CodeType)]
    return sorted({*code.co_names, *(name for c in inner for name in _names(c))})


def _value(value: Any, names: list[str], seen: set[Function]) -> list[str]:
    """A global read by a kernel; for one of our modules the names read from it."""
    if is_kernel(value):
        return _parts(value.py_func, value.options, seen)
    if isinstance(value, np.ndarray):
        return [value.dtype.str, repr(value.shape), value.tobytes().hex()]
    if isinstance(value, (bool, int, float, str, tuple, np.generic)):
        return [repr(value)]
    if isinstance(value, ModuleType) and is_ours(value.__name__):
        found = [getattr(value, name) for name in names if hasattr(value, name)]
        return [part for v in found for part in _value(v, names, seen)]
    if isinstance(value, type) and hasattr(value, "_fields"):
        return [value.__qualname__, *value._fields]  # compiled code accesses fields by index
    if isinstance(value, (ModuleType, FunctionType, BuiltinFunctionType, type, np.ufunc)):
        return [value.__name__]
    raise TypeError(f"a kernel reads a global of type {type(value).__name__}")
