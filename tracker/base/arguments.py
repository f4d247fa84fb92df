"""Command-line arguments from the fields of a dataclass, so that options are declared once.

A field's help is in its metadata: ``field(default=0, metadata=argument("random seed"))``.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from dataclasses import MISSING, Field, fields
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, Literal, TypeVar, Union, get_args, get_origin, get_type_hints

T = TypeVar("T")
ARGUMENT = "argument"


def argument(help: str, *flags: str, **more: Any) -> Mapping[str, Any]:
    """Metadata of a field that is an argument; ``more`` goes to ``ArgumentParser.add_argument``.

    Without ``flags``, a field with a default is the option ``--its-name`` and one without is
    positional. A bool is a flag that changes the default, ``--no-its-name`` where that is true. A
    tuple accepts several values, a `typing.Literal` one of its values.
    """
    return {ARGUMENT: (flags, {"help": help} | more)}


def thousandths(text: str) -> float:
    """The ``type`` of an argument in mm or ms whose field is in m or s."""
    try:
        return float(text) / 1000
    except ValueError:
        raise argparse.ArgumentTypeError(f"invalid float value: {text!r}") from None


def add_options(parser: argparse._ActionsContainer, options: type[Any]) -> None:
    """Add an argument for each field of the dataclass ``options`` that has `argument` metadata."""
    hints = get_type_hints(options)
    for each in _arguments(options):
        flags, more = each.metadata[ARGUMENT]
        required = each.default is MISSING and each.default_factory is MISSING
        more = _of_type(hints[each.name], each.default) | _default(each) | more
        if required and not flags:
            parser.add_argument(each.name, **more)
            continue
        no = "no-" if each.default is True else ""
        flags = flags or (f"--{no}{each.name.replace('_', '-')}",)
        if any(flag.startswith("-") for flag in flags):
            more = {"dest": each.name, "required": required} | more
            parser.add_argument(*flags, **more)
        else:
            parser.add_argument(each.name, **{"nargs": "?", "metavar": flags[0]} | more)


def options_of(options: type[T], args: argparse.Namespace, **changes: Any) -> T:
    """``options`` from parsed arguments; ``changes`` replaces or adds values by field."""
    values = {
        each.name: tuple(value) if isinstance(value, list) else value
        for each in _arguments(options)
        if each.name not in changes
        for value in [getattr(args, each.name)]
    }
    return options(**values, **changes)


def _arguments(options: type[Any]) -> list[Field[Any]]:
    return [each for each in fields(options) if ARGUMENT in each.metadata]


def _default(each: Field[Any]) -> dict[str, Any]:
    if each.default_factory is not MISSING:
        return {"default": each.default_factory()}
    return {} if each.default is MISSING else {"default": each.default}


def _of_type(hint: Any, default: Any) -> dict[str, Any]:
    """How `argparse` reads a value of this type."""
    origin, inside = get_origin(hint), get_args(hint)
    if hint is bool:
        return {"action": "store_false" if default is True else "store_true"}
    if origin in (Union, UnionType):
        (hint,) = (kind for kind in inside if kind is not NoneType)
        return _of_type(hint, default)
    if origin is Literal:
        return {"choices": inside}
    if origin is tuple:
        return _of_type(inside[0], MISSING) | {"nargs": "+" if default is MISSING else "*"}
    return {"type": hint} if hint in (int, float, Path) else {}
