"""numba's types for the annotations of kernels."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from numba import types

from tracker.kernels import signature

NUMBERS = {
    "b1": types.boolean, "i1": types.int8, "i2": types.int16, "i4": types.int32, "i8": types.int64,
    "u1": types.uint8, "u2": types.uint16, "u4": types.uint32, "u8": types.uint64,
    "f4": types.float32, "f8": types.float64, "c8": types.complex64, "c16": types.complex128,
}  # fmt: skip
_ARRAY = re.compile(r"(\w\d+)\[(\d)([CFA])\]")


def arguments(function: Callable[..., Any]) -> tuple[Any, ...]:
    """The types of a kernel's parameters. SignatureError if one has no type annotation."""
    return tuple(numba_type(a) for a in signature.parameters(function).values())


def numba_type(annotation: signature.Annotation) -> Any:
    """The type for one annotation. SignatureError as `signature.word` raises it."""
    members, array = signature.members(annotation), signature.array_word(annotation)
    if members is not None:
        plain = signature.without_marks(annotation)
        of_class = plain if isinstance(plain, type) else None
        return types.BaseTuple.from_types([numba_type(m) for _, m in members], of_class)
    if array is None:
        return NUMBERS[signature.word(annotation)]
    matched = _ARRAY.fullmatch(array)
    if matched is None:
        raise signature.SignatureError(f"{array} is no array's type.")
    number, dimensions, order = matched.groups()
    return types.Array(NUMBERS[number], int(dimensions), order)
