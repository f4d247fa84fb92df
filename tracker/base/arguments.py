"""Command-line arguments from the fields of a dataclass, so that options are declared once.

A field's help is in its metadata: ``field(default=0, metadata=argument("random seed"))``. A field
whose type is itself a dataclass of options, and whose metadata is `INCLUDED`, contributes its
arguments.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from dataclasses import MISSING, Field, dataclass, field, fields
from pathlib import Path
from types import NoneType, UnionType
from typing import (
    Any,
    Literal,
    TypeVar,
    Union,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

T = TypeVar("T")
ARGUMENT = "argument"
INCLUDED: Mapping[str, Any] = {"included": True}


@dataclass_transform(kw_only_default=True, frozen_default=True, field_specifiers=(field,))
def options(declared: type[T]) -> type[T]:
    """Makes a dataclass of a command's options: for the type checker one that is frozen, with
    keywords only. It has no methods besides ``__init__``, because each costs time when
    ``glovetrack --help`` imports the commands."""
    plain: type[T] = dataclass(kw_only=True, eq=False, repr=False, match_args=False)(declared)
    return plain


def argument(help: str, *flags: str, group: str = "", **more: Any) -> Mapping[str, Any]:
    """Metadata of a field that is an argument; ``more`` goes to ``ArgumentParser.add_argument``.

    Without ``flags``, a field with a default is the option ``--its-name`` and one without is
    positional. A bool is a flag that changes the default, ``--no-its-name`` where that is true. A
    tuple accepts several values, a `typing.Literal` one of its values. ``group`` is the heading in
    the help text; ``choices`` may be a function, which is called when the parser is built.
    """
    return {ARGUMENT: (flags, {"help": help} | more), "group": group}


def thousandths(text: str) -> float:
    """The ``type`` of an argument in mm or ms whose field is in m or s."""
    try:
        return float(text) / 1000
    except ValueError:
        raise argparse.ArgumentTypeError(f"invalid float value: {text!r}") from None


def add_options(parser: argparse._ActionsContainer, options: type[Any]) -> None:
    """Add an argument for each field of the dataclass ``options`` that has `argument` metadata."""
    hints = get_type_hints(options)
    groups: dict[str, argparse._ActionsContainer] = {"": parser}
    for each in _arguments(options):
        if each.metadata == INCLUDED:
            add_options(parser, hints[each.name])
            continue
        flags, more = each.metadata[ARGUMENT]
        if callable(more.get("choices")):
            more = more | {"choices": more["choices"]()}
        name = each.metadata["group"]
        if name not in groups:
            groups[name] = parser.add_argument_group(name)
        into = groups[name]
        required = each.default is MISSING and each.default_factory is MISSING
        more = _of_type(hints[each.name], each.default) | _default(each) | more
        if more.get("action") == "append":
            more = {k: v for k, v in more.items() if k != "nargs"} | {"default": []}
        if required and not flags:
            into.add_argument(each.name, **more)
            continue
        no = "no-" if each.default is True else ""
        flags = flags or (f"--{no}{each.name.replace('_', '-')}",)
        if any(flag.startswith("-") for flag in flags):
            more = {"dest": each.name, "required": required} | more
            into.add_argument(*flags, **more)
        else:
            into.add_argument(each.name, **{"nargs": "?", "metavar": flags[0]} | more)


def options_of(options: type[T], args: argparse.Namespace, **changes: Any) -> T:
    """``options`` from parsed arguments; ``changes`` replaces or adds values by field."""
    hints = get_type_hints(options)
    values = {
        each.name: options_of(hints[each.name], args)
        if each.metadata == INCLUDED
        else _value(getattr(args, each.name))
        for each in _arguments(options)
        if each.name not in changes
    }
    return options(**values, **changes)


def _value(parsed: Any) -> Any:
    return tuple(parsed) if isinstance(parsed, list) else parsed


def _arguments(options: type[Any]) -> list[Field[Any]]:
    return [
        each for each in fields(options) if ARGUMENT in each.metadata or each.metadata == INCLUDED
    ]


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
