"""Strict reading of TOML: unknown keys, wrong types and NaN are errors that name file and line."""

from __future__ import annotations

import math
import sys
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from tracker.errors import FileError
from tracker.messages import Array


class TomlTable:
    """One table of a file, read key by key; `finish` complains about keys nobody asked for."""

    def __init__(self, data: dict[str, Any], where: str, source: Source) -> None:
        self._data, self._where, self._source = data, where, source
        self._used: set[str] = set()

    def fail(self, key: str, why: str) -> FileError:
        """The error to raise for ``key`` of this table."""
        path = f"{self._where}.{key}" if self._where else key
        return FileError(f"{self._source.name}{self._source.line(self._where, key)}: {path} {why}.")

    def has(self, key: str) -> bool:
        return key in self._data

    def _take(self, key: str, default: Any) -> Any:
        self._used.add(key)
        if key in self._data:
            return self._data[key]
        if default is ...:
            raise self.fail(key, "is missing")
        return default

    def text(self, key: str, default: Any = ..., among: Iterable[str] | None = None) -> str:
        value = self._take(key, default)
        if not isinstance(value, str) or not value:
            raise self.fail(key, "must be a text")
        if among is not None and value not in (choices := list(among)):
            raise self.fail(key, f"is {value!r}; it must be one of {', '.join(choices)}")
        return value

    def integer(self, key: str, default: Any = ...) -> int:
        value = self._take(key, default)
        if not isinstance(value, int) or isinstance(value, bool):
            raise self.fail(key, "must be a whole number")
        return value

    def number(
        self, key: str, default: Any = ..., low: float = -math.inf, high: float = math.inf
    ) -> float:
        return self._number(key, self._take(key, default), low, high)

    def _number(self, key: str, value: Any, low: float, high: float) -> float:
        if not isinstance(value, int | float) or isinstance(value, bool):
            raise self.fail(key, "must be a number")
        if not abs(value) <= sys.float_info.max:  # NaN, infinite, or an integer beyond all floats
            raise self.fail(key, "must be a finite number")
        if not low <= value <= high:
            raise self.fail(key, f"is {value:g}; it must lie between {low:g} and {high:g}")
        return float(value)

    def vector(self, key: str, n: int, default: Any = ..., limit: float = math.inf) -> Array:
        value = self._take(key, default)
        if not isinstance(value, list | tuple) or len(value) != n:
            raise self.fail(key, f"must be a list of {n} numbers")
        return np.array([self._number(key, v, -limit, limit) for v in value])

    def unit(self, key: str, n: int, tolerance: float = 1e-3) -> Array:
        """A unit vector or quaternion, normalised."""
        value = self.vector(key, n)
        norm = float(np.linalg.norm(value))
        if abs(norm - 1) > tolerance:
            raise self.fail(key, f"has length {norm:.4g}; it must be 1 within {tolerance:g}")
        return value / norm

    def names(self, key: str, among: Iterable[str]) -> tuple[str, ...]:
        value = self._take(key, ...)
        choices = list(among)
        if not isinstance(value, list) or not all(v in choices for v in value):
            raise self.fail(key, f"must be a list out of {', '.join(choices)}")
        if len(set(value)) != len(value):
            raise self.fail(key, "names something twice")
        return tuple(value)

    def table(self, key: str, default: Any = ...) -> TomlTable:
        value = self._take(key, default)
        if not isinstance(value, dict):
            raise self.fail(key, "must be a table")
        where = f"{self._where}.{key}" if self._where else key
        return TomlTable(value, where, self._source)

    def tables(self, key: str) -> dict[str, TomlTable]:
        """The sub-tables of ``key`` by name; none if the key is absent."""
        group = self.table(key, {})
        return {name: group.table(name) for name in group._data}

    def table_list(self, key: str) -> list[TomlTable]:
        """An array of tables; empty if the key is absent."""
        value = self._take(key, [])
        if not isinstance(value, list) or not all(isinstance(v, dict) for v in value):
            raise self.fail(key, f"must be written as [[{key}]] tables")
        return [TomlTable(v, f"{key}[{i}]", self._source) for i, v in enumerate(value)]

    def keys(self) -> list[str]:
        return list(self._data)

    def finish(self) -> None:
        """Raise for the first key that was not asked for."""
        for key in self._data:
            if key not in self._used:
                raise self.fail(key, "is not a key that this file may have")


class Source:
    """The text behind a table, for line numbers in messages."""

    def __init__(self, name: str, text: str) -> None:
        self.name, self._lines = name, text.splitlines()

    def line(self, where: str, key: str) -> str:
        """``', line N'`` of a key where it can be found, else nothing."""
        start = self._table_start(where)
        if start is None:
            return ""
        for n in range(start, len(self._lines)):
            text = self._lines[n].strip()
            if n > start and text.startswith("["):
                break
            if text.split("=")[0].strip() == key:
                return f", line {n + 1}"
        return f", line {start + 1}" if where else ""

    def _table_start(self, where: str) -> int | None:
        if not where:
            return 0
        if where.endswith("]"):
            name, _, index = where[:-1].partition("[")
            hits = [n for n, t in enumerate(self._lines) if t.strip() == f"[[{name}]]"]
            return hits[int(index)] if int(index) < len(hits) else None
        return next((n for n, t in enumerate(self._lines) if t.strip() == f"[{where}]"), None)


def read_toml(text: str, name: str) -> TomlTable:
    """The root table of a TOML text; ``name`` stands for the file in messages.

    Raises FileError if it is no TOML.
    """
    return TomlTable(parse_toml(text, name), "", Source(name, text))


def parse_toml(text: str, name: str) -> dict[str, Any]:
    """The tables of a TOML text. Raises FileError if it is none, or nobody could have written it.

    The standard library's parser has no bound of its own on digits and nesting.
    """
    try:
        return tomllib.loads(text)
    except ValueError as error:  # TOMLDecodeError is one; so are integers of thousands of digits
        raise FileError(f"{name} is not valid TOML: {error}.") from error
    except RecursionError as error:
        raise FileError(f"{name} is not valid TOML: it is nested too deeply.") from error


def read_text(path: Path, limit: int = 4_000_000) -> str:
    """A small text file whole. Raises FileError where it is missing, huge or not UTF-8."""
    try:
        if path.stat().st_size > limit:
            raise FileError(f"{path} is larger than {limit} bytes: not a configuration file.")
        return path.read_text("utf-8")
    except UnicodeDecodeError as error:
        raise FileError(f"{path} is not a UTF-8 text file.") from error
    except OSError as error:
        raise FileError(f"{path} cannot be read: {error.strerror}.") from error
