"""The types with which a kernel is called, as words: ``f8`` ``i8`` ``f8[2C]`` ``(f8[1C],i8)``.

A number or array is its numpy type: kind and bytes. An array adds its dimensions and its order (C,
F, or A for any) and ``r`` if it may not be written to. A tuple has its members in brackets,
a named one its class before them; ``none`` is None. These are numba's own distinctions, so what is
compiled for the words does what numba would do.
"""

from __future__ import annotations

import numpy as np

SCALARS = ("b1", "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8", "c8", "c16")
_LARGEST = 2**63


class UnknownKindError(TypeError):
    """A value that no word is for."""


def kind_of(value: object) -> str:
    """The word for ``value``. UnknownKindError for what is no number, array, tuple or None."""
    if isinstance(value, np.ndarray):
        return _array(value)
    if isinstance(value, tuple):
        return f"{_class_of(value)}({','.join(kind_of(v) for v in value)})"
    if value is None:
        return "none"
    return _number(value)


def kinds_of(values: tuple[object, ...]) -> str:
    """The words for all arguments of a call."""
    return " ".join(kind_of(v) for v in values)


def _class_of(value: tuple[object, ...]) -> str:
    """Where a named tuple's class is found; nothing for a plain tuple."""
    kind = type(value)
    if kind is tuple:
        return ""
    if not hasattr(kind, "_fields") or "." in kind.__qualname__:
        raise UnknownKindError(kind.__qualname__)
    return f"{kind.__module__}.{kind.__name__}"


def _array(value: np.ndarray) -> str:
    order = "C" if value.flags.c_contiguous else "F" if value.flags.f_contiguous else "A"
    if not value.flags.aligned or not value.dtype.isnative:
        raise UnknownKindError("an array out of step with memory")
    return f"{_scalar(value.dtype)}[{value.ndim}{order}{'' if value.flags.writeable else 'r'}]"


def _number(value: object) -> str:
    if isinstance(value, bool):
        return "b1"
    if isinstance(value, np.generic):
        return _scalar(value.dtype)
    if isinstance(value, float):
        return "f8"
    if isinstance(value, complex):
        return "c16"
    if isinstance(value, int) and -_LARGEST <= value < _LARGEST:
        return "i8"
    raise UnknownKindError(type(value).__name__)


def _scalar(dtype: np.dtype) -> str:
    word = f"{dtype.kind}{dtype.itemsize}"
    if word not in SCALARS:
        raise UnknownKindError(str(dtype))
    return word
