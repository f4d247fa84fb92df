"""What a kernel's compiled code depends on, as a number: its own code, and all that it reads.

Two kernels with the same fingerprint compile to the same code. Lines and files do not count, so a
comment changes nothing, and neither does where the program lies.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from types import BuiltinFunctionType, CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

OURS = ("app", "tracker")
Function = Callable[..., Any]


def is_kernel(value: Any) -> bool:
    """Whether `decorator.kernel` made it, in whatever form."""
    return hasattr(value, "py_func") and hasattr(value, "options")


def fingerprint(function: Function, options: dict[str, Any]) -> str:
    """16 digits for a kernel of `decorator` and its options."""
    told = hashlib.sha256()
    for part in _parts(function, options, set()):
        told.update(part.encode())
        told.update(b"\0")
    return told.hexdigest()[:16]


def _parts(function: Function, options: dict[str, Any], told: set[Function]) -> list[str]:
    """All that is read, kernels called by this one included, each once."""
    if function in told:
        return [function.__qualname__]
    told.add(function)
    code = function.__code__
    parts = [function.__qualname__, repr(sorted(options.items())), *_code(code, function.__doc__)]
    names = _names(code)
    for name in names:
        if name in function.__globals__:
            parts += [name, *_value(function.__globals__[name], names, told)]
    return parts


def _code(code: CodeType, doc: str | None = None) -> list[str]:
    constants = [c for c in code.co_consts if c != doc and not isinstance(c, CodeType)]
    inner = [c for c in code.co_consts if isinstance(c, CodeType)]
    own = [code.co_code.hex(), repr(constants), repr(code.co_names), repr(code.co_varnames)]
    return own + [part for c in inner for part in _code(c)]


def _names(code: CodeType) -> list[str]:
    inner = [c for c in code.co_consts if isinstance(c, CodeType)]
    return sorted({*code.co_names, *(name for c in inner for name in _names(c))})


def _value(value: Any, names: list[str], told: set[Function]) -> list[str]:
    """A global that a kernel reads; of a module of ours what it reads there."""
    if is_kernel(value):
        return _parts(value.py_func, value.options, told)
    if isinstance(value, np.ndarray):
        return [value.dtype.str, repr(value.shape), value.tobytes().hex()]
    if isinstance(value, (bool, int, float, str, tuple, np.generic)):
        return [repr(value)]
    if isinstance(value, ModuleType) and value.__name__.partition(".")[0] in OURS:
        found = [getattr(value, name) for name in names if hasattr(value, name)]
        return [part for v in found for part in _value(v, names, told)]
    if isinstance(value, (ModuleType, FunctionType, BuiltinFunctionType, type, np.ufunc)):
        return [value.__name__]
    raise TypeError(f"a kernel reads a global of type {type(value).__name__}")
