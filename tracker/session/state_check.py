"""Checks whether an engine can continue from a recorded state.

The state is compared with the declarations of its records (`tracker.base.records`), in all its
parts, including those in lists and those that a new engine does not have. The new engine
(``fresh``) only determines the parts that always exist, and the sizes of the hand and the glove.
Arrays that are empty in it may have grown.
"""

from __future__ import annotations

import enum
from typing import Any

import numpy as np

from tracker.base.array_shapes import ArrayShape, Sizes
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.records import Record, record_of

_NUMBER = int | float | np.generic


class _Mismatch(Exception):
    """Raised for an invalid part of a state."""


def require_match(state: Any, fresh: Any, engine: str) -> None:
    """Raises FileError if the engine of that name cannot continue from ``state``."""
    where = mismatch(state, fresh)
    if where is not None:
        raise FileError(notice("session.state_misfit", engine=engine, where=where))


def mismatch(state: Any, fresh: Any) -> str | None:
    """The first part of ``state`` that does not match the engine with the initial state ``fresh``,
    for diagnosis; None if all match.
    """
    checker = _Declarations()
    try:
        checker.walk(fresh, "state", {})
        checker.walk(state, "state", {})
        _same_parts(state, fresh, "state", None)
    except _Mismatch as error:
        return str(error)
    return None


class _Declarations:
    """Checks arrays against declared shapes. The sizes of the hand and the glove are those of the
    state that is checked first."""

    def __init__(self) -> None:
        self._sizes: dict[str, Sizes] = {}  # of each part with declared sizes, by its path

    def walk(self, value: Any, path: str, sizes: Sizes) -> None:
        """Checks ``value`` recursively; ``sizes`` are those of the enclosing part."""
        known = record_of(type(value))
        if known is not None and not isinstance(value, enum.Enum):
            self._record(value, known, path, sizes)
        elif isinstance(value, list | tuple):
            for k, inside in enumerate(value):
                self.walk(inside, f"{path}[{k}]", sizes)

    def _record(self, whole: Any, known: Record, path: str, sizes: Sizes) -> None:
        if known.sized:
            sizes = self._sizes.setdefault(path, {})
        own: Sizes = {}
        for name, value in known.values(whole).items():
            if name in known.shapes:
                _match(value, known.shapes[name], f"{path}.{name}", own, sizes)
            else:
                self.walk(value, f"{path}.{name}", sizes)


def _match(value: Any, shape: ArrayShape, path: str, own: Sizes, shared: Sizes) -> None:
    """Checks arrays of a declared shape, alone or in lists; adds the sizes of names."""
    if isinstance(value, list | tuple):
        for inside in value:
            _match(inside, shape, path, own, shared)
    elif isinstance(value, np.ndarray):
        found = shape.match(value, shared | own)
        if found is None:
            raise _Mismatch(f"{path} has the shape {value.shape}, not {shape.text}")
        for name, size in found.items():
            (shared if name.isupper() else own)[name] = size
    elif value is not None:
        raise _Mismatch(f"{path} is a {type(value).__name__}, not an array")


def _same_parts(state: Any, fresh: Any, path: str, shape: ArrayShape | None) -> None:
    """Checks that the parts of a new engine exist; those that are None or in lists may vary."""
    if fresh is None:
        return
    if isinstance(fresh, _NUMBER) and not isinstance(fresh, enum.Enum):
        alike = isinstance(state, _NUMBER)
    else:
        alike = type(state) is type(fresh)
    if not alike:
        raise _Mismatch(f"{path} is a {type(state).__name__}, not a {type(fresh).__name__}")
    known = record_of(type(fresh))
    if isinstance(fresh, np.ndarray):
        if shape is None:
            _same_array(state, fresh, path)
    elif known is not None and not isinstance(fresh, enum.Enum):
        ours, theirs = known.values(state), known.values(fresh)
        for name, value in theirs.items():
            _same_parts(ours[name], value, f"{path}.{name}", known.shapes.get(name))
    elif isinstance(fresh, tuple):
        if len(state) != len(fresh):
            raise _Mismatch(f"{path} has {len(state)} parts, not {len(fresh)}")
        for k, (a, b) in enumerate(zip(state, fresh, strict=True)):
            _same_parts(a, b, f"{path}[{k}]", shape)


def _same_array(state: np.ndarray, fresh: np.ndarray, path: str) -> None:
    """For an array without a declared shape, axes that are initially empty may have grown."""
    same = state.dtype == fresh.dtype
    if same and fresh.shape != (0,):
        same = state.ndim == fresh.ndim
        same = same and all(b in (a, 0) for a, b in zip(state.shape, fresh.shape, strict=True))
    if not same:
        raise _Mismatch(f"{path} has the shape {state.shape}, not {fresh.shape}")
