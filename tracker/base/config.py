"""Frozen dataclasses of settings, read from tables and TOML, and written as TOML.

Such a dataclass has a default for each field: a number, a text, a boolean, a tuple of numbers, a
dict, or another such dataclass. `from_dict` is the one reader; its caller decides what
happens with invalid keys and values.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any, TypeVar

import tomli_w

from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import Notice, notice
from tracker.base.toml_reader import parse_toml

T = TypeVar("T")
OnProblem = Callable[[str, Notice], None]
"""Receives the path of a key and what is wrong with it; raises, or returns to use the default."""

UNKNOWN = notice("toml.setting")


class _Wrong(Exception):
    """A value that its field cannot hold, and why."""

    def __init__(self, why: Notice) -> None:
        super().__init__(why)
        self.why = why


def to_toml(params: Any) -> str:
    """TOML text of a tree of dataclasses; floats keep every digit. An empty dict is left out."""
    values = dataclasses.asdict(params)
    return tomli_w.dumps({name: value for name, value in values.items() if value != {}})


def from_toml(kind: type[T], text: str, name: str = "settings.toml") -> T:
    """A ``kind`` from TOML text; keys that are absent keep their defaults.

    Raises ConfigError naming the first key that is unknown, of a wrong type or not finite.
    """

    def on_problem(path: str, why: Notice) -> None:
        raise ConfigError(notice("config.key", file=name, key=path, why=why))

    try:
        data = parse_toml(text, name)
    except FileError as error:
        raise ConfigError(error.notice) from error
    return from_dict(kind, data, on_problem)


def from_dict(kind: type[T], data: dict[str, Any], on_problem: OnProblem, where: str = "") -> T:
    """A ``kind`` from a table, as JSON or TOML give it; keys that are absent keep their defaults.

    ``on_problem`` gets the path of each key that is `UNKNOWN` or has a wrong value.
    """
    default = kind()
    known = {f.name: getattr(default, f.name) for f in dataclasses.fields(kind)}  # type: ignore[arg-type]
    values: dict[str, Any] = {}
    for key, value in data.items():
        path = f"{where}.{key}" if where else key
        usual = known.get(key)
        if key not in known:
            on_problem(path, UNKNOWN)
        elif dataclasses.is_dataclass(usual) and isinstance(value, dict):
            values[key] = from_dict(type(usual), value, on_problem, path)
        else:
            try:
                values[key] = _taken(usual, value)
            except _Wrong as wrong:
                on_problem(path, wrong.why)
    return dataclasses.replace(default, **values)  # type: ignore[type-var]


def _taken(usual: Any, value: Any) -> Any:
    """The value in the type of its field. Raises _Wrong."""
    if dataclasses.is_dataclass(usual):
        raise _Wrong(notice("toml.table"))
    if isinstance(usual, tuple) and isinstance(value, list):
        return tuple(_number(v) for v in value)
    if isinstance(usual, float):
        return _number(value)
    if type(value) is not type(usual):
        raise _Wrong(notice("toml.type", type=type(usual).__name__))
    return value


def _number(value: Any) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool):
        raise _Wrong(notice("toml.number"))
    try:
        number = float(value)
    except OverflowError:  # an integer of hundreds of digits
        number = math.inf
    if not math.isfinite(number):
        raise _Wrong(notice("toml.finite"))
    return number
