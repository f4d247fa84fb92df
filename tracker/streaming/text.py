"""JSON messages of the same form again and again, with other numbers.

Composing a dictionary of 400 numbers and encoding it takes 1 ms. A message's form depends only on
what is known and on its words, so that the text between the numbers is stored.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.messages import Array

BoolArray = NDArray[np.bool_]
Column = list[Any]
DECIMALS = 6  # µm and µrad: below every error of a hand tracker, and half the bytes of a double
HOLE = "\0"
"""In the message of a `TextForm`: a value that is given as JSON."""
_HOLE = re.compile(r'"\\u0000(\d*)"')


class TextForm:
    """A message with holes for values and for the numbers of an array."""

    def __init__(self, message: object) -> None:
        """``message``: JSON-ready, with `HOLE` and those of `holes` in place of what changes."""
        text = json.dumps(message, separators=(",", ":"), allow_nan=False).replace("%", "%%")
        found = _HOLE.findall(text)
        self._order = np.array([int(n) for n in found if n], int)
        self._heads = [i for i, n in enumerate(found) if not n]
        self._form = _HOLE.sub("%s", text)

    def fill(self, flat: Array, head: Sequence[str] = ()) -> str:
        """The text with numbers of ``flat`` (n,), rounded, and with JSON ``head`` for each
        `HOLE`."""
        values: list[object] = np.round(flat[self._order], DECIMALS).tolist()
        for i, text in zip(self._heads, head, strict=True):
            values.insert(i, text)
        return self._form % tuple(values)


def holes(columns: Sequence[tuple[int, ...]], known: BoolArray | None) -> list[Column]:
    """As `numbers` for the columns of these shapes, with holes for the numbers of all columns in
    one array (n,); ``known`` (n,): those that are finite, None if all are."""
    out, at = [], 0
    for shape in columns:
        size = int(np.prod(shape))
        names = np.array([f"{HOLE}{i}" for i in range(at, at + size)], object).reshape(shape)
        there = np.ones(shape, bool) if known is None else known[at : at + size].reshape(shape)
        out.append(_with_none(names.tolist(), there))
        at += size
    return out


def numbers(values: Array) -> Column:
    """(n,) or (n, k), rounded, as JSON-ready objects; None for a number or a row that is not
    finite."""
    return _with_none(np.round(values, DECIMALS).tolist(), np.isfinite(values))


def _with_none(column: Column, known: BoolArray) -> Column:
    rows: BoolArray = known if known.ndim == 1 else np.asarray(known.all(axis=1))
    return [x if k else None for x, k in zip(column, rows, strict=True)]
