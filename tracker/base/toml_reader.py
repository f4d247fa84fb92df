"""Strict reading of TOML: unknown keys, wrong types and NaN are errors that name file and line."""

from __future__ import annotations

import contextlib
import math
import re
import sys
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from tracker.base.arrays import Array
from tracker.base.errors import FileError
from tracker.base.files import read_bounded
from tracker.base.notices import Notice, notice

MOST_BYTES = 1_000_000
"""For a configuration file; the longest of ours has a hundredth of it."""
_DEEPEST = 16
_MOST_TABLES = 1000
_MOST_DIGITS = 400
_LARGEST = 2**63 - 1
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]{0,63}")
_TOKEN = re.compile(
    r'"""(?:[^"\\]++|\\.|"(?!""))*+"{3,5}'  # texts of several lines
    r"|'''(?:[^']++|'(?!''))*+'{3,5}"
    r'|(?P<open>"""|\'\'\')'  # one that does not end: nothing after it is read
    r'|"(?:[^"\\\n]++|\\.)*+"'  # texts of one line
    r"|'[^'\n]*+'"
    r"|(?P<open_line>[\"'])"
    r"|#[^\n]*+|[A-Za-z0-9_+-]++|[ \t]++|.",
    re.DOTALL,
)


class TomlTable:
    """One table of a file, read key by key; `finish` raises for keys that were not read."""

    def __init__(self, data: dict[str, Any], where: str, source: TomlText) -> None:
        self._data, self._where, self._source = data, where, source
        self._used: set[str] = set()

    def fail(self, key: str, why: Notice) -> FileError:
        """The error to raise for ``key`` of this table; ``why`` continues the key."""
        path = _short(f"{self._where}.{key}" if self._where else key)
        line = self._source.line(self._where, key)
        if line is None:
            return FileError(notice("config.key", file=self._source.name, key=path, why=why))
        return FileError(
            notice("config.invalid_value", file=self._source.name, line=line, key=path, why=why)
        )

    def has(self, key: str) -> bool:
        return key in self._data

    def _take(self, key: str, default: Any) -> Any:
        self._used.add(key)
        if key in self._data:
            return self._data[key]
        if default is ...:
            raise self.fail(key, notice("toml.missing"))
        return default

    def text(self, key: str, default: Any = ..., among: Iterable[str] | None = None) -> str:
        value = self._take(key, default)
        if not isinstance(value, str) or not value:
            raise self.fail(key, notice("toml.text"))
        if among is not None and value not in (choices := list(among)):
            raise self.fail(key, notice("toml.choice", value=value, known=choices))
        return value

    def name(self, key: str) -> str:
        """Returns a text that is valid in topics, names of columns and of files."""
        return self._checked_name(key, self.text(key))

    def _checked_name(self, key: str, value: str) -> str:
        if not _NAME.fullmatch(value):
            raise self.fail(key, notice("toml.name", name=_short(value)))
        return value

    def integer(self, key: str, default: Any = ...) -> int:
        value = self._take(key, default)
        if not isinstance(value, int) or isinstance(value, bool):
            raise self.fail(key, notice("toml.integer"))
        if abs(value) > _LARGEST:
            raise self.fail(key, notice("toml.too_large"))
        return value

    def number(
        self, key: str, default: Any = ..., low: float = -math.inf, high: float = math.inf
    ) -> float:
        return self._number(key, self._take(key, default), low, high)

    def _number(self, key: str, value: Any, low: float, high: float) -> float:
        if not isinstance(value, int | float) or isinstance(value, bool):
            raise self.fail(key, notice("toml.number"))
        if not abs(value) <= sys.float_info.max:  # NaN, infinite, or an integer beyond all floats
            raise self.fail(key, notice("toml.finite"))
        if not low <= value <= high:
            raise self.fail(key, notice("toml.range", value=value, low=low, high=high))
        return float(value)

    def vector(self, key: str, n: int, default: Any = ..., limit: float = math.inf) -> Array:
        value = self._take(key, default)
        if not isinstance(value, list | tuple) or len(value) != n:
            raise self.fail(key, notice("toml.numbers", count=n))
        return np.array([self._number(key, v, -limit, limit) for v in value])

    def unit(self, key: str, n: int, tolerance: float = 1e-3) -> Array:
        """A unit vector or quaternion, normalised."""
        value = self.vector(key, n)
        norm = float(np.linalg.norm(value))
        if abs(norm - 1) > tolerance:
            raise self.fail(key, notice("toml.norm", norm=norm, tolerance=tolerance))
        return value / norm

    def names(self, key: str, among: Iterable[str], default: Any = ...) -> tuple[str, ...]:
        value = self._take(key, default)
        choices = list(among)
        if not isinstance(value, list) or not all(v in choices for v in value):
            raise self.fail(key, notice("toml.names", known=choices))
        if len(set(value)) != len(value):
            raise self.fail(key, notice("toml.twice"))
        return tuple(value)

    def table(self, key: str, default: Any = ...) -> TomlTable:
        value = self._take(key, default)
        if not isinstance(value, dict):
            raise self.fail(key, notice("toml.table"))
        where = f"{self._where}.{key}" if self._where else key
        return TomlTable(value, where, self._source)

    def label(self, key: str) -> str:
        """A text that people choose and see, such as a hue."""
        value = self.text(key)
        if not _is_label(value):
            raise self.fail(key, notice("toml.label", label=_short(value)))
        return value

    def tables(self, key: str, labels: bool = False) -> dict[str, TomlTable]:
        """Returns the sub-tables of ``key`` by name; empty if the key is absent.

        Names are as `name` allows, or with ``labels`` as `label` does.
        """
        group = self.table(key, {})
        self._count(key, len(group._data))
        for name in group._data:
            if labels and not _is_label(name):
                raise group.fail(name, notice("toml.label", label=_short(name)))
            if not labels and not _NAME.fullmatch(name):
                raise group.fail(name, notice("toml.name", name=_short(name)))
        return {name: group.table(name) for name in group._data}

    def table_list(self, key: str) -> list[TomlTable]:
        """An array of tables; empty if the key is absent."""
        value = self._take(key, [])
        if not isinstance(value, list) or not all(isinstance(v, dict) for v in value):
            raise self.fail(key, notice("toml.table_list", key=key))
        self._count(key, len(value))
        return [TomlTable(v, f"{key}[{i}]", self._source) for i, v in enumerate(value)]

    def _count(self, key: str, n: int) -> None:
        if n > _MOST_TABLES:
            raise self.fail(key, notice("toml.many_tables", count=n, most=_MOST_TABLES))

    def keys(self) -> list[str]:
        return list(self._data)

    def finish(self) -> None:
        """Raise for the first key that was not asked for."""
        for key in self._data:
            if key not in self._used:
                raise self.fail(key, notice("toml.unknown_key"))


def texts(table: TomlTable, key: str) -> tuple[str, ...]:
    """A text, or a list of texts that is not empty. Raises FileError for another value."""
    value = table._take(key, ...)
    found = [value] if isinstance(value, str) else value
    if not isinstance(found, list) or not found or not all(isinstance(v, str) for v in found):
        raise table.fail(key, notice("toml.texts"))
    return tuple(found)


class TomlText:
    """The text behind a table, for line numbers in messages."""

    def __init__(self, name: str, text: str) -> None:
        self.name, self._lines = name, text.splitlines()

    def line(self, where: str, key: str) -> int | None:
        """Number of the line of a key, where it can be found."""
        header = self._header([*where.split("."), key] if where else [key])
        if header is not None:
            return header + 1
        start = self._table_start(where)
        if start is None:
            return None
        for n in range(start, len(self._lines)):
            text = self._lines[n].strip()
            if n > start and text.startswith("["):
                break
            if text.split("=")[0].strip() == key:
                return n + 1
        return start + 1 if where else None

    def _header(self, path: list[str]) -> int | None:
        """Number of the line that begins the table of that path, however its name is quoted."""
        for n, text in enumerate(self._lines):
            text = text.strip()
            if text.startswith("[") and not text.startswith("[["):
                with contextlib.suppress(ValueError):
                    if _only_path(tomllib.loads(text)) == path:
                        return n
        return None

    def _table_start(self, where: str) -> int | None:
        if not where:
            return 0
        if where.endswith("]"):
            name, _, index = where[:-1].partition("[")
            hits = [n for n, t in enumerate(self._lines) if t.strip() == f"[[{name}]]"]
            return hits[int(index)] if int(index) < len(hits) else None
        return next((n for n, t in enumerate(self._lines) if t.strip() == f"[{where}]"), None)


def read_toml(text: str, name: str) -> TomlTable:
    """Returns the root table of a TOML text; ``name`` is that of the file in messages.

    Raises FileError if it is not TOML.
    """
    return TomlTable(parse_toml(text, name), "", TomlText(name, text))


def parse_toml(text: str, name: str) -> dict[str, Any]:
    """Parses a TOML text. Raises FileError if it is invalid or exceeds the limits.

    The standard library's parser does not limit digits and nesting, and its time grows with the
    square of the number of parts of a dotted key.
    """
    _check_bounds(text, name)
    try:
        return tomllib.loads(text)
    except ValueError as error:  # TOMLDecodeError is one; so are integers of thousands of digits
        raise FileError(notice("config.not_toml", file=name, why=error)) from error
    except RecursionError as error:
        raise FileError(notice("config.too_deep", file=name)) from error


def _check_bounds(text: str, name: str) -> None:
    """Raises FileError, with line and key, for what no person writes into such a file."""
    if len(text) > MOST_BYTES:
        raise FileError(notice("config.too_large", file=name, limit_bytes=MOST_BYTES))
    line, key, depth, parts, bare = 1, "", 0, 1, ""
    for found in _TOKEN.finditer(text):
        if found["open"] or found["open_line"]:  # the tokens after it would take quadratic time
            raise FileError(notice("config.unclosed_text", file=name, line=line))
        token = found[0]
        first = token[0]
        why: Notice | None = None
        if first in "\"'" or first == "_" or first.isalnum():
            bare = token
            if first.isdigit() and len(token) > _MOST_DIGITS:
                why = notice("toml.long_number", digits=len(token))
        elif first == ".":
            parts += 1
            if parts > _DEEPEST:
                key, why = bare, notice("toml.many_parts", most=_DEEPEST)
        elif first in "[{":
            depth += 1
            if depth > _DEEPEST:
                why = notice("toml.deep", most=_DEEPEST)
        elif first in "]}":
            depth -= 1
        elif first == "=":
            key = bare
        if why is not None:
            raise FileError(
                notice(
                    "config.invalid_value",
                    file=name,
                    line=line,
                    key=_short(key or bare) or "a table",
                    why=why,
                )
            )
        if first not in ". \t\"'_" and not first.isalnum():
            parts = 1
        line += token.count("\n")


def _is_label(text: str) -> bool:
    return 0 < len(text) <= 64 and text.isprintable() and "," not in text


def _only_path(data: dict[str, Any]) -> list[str]:
    """Keys from the root down to an empty table."""
    path = []
    while data:
        ((key, data),) = data.items()
        path.append(key)
    return path


def _short(text: str, most: int = 60) -> str:
    """What a message shows of a text that may be long or hold anything."""
    text = "".join(c if c.isprintable() else "?" for c in text[: most + 1])
    return text if len(text) <= most else f"{text[: most - 1]}…"


def read_text(path: Path, limit: int = MOST_BYTES) -> str:
    """A small text file whole. Raises FileError where it is missing, huge or not UTF-8."""
    try:
        text = read_bounded(path, limit, "a configuration file").decode("utf-8")
        return text.replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError as error:
        raise FileError(notice("config.not_utf8", file=path)) from error
    except OSError as error:
        raise FileError(notice("file.not_readable", path=path, why=error.strerror)) from error
