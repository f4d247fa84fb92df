"""A kernel's signature, derived from its parameters' annotations.

As text a parameter is one word: ``f8``, ``i8[1C]``, ``(f8,f8)``, ``a.b.State(x:f8,P:f8[2Cw])``. A
number is its numpy type: kind and bytes. An array adds its dimensions, its order (C, F, or A for
any), and ``w`` if the kernel writes to it. A tuple has its members in brackets, a named one also
its class and its fields' names. Numbers other than int, float, bool and complex are numpy's types;
arrays are the names of `tracker.kernels.arrays`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, get_args, get_origin, get_type_hints

import numpy as np

from tracker.kernels.arrays import WRITTEN

INSTALLED_IN = (__package__ or "").removesuffix("tracker.kernels")
"""Prefix of the packages' names: empty in this tree, ``glovetrack.`` in a wheel."""
NUMBERS = {bool: "b1", int: "i8", float: "f8", complex: "c16"}
Annotation = Any


class SignatureError(TypeError):
    """An annotation that does not specify the type for which a kernel is compiled."""


def signature(function: Callable[..., Any]) -> str:
    """The words of all parameters, separated by spaces. SignatureError if one has no type."""
    words = []
    for name, annotation in parameters(function).items():
        try:
            words.append(word(annotation))
        except SignatureError as error:
            raise SignatureError(f"{_full_name(function)}: {name}: {error}") from error
    return " ".join(words)


def parameters(function: Callable[..., Any]) -> dict[str, Annotation]:
    """Annotations by the names of the parameters. SignatureError where there is none."""
    code = function.__code__
    try:
        hints = get_type_hints(function, include_extras=True)
        return {name: hints[name] for name in code.co_varnames[: code.co_argcount]}
    except KeyError as missing:
        raise SignatureError(f"{_full_name(function)}: {missing} has no annotation.") from missing
    except NameError as unknown:
        raise SignatureError(f"{_full_name(function)}: {unknown}.") from unknown


def check_result(function: Callable[..., Any]) -> None:
    """SignatureError if a kernel that Python calls returns a named tuple.

    Its compiled function would import the tuple's class by its name in this tree, and crash in a
    wheel, where the class has another name.
    """
    result = get_type_hints(function).get("return")
    if isinstance(result, type) and hasattr(result, "_fields"):
        raise SignatureError(
            f"{_full_name(function)} returns the named tuple {result.__qualname__}. "
            "A kernel that Python calls has to return a plain tuple."
        )


def word(annotation: Annotation, written: bool = False) -> str:
    """The word for one parameter, or for a tuple's member; ``written``: the tuple is."""
    written = written or is_written(annotation)
    plain = without_marks(annotation)
    inside = members(annotation)
    if inside is not None:
        words = [f"{name}{word(member, written)}" for name, member in inside]
        return f"{_class_name(plain)}({','.join(words)})"
    array = array_word(annotation)
    if array is not None:
        return array.replace("]", "w]") if written else array
    if plain in NUMBERS:
        return NUMBERS[plain]
    if isinstance(plain, type) and issubclass(plain, np.generic):
        return f"{np.dtype(plain).kind}{np.dtype(plain).itemsize}"
    raise SignatureError(f"{annotation} does not say numbers, dimensions and order.")


def members(annotation: Annotation) -> list[tuple[str, Annotation]] | None:
    """A tuple's members, prefixed with ``name:`` for a named tuple; None for anything else."""
    plain = without_marks(annotation)
    if isinstance(plain, type) and issubclass(plain, tuple) and hasattr(plain, "_fields"):
        hints = get_type_hints(plain, include_extras=True)
        return [(f"{name}:", hints.get(name)) for name in plain._fields]
    if get_origin(plain) is tuple and Ellipsis not in get_args(plain):
        return [("", member) for member in get_args(plain)]
    return None


def array_word(annotation: Annotation) -> str | None:
    """The word for an array type of `tracker.kernels.arrays`."""
    words = [mark for mark in _marks(annotation) if isinstance(mark, str)]
    return words[0] if words else None


def is_written(annotation: Annotation) -> bool:
    """Whether it is marked as `tracker.kernels.arrays.Written`."""
    return any(mark is WRITTEN for mark in _marks(annotation))


def without_marks(annotation: Annotation) -> Annotation:
    return get_args(annotation)[0] if get_origin(annotation) is Annotated else annotation


def _marks(annotation: Annotation) -> tuple[Any, ...]:
    return get_args(annotation)[1:] if get_origin(annotation) is Annotated else ()


def _class_name(plain: Annotation) -> str:
    """The full name of a named tuple's class in this tree; empty for a plain tuple."""
    if not isinstance(plain, type):
        return ""
    return f"{plain.__module__.removeprefix(INSTALLED_IN)}.{plain.__qualname__}"


def _full_name(function: Callable[..., Any]) -> str:
    return f"{function.__module__}.{function.__qualname__}"
