"""Functions that descriptors name by a string: all exist, and have the parameters of the field."""

from __future__ import annotations

import ast
import inspect
import sys
import tomllib
from dataclasses import fields, is_dataclass
from pathlib import Path

import pytest

from tracker.base.command import Command
from tracker.base.registry import Deferred, deferred

ROOT = Path(__file__).parents[2]
ENTRY_POINTS = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"][
    "entry-points"
]
DECLARED = sorted({entry for group in ENTRY_POINTS.values() for entry in group.values()})


def names_in_code() -> dict[str, Path]:
    """Every name that the code passes to `deferred`, with its file."""
    found = {}
    for folder in ("app", "extensions", "glovetrack", "tracker"):
        for path in (ROOT / folder).rglob("*.py"):
            text = path.read_text("utf-8")
            if "deferred(" not in text or "tests" in path.parts:
                continue
            for node in ast.walk(ast.parse(text)):
                if isinstance(node, ast.Call) and ast.unparse(node.func) == "deferred":
                    found[ast.literal_eval(node.args[0])] = path
    return {name: path for name, path in found.items() if "package.module" not in name}


def as_deferred(value: object) -> Deferred | None:
    """What a field names: a function to call, or one to load."""
    value = getattr(value, "__self__", value)
    return value if isinstance(value, Deferred) else None


def test_every_name_exists_and_stays_within_its_part() -> None:
    """An extension names itself alone, and the engine no window: import contracts cannot see
    strings."""
    names = names_in_code()
    assert len(names) > 80
    for name, path in names.items():
        assert callable(Deferred(name).load()), name
        depth = 2 if name.startswith("extensions.") else 1
        here = path.relative_to(ROOT).with_suffix("").parts[:depth]
        assert tuple(name.split(".")[:depth]) == here, f"{path} names {name}"


@pytest.mark.parametrize("entry", DECLARED)
def test_descriptors_name_functions_with_the_parameters_of_their_fields(entry: str) -> None:
    descriptor = Deferred(entry).load()
    if not is_dataclass(descriptor):
        return
    for each in fields(descriptor):
        value = getattr(descriptor, each.name)
        named = as_deferred(value)
        if named is None:
            continue
        function = named.load()
        if each.name == "options":
            assert is_dataclass(function)
            continue
        if value is not named:  # loaded, not called
            assert callable(function)
            continue
        inspect.signature(function).bind(*range(count_of_arguments(each.type)))
        if isinstance(descriptor, Command) and each.name == "run":
            (parameter,) = inspect.signature(function).parameters.values()
            kind = descriptor.options
            kind = kind.load() if isinstance(kind, Deferred) else kind
            options = "Namespace" if kind is None else kind.__name__
            assert str(parameter.annotation).rpartition(".")[2] == options, entry


def count_of_arguments(annotation: object) -> int:
    """The number of arguments of the ``Callable`` in an annotation."""
    (call,) = (
        node
        for node in ast.walk(ast.parse(str(annotation)))
        if isinstance(node, ast.Subscript) and ast.unparse(node.value) == "Callable"
    )
    assert isinstance(call.slice, ast.Tuple) and isinstance(call.slice.elts[0], ast.List)
    return len(call.slice.elts[0].elts)


def test_a_module_is_imported_at_the_first_call() -> None:
    named = deferred("tests.base.later:double")
    assert "tests.base.later" not in sys.modules
    assert named(21) == 42 and "tests.base.later" in sys.modules
    with pytest.raises(AttributeError):
        deferred("tests.base.later:nothing")(1)
