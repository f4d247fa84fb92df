"""Settings: one frozen Params per stage, gathered in `Config`, read and written as TOML.

Params are plain frozen dataclasses of numbers, texts and booleans; `to_toml` and `from_toml` work
on any such tree, and an unknown key or wrong type is a ConfigError that names it.
"""

from __future__ import annotations

import dataclasses
import math
import tomllib
from typing import Any, TypeVar

from tracker.errors import ConfigError

T = TypeVar("T")


def to_toml(params: Any) -> str:
    """TOML text of a tree of dataclasses; floats keep every digit."""
    lines: list[str] = []
    _write(params, "", lines)
    return "\n".join(lines) + "\n"


def _write(params: Any, where: str, lines: list[str]) -> None:
    groups = []
    for f in dataclasses.fields(params):
        value = getattr(params, f.name)
        if dataclasses.is_dataclass(value):
            groups.append((f.name, value))
        else:
            lines.append(f"{f.name} = {_literal(value)}")
    for name, value in groups:
        path = f"{where}.{name}" if where else name
        lines.append(f"\n[{path}]")
        _write(value, path, lines)


def _literal(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        text = repr(value)
        return text if any(c in text for c in ".en") else text + ".0"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    raise TypeError(f"no TOML for {type(value).__name__}")


def from_toml(kind: type[T], text: str, name: str = "settings.toml") -> T:
    """A ``kind`` from TOML text; keys that are absent keep their defaults.

    Raises ConfigError naming the first key that is unknown, of a wrong type or not finite.
    """
    try:
        return _read(kind, tomllib.loads(text), "", name)
    except tomllib.TOMLDecodeError as error:
        raise ConfigError(f"{name} is not valid TOML: {error}.") from error


def _read(kind: type[T], data: dict[str, Any], where: str, name: str) -> T:
    default = kind()
    known = {f.name: getattr(default, f.name) for f in dataclasses.fields(kind)}  # type: ignore[arg-type]
    values: dict[str, Any] = {}
    for key, value in data.items():
        path = f"{where}.{key}" if where else key
        if key not in known:
            raise ConfigError(f"{name}: {path} is not a setting.")
        values[key] = _value(known[key], value, path, name)
    return dataclasses.replace(default, **values)  # type: ignore[type-var]


def _value(default: Any, value: Any, path: str, name: str) -> Any:
    if dataclasses.is_dataclass(default):
        if not isinstance(value, dict):
            raise ConfigError(f"{name}: {path} must be a table.")
        return _read(type(default), value, path, name)
    if isinstance(default, float) and isinstance(value, int) and not isinstance(value, bool):
        value = float(value)
    if type(value) is not type(default):
        raise ConfigError(f"{name}: {path} must be a {type(default).__name__}.")
    if isinstance(value, float) and not math.isfinite(value):
        raise ConfigError(f"{name}: {path} must be a finite number.")
    return value
