"""Declared shapes of arrays, as text: ``"n 3"``, ``"bool M"``, ``"0 | M"``, ``"21n 21n"``.

One or more alternatives, separated by ``|``: the sizes of the axes, each a number, a name or a
multiple of a name. A prefix is the type, ``bool``, ``int`` or ``complex``; the default is
floating-point numbers. The first alternative that matches is used.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

Sizes = dict[str, int]
"""The sizes of named axes."""

_KINDS = {"float": "f", "bool": "b", "int": "iu", "complex": "c"}
_AXIS = re.compile(r"(\d*)([A-Za-z]?)")


@dataclass(frozen=True)
class _Alternative:
    """kinds of NumPy types, and of each axis a factor and a name; without a name, a size."""

    kinds: str
    axes: tuple[tuple[int, str], ...]

    def match(self, array: np.ndarray, known: Sizes) -> Sizes | None:
        """The names that the array adds to ``known``; None where it has another shape."""
        if array.dtype.kind not in self.kinds or array.ndim != len(self.axes):
            return None
        found: Sizes = {}
        for size, (factor, name) in zip(array.shape, self.axes, strict=True):
            if not name:
                wanted = factor
            elif name in known or name in found:
                wanted = factor * known.get(name, found.get(name, 0))
            else:
                found[name] = size // factor
                wanted = factor * found[name]
            if size != wanted:
                return None
        return found


@dataclass(frozen=True)
class ArrayShape:
    """A declared shape; ``text`` is how it was written."""

    text: str
    alternatives: tuple[_Alternative, ...]

    @staticmethod
    def of(text: str) -> ArrayShape:
        """Parses a shape. Raises TypeError for an invalid one."""
        return ArrayShape(text, tuple(_alternative(part, text) for part in text.split("|")))

    def match(self, array: np.ndarray, known: Sizes) -> Sizes | None:
        """The names that the array adds to ``known``; None where it has another shape."""
        matches = (one.match(array, known) for one in self.alternatives)
        return next((found for found in matches if found is not None), None)


def _alternative(part: str, text: str) -> _Alternative:
    tokens = part.split()
    kind = tokens.pop(0) if tokens and tokens[0] in _KINDS else "float"
    axes = []
    for token in tokens:
        whole = _AXIS.fullmatch(token)
        if whole is None:
            raise TypeError(f"{text!r} is not a shape: {token!r}")
        factor, name = whole.groups()
        axes.append((int(factor or 1), name))
    return _Alternative(_KINDS[kind], tuple(axes))
