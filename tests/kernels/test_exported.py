"""Kernels that Python calls get an entry; every kernel of the product declares its types."""

import importlib
import textwrap
from typing import get_args, get_type_hints

import pytest

from tracker.kernels.exported import exported, kernels
from tracker.kernels.signature import members, signature

SOURCES = {
    "tracker/small.py": """
        from tracker.kernels import kernel

        @kernel
        def inner(x: float) -> float:
            return x

        @kernel(error_model="numpy")
        def outer(x: float) -> float:
            return inner(x)

        @kernel
        def _door(x: float) -> float:
            return outer(x)

        def plain(x: float) -> float:
            return _door(x)
    """,
    "tracker/user.py": """
        import tracker.small as numbers
        from tracker import small
        from tracker.small import inner as other_name, plain

        class User:
            table = {"one": other_name}

            def run(self) -> float:
                return numbers.outer(plain(1.0))
    """,
    "app/unused.py": "from tracker.small import inner\n",
}


def write(folder, sources):
    for path, source in sources.items():
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_text(textwrap.dedent(source), "utf-8")


def test_kernels_are_found_by_their_decorator(tmp_path):
    write(tmp_path, SOURCES)
    assert kernels(tmp_path) == [f"tracker.small.{name}" for name in ("_door", "inner", "outer")]


def test_a_kernel_is_exported_if_it_is_used_outside_of_kernels(tmp_path):
    write(tmp_path, {"tracker/small.py": SOURCES["tracker/small.py"]})
    assert exported(tmp_path) == ["tracker.small._door"]
    write(tmp_path, {"app/unused.py": SOURCES["app/unused.py"]})
    assert exported(tmp_path) == ["tracker.small._door"]  # importing is not calling
    write(tmp_path, SOURCES)
    assert exported(tmp_path) == kernels(tmp_path)


@pytest.mark.parametrize("name", kernels())
def test_every_kernel_declares_its_types(name):
    module, _, function = name.rpartition(".")
    signature(getattr(importlib.import_module(module), function).py_func)


def has_a_class_of_ours(annotation) -> bool:
    inside = members(annotation) or []
    named = any(name for name, _ in inside)
    return named or any(
        has_a_class_of_ours(a) for a in (*get_args(annotation), *dict(inside).values())
    )


def test_kernels_called_by_python_return_no_named_tuple():
    """Its class would be imported by the module's name in this tree, which differs in a wheel: the
    compiled call would crash the process."""
    for name in exported():
        module, _, function = name.rpartition(".")
        made = getattr(importlib.import_module(module), function)
        assert not has_a_class_of_ours(get_type_hints(made.py_func).get("return")), name
