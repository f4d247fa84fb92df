"""numba's types for the words of `tracker.kernels.kinds`."""

from __future__ import annotations

import importlib
import re
from typing import Any

from numba import types

NUMBERS = {
    "b1": types.boolean, "i1": types.int8, "i2": types.int16, "i4": types.int32, "i8": types.int64,
    "u1": types.uint8, "u2": types.uint16, "u4": types.uint32, "u8": types.uint64,
    "f4": types.float32, "f8": types.float64, "c8": types.complex64, "c16": types.complex128,
}  # fmt: skip
_ARRAY = re.compile(r"(\w\d+)\[(\d)([CFA])(r?)\]")


def arguments(kinds: str) -> tuple[Any, ...]:
    """The types of all arguments of a call."""
    return tuple(numba_type(word) for word in kinds.split(" ")) if kinds else ()


def numba_type(word: str) -> Any:
    """The type for one word."""
    if word.endswith(")"):
        place, _, members = word[:-1].partition("(")
        return types.BaseTuple.from_types([numba_type(m) for m in _members(members)], _class(place))
    if word == "none":
        return types.none
    array = _ARRAY.fullmatch(word)
    if array is None:
        return NUMBERS[word]
    number, dimensions, order, read_only = array.groups()
    return types.Array(NUMBERS[number], int(dimensions), order, readonly=bool(read_only))


def _class(place: str) -> type | None:
    """A named tuple's class; None for a plain one's."""
    module, _, name = place.rpartition(".")
    return getattr(importlib.import_module(module), name) if place else None


def _members(words: str) -> list[str]:
    """Parts between the commas that are in no bracket."""
    parts, depth = [""], 0
    for letter in words:
        depth += (letter == "(") - (letter == ")")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part for part in parts if part]
